// The function that materials and the mask pass call. Here: one facet, a bias that reads the normal, planes with
// masks.

/// Share of the light that reaches a receiver: 1 in the light and outside the map, 0 in shadow.
///
/// `position` is relative to the eye, in metres; `normal` is the geometric normal there; both are in the case's axes.
/// The function takes no derivatives, so any control flow may call it.
fn visibility(position: vec3<f32>, normal: vec3<f32>) -> f32 {
    let facet = shadow.facets[0];
    let place = place_in_facet(facet, facet_position(position));
    if !place.covered {
        return 1.0;
    }
    let plane = masked_plane(position);
    if plane < GROUND_PLANES {
        return masked_visibility(place, plane);
    }
    return filtered_visibility(biased_receiver(facet, place, facet_normal(normal)));
}
