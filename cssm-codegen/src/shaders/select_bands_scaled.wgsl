// Slot: which facet a receiver belongs to. Here: one facet for each band of distance; under a light that stands near
// band limits are multiples of a row of their own.

/// Finds the facet of a receiver: its band is the number of thresholds that its distance has reached.
fn facet_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);
    let distance = vec4<f32>(dot(shadow.distances[0], point));
    let unit = dot(shadow.units[0], point);
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < THRESHOLD_VECTORS; index += 1u) {
        reached += select(vec4<u32>(0u), vec4<u32>(1u), distance >= shadow.thresholds[index] * unit);
    }
    return min(reached.x + reached.y + reached.z + reached.w, BANDS - 1u);
}
