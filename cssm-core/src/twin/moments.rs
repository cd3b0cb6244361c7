//! Blurred moments of warped depths, and the shadow that they stand for.

use glam::DVec2;
use smallvec::SmallVec;

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
        // Blend the moments of four texels bilinearly; most texels that one is blurred over the others are as well.
        let corner = (texel - 0.5).floor();
        let weight = texel - 0.5 - corner;
        let window = self.window(tile, corner, behind_at);
        let at = |column: usize, row: usize| self.blurred(&window, column, row);
        let upper = at(0, 0).lerp(at(1, 0), weight.x);
        let lower = at(0, 1).lerp(at(1, 1), weight.x);
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

    /// Texels across a box that is blurred over.
    fn across(&self) -> usize {
        2 * self.blur_texels as usize + 1
    }

    /// Warped depths of the texels that four neighbours are blurred over, row by row; `corner` is the first of the four.
    /// Beyond the tile its last texels count on.
    fn window(&self, tile: &Tile, corner: DVec2, behind_at: impl Fn(DVec2) -> f64) -> SmallVec<[f64; 64]> {
        let low = DVec2::new(f64::from(tile.x), f64::from(tile.y));
        let high = low + DVec2::new(f64::from(tile.width), f64::from(tile.height)) - 1.0;
        let first = corner - f64::from(self.blur_texels);
        let side = self.across() as u32 + 1;
        let texel = |index: u32| first + DVec2::new(f64::from(index % side), f64::from(index / side));
        (0..side * side).map(|index| self.warped(behind_at(texel(index).clamp(low, high)))).collect()
    }

    /// Mean and mean square over the box of texels that begins at a column and row of a window.
    fn blurred(&self, window: &[f64], column: usize, row: usize) -> DVec2 {
        let across = self.across();
        let mut sum = DVec2::ZERO;
        for values in window.chunks_exact(across + 1).skip(row).take(across) {
            for value in &values[column..column + across] {
                sum += DVec2::new(*value, value * value);
            }
        }
        sum / (across * across) as f64
    }
}
