// Filters that know the light's extent: how far before the receiver its casters lie. Here: every texel is compared
// with the receiver's plane at its own centre.

/// Casters in a box around the receiver: their texels in it (x), and how far in depth they lie before the receiver,
/// summed over these (y).
fn casters_in_box(receiver: Receiver, half_widths: vec2<f32>) -> vec2<f32> {
    // Gather around corners that four texels share, from the first texel that the box touches.
    let gathers = gathers_of_box(receiver.texel, half_widths);
    let first = floor(receiver.texel - half_widths) + 1.0;
    var found = vec2<f32>(0.0);
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

            // Weigh those before the receiver by overlap.
            let before = before_by_four(references, stored);
            let overlaps = box_overlaps(offset, half_widths);
            let weights = select(vec4<f32>(0.0), overlaps, before > vec4<f32>(0.0));
            found += vec2<f32>(dot(weights, vec4<f32>(1.0)), dot(weights, before));
        }
    }
    return found;
}
