// Depth on devices that cannot leave it unclipped: the vertex stage hides it from the clipper, the fragment stage
// clamps it.

/// A position of the tile at a depth that no clip plane meets: half way between the clipper's limits.
fn hidden_depth(tile: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(tile.xy, 0.5 * tile.w, tile.w);
}

/// The depth that an unclipped capture would store, from the facet's clip z and w.
fn clamped_depth(depth_times_w: f32, w: f32) -> f32 {
    return clamp(depth_times_w / w, 0.0, 1.0);
}
