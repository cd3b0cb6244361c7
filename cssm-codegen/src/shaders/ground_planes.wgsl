// Where planes with masks lie in tiles, and how far their masks are blurred there.

/// Smallest standard deviation in texels: what bilinear reading blurs anyway.
const NARROWEST_BLUR: f32 = 0.5;

/// Largest standard deviation in reaches, so that what is cut off does not show.
const WIDEST_BLUR: f32 = 0.4;

/// A vector of a plane in a cell's tile: depth, one over w, squared densities along x and y.
fn ground_vector(cell: u32, plane: u32, vector: u32) -> vec3<f32> {
    return shadow.ground_tiles[(cell * GROUND_PLANES + plane) * 4u + vector].xyz;
}

/// What a Gaussian's exponent is per squared texel, along x (axis 0) or y (axis 1) of the map, for each plane.
fn ground_falloff(cell: u32, texel: GroundPlace, axis: u32) -> vec4<f32> {
    let at = select(texel.place.x, texel.place.y, axis == 1u);
    let slope = select(1.0, texel.slope, axis == 1u);
    let widest = max(WIDEST_BLUR * f32(BLUR), NARROWEST_BLUR);
    var falloff = vec4<f32>(0.0);
    for (var plane = 0u; plane < GROUND_PLANES; plane++) {
        let squared = dot(ground_vector(cell, plane, 2u + axis), vec3<f32>(1.0, at, at * at));
        let per_metre = sqrt(max(squared, 0.0)) * slope * dot(ground_vector(cell, plane, 1u), texel.place);
        let deviation = clamp(BLUR_METRES * per_metre, NARROWEST_BLUR, widest);
        falloff[plane] = -0.5 / (deviation * deviation);
    }
    return falloff;
}
