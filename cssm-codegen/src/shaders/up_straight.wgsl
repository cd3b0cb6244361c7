// Slot: how clip y changes around a receiver. Here: rows are straight.

/// Gradient of clip y after division, times w.
fn up_gradient(facet: Facet, place: Place) -> vec3<f32> {
    return facet.row_y.xyz - place.ndc.y * facet.row_w.xyz;
}
