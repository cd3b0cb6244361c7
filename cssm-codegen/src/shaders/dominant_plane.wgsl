// Receivers near the dominant plane, which has a facet of its own.

/// Whether a receiver lies within the plane's thickness, where its facet can show it.
fn is_near_dominant_plane(position: vec3<f32>) -> bool {
    let point = vec4<f32>(position, 1.0);
    return abs(dot(shadow.dominant[0], point)) <= 1.0 && dot(shadow.dominant[1], point) >= 0.0;
}
