// Renders casters with an alpha mask into one tile of the map on devices that cannot leave depth unclipped.

/// What the vertex stage of the clamped, tested capture hands to its fragment stage.
struct TestedCaster {
    /// Position in the tile, at a depth that no clip plane meets.
    @builtin(position) tile: vec4<f32>,
    /// Clip z of the facet: depth times w.
    @location(0) depth_times_w: f32,
    /// Clip w of the facet.
    @location(1) w: f32,
    /// Coordinates of the caster's mask.
    @location(2) uv: vec2<f32>,
}

/// Places a caster's vertex in the tile, but keeps its depth for the fragment stage.
@vertex
fn capture_tested_clamped_vertex(vertex: CasterVertex, @location(4) uv: vec2<f32>) -> TestedCaster {
    let tile = tile_position(capture_position(vertex));
    return TestedCaster(hidden_depth(tile), tile.z, tile.w, uv);
}

/// Leaves the caster's holes out and writes the depth that an unclipped capture would store.
@fragment
fn capture_tested_clamped_fragment(caster: TestedCaster) -> @builtin(frag_depth) f32 {
    if is_hole(caster.uv) {
        discard;
    }
    return clamped_depth(caster.depth_times_w, caster.w);
}
