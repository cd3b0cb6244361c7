// Renders casters with an alpha mask into one tile of the map. The pipeline leaves depth unclipped.

/// What the vertex stage of the tested capture hands to its fragment stage.
struct TestedCaster {
    /// Position in the tile.
    @builtin(position) tile: vec4<f32>,
    /// Coordinates of the caster's mask.
    @location(0) uv: vec2<f32>,
}

/// Places a caster's vertex in the tile.
@vertex
fn capture_tested_vertex(vertex: CasterVertex, @location(4) uv: vec2<f32>) -> TestedCaster {
    return TestedCaster(tile_position(capture_position(vertex)), uv);
}

/// Leaves the caster's holes out.
@fragment
fn capture_tested_fragment(@location(0) uv: vec2<f32>) {
    if is_hole(uv) {
        discard;
    }
}
