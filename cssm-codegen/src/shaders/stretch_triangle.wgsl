// A caster's triangle in x/w and k = y/w, where its edges are straight although the tile's rows are bent.

/// Applies the facet's matrix, row by row, to a position in the capture's axes; y/w is k, which is not bent yet.
fn straight_corner(position: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        dot(capture.row_x, position),
        dot(capture.row_y, position),
        dot(capture.row_z, position),
        dot(capture.row_w, position),
    );
}

/// How far from the tile a corner may lie, in tiles, and in multiples of the nearest and farthest k.
const FARTHEST_CORNER: vec3<f32> = vec3<f32>(64.0, 4.0, 0.25);

/// Whether a corner has a place in the bent tile or not too far from it; none has at w = 0 and behind.
fn has_place(corner: vec4<f32>) -> bool {
    let low = min(capture.stretch_tile.x, FARTHEST_CORNER.z * capture.stretch_tile.x);
    let high = FARTHEST_CORNER.y * capture.stretch_tile.y;
    let is_beside = abs(corner.x) <= FARTHEST_CORNER.x * corner.w;
    return corner.w > 0.0 && is_beside && corner.y >= low * corner.w && corner.y <= high * corner.w;
}

/// Whether all of a triangle lies outside one edge of the tile.
fn is_outside(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> bool {
    let x = vec3<f32>(one.x, two.x, three.x);
    let y = vec3<f32>(one.y, two.y, three.y);
    let w = vec3<f32>(one.w, two.w, three.w);
    let is_aside = all(x > w) || all(x < -w);
    let is_before = all(y > capture.stretch_tile.y * w) || all(y < capture.stretch_tile.x * w);
    return is_aside || is_before || all(w <= vec3<f32>(0.0));
}

/// Texels by which an edge with straight ends misses the bent one; beyond any bound where an end has no place.
fn edge_error(one: vec4<f32>, two: vec4<f32>) -> f32 {
    if !(has_place(one) && has_place(two)) {
        return NO_PLACE;
    }
    let start = one.y / one.w;
    let end = two.y / two.w;
    return 0.5 * capture.tile_size.y * chord_error(min(start, end), max(start, end));
}

/// An error beyond any bound.
const NO_PLACE: f32 = 1e30;

/// The largest of a triangle's edges' errors; no point inside is farther off.
fn triangle_error(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> f32 {
    return max(edge_error(one, two), max(edge_error(two, three), edge_error(three, one)));
}

/// A position that no tile shows.
const HIDDEN: vec4<f32> = vec4<f32>(2.0, 2.0, 0.5, 1.0);
