// Renders casters into one tile of the map on devices that cannot leave depth unclipped. The vertex stage hides the
// depth from the clipper, the fragment stage clamps it.

/// What the vertex stage of the clamped capture hands to its fragment stage.
struct ClampedCaster {
    /// Position in the tile, at a depth that no clip plane meets.
    @builtin(position) clip: vec4<f32>,
    /// Clip z of the facet: depth times w.
    @location(0) depth_times_w: f32,
    /// Clip w of the facet.
    @location(1) w: f32,
}

/// Places a caster's vertex in the tile, half way between the clipper's depth limits.
///
/// The instance rows take an object-space point to world axes relative to the eye, so no world coordinate is large.
@vertex
fn capture_clamped_vertex(
    @location(0) position: vec3<f32>,
    @location(1) eye_from_object_x: vec4<f32>,
    @location(2) eye_from_object_y: vec4<f32>,
    @location(3) eye_from_object_z: vec4<f32>,
) -> ClampedCaster {
    // Move the vertex from its object to the eye.
    let object = vec4<f32>(position, 1.0);
    let caster = vec4<f32>(
        dot(eye_from_object_x, object),
        dot(eye_from_object_y, object),
        dot(eye_from_object_z, object),
        1.0,
    );

    // Apply the facet's matrix, but keep its depth for the fragment stage.
    let w = dot(capture.row_w, caster);
    var placed: ClampedCaster;
    placed.clip = vec4<f32>(dot(capture.row_x, caster), dot(capture.row_y, caster), 0.5 * w, w);
    placed.depth_times_w = dot(capture.row_z, caster);
    placed.w = w;
    return placed;
}

/// Writes the depth that an unclipped capture would store.
@fragment
fn capture_clamped_fragment(placed: ClampedCaster) -> @builtin(frag_depth) f32 {
    return clamp(placed.depth_times_w / placed.w, 0.0, 1.0);
}
