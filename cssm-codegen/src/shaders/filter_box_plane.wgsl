// Filters with kernels: every texel is compared with the receiver's plane at its own centre.

/// Share of light in a box around the receiver, read by so many gathers along x and y.
fn lit_in_box(receiver: Receiver, half_widths: vec2<f32>, gathers: vec2<u32>) -> f32 {
    // Gather around corners that four texels share, from the first texel that the box touches.
    let first = floor(receiver.texel - half_widths) + 1.0;
    var lit = 0.0;
    for (var row = 0u; row < gathers.y; row++) {
        for (var column = 0u; column < gathers.x; column++) {
            let corner = first + 2.0 * vec2<f32>(f32(column), f32(row));
            let stored = textureGather(map, map_sampler, corner / MAP_SIZE);

            // Follow the plane to each centre; a gather begins at the lower left and runs against the clock.
            let offset = corner - receiver.texel;
            let references = vec4<f32>(
                plane_reference(receiver, offset + vec2<f32>(-0.5, 0.5)),
                plane_reference(receiver, offset + vec2<f32>(0.5, 0.5)),
                plane_reference(receiver, offset + vec2<f32>(0.5, -0.5)),
                plane_reference(receiver, offset + vec2<f32>(-0.5, -0.5)),
            );

            // Compare, and weigh by overlap.
            let passed = lit_by_four(references, stored);
            lit += dot(passed, box_overlaps(offset, half_widths));
        }
    }
    return clamp(lit / (4.0 * half_widths.x * half_widths.y), 0.0, 1.0);
}
