// Slot: which facet a receiver belongs to. Here: one facet in each sector around the eye.

/// Finds the facet of a receiver.
fn facet_index(position: vec3<f32>) -> u32 {
    return sector_index(position);
}
