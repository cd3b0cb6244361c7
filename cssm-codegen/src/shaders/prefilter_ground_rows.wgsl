// The prefilter's first pass where every facet has a tile of its own.

/// Covers the tile of a cell.
@vertex
fn prefilter_rows_vertex(
    @builtin(vertex_index) corner: u32,
    @builtin(instance_index) cell: u32,
) -> GroundCorner {
    return ground_corner(corner, cell);
}

/// Masks of the planes at a texel, blurred along rows.
@fragment
fn prefilter_rows_fragment(tile: GroundCorner) -> @location(0) vec4<f32> {
    return masks_along_rows(tile);
}
