// Renders casters into one facet's part of a tile. The pipeline leaves depth unclipped and cuts by clip distances.

/// A caster's vertex in the tile.
struct ClippedCaster {
    /// Position in the tile.
    @builtin(position) tile: vec4<f32>,
    /// Distances from the facet's half-spaces; the pipeline cuts where one is negative.
    @builtin(clip_distances) clips: array<f32, 2>,
}

/// Places a caster's vertex in the tile and measures the facet's half-spaces there.
@vertex
fn capture_vertex(vertex: CasterVertex) -> ClippedCaster {
    let position = capture_position(vertex);
    let clips = clip_values(position);
    return ClippedCaster(tile_position(position), array<f32, 2>(clips.x, clips.y));
}
