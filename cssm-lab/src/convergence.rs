//! Convergence: how fast a map's errors shrink as it grows. A floor means a wrong matrix, clip set or bias.

use cssm_core::LightCase;
use serde::Serialize;

use crate::case_file::with_map_size;
use crate::error::LabError;
use crate::score::Score;
use crate::score::statistics::slope;
use crate::sight::Sight;
pub use crate::stage::convergence;
use crate::twin::{self, TwinCasters};

/// Map sides that are tried.
pub const SIDES: [u32; 5] = [256, 512, 1024, 2048, 4096];

/// Map sides from which the slope is taken.
const SLOPE_SIDES: std::ops::RangeInclusive<u32> = 512..=4096;

/// A level with fewer wrong pixels is not judged.
const FEWEST_WRONG_PIXELS: u64 = 200;

/// A level with a smaller share of interior is not judged.
const LEAST_INTERIOR: f64 = 0.3;

/// Mismatch over map sizes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Convergence {
    /// One entry for each map side.
    pub levels: Vec<Level>,
    /// Slope of log mismatch over log side among the judged levels of 512 to 4096; absent with fewer than two.
    pub slope: Option<f64>,
    /// Largest share of interior errors among the judged levels.
    pub interior: f64,
    /// Interior errors and light-facing pixels of the judged levels, to be pooled over views.
    pub interior_pooled: (u64, u64),
}

/// One map size.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Level {
    /// Side of the square map in texels.
    pub side: u32,
    /// Whether it has enough wrong pixels and enough interior to say anything.
    pub judged: bool,
    /// Its score.
    pub score: Score,
}

/// Tries a case on the f64 twin with square maps of several sizes.
///
/// # Errors
/// [`LabError::NothingJudged`] when no level could be judged; else what planning says.
pub fn twin_convergence(
    sight: &Sight<'_>,
    casters: &TwinCasters<'_>,
    case: &LightCase,
    sides: &[u32],
) -> Result<Convergence, LabError> {
    converge(case, sides, |case| Ok(twin::outcome(sight, casters, case)?.outcome.score))
}

/// Scores a case with square maps of several sizes.
pub(crate) fn converge(
    case: &LightCase,
    sides: &[u32],
    score: impl Fn(&LightCase) -> Result<Score, LabError>,
) -> Result<Convergence, LabError> {
    let mut levels = Vec::with_capacity(sides.len());
    for side in sides {
        let score = score(&with_map_size(case.clone(), (*side, *side))?)?;
        levels.push(Level { side: *side, judged: is_judged(&score), score });
    }
    summary(levels)
}

fn is_judged(score: &Score) -> bool {
    let wrong = (score.mismatch * score.facing_pixels as f64).round() as u64;
    wrong >= FEWEST_WRONG_PIXELS && score.interior_area >= LEAST_INTERIOR
}

fn summary(levels: Vec<Level>) -> Result<Convergence, LabError> {
    let judged = || levels.iter().filter(|level| level.judged);
    if judged().next().is_none() {
        return Err(LabError::NothingJudged {
            wrong_pixels: FEWEST_WRONG_PIXELS,
            interior_percent: 100.0 * LEAST_INTERIOR,
        });
    }
    let points: Vec<_> = judged()
        .filter(|level| SLOPE_SIDES.contains(&level.side))
        .map(|level| (libm::log2(f64::from(level.side)), libm::log2(level.score.mismatch)))
        .collect();
    let interior =
        judged().map(|level| level.score.leak.interior + level.score.acne.interior).fold(0.0, f64::max);
    let pooled = judged().fold((0, 0), |(wrong, pixels), level| {
        (wrong + level.score.interior_wrong_pixels, pixels + level.score.facing_pixels)
    });
    Ok(Convergence { slope: slope(&points), interior, interior_pooled: pooled, levels })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(side: u32, wrong: u64) -> Level {
        let facing_pixels = 100_000;
        let mismatch = wrong as f64 / facing_pixels as f64;
        let score = Score { facing_pixels, mismatch, interior_area: 0.8, ..Score::default() };
        Level { side, judged: is_judged(&score), score }
    }

    #[test]
    fn halving_errors_slope_down_by_one() {
        let levels = [256, 512, 1024, 2048, 4096].map(|side| level(side, 4_096_000 / u64::from(side)));
        let found = summary(levels.to_vec()).unwrap();
        assert!((found.slope.unwrap() + 1.0).abs() < 1e-9, "{:?}", found.slope);
    }

    #[test]
    fn a_floor_flattens_the_slope() {
        let levels = [512, 1024, 2048, 4096].map(|side| level(side, 3000 + 512_000 / u64::from(side)));
        assert!(summary(levels.to_vec()).unwrap().slope.unwrap() > -0.3);
    }

    #[test]
    fn levels_with_few_errors_are_not_judged() {
        let found = summary(vec![level(512, 4000), level(1024, 2000), level(2048, 199)]).unwrap();
        assert!(!found.levels[2].judged);
        assert!((found.slope.unwrap() + 1.0).abs() < 1e-9);
        assert!(matches!(summary(vec![level(512, 10)]), Err(LabError::NothingJudged { .. })));
    }
}
