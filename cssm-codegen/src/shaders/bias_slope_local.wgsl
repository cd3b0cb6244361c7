// Slot: how the reference is kept off the receiver's own texels. Here: by the depth that the surface changes across
// `BIAS_TEXELS` of its texels, under a light that stands near.

/// Smallest cosine between normal and light that still widens the bias.
const SMALLEST_COSINE: f32 = 0.01;

/// The receiver, moved towards the light in proportion to the tangent of the angle between normal and light.
///
/// A texel is `texel_metres_per_w * w` wide and a metre is `depth_per_metre / w` deep, so w leaves the product.
fn biased_receiver(facet: Facet, place: Place, position: vec3<f32>, normal: vec3<f32>) -> Receiver {
    let per_distance = per_light_distance(position);
    let toward_light = (shadow.light_position.xyz - position) * per_distance;
    let cosine = clamp(dot(normal, toward_light), SMALLEST_COSINE, 1.0);
    let tangent = sqrt(1.0 - cosine * cosine) / cosine;
    let depth_per_metre = facet.depth_per_metre * per_distance;
    let lowered = place.ndc.z - BIAS_TEXELS * facet.texel_metres_per_w * depth_per_metre * tangent;
    return Receiver(place.texel, held_depth(lowered));
}
