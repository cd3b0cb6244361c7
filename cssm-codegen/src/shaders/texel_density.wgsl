// How close texels lie around a receiver.

/// Texels per metre across the light along x and y of the map.
fn texels_per_metre(facet: Facet, place: Place) -> vec2<f32> {
    let across = facet.row_x.xyz - place.ndc.x * facet.row_w.xyz;
    let up = up_gradient(facet, place);
    let lengths = vec2<f32>(gradient_length(across), gradient_length(up));
    return lengths * abs(facet.texel_from_ndc.xy) / place.w;
}
