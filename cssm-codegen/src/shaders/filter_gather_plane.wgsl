// Slot: how texels become visibility. Here: four texels are gathered, each compared with the receiver's plane at its
// own centre, and blended.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver) -> f32 {
    // Gather around the corner that the four texels share: rounding cannot reach another four from there.
    let corner = floor(receiver.texel - 0.5) + 1.0;
    let stored = textureGather(map, map_sampler, corner / MAP_SIZE);

    // Follow the plane to each centre; a gather begins at the lower left and runs against the clock.
    let offset = corner - receiver.texel;
    let references = vec4<f32>(
        plane_reference(receiver, offset + vec2<f32>(-0.5, 0.5)),
        plane_reference(receiver, offset + vec2<f32>(0.5, 0.5)),
        plane_reference(receiver, offset + vec2<f32>(0.5, -0.5)),
        plane_reference(receiver, offset + vec2<f32>(-0.5, -0.5)),
    );

    // Compare, then blend.
    let lit = lit_by_four(references, stored);
    let weight = vec2<f32>(0.5) - offset;
    return mix(mix(lit.w, lit.z, weight.x), mix(lit.x, lit.y, weight.x), weight.y);
}
