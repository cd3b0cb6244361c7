// Slot: how long gradients of facet coordinates are. Here: facets are evaluated in the caller's axes.

/// Length of a gradient per metre.
fn gradient_length(gradient: vec3<f32>) -> f32 {
    return length(gradient);
}
