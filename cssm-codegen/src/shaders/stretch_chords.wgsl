// Which edges of a triangle that is decided texel by texel are straight all the same: those that the ordinary pass may
// draw for the triangle on the other side. No texel falls between both.

/// The triangle of three corners with its straight edges.
fn bent_triangle(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> BentTriangle {
    let inner = inner_side(one, two, three);
    let first = select(0.0, 1.0, is_chord(two, three, inner));
    let second = select(0.0, 2.0, is_chord(three, one, inner));
    let third = select(0.0, 4.0, is_chord(one, two, inner));
    let rows = vec3<f32>(chord_row(one), chord_row(two), chord_row(three));
    return BentTriangle(one, two, three, vec4<f32>(rows, first + second + third));
}

/// Clip y of a corner after division; zero where it has no place.
fn chord_row(corner: vec4<f32>) -> f32 {
    if !has_place(corner) {
        return 0.0;
    }
    return remapped(capture.remap, corner.y / corner.w);
}

/// Whether an edge is taken straight: it misses the bent one by no more than the bound and does not lie within it.
fn is_chord(one: vec4<f32>, two: vec4<f32>, inner: f32) -> bool {
    let error = edge_error(one, two);
    if error > STRETCH_BOUND || !is_bent() {
        return false;
    }
    let start = one.y / one.w;
    let end = two.y / two.w;
    let bend = bend_between(min(start, end), max(start, end));
    return error <= CHORD_MARGIN || !bulges_out(bend, two.x / two.w - one.x / one.w, inner);
}
