// The function that materials and the mask pass call. Here: one facet, no bias, a filter with a kernel.

/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
/// `position` is relative to the eye, in the case's axes and metres. The function takes no derivatives, so any control
/// flow may call it.
fn visibility(position: vec3<f32>) -> f32 {
    let facet = shadow.facets[0];
    let place = place_in_facet(facet, facet_position(position));
    if !place.covered {
        return 1.0;
    }
    let receiver = biased_receiver(place);
    return filtered_visibility(receiver, kernel_at(facet, place));
}
