// Slot: which facet a receiver belongs to. Here: one facet for each band of distance.

/// Finds the facet of a receiver: its band is the number of thresholds that its distance has reached.
fn facet_index(position: vec3<f32>) -> u32 {
    let distance = dot(shadow.distances[0], vec4<f32>(position, 1.0));
    var reached = vec4<u32>(0u);
    for (var index = 0u; index < THRESHOLD_VECTORS; index += 1u) {
        reached += select(vec4<u32>(0u), vec4<u32>(1u), vec4<f32>(distance) >= shadow.thresholds[index]);
    }
    return min(reached.x + reached.y + reached.z + reached.w, BANDS - 1u);
}
