// Slot: the axes that facets are evaluated in. Here: the camera's, sheared along the light. Two of three coordinates
// then hold no part along the light, so nothing cancels where a receiver lies far along its ray.

/// The position as facet rows take it: moved along the light to the plane z = 0, z kept.
fn facet_position(position: vec3<f32>) -> vec3<f32> {
    let leading = fma(shadow.shear.xy, vec2<f32>(position.z), position.xy);
    return vec3<f32>(leading + shadow.shear.zw * position.z, position.z);
}
