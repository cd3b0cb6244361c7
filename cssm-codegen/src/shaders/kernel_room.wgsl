// How wide a kernel may be where a tile ends.

/// Half the width of the narrowest kernel in texels, which blends bilinearly.
const NARROWEST_KERNEL: f32 = 0.5;

/// Half the widths of the widest kernel in texels that reads its own tile alone.
fn room_in_tile(facet: Facet, place: Place) -> vec2<f32> {
    let inside = min(place.texel - facet.texel_limits.xy, facet.texel_limits.zw - place.texel);
    return inside + NARROWEST_KERNEL;
}
