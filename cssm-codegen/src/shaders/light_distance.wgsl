// How far a light that stands near is from a receiver. Depth runs with one over the distance from such a light, so that
// a metre along the ray is the less deep the farther it lies.

/// Smallest distance from the light that is told apart, in metres.
const NEAREST_LIGHT: f32 = 1e-6;

/// One over the distance between the light and a position in the case's axes, per metre.
fn per_light_distance(position: vec3<f32>) -> f32 {
    return 1.0 / max(distance(shadow.light_position.xyz, position), NEAREST_LIGHT);
}
