// Slot: the facet that a receiver belongs to. Here: one for receivers near the dominant plane, one for all others.

/// The facet of a receiver.
fn own_facet(position: vec3<f32>) -> Facet {
    return shadow.facets[select(0u, DOMINANT, is_near_dominant_plane(position))];
}
