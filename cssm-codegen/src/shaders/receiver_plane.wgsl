// What the filters compare with the map when every texel has a reference of its own: the receiver's plane there.

/// A receiver in the map, with its plane.
struct Receiver {
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Depth of the lowered plane at the receiver itself.
    reference: f32,
    /// Change of the plane's depth per texel along x and y.
    gradient: vec2<f32>,
}

/// Depth of the receiver's plane at an offset in texels, within the depths that the map can hold.
fn plane_reference(receiver: Receiver, offset: vec2<f32>) -> f32 {
    return held_depth(receiver.reference + dot(receiver.gradient, offset));
}
