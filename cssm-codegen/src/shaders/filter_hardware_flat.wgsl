// Slot: how texels become visibility. Here: the comparison sampler blends four texels, one reference.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver) -> f32 {
    return lit_by_sampler(receiver.texel, receiver.reference);
}
