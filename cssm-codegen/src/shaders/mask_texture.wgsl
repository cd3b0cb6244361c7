// The mask pass: the normal comes from the engine.

/// Writes the visibility of the surface behind a pixel to red; sky is lit.
@fragment
fn mask_fragment(@builtin(position) pixel: vec4<f32>) -> @location(0) vec4<f32> {
    let inverse_depth = inverse_depth_at(vec2<i32>(pixel.xy));
    if inverse_depth <= 0.0 {
        return vec4<f32>(1.0, 0.0, 0.0, 1.0);
    }
    let position = view_ray(pixel.xy) / inverse_depth;
    let normal = textureLoad(scene_normal, vec2<i32>(pixel.xy), 0).xyz;
    let lit = visibility(position, normal);
    return vec4<f32>(lit, 0.0, 0.0, 1.0);
}
