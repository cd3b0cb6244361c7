// From the capture's axes to the facet's tile.

/// Applies the facet's matrix, row by row, to a position in the capture's axes.
fn tile_position(position: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(
        dot(capture.row_x, position),
        dot(capture.row_y, position),
        dot(capture.row_z, position),
        dot(capture.row_w, position),
    );
}
