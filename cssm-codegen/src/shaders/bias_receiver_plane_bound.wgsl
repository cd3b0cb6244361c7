// Slot: how the reference is kept off the receiver's own texels. Here: by the receiver's own plane, which is exact in
// every facet; rounding, half a texel, and what casters' edges may be off along the rows are left to a bias.

/// The receiver with the plane through it; a normal of any length will do.
fn biased_receiver(facet: Facet, place: Place, normal: vec3<f32>) -> Receiver {
    let gradient = plane_gradient(facet, place, normal);
    let lowered = facet.receiver_plane_depth + STRETCH_BOUND * abs(gradient.y);
    return Receiver(place.texel, place.ndc.z - lowered, gradient);
}
