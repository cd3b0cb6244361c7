// The walk around the eye: neighbouring sectors share a border row, so every point has exactly one sector, also on a
// border.

/// Finds the sector of a receiver: its first border decides the direction, then each border is passed or not.
fn sector_index(position: vec3<f32>) -> u32 {
    let point = vec4<f32>(position, 1.0);
    if dot(shadow.borders[0], point) >= 0.0 {
        // Walk forwards from the ring's start.
        var sector = 0u;
        while sector < SECTORS - 1u && dot(shadow.borders[sector + 1u], point) >= 0.0 {
            sector += 1u;
        }
        return sector;
    }

    // Walk backwards from the ring's end.
    var sector = SECTORS - 1u;
    while sector > 0u && dot(shadow.borders[sector], point) < 0.0 {
        sector -= 1u;
    }
    return sector;
}
