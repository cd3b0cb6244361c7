// Slot: how the reference is kept off the receiver's own texels. Here: by the receiver's own plane, which is exact in
// every facet, so that only rounding and half a texel are left to a bias.

/// Largest change of depth from one texel to the next that a plane is followed to: the map's whole range.
const STEEPEST_PLANE: f32 = 1.0;

/// The receiver with the plane through it; a normal of any length will do.
fn biased_receiver(facet: Facet, place: Place, normal: vec3<f32>) -> Receiver {
    // Take the gradients of the facet's coordinates; their common factor 1/w cancels below.
    let across = facet.row_x.xyz - place.ndc.x * facet.row_w.xyz;
    let up = facet.row_y.xyz - place.ndc.y * facet.row_w.xyz;
    let away = facet.row_z.xyz - place.ndc.z * facet.row_w.xyz;

    // Solve for the depth that x and y change by while the point stays on the plane.
    let area = dot(normal, cross(across, up));
    let slope = vec2<f32>(dot(away, cross(up, normal)), dot(away, cross(normal, across)));

    // Turn it into depth per texel; a plane that the light only grazes is as steep as the map allows.
    let exact = slope / (area * facet.texel_from_ndc.xy);
    let followed = clamp(exact, vec2<f32>(-STEEPEST_PLANE), vec2<f32>(STEEPEST_PLANE));
    let gradient = select(followed, vec2<f32>(0.0), area == 0.0);
    return Receiver(place.texel, place.ndc.z - facet.receiver_plane_depth, gradient);
}
