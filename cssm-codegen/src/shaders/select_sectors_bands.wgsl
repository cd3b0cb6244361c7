// Slot: which facet a receiver belongs to. Here: bands of distance in each sector around the eye.

/// Finds the facet of a receiver: its sector, then the number of that sector's thresholds that its distance has
/// reached.
fn facet_index(position: vec3<f32>) -> u32 {
    let sector = sector_index(position);
    let distance = dot(shadow.distances[sector], vec4<f32>(position, 1.0));
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < THRESHOLD_VECTORS; index += 1u) {
        let limits = shadow.thresholds[sector * THRESHOLD_VECTORS + index];
        reached += select(vec4<u32>(0u), vec4<u32>(1u), vec4<f32>(distance) >= limits);
    }
    return sector * BANDS + min(reached.x + reached.y + reached.z + reached.w, BANDS - 1u);
}
