//! Equal footprints: tiles stand in the order of their facets, neighbours may share a strip, and the partition whose
//! tiles all reach the smallest footprint is taken.
//!
//! At a footprint, every run of neighbours needs a certain width to fit into the height of a strip; the least total
//! width over all partitions is found by dynamic programming. The footprint at which it equals the map's width is the
//! answer: a minimum of continuous functions of view and light, and so continuous itself.

use super::curve::{self, Curve, WIDTHS};
use super::strips::{self, Strip};
use super::{MapArea, Placement, TileDemand};
use crate::plan::PlanError;

/// Rounds of the search for the footprint; a dozen is usual.
const ROUNDS: u32 = 40;
/// Relative precision of the footprint.
const PRECISION: f64 = 1e-5;

pub(super) fn place(demands: &[TileDemand], area: &MapArea) -> Result<Vec<Placement>, PlanError> {
    let fold = Fold::new(demands, area);
    let placed = fold.smallest().and_then(|(footprint, runs)| {
        let strips: Vec<Strip> = runs.iter().map(|run| fold.strip(run, footprint)).collect();
        let tiles = strips::tiles(&strips, demands.len(), area, true)?;
        let turned = runs.iter().flat_map(|run| fold.turned(run));
        Some(tiles.into_iter().zip(turned).map(|(tile, turned)| Placement { tile, turned }).collect())
    });
    placed.ok_or_else(|| area.too_small(demands.len()))
}

/// Neighbouring tiles in one strip.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Run {
    from: usize,
    to: usize,
    /// Inner width, in texels times footprint.
    width: f64,
}

struct Fold {
    widths: [f64; WIDTHS],
    curves: Vec<Curve>,
    map_width: f64,
    map_height: f64,
    gutters: f64,
    smallest_side: f64,
    strips: Option<usize>,
}

impl Fold {
    fn new(demands: &[TileDemand], area: &MapArea) -> Self {
        let widths = curve::widths(demands);
        Self {
            curves: demands.iter().map(|demand| Curve::new(demand, &widths)).collect(),
            widths,
            map_width: f64::from(area.width),
            map_height: f64::from(area.height),
            gutters: 2.0 * f64::from(area.gutter),
            smallest_side: f64::from(area.smallest_side()),
            strips: area.strips.map(|strips| (strips as usize).min(demands.len())),
        }
    }

    /// The smallest footprint at which all tiles fit, and the runs that make it.
    fn smallest(&self) -> Option<(f64, Vec<Run>)> {
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut footprint = self.widths[WIDTHS - 1] / self.map_width;
        let mut found = None;
        for _ in 0..ROUNDS {
            let (total, runs) = self.partition(footprint);
            if total <= self.map_width {
                high = footprint;
                found = Some((footprint, runs));
            } else {
                low = footprint;
            }
            if high.is_finite() && high - low <= PRECISION * high {
                break;
            }

            // Areas fall with the square of the footprint; aim just past the goal, so as to close in from both sides.
            let past = if total <= self.map_width { 1.0 - 0.3 * PRECISION } else { 1.0 + 0.3 * PRECISION };
            let aim = footprint * (total / self.map_width).sqrt().min(4.0) * past;
            footprint = match (aim > low && aim < high, high.is_finite()) {
                (true, _) => aim,
                (false, true) => 0.5 * (low + high),
                (false, false) => 2.0 * footprint,
            };
        }
        found
    }

    /// Least total width of strips that reach a footprint, and their runs; infinite where there are none.
    fn partition(&self, footprint: f64) -> (f64, Vec<Run>) {
        // Running sums of the lengths at each width.
        let tiles = self.curves.len();
        let mut sums = vec![[0.0; WIDTHS]; tiles + 1];
        for (tile, curve) in self.curves.iter().enumerate() {
            for (width, length) in curve.lengths.iter().enumerate() {
                // Too long is too long: sums keep their precision.
                let side = self.side(*length, footprint).min(2.0 * self.map_height);
                sums[tile + 1][width] = sums[tile][width] + side;
            }
        }

        // least[s][to]: the first `to` tiles, in s strips where their number is declared.
        let nothing = Run { from: 0, to: 0, width: 0.0 };
        let layers = self.strips.map_or(1, |strips| strips + 1);
        let mut least = vec![vec![(f64::INFINITY, nothing); tiles + 1]; layers];
        least[0][0].0 = 0.0;
        for to in 1..=tiles {
            for from in (0..to).rev() {
                let Some(width) = self.width(&sums[from], &sums[to]) else { break };
                let side = self.side(width, footprint);
                for layer in self.strips.map_or(0, |_| 1)..layers {
                    let total = least[layer - self.strips.map_or(0, |_| 1)][from].0 + side;
                    if total < least[layer][to].0 {
                        least[layer][to] = (total, Run { from, to, width });
                    }
                }
            }
        }

        // Walk back from the last tile.
        let (mut layer, mut to) = (layers - 1, tiles);
        let total = least[layer][tiles].0;
        let mut runs = Vec::new();
        while to > 0 && total.is_finite() {
            let run = least[layer][to].1;
            runs.push(run);
            to = run.from;
            layer -= self.strips.map_or(0, |_| 1);
        }
        runs.reverse();
        (total, runs)
    }

    /// Width at which a run's lengths add up to the map's height; `None` where no width is enough.
    fn width(&self, before: &[f64; WIDTHS], after: &[f64; WIDTHS]) -> Option<f64> {
        let need = |index: usize| after[index] - before[index];
        if need(WIDTHS - 1) > self.map_height {
            return None;
        }
        let (mut low, mut high) = (0, WIDTHS - 1);
        while low < high {
            let middle = (low + high) / 2;
            if need(middle) <= self.map_height { high = middle } else { low = middle + 1 }
        }
        if high == 0 {
            return Some(self.widths[0]);
        }
        // Lengths fall like 1 / width: interpolate their reciprocals.
        let (one, two) = (1.0 / need(high - 1), 1.0 / need(high));
        let part = (1.0 / self.map_height - one) / (two - one);
        Some(self.widths[high - 1] + (self.widths[high] - self.widths[high - 1]) * part)
    }

    /// A side in texels, gutters included.
    fn side(&self, inner: f64, footprint: f64) -> f64 {
        (inner / footprint + self.gutters).max(self.smallest_side)
    }

    /// The widths around a run's, and its place between them.
    fn between(&self, run: &Run) -> (usize, f64) {
        let above = self.widths.partition_point(|width| *width < run.width).clamp(1, WIDTHS - 1);
        let (low, high) = (self.widths[above - 1], self.widths[above]);
        (above, ((run.width - low) / (high - low)).clamp(0.0, 1.0))
    }

    fn strip(&self, run: &Run, footprint: f64) -> Strip {
        let (above, part) = self.between(run);
        let length = |index: usize| {
            let lengths = &self.curves[index].lengths;
            let inner = 1.0 / ((1.0 - part) / lengths[above - 1] + part / lengths[above]);
            (index, self.side(inner, footprint))
        };
        Strip { side: self.side(run.width, footprint), tiles: (run.from..run.to).map(length).collect() }
    }

    /// Which tiles of a run are shorter when turned.
    fn turned(&self, run: &Run) -> impl Iterator<Item = bool> {
        let (above, _) = self.between(run);
        (run.from..run.to).map(move |index| self.curves[index].turned[above])
    }
}
