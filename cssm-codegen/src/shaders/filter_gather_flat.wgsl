// Slot: how texels become visibility. Here: four texels are gathered, compared with one reference and blended.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver) -> f32 {
    // Gather around the corner that the four texels share: rounding cannot reach another four from there.
    let corner = floor(receiver.texel - 0.5) + 1.0;
    let stored = textureGather(map, map_sampler, corner / MAP_SIZE);

    // Compare, then blend; a gather begins at the lower left and runs against the clock.
    let lit = lit_by_four(vec4<f32>(receiver.reference), stored);
    let weight = receiver.texel + 0.5 - corner;
    return mix(mix(lit.w, lit.z, weight.x), mix(lit.x, lit.y, weight.x), weight.y);
}
