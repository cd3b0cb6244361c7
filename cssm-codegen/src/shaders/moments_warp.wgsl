// Depths as moments take them (Lauritzen and McCool, layered variance shadow maps, 2008): warped so that what lies
// before a receiver weighs the less the farther before it lies.

/// A depth that grows away from the light, warped.
fn warped(depth: f32) -> f32 {
    return exp(EXPONENT * (depth - nearest_depth()));
}
