//! How many texels each shadow gets of one budget.
//!
//! A shadow's predicted error falls as one over the side of its square: side times footprint is a constant of the view
//! and the light. Everyone starts with the smallest useful square; then the shadow with the largest weighted error gets
//! the next size, until all are good enough or the budget is spent. So a budget that is too small takes from those whose
//! error grows least.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// Sides that squares may have: few enough that freed places fit newcomers, close enough that little is wasted.
const LADDER: [u32; 16] =
    [64, 96, 128, 192, 256, 384, 512, 768, 1024, 1536, 2048, 3072, 4096, 6144, 8192, 12288];

/// What one shadow asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Claim {
    /// Predicted 95th percentile of the footprint in pixels, times the side it was predicted for.
    pub(super) pixels_times_side: f64,
    /// Weight of its error.
    pub(super) priority: f64,
    /// Footprint in pixels that is good enough.
    pub(super) enough_pixels: f64,
    /// Smallest side.
    pub(super) min_side: u32,
    /// Largest side.
    pub(super) max_side: u32,
}

impl Claim {
    fn weighted_error(&self, side: u32) -> f64 {
        self.priority * self.pixels_times_side / f64::from(side)
    }

    /// Whether a side leaves nothing to wish for.
    fn is_content(&self, side: u32) -> bool {
        self.pixels_times_side <= self.enough_pixels * f64::from(side)
    }
}

/// The side of every claim's square within a budget; 0 where not even the smallest fits. `queue` keeps its memory.
pub(super) fn sides(
    claims: &[Claim],
    budget_texels: u64,
    sides: &mut Vec<u32>,
    queue: &mut BinaryHeap<Wish>,
) {
    sides.clear();
    sides.resize(claims.len(), 0);
    let mut left_texels = budget_texels;
    queue.clear();
    queue.extend(claims.iter().enumerate().map(|(index, claim)| Wish::new(claim, index, 0)));

    // Serve the largest error first; who cannot be served stays as it is.
    while let Some(wish) = queue.pop() {
        let claim = &claims[wish.index];
        let side = sides[wish.index];
        let Some(next) = next_side(claim, side) else { continue };
        let more = squared(next) - squared(side);
        if more > left_texels {
            continue;
        }
        left_texels -= more;
        sides[wish.index] = next;
        queue.push(Wish::new(claim, wish.index, next));
    }
}

/// Number of steps of the ladder from one side to another.
pub(super) fn steps_between(one: u32, other: u32) -> usize {
    let place = |side: u32| LADDER.partition_point(|step| *step < side);
    place(one).abs_diff(place(other))
}

/// The next side for a claim that has `side`, 0 for none; `None` where it needs no more.
fn next_side(claim: &Claim, side: u32) -> Option<u32> {
    let least = claim.min_side.min(claim.max_side).max(1);
    if side == 0 {
        return Some(
            LADDER.into_iter().find(|step| *step >= least).unwrap_or(least).min(claim.max_side.max(1)),
        );
    }
    if claim.is_content(side) || !claim.pixels_times_side.is_finite() {
        return None;
    }
    LADDER.into_iter().find(|step| *step > side).filter(|step| *step <= claim.max_side)
}

fn squared(side: u32) -> u64 {
    u64::from(side) * u64::from(side)
}

/// A claim in the queue, by what it suffers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wish {
    /// Those without a square come first.
    has_none: bool,
    weighted_error: f64,
    index: usize,
}

impl Wish {
    fn new(claim: &Claim, index: usize, side: u32) -> Self {
        Self { has_none: side == 0, weighted_error: claim.weighted_error(side.max(1)), index }
    }
}

impl Ord for Wish {
    fn cmp(&self, other: &Self) -> Ordering {
        let order = self.has_none.cmp(&other.has_none);
        let order = order.then(self.weighted_error.total_cmp(&other.weighted_error));
        order.then(other.index.cmp(&self.index))
    }
}

impl PartialOrd for Wish {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Wish {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Wish {}

#[cfg(test)]
mod tests {
    use super::*;

    fn claim(pixels_times_side: f64, priority: f64) -> Claim {
        Claim { pixels_times_side, priority, enough_pixels: 1.0, min_side: 64, max_side: 4096 }
    }

    fn shared(claims: &[Claim], budget_texels: u64) -> Vec<u32> {
        let mut found = Vec::new();
        sides(claims, budget_texels, &mut found, &mut BinaryHeap::new());
        found
    }

    #[test]
    fn everyone_gets_enough_where_there_is_enough() {
        assert_eq!(shared(&[claim(1000.0, 1.0), claim(100.0, 1.0)], 1 << 24), [1024, 128]);
    }

    #[test]
    fn a_small_budget_is_kept_and_evens_errors_out() {
        let claims: Vec<_> = (1..=40).map(|index| claim(f64::from(index) * 100.0, 1.0)).collect();
        let budget = 2_000_000;
        let found = shared(&claims, budget);
        assert!(found.iter().map(|side| squared(*side)).sum::<u64>() <= budget);
        let errors = claims.iter().zip(&found).map(|(claim, side)| claim.weighted_error(*side));
        let worst = errors.fold(0.0, f64::max);
        let equal: f64 = claims.iter().map(|claim| claim.pixels_times_side.powi(2)).sum();
        let best = (equal / budget as f64).sqrt();
        assert!(worst <= 1.6 * best, "{worst} px, where {best} px would be even");
    }

    #[test]
    fn priority_buys_texels_and_no_one_takes_a_place_that_is_not_there() {
        let found = shared(&[claim(1000.0, 1.0), claim(1000.0, 8.0)], 300_000);
        assert!(found[1] > found[0], "{found:?}");
        let crowd = vec![claim(100.0, 1.0); 100];
        let found = shared(&crowd, 10 * 64 * 64);
        assert_eq!(found.iter().filter(|side| **side == 64).count(), 10);
        assert_eq!(found.iter().filter(|side| **side == 0).count(), 90);
    }

    #[test]
    fn what_no_texels_help_gets_the_smallest_square() {
        assert_eq!(shared(&[claim(f64::INFINITY, 1.0), claim(512.0, 1.0)], 1 << 20), [64, 512]);
    }
}
