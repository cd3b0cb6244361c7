// Slot: how rows are bent back. Here: from the perspective of an eye that is pushed back.

/// One over distance, of clip y after division: the inverse of `remapped`. What lies nearer than the eye itself is as
/// near as can be told apart.
fn unremapped(remap: vec4<f32>, y: f32) -> f32 {
    let value = (y - remap.x) / remap.y;
    return value / max(1.0 - remap.z * value, SMALLEST_DIVISOR);
}
