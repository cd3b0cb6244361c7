// From the capture's axes to the facet's tile, whose rows are bent: clip y/w is one over a distance, and a remap takes
// it to the tile. Only corners are bent; x and depth stay as they are.

/// Applies the facet's matrix, row by row, to a position in the capture's axes, and bends its y.
fn tile_position(position: vec4<f32>) -> vec4<f32> {
    let straight = dot(capture.row_y, position);
    let w = dot(capture.row_w, position);
    return vec4<f32>(dot(capture.row_x, position), bent_y(straight, w), dot(capture.row_z, position), w);
}

/// Clip y of a corner. A corner nearer than the tile reaches, w = 0 and beyond, has no place in bent rows: it follows
/// the remap's tangent at the tile's nearest row, so that what is cut off there joins what is seen without a step.
fn bent_y(straight: f32, w: f32) -> f32 {
    let nearest = max(unremapped(capture.remap, -1.0), unremapped(capture.remap, 1.0));
    if w > 0.0 && straight < nearest * w {
        return remapped(capture.remap, straight / w) * w;
    }
    return remapped(capture.remap, nearest) * w + remap_slope(capture.remap, nearest) * (straight - nearest * w);
}
