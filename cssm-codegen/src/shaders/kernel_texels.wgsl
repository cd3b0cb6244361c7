// Slot: how wide the kernel of the filter is. Here: so many texels, everywhere.

/// Half the widths of the kernel in texels along x and y of the map.
fn kernel_at(facet: Facet, place: Place) -> vec2<f32> {
    return min(vec2<f32>(WIDEST_KERNEL), room_in_tile(facet, place));
}
