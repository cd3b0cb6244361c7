// What is rasterised for a triangle that is decided texel by texel: the polygon of its corners and of the points where
// the tangents of edges that bulge out meet, six corners at most; a box along the longest edge where that is thin; a
// box of the tile where a corner has no place in it.

/// Texels by which a polygon is widened, so that no rounding loses a texel.
const COVER_MARGIN: f32 = 0.0625;
/// Height in texels below which a triangle gets a box.
const THIN: f32 = 1.5;

/// A corner of what covers a triangle; six of them go around it.
fn covering_corner(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, number: u32) -> vec4<f32> {
    if has_place(one) && has_place(two) && has_place(three) {
        return tile_corner(cover(one, two, three, number));
    }
    let box = cut_box(one, two, three);
    if !(box.x <= box.z && box.y <= box.w) {
        return HIDDEN;
    }
    return tile_corner(box_corner(box, number));
}

/// Position in the tile of a point in texels, right and up from the tile's centre.
fn tile_corner(point: vec2<f32>) -> vec4<f32> {
    return vec4<f32>(2.0 * point / capture.tile_size, 0.5, 1.0);
}

/// The point of a corner that has a place, in texels, right and up from the tile's centre.
fn bent_point(corner: vec4<f32>) -> vec2<f32> {
    let y = remapped(capture.remap, corner.y / corner.w);
    return 0.5 * capture.tile_size * vec2<f32>(corner.x / corner.w, y);
}

