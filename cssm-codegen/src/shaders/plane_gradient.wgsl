// The receiver's own plane over the map.

/// Largest change of depth from one texel to the next that a plane is followed to: the map's whole range.
const STEEPEST_PLANE: f32 = 1.0;

/// Change of depth per texel along x and y over the plane through a receiver; a normal of any length will do.
fn plane_gradient(facet: Facet, place: Place, normal: vec3<f32>) -> vec2<f32> {
    // Take the gradients of the facet's coordinates; their common factor 1/w cancels below.
    let across = facet.row_x.xyz - place.ndc.x * facet.row_w.xyz;
    let up = up_gradient(facet, place);
    let away = facet.row_z.xyz - place.ndc.z * facet.row_w.xyz;

    // Solve for the depth that x and y change by while the point stays on the plane.
    let area = dot(normal, cross(across, up));
    let slope = vec2<f32>(dot(away, cross(up, normal)), dot(away, cross(normal, across)));

    // Turn it into depth per texel; a plane that the light only grazes is as steep as the map allows.
    let exact = slope / (area * facet.texel_from_ndc.xy);
    let followed = clamp(exact, vec2<f32>(-STEEPEST_PLANE), vec2<f32>(STEEPEST_PLANE));
    return select(followed, vec2<f32>(0.0), area == 0.0);
}
