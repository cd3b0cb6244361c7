// Slot: how texels become visibility. Here: a box of the kernel's width, each texel worth its exact overlap.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver, half_widths: vec2<f32>) -> f32 {
    return lit_in_box(receiver, half_widths, gathers_of_box(receiver.texel, half_widths));
}
