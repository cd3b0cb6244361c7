//! Where a facet's image lies once its tile is known: inside the gutters, or inside its triangle of a shared tile.

use glam::{DVec2, DVec4};
use smallvec::{SmallVec, smallvec};

use crate::facet::{FacetRows, Tile};
use crate::polygon::Places;
use crate::technique::Region;

/// Smallest radius of the circle inside a triangle's receivers, in texels.
const SMALLEST_RADIUS_TEXELS: f64 = 1.0;

/// Half-spaces that casters are cut with.
pub(super) type Clip = SmallVec<[DVec4; 2]>;

/// A window within its tile.
#[derive(Debug)]
pub(super) struct Inset {
    /// Its rows.
    pub(super) rows: FacetRows,
    /// Half-spaces that casters are cut with.
    pub(super) clip: Clip,
    /// Texels that the window's clip space, before it was moved, takes across and up.
    pub(super) inner_texels: DVec2,
}

/// Moves x and y rows off the tile's edges and off its neighbours in a shared tile by the gutter, and finds the
/// half-spaces that casters are cut with. `None` when the gutters leave nothing.
/// `reach` is the distance in texels along each axis from a receiver to the farthest texel centre that its filter reads.
/// Lists the outline of its receivers in x/w and y/w.
pub(super) fn inset(
    (rows, corners): (&FacetRows, &[DVec2]),
    region: &Region,
    (tile, reach): (&Tile, f64),
    outline: &mut Places,
) -> Option<Inset> {
    let (rows, clip, scale, shift) = moved(rows, region, tile, reach)?;
    let place = |corner: &DVec2| {
        let y = if rows.remap.is_none() { corner.y * scale.y + shift.y } else { corner.y };
        DVec2::new(corner.x * scale.x + shift.x, y)
    };
    for corner in corners {
        outline.push(place(corner));
    }
    let inner_texels = scale * DVec2::new(f64::from(tile.width), f64::from(tile.height));
    Some(Inset { rows, clip, inner_texels })
}

/// The rows within their tile, half-spaces that casters are cut with, and what clip space was scaled and then shifted by.
fn moved(
    rows: &FacetRows,
    region: &Region,
    tile: &Tile,
    reach: f64,
) -> Option<(FacetRows, Clip, DVec2, DVec2)> {
    match region {
        Region::Tile(_) | Region::Whole(_) => {
            let inner = |side: u32| f64::from(side - 2 * tile.gutter) / f64::from(side);
            let scale = DVec2::new(inner(tile.width), inner(tile.height));
            let across = rows.x * scale.x;
            let rows = if rows.remap.is_none() {
                FacetRows { x: across, y: rows.y * scale.y, ..*rows }
            } else {
                FacetRows { x: across, remap: rows.remap.scaled(scale.y), ..*rows }
            };
            Some((rows, Clip::new(), scale, DVec2::ZERO))
        }
        Region::Triangle { corners, .. } => {
            // Shrink the triangle about the centre of its inner circle, measured in texels.
            let texels = DVec2::new(f64::from(tile.width), f64::from(tile.height)) * 0.5;
            let [a, b, c] = corners.map(|corner| corner * texels);
            let sides = [(b - c).length(), (c - a).length(), (a - b).length()];
            let perimeter: f64 = sides.iter().sum();
            let centre = (a * sides[0] + b * sides[1] + c * sides[2]) / perimeter;
            let radius = (b - a).perp_dot(c - a) / perimeter;
            // Across an oblique edge the corner of a kernel reaches farther than its sides.
            let across = |from: DVec2, to: DVec2| {
                let normal = (to - from).perp().normalize_or_zero().abs();
                reach * (normal.x + normal.y)
            };
            let left = radius - f64::from(tile.gutter).max(across(a, b)).max(across(c, a));
            if left.is_nan() || left < SMALLEST_RADIUS_TEXELS {
                return None;
            }
            let scale = left / radius;
            let centre = centre / texels;
            let moved = |row: DVec4, centre: f64| row * scale + rows.w * (centre * (1.0 - scale));
            let rows = FacetRows { x: moved(rows.x, centre.x), y: moved(rows.y, centre.y), ..*rows };

            // Cut casters at the whole triangle's inner edges: filters see casters up to there.
            let [tip, one, two] = *corners;
            let edge = |from: DVec2, to: DVec2| {
                let inward = (to - from).perp();
                let row = rows.x * inward.x + rows.y * inward.y - rows.w * inward.dot(from);
                row / row.truncate().length()
            };
            let clip = smallvec![edge(tip, one), edge(two, tip)];
            Some((rows, clip, DVec2::splat(scale), centre * (1.0 - scale)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::remap::Remap;
    use crate::technique::TileRequest;

    fn identity() -> FacetRows {
        FacetRows { x: DVec4::X, y: DVec4::Y, z: DVec4::Z, w: DVec4::W, remap: Remap::NONE }
    }

    #[test]
    fn receivers_keep_a_gutter_from_every_edge_of_their_triangle() {
        let tile = Tile { x: 0, y: 0, width: 256, height: 128, gutter: 3 };
        let corners = [DVec2::new(0.2, 0.3), DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0)];
        let region = Region::Triangle { square: 0, request: TileRequest::Footprint, corners };
        let (rows, clips, ..) = moved(&identity(), &region, &tile, 1.0).unwrap();
        assert_eq!(clips.len(), 2);
        let texels = DVec2::new(128.0, 64.0);
        let image = |corner: DVec2| {
            let point = corner.extend(0.0).extend(1.0);
            DVec2::new(rows.x.dot(point), rows.y.dot(point)) * texels
        };
        let whole = corners.map(|corner| corner * texels);
        for corner in corners {
            let moved = image(corner);
            for k in 0..3 {
                let (from, to) = (whole[k], whole[(k + 1) % 3]);
                let distance = (to - from).perp().normalize().dot(moved - from);
                assert!(distance > 3.0 - 1e-9, "{distance}");
            }
        }
        // A clip row is zero on the whole triangle's edge and positive inside.
        let inside = (corners[0] + corners[1] + corners[2]) / 3.0;
        assert!(clips.iter().all(|clip| clip.dot(inside.extend(0.0).extend(1.0)) > 0.0));
    }

    #[test]
    fn a_triangle_narrower_than_its_gutters_is_refused() {
        let tile = Tile { x: 0, y: 0, width: 64, height: 64, gutter: 4 };
        let corners = [DVec2::new(0.0, -0.9), DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0)];
        let region = Region::Triangle { square: 0, request: TileRequest::Footprint, corners };
        assert!(moved(&identity(), &region, &tile, 1.0).is_none());
    }
}
