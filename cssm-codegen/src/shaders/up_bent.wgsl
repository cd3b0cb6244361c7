// Slot: how clip y changes around a receiver. Here: rows are bent, so it changes with one over distance, times the
// slope of the remap.

/// Gradient of clip y after division, times w.
fn up_gradient(facet: Facet, place: Place) -> vec3<f32> {
    let straight = facet.row_y.xyz - place.inverse_distance * facet.row_w.xyz;
    return straight * remap_slope(facet.remap, place.inverse_distance);
}
