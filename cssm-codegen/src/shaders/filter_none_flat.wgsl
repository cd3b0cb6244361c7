// Slot: how texels become visibility. Here: the nearest texel, one reference.

/// Share of light that reaches the receiver: all or none.
fn filtered_visibility(receiver: Receiver) -> f32 {
    let stored = textureLoad(map, vec2<i32>(receiver.texel), 0);
    return lit_by(receiver.reference, stored);
}
