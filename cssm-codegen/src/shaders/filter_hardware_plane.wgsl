// Slot: how texels become visibility. Here: the comparison sampler blends four texels and takes one reference, so the
// receiver's plane stands where it is nearest to the light.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver) -> f32 {
    // Find the offsets from the receiver to the nearer and the farther texel centres.
    let first = floor(receiver.texel - 0.5) + 0.5 - receiver.texel;
    let second = first + 1.0;

    // Take the plane's point nearest to the light: the axes add up, so each is lowered alone.
    let lowest = min(receiver.gradient * first, receiver.gradient * second);
    let reference = held_depth(receiver.reference + lowest.x + lowest.y);
    return lit_by_sampler(receiver.texel, reference);
}
