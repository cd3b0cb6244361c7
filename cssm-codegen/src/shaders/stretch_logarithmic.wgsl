// Slot: how edges of casters bend with the rows. Here: by the logarithm of distance, with a kink at the focus and a
// straight line beyond the horizon.

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
    let focus = 1.0 / capture.remap[0].w;
    let before = abs(capture.remap[0].y);
    let after = abs(capture.remap[0].z);
    let span = high - low;
    let relative = span / max(low, horizon);
    let steepest = select(select(max(before, after), after, high <= focus), before, low >= focus);
    let smooth_part = 0.125 * relative * relative * steepest;

    // A kink adds what the change of slope bends.
    let is_kinked = low < focus && focus < high;
    let kink = (focus - low) * (high - focus) / max(span * focus, MIN_SPAN) * abs(before - after);
    return smooth_part + select(0.0, kink, is_kinked);
}

/// Smallest span of k that is divided by.
const MIN_SPAN: f32 = 1e-30;

/// How the rows bend from one k to a larger one.
fn bend_between(low: f32, high: f32) -> Bend {
    let start = remap_slope(capture.remap, low);
    let end = remap_slope(capture.remap, high);
    let focus = capture.remap[0].w;
    if low * focus < 1.0 && high * focus > 1.0 {
        let far = capture.remap[0].z * focus;
        let near = capture.remap[0].y * focus;
        let least = min(min(start, end), min(far, near));
        let most = max(max(start, end), max(far, near));
        let is_up = start > far || far > near || near > end;
        let is_down = start < far || far < near || near < end;
        return Bend(least, most, is_up, is_down);
    }
    return Bend(min(start, end), max(start, end), start > end, start < end);
}
