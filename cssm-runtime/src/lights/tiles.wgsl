// Prepares tiles of the shared depth texture before casters are drawn into them: the viewport is the tile.

/// Casters that stay, as drawn before; has the size of the shared texture.
@group(0) @binding(0)
var still_casters: texture_depth_2d;

/// Corner of a triangle that covers the viewport: (-1, 1), (-1, -3) and (3, 1).
fn corner(index: u32, depth: f32) -> vec4<f32> {
    let x = select(-1.0, 3.0, index == 2u);
    let y = select(1.0, -3.0, index == 1u);
    return vec4<f32>(x, y, depth, 1.0);
}

/// Empties a tile whose depth is stored as it is.
@vertex
fn empty_standard(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    return corner(index, 1.0);
}

/// Empties a tile whose depth is stored reversed.
@vertex
fn empty_reversed(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    return corner(index, 0.0);
}

/// Brings the casters that stay back into a tile.
@fragment
fn still(@builtin(position) texel: vec4<f32>) -> @builtin(frag_depth) f32 {
    return textureLoad(still_casters, vec2<i32>(texel.xy), 0);
}
