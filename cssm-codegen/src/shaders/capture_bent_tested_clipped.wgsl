// Renders all triangles of casters with an alpha mask, texel by texel (camera space shadow maps, section 4), and
// cuts those of facets that share a tile. Every triangle gets twelve corners: a fan of six around it, or none.

/// What the vertex stage of the bent, tested capture hands to its fragment stage.
struct BentTestedCaster {
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
    /// Coordinates of the mask at the first (xy) and the second (zw) corner.
    @location(4) @interpolate(flat) uvs: vec4<f32>,
    /// Coordinates of the mask at the third corner.
    @location(5) @interpolate(flat) last_uv: vec2<f32>,
    /// Distances of the corners from the facet's first half-space.
    @location(6) @interpolate(flat) first_clips: vec3<f32>,
    /// Distances of the corners from its second half-space.
    @location(7) @interpolate(flat) second_clips: vec3<f32>,
}

/// Places a corner of what covers a triangle in the tile.
@vertex
fn capture_bent_tested_vertex(caster: CasterVertex) -> BentTestedCaster {
    let first = fan_triangle(caster.number);
    let at_one = corner_position(caster, first);
    let at_two = corner_position(caster, first + 1u);
    let at_three = corner_position(caster, first + 2u);
    let one = straight_corner(at_one);
    let two = straight_corner(at_two);
    let three = straight_corner(at_three);
    let clips = mat3x2<f32>(clip_values(at_one), clip_values(at_two), clip_values(at_three));
    var corner = HIDDEN;
    if !is_outside(one, two, three) {
        corner = covering_corner(one, two, three, fan_corner(caster.number));
    }
    let uvs = vec4<f32>(mesh_uv(first), mesh_uv(first + 1u));
    let chords = bent_triangle(one, two, three).chords;
    return BentTestedCaster(
        corner,
        one,
        two,
        three,
        chords,
        uvs,
        mesh_uv(first + 2u),
        vec3<f32>(clips[0].x, clips[1].x, clips[2].x),
        vec3<f32>(clips[0].y, clips[1].y, clips[2].y),
    );
}

/// Leaves the caster's holes out and writes the depth of the triangle where it holds the texel's centre.
@fragment
fn capture_bent_tested_fragment(caster: BentTestedCaster) -> @builtin(frag_depth) f32 {
    let triangle = BentTriangle(caster.one, caster.two, caster.three, caster.chords);
    let shares = bent_shares(triangle, caster.tile.xy);

    // Sample before any fragment is discarded: neighbours measure the change of the coordinates together.
    let uvs = mat3x2<f32>(caster.uvs.xy, caster.uvs.zw, caster.last_uv);
    let hole = is_hole(uvs * shares.xyz);
    let clips = vec2<f32>(dot(caster.first_clips, shares.xyz), dot(caster.second_clips, shares.xyz));
    if hole || shares.w < 0.0 || is_cut(clips) {
        discard;
    }
    return bent_depth(triangle, shares.xyz);
}
