// Slot: how texels become visibility. Here: a box as wide as the edge of the shadow that a light with an extent throws
// (Fernando, percentage-closer soft shadows, 2005), in metres across the light, whatever the facet's warp. Every texel
// of both boxes is read and worth its exact overlap: no noise, and no steps.

/// Share of light that reaches the receiver.
fn filtered_visibility(receiver: Receiver, kernel: Kernel) -> f32 {
    // Average the casters that could reach the receiver, up to the near end of depth.
    let highest = receiver.reference - nearest_depth();
    let search = clamp(kernel.per_depth * highest, vec2<f32>(NARROWEST_KERNEL), kernel.widest);
    let casters = casters_in_box(receiver, search);
    if casters.x <= 0.0 {
        return 1.0;
    }

    // Blend as wide as the light's image through their edge.
    let edge = kernel.per_depth * (casters.y / casters.x);
    let half_widths = clamp(edge, vec2<f32>(NARROWEST_KERNEL), kernel.widest);
    return lit_in_box(receiver, half_widths, gathers_of_box(receiver.texel, half_widths));
}
