// The function that materials and the mask pass call. Here: several facets, a bias that reads no normal, a light that
// stands near, planes with masks.

/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
/// `position` is relative to the eye, in the case's axes and metres. The function takes no derivatives, so any control
/// flow may call it.
fn visibility(position: vec3<f32>) -> f32 {
    let point = facet_position(position);
    let facet = own_facet(point);
    let place = place_in_facet(facet, point);
    if !place.covered {
        return 1.0;
    }
    let plane = masked_plane(position);
    if plane < GROUND_PLANES {
        return masked_visibility(place, plane);
    }
    return filtered_visibility(biased_receiver(facet, place, position));
}
