// Slot: how wide the kernel of the filter is. Here: a distance across the light, so that shadows are as soft in every
// facet.

/// Half the widths of the kernel in texels along x and y of the map.
fn kernel_at(facet: Facet, place: Place) -> vec2<f32> {
    let wanted = KERNEL_METRES * texels_per_metre(facet, place);
    let held = clamp(wanted, vec2<f32>(NARROWEST_KERNEL), vec2<f32>(WIDEST_KERNEL));
    return min(held, room_in_tile(facet, place));
}
