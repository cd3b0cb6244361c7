// Renders casters into one tile of the map. The pipeline leaves depth unclipped: a caster between the light and the
// facet's near limit keeps its place in the map and lands on the depth nearest to the light.

/// Places a caster's vertex in the tile.
@vertex
fn capture_vertex(vertex: CasterVertex) -> @builtin(position) vec4<f32> {
    return tile_position(capture_position(vertex));
}
