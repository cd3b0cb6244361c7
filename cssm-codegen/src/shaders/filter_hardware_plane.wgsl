// Slot: how texels become visibility. Here: the comparison sampler blends four texels and takes one reference, so the
// receiver's plane stands at its lowest of the four.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver) -> f32 {
    // Find the offsets from the receiver to the nearer and the farther texel centres.
    let first = floor(receiver.texel - 0.5) + 0.5 - receiver.texel;
    let second = first + 1.0;

    // Take the plane's lowest point: the axes add up, so each is lowered alone.
    let lowest = min(receiver.gradient * first, receiver.gradient * second);
    let reference = clamp(receiver.reference + lowest.x + lowest.y, 0.0, 1.0);
    return textureSampleCompareLevel(map, map_sampler, receiver.texel / MAP_SIZE, reference);
}
