// Receivers on planes that shadow nothing on themselves: their masks hold what stands before them, blurred by the
// prefilter, and need no comparison.

/// How far a receiver may lie from a plane, relative to the terms of its distance: what rounding makes of its position.
const GROUND_ROUNDING: f32 = 4e-6;

/// The plane that a receiver in the case's axes lies on; as many as there are where it lies on none.
fn masked_plane(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);
    for (var plane = 0u; plane < GROUND_PLANES; plane++) {
        let row = shadow.ground_planes[plane];
        if abs(dot(row, point)) <= GROUND_ROUNDING * dot(abs(row), abs(point)) {
            return plane;
        }
    }
    return GROUND_PLANES;
}

/// Share of light that reaches a receiver on a plane.
fn masked_visibility(place: Place, plane: u32) -> f32 {
    let covered = textureSampleLevel(ground_masks, ground_sampler, place.texel / MAP_SIZE, 0.0);
    return 1.0 - covered[plane];
}
