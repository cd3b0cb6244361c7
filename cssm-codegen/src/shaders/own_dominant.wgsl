// Slot: the facet that a receiver belongs to. Here: the last of all near the dominant plane, elsewhere the one that the
// walk ends at.

/// The facet of a receiver.
fn own_facet(position: vec3<f32>) -> Facet {
    if is_near_dominant_plane(position) {
        return shadow.facets[DOMINANT];
    }
    return shadow.facets[facet_index(position)];
}
