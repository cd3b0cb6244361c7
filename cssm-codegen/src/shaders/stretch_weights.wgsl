// Whether a texel's centre lies in a triangle, in x/w and k = y/w. Corners are moved to the texel before they are
// multiplied, so that edges keep all their digits.

/// Twice the signed area between the origin and two points. Both triangles of an edge get the same digits with opposite
/// signs, so that no texel falls between them.
fn turned(one: vec2<f32>, two: vec2<f32>) -> f32 {
    let is_swapped = one.x > two.x || (one.x == two.x && one.y > two.y);
    let start = select(one, two, is_swapped);
    let end = select(two, one, is_swapped);
    let turn = start.x * end.y - end.x * start.y;
    return select(turn, -turn, is_swapped);
}

/// Weights of a triangle's corners at a place, up to a common factor; inside, all have the sign of their sum times w.
/// Corners at w = 0 and behind are corners like all others (Olano and Greer, triangle scan conversion using 2D
/// homogeneous coordinates).
fn straight_weights(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, place: vec2<f32>) -> vec3<f32> {
    let from_one = one.xy - place * one.w;
    let from_two = two.xy - place * two.w;
    let from_three = three.xy - place * three.w;
    return vec3<f32>(turned(from_two, from_three), turned(from_three, from_one), turned(from_one, from_two));
}

/// Corners of a triangle whose bent edges are decided texel by texel.
struct BentTriangle {
    /// Clip x, k times w, clip z and w of the first corner.
    one: vec4<f32>,
    /// Second corner.
    two: vec4<f32>,
    /// Third corner.
    three: vec4<f32>,
    /// Clip y of the corners after division (xyz), and the sum of 1, 2 and 4 for each of the edges opposite them that
    /// is taken straight, as the triangle on its other side may have it.
    chords: vec4<f32>,
}

/// Share of each corner at a texel of the map (xyz), and 1 inside, -1 outside (w).
fn bent_shares(triangle: BentTriangle, texel: vec2<f32>) -> vec4<f32> {
    let half_size = 0.5 * capture.tile_size;
    let offset = (texel - capture.stretch_tile.zw - half_size) / half_size;
    let ndc = vec2<f32>(offset.x, -offset.y);
    let place = vec2<f32>(ndc.x, unremapped(capture.remap, ndc.y));
    let w = vec3<f32>(triangle.one.w, triangle.two.w, triangle.three.w);
    let unsigned_weights = straight_weights(triangle.one, triangle.two, triangle.three, place);
    let side = sign(dot(unsigned_weights, w));
    let weights = unsigned_weights * side;

    // Straight edges are decided in texels, with a margin that no rasteriser rounds away.
    let x = vec3<f32>(triangle.one.x, triangle.two.x, triangle.three.x) / w;
    let one = (vec2<f32>(x.x, triangle.chords.x) - ndc) * half_size;
    let two = (vec2<f32>(x.y, triangle.chords.y) - ndc) * half_size;
    let three = (vec2<f32>(x.z, triangle.chords.z) - ndc) * half_size;
    let lengths = vec3<f32>(distance(two, three), distance(three, one), distance(one, two));
    let turns = vec3<f32>(turned(two, three), turned(three, one), turned(one, two));
    let chord_tests = turns * side * row_sign() + CHORD_MARGIN * lengths;
    let chords = vec3<u32>(u32(triangle.chords.w)) & vec3<u32>(1u, 2u, 4u);
    let tests = select(weights, chord_tests, chords != vec3<u32>(0u));

    // Beside a straight edge the nearest point of the triangle counts.
    let kept = max(weights, vec3<f32>(0.0));
    let is_inside = all(tests >= vec3<f32>(0.0)) && dot(kept, w) > 0.0;
    return vec4<f32>(kept / max(kept.x + kept.y + kept.z, SMALLEST_SUM), select(-1.0, 1.0, is_inside));
}

/// Smallest sum of weights that is divided by.
const SMALLEST_SUM: f32 = 1e-37;

/// The depth of a triangle's point with these shares of its corners.
fn bent_depth(triangle: BentTriangle, shares: vec3<f32>) -> f32 {
    let z = dot(shares, vec3<f32>(triangle.one.z, triangle.two.z, triangle.three.z));
    let w = dot(shares, vec3<f32>(triangle.one.w, triangle.two.w, triangle.three.w));
    return clamp(z / w, 0.0, 1.0);
}
