// Slot: how texels become visibility. Here: the nearest texel, compared with the receiver's plane at its centre.

/// Share of light that reaches the receiver: all or none.
fn filtered_visibility(receiver: Receiver) -> f32 {
    let nearest = floor(receiver.texel);
    let stored = textureLoad(map, vec2<i32>(nearest), 0);
    let reference = plane_reference(receiver, nearest + 0.5 - receiver.texel);
    return lit_by(reference, stored);
}
