// From the space of the engine's positions to the capture's axes.

/// Applies three rows to a position: relative to the eye, in the capture's axes.
fn placed(position: vec3<f32>, row_x: vec4<f32>, row_y: vec4<f32>, row_z: vec4<f32>) -> vec4<f32> {
    let point = vec4<f32>(position, 1.0);
    return vec4<f32>(dot(row_x, point), dot(row_y, point), dot(row_z, point), 1.0);
}
