// Where something stands between the light and each plane, blurred along rows of each tile.

/// 1 for each plane before which a texel of the map holds a caster.
fn covered_at(cell: u32, texel: vec2<i32>) -> vec4<f32> {
    let place = ground_place(cell, texel).place;
    let stored = comparable_depth(textureLoad(map, texel, 0));
    var covered = vec4<f32>(0.0);
    for (var plane = 0u; plane < GROUND_PLANES; plane++) {
        let depth = held_depth(dot(ground_vector(cell, plane, 0u), place));
        let meets = dot(ground_vector(cell, plane, 1u), place) > 0.0;
        covered[plane] = select(0.0, 1.0, meets && stored < depth);
    }
    return covered;
}

/// Weighted mean of what covers the planes around a texel; beyond the tile its last texels count on.
fn masks_along_rows(tile: GroundCorner) -> vec4<f32> {
    let texel = vec2<i32>(tile.place.xy);
    let falloff = ground_falloff(tile.cell, ground_place(tile.cell, texel), 0u);
    let ends = vec2<i32>(tile.texels.xz);
    let reach = i32(BLUR);
    var sum = vec4<f32>(0.0);
    var whole = vec4<f32>(0.0);
    for (var offset = -reach; offset <= reach; offset++) {
        let column = clamp(texel.x + offset, ends.x, ends.y);
        let weight = exp(falloff * f32(offset * offset));
        sum += weight * covered_at(tile.cell, vec2<i32>(column, texel.y));
        whole += weight;
    }
    return sum / whole;
}
