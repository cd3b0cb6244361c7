// Slot: how the reference is kept off the receiver's own texels. Here: by the receiver's own plane, which is exact in
// every facet; half a texel under a light that stands near, rounding, and what casters' edges may be off along the rows
// are left to a bias.

/// The receiver with the plane through it; a normal of any length will do.
fn biased_receiver(facet: Facet, place: Place, position: vec3<f32>, normal: vec3<f32>) -> Receiver {
    let gradient = plane_gradient(facet, place, facet_normal(normal));
    let texel_part = facet.receiver_plane_depth * per_light_distance(position);
    let lowered = texel_part + facet.rounding_depth + STRETCH_BOUND * abs(gradient.y);
    return Receiver(place.texel, place.ndc.z - lowered, gradient);
}
