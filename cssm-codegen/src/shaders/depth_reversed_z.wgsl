// Slot: what the engine's depth holds. Here: reversed-z, 1 at the near plane.

/// One over the depth in metres at a pixel; 0 where nothing was drawn.
fn inverse_depth_at(pixel: vec2<i32>) -> f32 {
    let stored = textureLoad(scene_depth, pixel, 0);
    return select(0.0, stored * mask.inverse_depth.x + mask.inverse_depth.y, stored > 0.0);
}
