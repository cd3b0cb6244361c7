// Renders casters with an alpha mask into one facet's part of a tile. The pipeline leaves depth unclipped and cuts by
// clip distances.

/// What the vertex stage of the tested capture hands to the pipeline and to its fragment stage.
struct TestedCaster {
    /// Position in the tile.
    @builtin(position) tile: vec4<f32>,
    /// Distances from the facet's half-spaces; the pipeline cuts where one is negative.
    @builtin(clip_distances) clips: array<f32, 2>,
    /// Coordinates of the caster's mask.
    @location(0) uv: vec2<f32>,
}

/// Places a caster's vertex in the tile and measures the facet's half-spaces there.
@vertex
fn capture_tested_vertex(vertex: CasterVertex, @location(4) uv: vec2<f32>) -> TestedCaster {
    let position = capture_position(vertex);
    let clips = clip_values(position);
    return TestedCaster(tile_position(position), array<f32, 2>(clips.x, clips.y), uv);
}

/// Leaves the caster's holes out.
@fragment
fn capture_tested_fragment(@location(0) uv: vec2<f32>) {
    if is_hole(uv) {
        discard;
    }
}
