// Slot: a normal in the axes that facets are evaluated in. Here: those of the caller.

/// The normal as facet rows take it.
fn facet_normal(normal: vec3<f32>) -> vec3<f32> {
    return normal;
}
