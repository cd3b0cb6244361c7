//! Blurred masks of what stands between the light and a plane.

use glam::{DVec2, DVec3};

use crate::facet::Tile;
use crate::ground::PlaneInTile;
use crate::remap::Remap;

/// Smallest standard deviation in texels: what bilinear reading blurs anyway.
const NARROWEST: f64 = 0.5;
/// Largest standard deviation in reaches, so that what is cut off does not show.
const WIDEST: f64 = 0.4;

/// The mask of one plane in one facet.
pub(super) struct GroundMask<'a> {
    pub(super) tile: &'a Tile,
    pub(super) remap: &'a Remap,
    pub(super) plane: PlaneInTile,
    /// Standard deviation in metres on the plane.
    pub(super) blur_metres: f64,
    /// Texels that the blur is cut off at.
    pub(super) reach_texels: u32,
}

impl GroundMask<'_> {
    /// Share of light at a place on the plane; `depth_at` tells a texel's depth, growing away from the light from `nearest` to
    /// `farthest`.
    pub(super) fn visibility(
        &self,
        texel: DVec2,
        (nearest, farthest): (f64, f64),
        depth_at: impl Fn(DVec2) -> f64,
    ) -> f64 {
        let covered = |corner: DVec2| {
            let (place, _) = self.place(corner);
            let plane = self.plane.depth.dot(place.extend(1.0)).clamp(nearest, farthest);
            let meets = self.plane.inverse_w.dot(place.extend(1.0)) > 0.0;
            f64::from(u8::from(meets && depth_at(corner) < plane))
        };
        let along_row = |corner: DVec2| {
            let sigma = self.deviation(corner).x;
            self.blurred(sigma, |offset| covered(self.held(corner + DVec2::new(offset, 0.0))))
        };
        let masked = |corner: DVec2| {
            let sigma = self.deviation(corner).y;
            self.blurred(sigma, |offset| along_row(self.held(corner + DVec2::new(0.0, offset))))
        };

        // Blend four texels bilinearly.
        let corner = (texel - 0.5).floor();
        let weight = texel - 0.5 - corner;
        let at = |dx: f64, dy: f64| masked(corner + DVec2::new(dx, dy));
        let upper = at(0.0, 0.0) * (1.0 - weight.x) + at(1.0, 0.0) * weight.x;
        let lower = at(0.0, 1.0) * (1.0 - weight.x) + at(1.0, 1.0) * weight.x;
        1.0 - upper * (1.0 - weight.y) - lower * weight.y
    }

    /// Clip x/w and y/w of a texel's centre before rows are bent, and how steeply they are bent there.
    fn place(&self, corner: DVec2) -> (DVec2, f64) {
        let size = DVec2::new(f64::from(self.tile.width), f64::from(self.tile.height));
        let first = DVec2::new(f64::from(self.tile.x), f64::from(self.tile.y));
        let share = (corner + 0.5 - first) / size;
        let y = self.remap.k(1.0 - 2.0 * share.y);
        (DVec2::new(2.0 * share.x - 1.0, y), self.remap.slope(y))
    }

    /// Standard deviations along x and y of the map in texels.
    fn deviation(&self, corner: DVec2) -> DVec2 {
        let (place, slope) = self.place(corner);
        let powers = |value: f64| DVec3::new(1.0, value, value * value);
        let squared = DVec2::new(self.plane.across.dot(powers(place.x)), self.plane.up.dot(powers(place.y)));
        let per_w = DVec2::new(squared.x.max(0.0).sqrt(), squared.y.max(0.0).sqrt() * slope.abs());
        let per_metre = per_w * self.plane.inverse_w.dot(place.extend(1.0));
        let widest = (WIDEST * f64::from(self.reach_texels)).max(NARROWEST);
        (per_metre * self.blur_metres).clamp(DVec2::splat(NARROWEST), DVec2::splat(widest))
    }

    /// A texel of the tile: beyond it its last texels count on.
    fn held(&self, corner: DVec2) -> DVec2 {
        let low = DVec2::new(f64::from(self.tile.x), f64::from(self.tile.y));
        let high = low + DVec2::new(f64::from(self.tile.width), f64::from(self.tile.height)) - 1.0;
        corner.clamp(low, high)
    }

    /// Mean of values around a texel by a Gaussian.
    fn blurred(&self, deviation: f64, value_at: impl Fn(f64) -> f64) -> f64 {
        let reach = self.reach_texels as i32;
        let (mut sum, mut whole) = (0.0, 0.0);
        for offset in (-reach..=reach).map(f64::from) {
            let weight = libm::exp(-0.5 * (offset / deviation) * (offset / deviation));
            (sum, whole) = (sum + weight * value_at(offset), whole + weight);
        }
        sum / whole
    }
}
