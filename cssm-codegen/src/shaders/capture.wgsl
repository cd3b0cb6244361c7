// Renders casters into one tile of the map. The pipeline leaves depth unclipped: a caster between the light and the
// facet's near limit keeps its place in the map and lands on depth 0.

/// Places a caster's vertex in the tile.
///
/// The instance rows take an object-space point to world axes relative to the eye, so no world coordinate is large.
@vertex
fn capture_vertex(
    @location(0) position: vec3<f32>,
    @location(1) eye_from_object_x: vec4<f32>,
    @location(2) eye_from_object_y: vec4<f32>,
    @location(3) eye_from_object_z: vec4<f32>,
) -> @builtin(position) vec4<f32> {
    // Move the vertex from its object to the eye.
    let object = vec4<f32>(position, 1.0);
    let caster = vec4<f32>(
        dot(eye_from_object_x, object),
        dot(eye_from_object_y, object),
        dot(eye_from_object_z, object),
        1.0,
    );

    // Apply the facet's matrix, row by row.
    return vec4<f32>(
        dot(capture.row_x, caster),
        dot(capture.row_y, caster),
        dot(capture.row_z, caster),
        dot(capture.row_w, caster),
    );
}
