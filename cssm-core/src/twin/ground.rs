//! Blurred masks of what stands between the light and a plane.

use glam::{DVec2, DVec3};
use smallvec::SmallVec;

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
            self.blurred(sigma, |tap| covered(self.held(corner + DVec2::new(self.offset(tap), 0.0))))
        };

        // Blur the rows of two columns that four neighbours need; most of them are the same for both rows of texels.
        let corner = (texel - 0.5).floor();
        let weight = texel - 0.5 - corner;
        let rows: SmallVec<[[f64; 2]; 32]> = (0..=self.taps())
            .map(|row| {
                let first = corner + DVec2::new(0.0, self.offset(row));
                [first, first + DVec2::X].map(|corner| along_row(self.held(corner)))
            })
            .collect();

        // Blend four texels bilinearly.
        let at = |column: usize, row: usize| {
            let sigma = self.deviation(corner + DVec2::new(column as f64, row as f64)).y;
            self.blurred(sigma, |tap| rows[row + tap][column])
        };
        let upper = at(0, 0) * (1.0 - weight.x) + at(1, 0) * weight.x;
        let lower = at(0, 1) * (1.0 - weight.x) + at(1, 1) * weight.x;
        1.0 - upper * (1.0 - weight.y) - lower * weight.y
    }

    /// Texels that a blur reads along an axis.
    fn taps(&self) -> usize {
        2 * self.reach_texels as usize + 1
    }

    /// How far one of them lies from the middle.
    fn offset(&self, tap: usize) -> f64 {
        tap as f64 - f64::from(self.reach_texels)
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

    /// Mean of the values of all taps by a Gaussian.
    fn blurred(&self, deviation: f64, value_at: impl Fn(usize) -> f64) -> f64 {
        let weight = |offset: u32| {
            let share = f64::from(offset) / deviation;
            libm::exp(-0.5 * share * share)
        };
        let weights: SmallVec<[f64; 16]> = (0..=self.reach_texels).map(weight).collect();
        let (mut sum, mut whole) = (0.0, 0.0);
        for tap in 0..self.taps() {
            let weight = weights[tap.abs_diff(self.reach_texels as usize)];
            (sum, whole) = (sum + weight * value_at(tap), whole + weight);
        }
        sum / whole
    }
}
