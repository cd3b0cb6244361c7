// From a pixel to the direction behind it.

/// Direction of a pixel, relative to the eye, in the case's axes, with a depth of one metre.
fn view_ray(pixel: vec2<f32>) -> vec3<f32> {
    let part = pixel / vec2<f32>(textureDimensions(scene_depth));
    return mask.ray_corner.xyz + mask.ray_across.xyz * part.x + mask.ray_down.xyz * part.y;
}
