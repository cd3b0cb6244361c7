// Slot: the facet that a receiver belongs to. Here: the one that the walk ends at.

/// The facet of a receiver.
fn own_facet(position: vec3<f32>) -> Facet {
    return shadow.facets[facet_index(position)];
}
