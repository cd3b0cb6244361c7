// Slot: how edges of casters bend with the rows. Here: by the logarithm of distance, with a straight line beyond the
// horizon.

/// Largest k of a horizon; rows without any bend end there.
const STRAIGHT_HORIZON: f32 = 1e38;

/// Whether the facet's rows are bent at all.
fn is_bent() -> bool {
    return capture.remap[1].x < STRAIGHT_HORIZON;
}

/// Bound of the distance, in clip y, between the bent rows from one k to a larger one and the chord across them.
fn chord_error(low: f32, high: f32) -> f32 {
    let horizon = capture.remap[1].x;
    if high <= horizon {
        return 0.0;
    }

    // The second derivative is largest where the curve begins.
    let relative = (high - low) / max(low, horizon);
    return 0.125 * relative * relative * abs(remap_slope(capture.remap, high) * high);
}

/// How the rows bend from one k to a larger one.
fn bend_between(low: f32, high: f32) -> Bend {
    let start = remap_slope(capture.remap, low);
    let end = remap_slope(capture.remap, high);
    return Bend(min(start, end), max(start, end), start > end, start < end);
}
