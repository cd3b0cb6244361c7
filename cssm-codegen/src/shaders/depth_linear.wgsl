// Slot: what the engine's depth holds. Here: metres along the view axis.

/// One over the depth in metres at a pixel; 0 where nothing was drawn.
fn inverse_depth_at(pixel: vec2<i32>) -> f32 {
    let metres = textureLoad(scene_depth, pixel, 0).r;
    return select(0.0, 1.0 / metres, metres > 0.0);
}
