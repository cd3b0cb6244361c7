// Slot: how stored depths compare with references. Here: depth is stored as it is, 0 towards the light.

/// The nearest depth that the map can hold.
fn held_depth(depth: f32) -> f32 {
    return clamp(depth, 0.0, 1.0);
}

/// Share of light that a stored depth lets through: all or none.
fn lit_by(reference: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, reference <= stored);
}

/// Share of light that each of four stored depths lets through: all or none.
fn lit_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return select(vec4<f32>(0.0), vec4<f32>(1.0), references <= stored);
}

/// How far each of four stored depths lies before its reference.
fn before_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return references - stored;
}

/// A stored depth as references are: growing away from the light.
fn comparable_depth(stored: f32) -> f32 {
    return stored;
}

/// The depth nearest to the light.
fn nearest_depth() -> f32 {
    return 0.0;
}
