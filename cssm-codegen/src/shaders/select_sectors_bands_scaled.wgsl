// Slot: which facet a receiver belongs to. Here: bands of distance in each sector around the eye; under a light that
// stands near each sector's band limits are multiples of a row of its own.

/// Finds the facet of a receiver: its sector, then the number of that sector's thresholds that its distance has
/// reached.
fn facet_index(position: vec3<f32>) -> u32 {
    let sector = sector_index(position);
    let point = vec4<f32>(position, 1.0);
    let distance = vec4<f32>(dot(shadow.distances[sector], point));
    let unit = dot(shadow.units[sector], point);
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < THRESHOLD_VECTORS; index += 1u) {
        let limits = shadow.thresholds[sector * THRESHOLD_VECTORS + index] * unit;
        reached += select(vec4<u32>(0u), vec4<u32>(1u), distance >= limits);
    }
    return sector * BANDS + min(reached.x + reached.y + reached.z + reached.w, BANDS - 1u);
}
