// What an edge needs to know of the rows between its ends.

/// How rows bend between two k.
struct Bend {
    /// Least change of clip y per change of k.
    least: f32,
    /// Greatest change.
    most: f32,
    /// Whether rows lie above the chord.
    is_up: bool,
    /// Whether rows lie below the chord.
    is_down: bool,
}

/// Whether a bent edge bulges out of its triangle; `inner` is positive where the inside lies to the left of the way
/// from one end to the other, x to the right and y up.
fn bulges_out(bend: Bend, width: f32, inner: f32) -> bool {
    return select(bend.is_down, bend.is_up, inner * width < 0.0);
}

/// Texels by which a straight edge is widened, so that it meets what a rasteriser makes of the same edge.
const CHORD_MARGIN: f32 = 0.0078125;

/// 1 where clip y grows with k, -1 where it falls.
fn row_sign() -> f32 {
    return sign(remap_slope(capture.remap, capture.stretch_tile.y));
}
