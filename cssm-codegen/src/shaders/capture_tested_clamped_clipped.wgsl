// Renders casters with an alpha mask into one facet's part of a tile on devices that cannot leave depth unclipped or
// have no clip distances.

/// What the vertex stage of the clamped, tested capture hands to its fragment stage.
struct TestedCaster {
    /// Position in the tile, at a depth that no clip plane meets.
    @builtin(position) tile: vec4<f32>,
    /// Clip z of the facet: depth times w.
    @location(0) depth_times_w: f32,
    /// Clip w of the facet.
    @location(1) w: f32,
    /// Distances from the facet's half-spaces.
    @location(2) clips: vec2<f32>,
    /// Coordinates of the caster's mask.
    @location(3) uv: vec2<f32>,
}

/// Places a caster's vertex in the tile, but keeps its depth and the cuts for the fragment stage.
@vertex
fn capture_tested_clamped_vertex(vertex: CasterVertex, @location(4) uv: vec2<f32>) -> TestedCaster {
    let position = capture_position(vertex);
    let tile = tile_position(position);
    return TestedCaster(hidden_depth(tile), tile.z, tile.w, clip_values(position), uv);
}

/// Cuts the caster, leaves its holes out and writes the depth that an unclipped capture would store.
@fragment
fn capture_tested_clamped_fragment(caster: TestedCaster) -> @builtin(frag_depth) f32 {
    // Sample before any fragment is discarded: neighbours measure the change of the coordinates together.
    let hole = is_hole(caster.uv);
    if hole || is_cut(caster.clips) {
        discard;
    }
    return clamped_depth(caster.depth_times_w, caster.w);
}
