// Slot: how long gradients of facet coordinates are. Here: facets are evaluated in sheared axes, and gradients turn as
// normals do.

/// Length of a gradient per metre, in the caller's axes.
fn gradient_length(gradient: vec3<f32>) -> f32 {
    return length(vec3<f32>(gradient.xy, gradient.z + dot(shadow.shear.xy + shadow.shear.zw, gradient.xy)));
}
