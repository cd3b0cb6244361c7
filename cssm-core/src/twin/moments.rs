//! Blurred moments of warped depths, and the shadow that they stand for.

use glam::DVec2;

use crate::facet::Tile;

/// Least standard deviation, in shares of the warped receiver depth: what rounding of 32-bit moments may hide.
pub(super) const LEAST_DEVIATION: f64 = 0.005;

/// How moments are made and read.
pub(super) struct Moments {
    /// Exponent over the whole depth.
    pub(super) exponent: f64,
    /// Texels to either side that moments are blurred over.
    pub(super) blur_texels: u32,
    /// Share of light below which a receiver counts as dark.
    pub(super) bleeding: f64,
}

impl Moments {
    /// Visibility of a point whose reference lies `behind` the near end of depth; `behind_at` tells it of a texel.
    pub(super) fn visibility(
        &self,
        tile: &Tile,
        texel: DVec2,
        behind: f64,
        behind_at: impl Fn(DVec2) -> f64,
    ) -> f64 {
        // Blend the moments of four texels bilinearly.
        let corner = (texel - 0.5).floor();
        let weight = texel - 0.5 - corner;
        let at = |dx: f64, dy: f64| self.blurred(tile, corner + DVec2::new(dx, dy), &behind_at);
        let upper = at(0.0, 0.0).lerp(at(1.0, 0.0), weight.x);
        let lower = at(0.0, 1.0).lerp(at(1.0, 1.0), weight.x);
        let moments = upper.lerp(lower, weight.y);

        // Bound the share of casters behind the receiver by Chebyshev's inequality, one-tailed.
        let receiver = self.warped(behind);
        let before = receiver - moments.x;
        if before <= 0.0 {
            return 1.0;
        }
        let least = LEAST_DEVIATION * receiver;
        let variance = (moments.y - moments.x * moments.x).max(least * least);
        let share = variance / (variance + before * before);
        ((share - self.bleeding) / (1.0 - self.bleeding)).clamp(0.0, 1.0)
    }

    fn warped(&self, behind: f64) -> f64 {
        libm::exp(self.exponent * behind)
    }

    /// Mean and mean square over a box of texels; beyond the tile its last texels count on.
    fn blurred(&self, tile: &Tile, corner: DVec2, behind_at: &impl Fn(DVec2) -> f64) -> DVec2 {
        let low = DVec2::new(f64::from(tile.x), f64::from(tile.y));
        let high = low + DVec2::new(f64::from(tile.width), f64::from(tile.height)) - 1.0;
        let radius = self.blur_texels as i32;
        let mut sum = DVec2::ZERO;
        for row in -radius..=radius {
            for column in -radius..=radius {
                let corner = (corner + DVec2::new(f64::from(column), f64::from(row))).clamp(low, high);
                let value = self.warped(behind_at(corner));
                sum += DVec2::new(value, value * value);
            }
        }
        sum / f64::from((2 * radius + 1) * (2 * radius + 1))
    }
}
