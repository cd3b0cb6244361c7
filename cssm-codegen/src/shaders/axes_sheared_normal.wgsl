// Slot: a normal in the axes that facets are evaluated in. Here: the camera's, sheared along the light. Normals turn
// against positions, so that planes stay where they are.

/// The normal as facet rows take it.
fn facet_normal(normal: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(normal.xy, normal.z - dot(shadow.shear.xy + shadow.shear.zw, normal.xy));
}
