// Slot: the axes that facets are evaluated in. Here: those of the caller.

/// The position as facet rows take it.
fn facet_position(position: vec3<f32>) -> vec3<f32> {
    return position;
}
