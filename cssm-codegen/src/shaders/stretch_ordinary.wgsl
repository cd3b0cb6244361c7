// Corners of triangles whose straight edges miss the bent ones by no more than the bound; the others are left to the
// pass that decides texel by texel.

/// Moves a corner from its object to the eye, into the capture's axes; zero where the triangle is left out.
fn capture_position(caster: CasterVertex) -> vec4<f32> {
    let number = caster.number % 3u;
    let first = caster.number - number;
    let positions = array<vec4<f32>, 3>(
        corner_position(caster, first),
        corner_position(caster, first + 1u),
        corner_position(caster, first + 2u),
    );
    let position = select(select(positions[2], positions[1], number == 1u), positions[0], number == 0u);
    if is_bent() {
        let one = straight_corner(positions[0]);
        let two = straight_corner(positions[1]);
        let three = straight_corner(positions[2]);
        if is_outside(one, two, three) || !(triangle_error(one, two, three) <= STRETCH_BOUND) {
            return vec4<f32>(0.0);
        }
    }
    return position;
}

/// Applies the facet's matrix to a position in the capture's axes, and bends its y.
fn tile_position(position: vec4<f32>) -> vec4<f32> {
    if position.w == 0.0 {
        return HIDDEN;
    }
    let corner = straight_corner(position);
    if is_bent() {
        return vec4<f32>(corner.x, remapped(capture.remap, corner.y / corner.w) * corner.w, corner.zw);
    }
    let y = remapped(capture.remap, 0.0) * corner.w + remap_slope(capture.remap, 0.0) * corner.y;
    return vec4<f32>(corner.x, y, corner.zw);
}
