// Slot: how the comparison sampler gets its reference. Here: depth is stored as it is, and the sampler compares less or
// equal.

/// Share of light that the four texels around a point of the map let through, blended.
fn lit_by_sampler(texel: vec2<f32>, reference: f32) -> f32 {
    return textureSampleCompareLevel(map, map_sampler, texel / MAP_SIZE, reference);
}
