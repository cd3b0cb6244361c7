// Slot: how steeply rows are bent. Here: by the logarithm of distance.

/// Change of clip y after division per change of one over distance.
fn remap_slope(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].z;
    }
    return remap[0].y / inverse_distance;
}
