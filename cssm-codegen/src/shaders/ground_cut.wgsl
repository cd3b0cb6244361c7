// Which texels of a tile are a facet's own, where facets share tiles and each is cut off at two edges.

/// Whether a place in the tile belongs to the facet.
fn in_own_part(cell: u32, place: vec3<f32>) -> bool {
    let one = dot(shadow.ground_edges[2u * cell].xyz, place);
    let two = dot(shadow.ground_edges[2u * cell + 1u].xyz, place);
    return one >= 0.0 && two >= 0.0;
}
