// The prefilter's second pass: moments blurred along columns of each tile.

/// Covers the tile of a cell.
@vertex
fn prefilter_columns_vertex(@builtin(vertex_index) corner: u32, @builtin(instance_index) cell: u32) -> TileCorner {
    return tile_corner(corner, cell);
}

/// Mean of the moments around a texel; beyond the tile its last texels count on.
@fragment
fn prefilter_columns_fragment(tile: TileCorner) -> @location(0) vec2<f32> {
    let texel = vec2<i32>(tile.place.xy);
    let ends = vec2<i32>(tile.texels.yw);
    let reach = i32(BLUR);
    var sum = vec2<f32>(0.0);
    for (var offset = -reach; offset <= reach; offset++) {
        let row = clamp(texel.y + offset, ends.x, ends.y);
        sum += textureLoad(moment_rows, vec2<i32>(texel.x, row), 0).xy;
    }
    return sum / f32(2 * reach + 1);
}
