// Slot: how texels become visibility. Here: a box as wide everywhere, each texel worth its exact overlap.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver, half_widths: vec2<f32>) -> f32 {
    return lit_in_box(receiver, half_widths, vec2<u32>(GATHERS));
}