/// Side on which the inside of a triangle lies: 1 to the left of its edges, x to the right and y up; 0 where rounding
/// could decide.
fn inner_side(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> f32 {
    let start = one.xy / one.w;
    let second = two.xy / two.w - start;
    let third = three.xy / three.w - start;
    let left = second.x * third.y;
    let right = second.y * third.x;
    let turn = left - right;
    return select(0.0, sign(turn) * row_sign(), abs(turn) > SURE_TURN * (abs(left) + abs(right)));
}

/// Share of its parts beyond which a difference has a sure sign.
const SURE_TURN: f32 = 1e-4;

/// A corner of the polygon around a triangle whose corners all have a place.
fn cover(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, number: u32) -> vec2<f32> {
    let at_one = bent_point(one);
    let at_two = bent_point(two);
    let at_three = bent_point(three);
    let first_edge = at_two - at_one;
    let last_edge = at_three - at_one;
    let area = first_edge.x * last_edge.y - first_edge.y * last_edge.x;
    let longest = max(max(length(first_edge), length(last_edge)), distance(at_two, at_three));
    let inner = inner_side(one, two, three);
    if !(area * inner >= THIN * longest) {
        return thin_cover(one, two, three, number);
    }

    // Go around, then away from the centre, by the margin at least.
    var point = at_one;
    switch number {
        case 0u: {}
        case 1u: {
            point = outer_point(one, two, inner);
        }
        case 2u: {
            point = at_two;
        }
        case 3u: {
            point = outer_point(two, three, inner);
        }
        case 4u: {
            point = at_three;
        }
        default: {
            point = outer_point(three, one, inner);
        }
    }
    let centre = (at_one + at_two + at_three) / 3.0;
    return centre + (point - centre) * (1.0 + 3.0 * COVER_MARGIN * longest / (area * inner));
}

/// Where the end tangents of an edge that bulges out meet; the middle of an edge that does not.
fn outer_point(one: vec4<f32>, two: vec4<f32>, inner: f32) -> vec2<f32> {
    let at_one = bent_point(one);
    let way = bent_point(two) - at_one;
    let start = one.y / one.w;
    let end = two.y / two.w;
    let bend = bend_between(min(start, end), max(start, end));
    if !bulges_out(bend, way.x, inner) {
        return at_one + 0.5 * way;
    }

    // Slopes along the edge, from end to end.
    let rise = 0.5 * capture.tile_size.y * (end - start);
    let highest = max(bend.least * rise, bend.most * rise);
    let lowest = min(bend.least * rise, bend.most * rise);
    let is_up = inner * way.x < 0.0;
    let leaving = select(lowest, highest, is_up);
    let arriving = select(highest, lowest, is_up);
    let part = (way.y - arriving) / (leaving - arriving);
    if !(part > 0.0 && part < 1.0) {
        return at_one + 0.5 * way;
    }
    return at_one + vec2<f32>(way.x, leaving) * part;
}

/// A corner of the box around a thin triangle, along its longest edge. Bulges to either side are in it.
fn thin_cover(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>, number: u32) -> vec2<f32> {
    let at_one = bent_point(one);
    let first_edge = bent_point(two) - at_one;
    let last_edge = bent_point(three) - at_one;
    let middle_edge = last_edge - first_edge;
    var longest = first_edge;
    longest = select(longest, last_edge, length(last_edge) > length(longest));
    longest = select(longest, middle_edge, length(middle_edge) > length(longest));
    let size = length(longest);
    let along = select(vec2<f32>(1.0, 0.0), longest / max(size, COVER_MARGIN), size > COVER_MARGIN);
    let axes = mat2x2<f32>(along, vec2<f32>(-along.y, along.x));

    var box = vec4<f32>(0.0);
    box = widened(box, first_edge * axes);
    box = widened(box, last_edge * axes);
    box = widened(box, (outer_point(one, two, 1.0) - at_one) * axes);
    box = widened(box, (outer_point(one, two, -1.0) - at_one) * axes);
    box = widened(box, (outer_point(two, three, 1.0) - at_one) * axes);
    box = widened(box, (outer_point(two, three, -1.0) - at_one) * axes);
    box = widened(box, (outer_point(three, one, 1.0) - at_one) * axes);
    box = widened(box, (outer_point(three, one, -1.0) - at_one) * axes);
    let margin = vec4<f32>(-COVER_MARGIN, -COVER_MARGIN, COVER_MARGIN, COVER_MARGIN);
    return at_one + axes * box_corner(box + margin, number);
}

/// The smallest box that holds a box, given by its least and greatest corner, and a point.
fn widened(box: vec4<f32>, point: vec2<f32>) -> vec4<f32> {
    return vec4<f32>(min(box.xy, point), max(box.zw, point));
}

/// A corner of a box; those after the fourth are the first again.
fn box_corner(box: vec4<f32>, number: u32) -> vec2<f32> {
    let is_right = number == 1u || number == 2u;
    let is_upper = number == 2u || number == 3u;
    return vec2<f32>(select(box.x, box.z, is_right), select(box.y, box.w, is_upper));
}

/// The box, in texels from the tile's centre, around what the tile holds of a triangle; inside out where that is
/// nothing. It is decided where edges are straight: the tile's part of each edge, and the tile's corners that lie
/// inside.
fn cut_box(one: vec4<f32>, two: vec4<f32>, three: vec4<f32>) -> vec4<f32> {
    let limits = capture.stretch_tile;
    var box = vec4<f32>(NO_PLACE, NO_PLACE, -NO_PLACE, -NO_PLACE);
    box = with_edge(box, one, two);
    box = with_edge(box, two, three);
    box = with_edge(box, three, one);
    for (var number = 0u; number < 4u; number++) {
        let corner = box_corner(vec4<f32>(-1.0, limits.x, 1.0, limits.y), number);
        let weights = straight_weights(one, two, three, corner);
        let side = sign(dot(weights, vec3<f32>(one.w, two.w, three.w)));
        if side != 0.0 && all(weights * side >= vec3<f32>(0.0)) {
            box = widened(box, corner);
        }
    }

    // Bend its rows.
    let lower = remapped(capture.remap, box.y);
    let upper = remapped(capture.remap, box.w);
    let scale = 0.5 * vec4<f32>(capture.tile_size, capture.tile_size);
    let bent = vec4<f32>(box.x, min(lower, upper), box.z, max(lower, upper)) * scale;
    return select(bent + vec4<f32>(-1.0, -1.0, 1.0, 1.0), box, vec4<bool>(box.x > box.z));
}

/// A box in x/w and k that also holds the tile's part of an edge.
fn with_edge(box: vec4<f32>, one: vec4<f32>, two: vec4<f32>) -> vec4<f32> {
    // Clip where the tile's four edges are planes through w = 0.
    let start = tile_distances(one);
    let end = tile_distances(two);
    let meets = start / (start - end);
    let entries = select(vec4<f32>(0.0), meets, start < vec4<f32>(0.0));
    let exits = select(vec4<f32>(1.0), meets, end < vec4<f32>(0.0));
    let entry = max(max(entries.x, entries.y), max(entries.z, entries.w));
    let exit = min(min(exits.x, exits.y), min(exits.z, exits.w));
    let is_missed = (start < vec4<f32>(0.0)) & (end < vec4<f32>(0.0));
    if any(is_missed) || entry > exit {
        return box;
    }
    return widened(widened(box, tile_place(mix(one, two, entry))), tile_place(mix(one, two, exit)));
}

/// Distances from the tile's left, right, far and near edge, times w; none is negative inside.
fn tile_distances(corner: vec4<f32>) -> vec4<f32> {
    let limits = capture.stretch_tile.xy * corner.w;
    return vec4<f32>(corner.w + corner.x, corner.w - corner.x, corner.y - limits.x, limits.y - corner.y);
}

/// x/w and k of a point on or inside the tile's edges.
fn tile_place(corner: vec4<f32>) -> vec2<f32> {
    let place = corner.xy / max(corner.w, SMALLEST_SUM);
    return clamp(place, vec2<f32>(-1.0, capture.stretch_tile.x), vec2<f32>(1.0, capture.stretch_tile.y));
}
