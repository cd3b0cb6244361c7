// Slot: how the reference is kept off the receiver's own texels. Here: by a constant distance along the light.

/// The receiver, moved towards the light by `BIAS_METRES`.
fn biased_receiver(facet: Facet, place: Place) -> Receiver {
    let lowered = place.ndc.z - BIAS_METRES * facet.depth_per_metre / place.w;
    return Receiver(place.texel, held_depth(lowered));
}
