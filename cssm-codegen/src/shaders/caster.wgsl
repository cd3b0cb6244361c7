// What every capture takes from the engine: a vertex of a caster and where the caster stands.

/// A vertex of a caster.
struct CasterVertex {
    /// Position in the object's own space.
    @location(0) position: vec3<f32>,
    /// First of the instance's rows; they take the object's space to the capture's axes, relative to the eye.
    @location(1) eye_from_object_x: vec4<f32>,
    /// Second row.
    @location(2) eye_from_object_y: vec4<f32>,
    /// Third row.
    @location(3) eye_from_object_z: vec4<f32>,
}

/// Moves a vertex from its object to the eye, into the capture's axes: no coordinate is large that the view or the
/// light shows small.
fn capture_position(vertex: CasterVertex) -> vec4<f32> {
    let object = vec4<f32>(vertex.position, 1.0);
    return vec4<f32>(
        dot(vertex.eye_from_object_x, object),
        dot(vertex.eye_from_object_y, object),
        dot(vertex.eye_from_object_z, object),
        1.0,
    );
}
