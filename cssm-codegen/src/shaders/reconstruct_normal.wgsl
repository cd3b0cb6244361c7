// The geometric normal behind a pixel, from depth alone. One over depth is affine in the image over any plane, so two
// neighbours on the same surface predict the centre exactly: the side that predicts it better is the side that lies
// on the surface, also beside silhouettes and creases.

/// Change of one over depth per pixel along one axis of the image.
fn inverse_depth_slope(pixel: vec2<i32>, axis: vec2<i32>, centre: f32) -> f32 {
    // Take two neighbours on either side; beyond the image's edge the nearest pixel stands in.
    let last = vec2<i32>(textureDimensions(scene_depth)) - 1;
    let behind_near = inverse_depth_at(max(pixel - axis, vec2<i32>(0)));
    let behind_far = inverse_depth_at(max(pixel - 2 * axis, vec2<i32>(0)));
    let ahead_near = inverse_depth_at(min(pixel + axis, last));
    let ahead_far = inverse_depth_at(min(pixel + 2 * axis, last));

    // Prefer the side that predicts the centre better, unless the image ends there.
    let behind_error = abs(2.0 * behind_near - behind_far - centre);
    let ahead_error = abs(2.0 * ahead_near - ahead_far - centre);
    let behind_ends = any(pixel - 2 * axis < vec2<i32>(0));
    let ahead_ends = any(pixel + 2 * axis > last);
    let behind_is_better = !behind_ends && (ahead_ends || behind_error <= ahead_error);
    return select(ahead_near - centre, centre - behind_near, behind_is_better);
}

/// Unit normal of the surface behind a pixel, in the case's axes, on the side that faces the eye.
fn reconstructed_normal(pixel: vec2<i32>, ray: vec3<f32>, inverse_depth: f32) -> vec3<f32> {
    // Measure how one over depth changes across the whole image and down it.
    let size = vec2<f32>(textureDimensions(scene_depth));
    let across_slope = inverse_depth_slope(pixel, vec2<i32>(1, 0), inverse_depth) * size.x;
    let down_slope = inverse_depth_slope(pixel, vec2<i32>(0, 1), inverse_depth) * size.y;

    // Cross the two tangents of ray / inverse_depth; this sum is free of divisions.
    let across = mask.ray_across.xyz;
    let down = mask.ray_down.xyz;
    let level = inverse_depth * cross(across, down);
    let normal = level + across_slope * cross(down, ray) + down_slope * cross(ray, across);
    return normalize(select(normal, -normal, dot(normal, ray) > 0.0));
}
