// Renders the triangles that bent rows bend too far for straight edges, texel by texel (camera space shadow maps,
// section 4). Every triangle gets twelve corners: a fan of six around it, or none.

/// What the vertex stage of the bent capture hands to its fragment stage.
struct BentCaster {
    /// Position in the tile.
    @builtin(position) tile: vec4<f32>,
    /// First corner of the triangle.
    @location(0) @interpolate(flat) one: vec4<f32>,
    /// Second corner.
    @location(1) @interpolate(flat) two: vec4<f32>,
    /// Third corner.
    @location(2) @interpolate(flat) three: vec4<f32>,
    /// Its straight edges.
    @location(3) @interpolate(flat) chords: vec4<f32>,
}

/// Places a corner of what covers a triangle in the tile.
@vertex
fn capture_bent_vertex(caster: CasterVertex) -> BentCaster {
    let first = fan_triangle(caster.number);
    let one = straight_corner(corner_position(caster, first));
    let two = straight_corner(corner_position(caster, first + 1u));
    let three = straight_corner(corner_position(caster, first + 2u));
    let is_ordinary = !is_bent() || triangle_error(one, two, three) <= STRETCH_BOUND * SURE_BOUND;
    if is_ordinary || is_outside(one, two, three) {
        return BentCaster(HIDDEN, one, two, three, vec4<f32>(0.0));
    }
    let triangle = bent_triangle(one, two, three);
    let corner = covering_corner(one, two, three, fan_corner(caster.number));
    return BentCaster(corner, one, two, three, triangle.chords);
}

/// Share of the bound below which the ordinary pass draws a triangle, whatever the last digit of its error.
const SURE_BOUND: f32 = 0.9999;

/// Writes the depth of the triangle where it holds the texel's centre.
@fragment
fn capture_bent_fragment(caster: BentCaster) -> @builtin(frag_depth) f32 {
    let triangle = BentTriangle(caster.one, caster.two, caster.three, caster.chords);
    let shares = bent_shares(triangle, caster.tile.xy);
    if shares.w < 0.0 {
        discard;
    }
    return bent_depth(triangle, shares.xyz);
}
