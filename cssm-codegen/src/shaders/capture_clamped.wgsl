// Renders casters into one tile of the map on devices that cannot leave depth unclipped.

/// What the vertex stage of the clamped capture hands to its fragment stage.
struct ClampedCaster {
    /// Position in the tile, at a depth that no clip plane meets.
    @builtin(position) tile: vec4<f32>,
    /// Clip z of the facet: depth times w.
    @location(0) depth_times_w: f32,
    /// Clip w of the facet.
    @location(1) w: f32,
}

/// Places a caster's vertex in the tile, but keeps its depth for the fragment stage.
@vertex
fn capture_clamped_vertex(vertex: CasterVertex) -> ClampedCaster {
    let tile = tile_position(capture_position(vertex));
    return ClampedCaster(hidden_depth(tile), tile.z, tile.w);
}

/// Writes the depth that an unclipped capture would store.
@fragment
fn capture_clamped_fragment(caster: ClampedCaster) -> @builtin(frag_depth) f32 {
    return clamped_depth(caster.depth_times_w, caster.w);
}
