// The walk around the eye: neighbouring sectors share a border row, so every point has exactly one sector, also on a
// border.

/// Finds the sector of a receiver: its first border decides the direction, then each border is passed or not.
fn sector_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);

    // Walk forwards from the ring's start up to the first border that is not passed, and backwards from its end down to
    // the first that is: both at once, without a branch.
    var is_ahead = 1u;
    var forwards = 0u;
    var backwards = 0u;
    for (var border = 1u; border < SECTORS; border += 1u) {
        let is_passed = dot(shadow.borders[border], point) >= 0.0;
        is_ahead = select(0u, is_ahead, is_passed);
        forwards += is_ahead;
        backwards = select(backwards, border, is_passed);
    }
    return select(backwards, forwards, dot(shadow.borders[0], point) >= 0.0);
}
