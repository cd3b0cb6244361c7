// Slot: how the comparison sampler gets its reference. Here: the sampler compares stored depth in the plan's direction,
// less or equal, or greater or equal where depth is stored reversed, so the reference loses its sign.

/// Share of light that the four texels around a point of the map let through to a signed reference, blended.
fn lit_by_sampler(texel: vec2<f32>, reference: f32) -> f32 {
    let as_stored = shadow.depth_sign * reference;
    return textureSampleCompareLevel(map, map_sampler, texel / MAP_SIZE, as_stored);
}
