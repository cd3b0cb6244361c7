// The walk around the eye in either half of space: a plane through the light parts the halves, and each has a ring of
// sectors. Neighbouring sectors share a border row, so every point has exactly one sector, also on a border.

/// Finds the sector of a receiver, halves counted through: its half, then the direction by the ring's first border,
/// then each border is passed or not.
fn sector_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);
    let start = select(0u, SECTORS, dot(shadow.split, point) < 0.0);
    let end = start + SECTORS - 1u;
    if dot(shadow.borders[start], point) >= 0.0 {
        // Walk forwards from the ring's start.
        var sector = start;
        while sector < end && dot(shadow.borders[sector + 1u], point) >= 0.0 {
            sector += 1u;
        }
        return sector;
    }

    // Walk backwards from the ring's end.
    var sector = end;
    while sector > start && dot(shadow.borders[sector], point) < 0.0 {
        sector -= 1u;
    }
    return sector;
}
