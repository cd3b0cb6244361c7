// Tiles of the plan as rectangles, one for each cell of the selection walk, whose planes they show.

/// A corner of a tile, the tile, and the cell.
struct GroundCorner {
    /// Place in the map's clip space.
    @builtin(position) place: vec4<f32>,
    /// The tile's first texels (xy) and last (zw).
    @location(0) @interpolate(flat) texels: vec4<f32>,
    /// The cell.
    @location(1) @interpolate(flat) cell: u32,
}

/// One of the six corners of two triangles that cover a cell's tile; cells without a facet have no extent.
fn ground_corner(corner: u32, cell: u32) -> GroundCorner {
    // Texel limits lie less than a texel inside the tile.
    let limits = shadow.facets[cell].texel_limits;
    let low = floor(limits.xy);
    let high = ceil(limits.zw);

    // Go around: left and upper, right and upper, left and lower, then the other three.
    let right = corner == 1u || corner > 3u;
    let lower = corner == 2u || corner == 3u || corner == 5u;
    let texel = select(low, high, vec2<bool>(right, lower));
    let ndc = vec2<f32>(2.0, -2.0) * texel / MAP_SIZE + vec2<f32>(-1.0, 1.0);
    return GroundCorner(vec4<f32>(ndc, 0.0, 1.0), vec4<f32>(low, high - 1.0), cell);
}
