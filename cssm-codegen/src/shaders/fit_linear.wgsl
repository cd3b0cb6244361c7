// Slot: what the engine's depth holds, for measuring it. Here: metres along the view axis.

/// Depth in metres at a pixel; 0 where nothing was drawn.
fn measured_metres(pixel: vec2<i32>) -> f32 {
    return max(0.0, textureLoad(scene_depth, pixel, 0).r);
}
