// The prefilter's first pass: moments of the map's depths, blurred along rows of each tile.

/// Covers the tile of a cell.
@vertex
fn prefilter_rows_vertex(@builtin(vertex_index) corner: u32, @builtin(instance_index) cell: u32) -> TileCorner {
    return tile_corner(corner, cell);
}

/// Mean and mean square of the depths around a texel; beyond the tile its last texels count on.
@fragment
fn prefilter_rows_fragment(tile: TileCorner) -> @location(0) vec2<f32> {
    let texel = vec2<i32>(tile.place.xy);
    let ends = vec2<i32>(tile.texels.xz);
    let reach = i32(BLUR);
    var sum = vec2<f32>(0.0);
    for (var offset = -reach; offset <= reach; offset++) {
        let column = clamp(texel.x + offset, ends.x, ends.y);
        let depth = warped(comparable_depth(textureLoad(map, vec2<i32>(column, texel.y), 0)));
        sum += vec2<f32>(depth, depth * depth);
    }
    return sum / f32(2 * reach + 1);
}
