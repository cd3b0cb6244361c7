// The triangle of the mask pass.

/// Covers the image with one triangle: corners (-1, 1), (-1, -3) and (3, 1).
@vertex
fn mask_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    let x = select(-1.0, 3.0, corner == 2u);
    let y = select(1.0, -3.0, corner == 1u);
    return vec4<f32>(x, y, 0.0, 1.0);
}
