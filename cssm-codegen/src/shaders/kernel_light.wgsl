// Slot: how wide the kernel of the filter is. Here: as wide as a light with an extent makes the edge of a shadow.

/// How wide edges of shadows are around a receiver.
struct Kernel {
    /// Half the widths in texels for a caster one unit of depth before the receiver.
    per_depth: vec2<f32>,
    /// Half the widths of the widest kernel in texels.
    widest: vec2<f32>,
}

/// Edges around a receiver.
///
/// Depth times w over depth per metre is the distance between caster and receiver along a directional light's rays; for
/// a light that stands near it is that distance as a multiple of the caster's own from the light. Times the light's
/// radius both are half the edge's width in metres.
fn kernel_at(facet: Facet, place: Place) -> Kernel {
    let radius = LIGHT_RADIUS * place.w / facet.depth_per_metre;
    let widest = min(vec2<f32>(WIDEST_KERNEL), room_in_tile(facet, place));
    return Kernel(radius * texels_per_metre(facet, place), widest);
}
