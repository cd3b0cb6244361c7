// Slot: how rows are bent. Here: by the perspective of an eye that is pushed back: with k = 1 / distance,
// y = shift + scale k / (1 + push k). The record's vector holds shift, scale and push.

/// Clip y after division, of one over distance; farther than infinity it goes on without end.
fn remapped(remap: vec4<f32>, inverse_distance: f32) -> f32 {
    return remap.x + remap.y * inverse_distance / max(1.0 + remap.z * inverse_distance, SMALLEST_DIVISOR);
}
