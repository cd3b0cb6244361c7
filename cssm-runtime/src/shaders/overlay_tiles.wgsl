// The map as it is, texel for texel: depths as grey between the nearest and the farthest of their tile, tiles outlined.
// `Settings` and the names of rows stand before this text.

@group(0) @binding(0) var<uniform> settings: Settings;
// The rows of each tile.
@group(0) @binding(1) var numbers: texture_2d<f32>;
@group(0) @binding(2) var map: texture_depth_2d;

// Texels across and down a tile that its range of depths is taken from.
const SAMPLES: u32 = 16u;

struct Corner {
    @builtin(position) position: vec4<f32>,
    // Map texels.
    @location(0) texel: vec2<f32>,
    @location(1) @interpolate(flat) rectangle: vec4<f32>,
    @location(2) @interpolate(flat) colour: vec4<f32>,
    // The smallest and the largest depth.
    @location(3) @interpolate(flat) range: vec2<f32>,
}

fn number(index: u32) -> vec4<f32> {
    return textureLoad(numbers, vec2<u32>(index % ROW_TEXELS, index / ROW_TEXELS), 0);
}

fn is_drawn(depth: f32) -> bool {
    return depth > 0.0 && depth < 1.0;
}

@vertex
fn tiles_vertex(@builtin(vertex_index) index: u32, @builtin(instance_index) tile: u32) -> Corner {
    let rectangle = number(TILE_ROWS * tile + TILE_RECTANGLE);
    var range = vec2<f32>(1.0, 0.0);
    for (var at = 0u; at < SAMPLES * SAMPLES; at++) {
        let share = (vec2<f32>(vec2<u32>(at % SAMPLES, at / SAMPLES)) + 0.5) / f32(SAMPLES);
        let depth = textureLoad(map, vec2<i32>(rectangle.xy + share * rectangle.zw), 0);
        if is_drawn(depth) {
            range = vec2<f32>(min(range.x, depth), max(range.y, depth));
        }
    }
    // Two triangles.
    let corner = vec2<f32>(f32(index == 1u || index == 2u || index == 4u), f32(index == 2u || index >= 4u));
    let texel = rectangle.xy + corner * rectangle.zw;
    let place = texel / settings.map_texels * 2.0 - 1.0;
    let colour = number(TILE_ROWS * tile + TILE_COLOUR);
    return Corner(vec4<f32>(place.x, -place.y, 0.0, 1.0), texel, rectangle, colour, range);
}

@fragment
fn tiles_fragment(corner: Corner) -> @location(0) vec4<f32> {
    // Outline the tile in pixels of the picture.
    let texels_per_pixel = vec2<f32>(abs(dpdx(corner.texel.x)), abs(dpdy(corner.texel.y)));
    let inside = min(corner.texel - corner.rectangle.xy, corner.rectangle.xy + corner.rectangle.zw - corner.texel);
    if any(inside < settings.outline_pixels * texels_per_pixel) {
        return vec4<f32>(corner.colour.rgb, 1.0);
    }
    let depth = textureLoad(map, vec2<i32>(floor(corner.texel)), 0);
    if !is_drawn(depth) {
        return vec4<f32>(corner.colour.rgb * 0.15, 1.0);
    }
    let span = max(corner.range.y - corner.range.x, 1e-9);
    let grey = 0.2 + 0.75 * clamp((depth - corner.range.x) / span, 0.0, 1.0);
    return vec4<f32>(grey, grey, grey, 1.0);
}
