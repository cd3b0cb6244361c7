// Slot: how rows are bent back. Here: from the logarithm of distance.

/// One over distance, of clip y after division: the inverse of `remapped`.
fn unremapped(remap: array<vec4<f32>, 2>, y: f32) -> f32 {
    let beyond_horizon = (y - remap[1].y) / remap[1].z;
    if beyond_horizon <= remap[1].x {
        return beyond_horizon;
    }
    return exp((y - remap[0].x) / remap[0].y) / remap[0].z;
}
