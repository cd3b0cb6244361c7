// Slot: how rows are bent back. Here: from the logarithm of distance.

/// One over distance, of clip y after division: the inverse of `remapped`.
fn unremapped(remap: array<vec4<f32>, 2>, y: f32) -> f32 {
    let beyond_horizon = (y - remap[1].y) / remap[1].z;
    if remap[1].z != 0.0 && beyond_horizon <= remap[1].x {
        return beyond_horizon;
    }
    let after_focus = (y - remap[0].x) / remap[0].z;
    let before_focus = (y - remap[0].x) / remap[0].y;
    return exp(select(after_focus, before_focus, after_focus > 0.0)) / remap[0].w;
}
