// Slot: what the engine's depth holds, for measuring it. Here: reversed-z, 1 at the near plane.

/// Depth in metres at a pixel; 0 where nothing was drawn.
fn measured_metres(pixel: vec2<i32>) -> f32 {
    let stored = textureLoad(scene_depth, pixel, 0);
    return select(0.0, 1.0 / (stored * fit.inverse_depth.x + fit.inverse_depth.y), stored > 0.0);
}
