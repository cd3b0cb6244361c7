// Slot: how the reference is kept off the receiver's own texels. Here: by a constant distance along the ray of a light
// that stands near.

/// The receiver, moved towards the light by `BIAS_METRES`.
fn biased_receiver(facet: Facet, place: Place, position: vec3<f32>) -> Receiver {
    let depth_per_metre = facet.depth_per_metre * per_light_distance(position);
    return Receiver(place.texel, held_depth(place.ndc.z - BIAS_METRES * depth_per_metre / place.w));
}
