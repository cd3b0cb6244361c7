// Slot: how rows are bent. Here: by the logarithm of distance, in terms of k = 1 / distance. The record's first vector
// holds the value at a reference distance, the change per ln(k reference), and the reference; its second vector holds k
// at the horizon, and of the straight line that goes on from there the value at k = 0 and the change per k.

/// Clip y after division, of one over distance.
fn remapped(remap: array<vec4<f32>, 2>, inverse_distance: f32) -> f32 {
    if inverse_distance <= remap[1].x {
        return remap[1].y + remap[1].z * inverse_distance;
    }
    return remap[0].x + remap[0].y * log(inverse_distance * remap[0].z);
}
