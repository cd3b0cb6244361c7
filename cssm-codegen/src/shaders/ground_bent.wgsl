// Slot: where a texel lies in a facet's image, before rows are bent. Here: y/w is one over a distance, and a remap has
// taken it to the tile.

/// A texel's centre in a facet's image.
struct GroundPlace {
    /// Clip x/w and y/w, and 1.
    place: vec3<f32>,
    /// How steeply rows are bent there.
    slope: f32,
}

/// Where a texel's centre lies.
fn ground_place(cell: u32, texel: vec2<i32>) -> GroundPlace {
    let texel_from_ndc = shadow.facets[cell].texel_from_ndc;
    let ndc = (vec2<f32>(texel) + 0.5 - texel_from_ndc.zw) / texel_from_ndc.xy;
    let up = unremapped(shadow.facets[cell].remap, ndc.y);
    let slope = abs(remap_slope(shadow.facets[cell].remap, up));
    return GroundPlace(vec3<f32>(ndc.x, up, 1.0), slope);
}
