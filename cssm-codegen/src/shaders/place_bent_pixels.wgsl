// From a point in the case's axes to its place in a facet's tile, whose rows are bent: y/w is one over a distance, and
// a remap takes it to the tile. The kernel needs both, and the size of a screen pixel there.

/// Where a receiver falls in its facet.
struct Place {
    /// Clip space of the tile after division: x and y in [-1, 1], z growing away from the light.
    ndc: vec3<f32>,
    /// What was divided by.
    w: f32,
    /// Metres that a screen pixel spans at the point's depth.
    pixel_metres: f32,
    /// What the remap took to y: one over distance in metres.
    inverse_distance: f32,
    /// Map texel coordinates; texel centres lie at .5, y grows down.
    texel: vec2<f32>,
    /// Whether every texel that a filter takes here belongs to the tile.
    covered: bool,
}

/// Applies a facet's matrix, row by row, to a position relative to the eye.
fn place_in_facet(facet: Facet, position: vec3<f32>) -> Place {
    let point = vec4<f32>(position, 1.0);
    let w = dot(facet.row_w, point);
    let clip = vec3<f32>(dot(facet.row_x, point), dot(facet.row_y, point), dot(facet.row_z, point));
    let straight = clip / w;
    let ndc = vec3<f32>(straight.x, remapped(facet.remap, straight.y), straight.z);
    let texel = ndc.xy * facet.texel_from_ndc.xy + facet.texel_from_ndc.zw;

    // Facets without receivers are all zero, so w refuses them.
    let inside = all(texel >= facet.texel_limits.xy) && all(texel <= facet.texel_limits.zw);
    let pixel_metres = dot(shadow.pixel_metres, point);
    return Place(ndc, w, pixel_metres, straight.y, texel, w > 0.0 && inside);
}
