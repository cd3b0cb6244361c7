// Slot: how steeply rows are bent. Here: by the perspective of an eye that is pushed back.

/// Change of clip y after division per change of one over distance.
fn remap_slope(remap: vec4<f32>, inverse_distance: f32) -> f32 {
    let divisor = max(1.0 + remap.z * inverse_distance, SMALLEST_DIVISOR);
    return remap.y / (divisor * divisor);
}
