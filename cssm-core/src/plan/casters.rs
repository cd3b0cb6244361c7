//! Which casters can matter to a facet: the volume its receivers sweep towards the light.

use glam::{DVec2, DVec4};

use crate::facet::{FacetRows, Tile};

/// Sine of the angle between a plane and the light below which the plane counts as containing it.
const CONTAINS_LIGHT: f64 = 1e-9;
/// Edge of a silhouette, in its extents, whose direction is but rounding; without it the volume is hardly larger.
const SHORTEST_EDGE: f64 = 1e-9;
/// Filter taps beyond the receivers' silhouette, in texels, when the tile has no gutter.
const FEWEST_TEXELS: f64 = 1.0;

/// Lists half-spaces around everything whose shadow can reach receivers, given by their own half-spaces and their outline in
/// x/w and y/w, or the filter taps around them. All rows are in the space of `light`.
pub(super) fn list_planes(
    rows: &FacetRows,
    tile: &Tile,
    receivers: &[DVec4],
    outline: &[DVec2],
    light: DVec4,
    planes: &mut Vec<DVec4>,
) {
    // Below: moving away from the light never enters a half-space that faces it.
    planes.clear();
    planes.reserve(receivers.len() + outline.len().max(4) + 1);
    for plane in receivers {
        // Most planes between facets contain the light.
        let (facing, square) = (plane.dot(light), plane.truncate().length_squared());
        if facing > 0.0 && facing * facing > CONTAINS_LIGHT * CONTAINS_LIGHT * square {
            planes.push(*plane * (1.0 / square.sqrt()));
        }
    }

    // Around: the silhouette of the receivers in the light's view, moved out by the gutter.
    let margin = f64::from(tile.gutter).max(FEWEST_TEXELS);
    let (texel_x, texel_y) = (2.0 * margin / f64::from(tile.width), 2.0 * margin / f64::from(tile.height));
    let reach_y = |k: f64| {
        if rows.remap.is_none() {
            return texel_y;
        }
        let y = rows.remap.y(k);
        let reach = |y: f64| libm::fabs(rows.remap.k(y) - k);
        reach(y + texel_y).max(reach(y - texel_y))
    };
    if outline.len() >= 3 {
        let low = outline.iter().fold(DVec2::INFINITY, |low, corner| low.min(*corner));
        let high = outline.iter().fold(DVec2::NEG_INFINITY, |high, corner| high.max(*corner));
        let shortest = (high - low) * SHORTEST_EDGE;
        for (one, two) in outline.iter().zip(outline.iter().cycle().skip(1)) {
            let along = *two - *one;
            if along.abs().cmple(shortest).all() {
                continue;
            }
            let inward = along.perp();
            let texel_y = reach_y(one.y).max(reach_y(two.y));
            let slack = inward.x.abs() * texel_x + inward.y.abs() * texel_y;
            planes.push(rows.x * inward.x + rows.y * inward.y + rows.w * (slack - inward.dot(*one)));
        }
    } else {
        let (low, high) = (rows.remap.k(-1.0), rows.remap.k(1.0));
        let (low, high) = (rows.w * low.min(high), rows.w * low.max(high));
        planes.extend([rows.w + rows.x, rows.w - rows.x, rows.y - low, high - rows.y]);
    }

    // In front of the facet's w = 0 plane nothing lands in the tile.
    planes.push(rows.w);
}
