// What the filters compare with the map when all of a receiver's texels share one reference.

/// A receiver in the map.
struct Receiver {
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Depth below which a stored depth shadows the receiver.
    reference: f32,
}
