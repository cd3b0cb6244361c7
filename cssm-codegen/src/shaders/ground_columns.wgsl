// Masks of planes blurred along columns of each tile.

/// Weighted mean of the masks around a texel; beyond the tile its last texels count on.
fn masks_along_columns(tile: GroundCorner) -> vec4<f32> {
    let texel = vec2<i32>(tile.place.xy);
    let falloff = ground_falloff(tile.cell, ground_place(tile.cell, texel), 1u);
    let ends = vec2<i32>(tile.texels.yw);
    let reach = i32(BLUR);
    var sum = vec4<f32>(0.0);
    var whole = vec4<f32>(0.0);
    for (var offset = -reach; offset <= reach; offset++) {
        let row = clamp(texel.y + offset, ends.x, ends.y);
        let weight = exp(falloff * f32(offset * offset));
        sum += weight * textureLoad(ground_rows, vec2<i32>(texel.x, row), 0);
        whole += weight;
    }
    return sum / whole;
}
