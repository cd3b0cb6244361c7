// Slot: how the reference is kept off the receiver's own texels. Here: by a distance in the world plus a multiple of
// the local texel ("Perspective Shadow Maps: Care and Feeding", GPU Gems, chapter 14), along the ray of a light that
// stands near.

/// The receiver, moved towards the light by `BIAS_A_METRES` and `BIAS_B_TEXELS` of its texels.
///
/// A texel is `texel_metres_per_w * w` wide and a metre is `depth_per_metre / w` deep, so w leaves the second part.
fn biased_receiver(facet: Facet, place: Place, position: vec3<f32>) -> Receiver {
    let depth_per_metre = facet.depth_per_metre * per_light_distance(position);
    let constant_part = BIAS_A_METRES * depth_per_metre / place.w;
    let texel_part = BIAS_B_TEXELS * facet.texel_metres_per_w * depth_per_metre;
    return Receiver(place.texel, held_depth(place.ndc.z - constant_part - texel_part));
}
