// Boxes around a receiver: how many gathers read one, and what four gathered texels are worth in it.

/// Overlaps of four texels with a box, in the order of a gather. `offset` leads from the middle of the box to the
/// corner that the texels share.
fn box_overlaps(offset: vec2<f32>, half_widths: vec2<f32>) -> vec4<f32> {
    let middle = clamp(offset, -half_widths, half_widths);
    let before = middle - clamp(offset - 1.0, -half_widths, half_widths);
    let after = clamp(offset + 1.0, -half_widths, half_widths) - middle;
    return vec4<f32>(before.x, after.x, after.x, before.x) * vec4<f32>(after.yy, before.yy);
}

/// Gathers along x and y that read every texel that a box touches.
fn gathers_of_box(middle: vec2<f32>, half_widths: vec2<f32>) -> vec2<u32> {
    let texels = floor(middle + half_widths) - floor(middle - half_widths) + 1.0;
    return vec2<u32>(ceil(0.5 * texels));
}
