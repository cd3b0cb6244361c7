// Slot: how the reference is kept off the receiver's own texels. Here: by the receiver's own plane, which is exact in
// every facet, so that only rounding and half a texel are left to a bias.

/// The receiver with the plane through it; a normal of any length will do.
fn biased_receiver(facet: Facet, place: Place, normal: vec3<f32>) -> Receiver {
    let gradient = plane_gradient(facet, place, normal);
    return Receiver(place.texel, place.ndc.z - facet.receiver_plane_depth, gradient);
}
