// Slot: how stored depths compare with references. Here: each plan chooses which end of stored depth lies towards the
// light. Times the plan's sign every depth grows away from the light; rows and references carry that sign already.

/// The nearest signed depth that the map can hold.
fn held_depth(depth: f32) -> f32 {
    return clamp(depth, min(shadow.depth_sign, 0.0), max(shadow.depth_sign, 0.0));
}

/// Share of light that a stored depth lets through to a signed reference: all or none.
fn lit_by(reference: f32, stored: f32) -> f32 {
    return select(0.0, 1.0, reference <= shadow.depth_sign * stored);
}

/// Share of light that each of four stored depths lets through to its signed reference: all or none.
fn lit_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return select(vec4<f32>(0.0), vec4<f32>(1.0), references <= shadow.depth_sign * stored);
}

/// How far each of four stored depths lies before its signed reference.
fn before_by_four(references: vec4<f32>, stored: vec4<f32>) -> vec4<f32> {
    return references - shadow.depth_sign * stored;
}

/// A stored depth as references are: growing away from the light.
fn comparable_depth(stored: f32) -> f32 {
    return shadow.depth_sign * stored;
}

/// The signed depth nearest to the light.
fn nearest_depth() -> f32 {
    return min(shadow.depth_sign, 0.0);
}
