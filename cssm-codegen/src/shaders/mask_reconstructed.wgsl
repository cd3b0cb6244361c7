// The mask pass: the normal comes from neighbouring depths.

/// Writes the visibility of the surface behind a pixel to red; sky is lit.
@fragment
fn mask_fragment(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let inverse_depth = inverse_depth_at(vec2<i32>(pixel.xy));
    if inverse_depth <= 0.0 {
        return vec4<f32>(1.0, 0.0, 0.0, 1.0);
    }
    let ray = view_ray(pixel.xy);
    let normal = reconstructed_normal(vec2<i32>(pixel.xy), ray, inverse_depth);
    let lit = visibility(ray / inverse_depth, normal);
    return vec4<f32>(lit, 0.0, 0.0, 1.0);
}
