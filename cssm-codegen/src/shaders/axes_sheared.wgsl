// Slot: the axes that facets are evaluated in. Here: the camera's, sheared along the light. Two of three coordinates
// then hold no part along the light, so nothing cancels where a receiver lies far along its ray.

/// Two to the power of -23: the last bit of a float's mantissa.
const LAST_BIT: f32 = 1.1920928955078125e-7;

/// The position as facet rows take it: moved along the light to the plane z = 0, z kept.
///
/// What is added may cancel the position nearly, so its products must not be rounded, and a fused multiplication is not
/// to be had everywhere. The leading parts of the shear have twelve bits; so have both halves of z. The lower half is
/// taken as a whole number, from which no compiler finds the way back to one rounded product.
fn facet_position(position: vec3<f32>) -> vec3<f32> {
    // Split z.
    let bits = bitcast<u32>(position.z);
    let upper = bitcast<f32>(bits & 0xfffff000u);
    let lower = f32(bits & 0xfffu);
    let step = bitcast<f32>(bits & 0xff800000u) * LAST_BIT;

    // Add the largest product first: each sum is exact while it cancels.
    var moved = position.xy + shadow.shear.xy * upper;
    moved += (shadow.shear.xy * step) * lower;
    moved += shadow.shear.zw * position.z;
    return vec3<f32>(moved, position.z);
}
