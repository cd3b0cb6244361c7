// The prefilter's first pass where facets share tiles.

/// Covers the tile of a cell.
@vertex
fn prefilter_rows_vertex(
    @builtin(vertex_index) corner: u32,
    @builtin(instance_index) cell: u32,
) -> GroundCorner {
    return ground_corner(corner, cell);
}

/// Masks of the planes at a texel of the facet, blurred along rows.
@fragment
fn prefilter_rows_fragment(tile: GroundCorner) -> @location(0) vec4<f32> {
    if !in_own_part(tile.cell, ground_place(tile.cell, vec2<i32>(tile.place.xy)).place) {
        discard;
    }
    return masks_along_rows(tile);
}
