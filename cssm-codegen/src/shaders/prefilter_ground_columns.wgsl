// The prefilter's second pass where every facet has a tile of its own.

/// Covers the tile of a cell.
@vertex
fn prefilter_columns_vertex(
    @builtin(vertex_index) corner: u32,
    @builtin(instance_index) cell: u32,
) -> GroundCorner {
    return ground_corner(corner, cell);
}

/// Masks of the planes at a texel, blurred along columns.
@fragment
fn prefilter_columns_fragment(tile: GroundCorner) -> @location(0) vec4<f32> {
    return masks_along_columns(tile);
}
