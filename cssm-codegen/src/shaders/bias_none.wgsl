// Slot: how the reference is kept off the receiver's own texels. Here: not at all.

/// The receiver as it is.
fn biased_receiver(place: Place) -> Receiver {
    return Receiver(place.texel, held_depth(place.ndc.z));
}
