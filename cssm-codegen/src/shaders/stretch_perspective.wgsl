// Slot: how edges of casters bend with the rows. Here: by the perspective of an eye that is pushed back.

/// Whether the facet's rows are bent at all.
fn is_bent() -> bool {
    return capture.remap.z != 0.0;
}

/// Largest distance, in clip y, between the bent rows from one k to a larger one and the chord across them.
fn chord_error(low: f32, high: f32) -> f32 {
    let low_root = inverseSqrt(max(1.0 + capture.remap.z * low, SMALLEST_DIVISOR));
    let high_root = inverseSqrt(max(1.0 + capture.remap.z * high, SMALLEST_DIVISOR));
    let gap = low_root - high_root;
    return abs(capture.remap.y / capture.remap.z) * gap * gap;
}

/// How the rows bend from one k to a larger one.
fn bend_between(low: f32, high: f32) -> Bend {
    let start = remap_slope(capture.remap, low);
    let end = remap_slope(capture.remap, high);
    return Bend(min(start, end), max(start, end), start > end, start < end);
}
