//! Equal footprints: tiles stand in the order of their facets, neighbours may share a strip, and the partition whose
//! tiles all reach the smallest footprint is taken.
//!
//! At a footprint, every run of neighbours needs a certain width to fit into the height of a strip; the least total
//! width over all partitions is found by dynamic programming. The footprint at which it equals the map's width is the
//! answer: a minimum of continuous functions of view and light, and so continuous itself.

use super::spread::{self, Curve, WIDTHS};
use super::strips::{self, Few, Strip};
use super::{MapArea, Placement, TileDemand};
use crate::plan::PlanError;

/// Rounds of the search for the footprint; half a dozen is usual.
const ROUNDS: u32 = 40;
/// Relative precision of the footprint.
const PRECISION: f64 = 1e-4;
/// Share of the map that tiles of least sides would fill, where the search begins.
const FIRST_FILL: f64 = 0.8;

pub(super) fn place(demands: &[TileDemand], area: &MapArea) -> Result<Vec<Placement>, PlanError> {
    let fold = Fold::new(demands, area);
    let mut search = Search::new(&fold);
    let placed = search.smallest(&fold).and_then(|footprint| {
        let runs = &search.best;
        let strips: Few<Strip> = runs.iter().map(|run| fold.strip(run, footprint)).collect();
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

impl Run {
    const NONE: Self = Self { from: 0, to: 0, width: 0.0 };
}

struct Fold {
    widths: [f64; WIDTHS],
    curves: Vec<Curve>,
    /// Footprint at which tiles of least sides would fill the map.
    first: f64,
    map_width: f64,
    map_height: f64,
    gutters: f64,
    smallest_side: f64,
    strips: Option<usize>,
}

impl Fold {
    fn new(demands: &[TileDemand], area: &MapArea) -> Self {
        let widths = spread::widths(demands.iter().map(|demand| (demand.spread, demand.may_turn)));
        let curve = |demand: &TileDemand| demand.spread.curve(demand.may_turn, &widths);
        let (map_width, map_height) = (f64::from(area.width), f64::from(area.height));
        let least: f64 = demands.iter().map(|demand| demand.spread.least_area()).sum();
        let first = (least / (FIRST_FILL * map_width * map_height)).sqrt();
        Self {
            curves: demands.iter().map(curve).collect(),
            first: if first.is_normal() { first } else { widths[WIDTHS - 1] / map_width },
            widths,
            map_width,
            map_height,
            gutters: 2.0 * f64::from(area.gutter),
            smallest_side: f64::from(area.smallest_side()),
            strips: area.strips.map(|strips| (strips as usize).min(demands.len())),
        }
    }

    /// Inner width at which the lengths of a run, whose running sums these are, add up to the map's height, among the widths
    /// from `start` on, where it goes on from; `None` where no width is enough.
    fn width(&self, before: &[f64; WIDTHS], after: &[f64; WIDTHS], start: &mut usize) -> Option<f64> {
        let height = self.map_height;
        let enough = |index: &usize| after[*index] - before[*index] <= height;
        let high = (*start..WIDTHS).find(enough)?;
        *start = high;
        if high == 0 {
            return Some(self.widths[0]);
        }
        // Lengths fall like 1 / width: interpolate their reciprocals.
        let (one, two) = (after[high - 1] - before[high - 1], after[high] - before[high]);
        let part = (one - height) * two / (height * (one - two));
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

/// The search for the footprint, with what its rounds share.
struct Search {
    /// Running sums of the lengths at each width.
    sums: Vec<[f64; WIDTHS]>,
    /// Least width and last run of the first tiles, in each number of strips where that is declared.
    least: Vec<(f64, Run)>,
    /// Runs of the best partition so far.
    best: Vec<Run>,
}

impl Search {
    fn new(fold: &Fold) -> Self {
        let places = fold.curves.len() + 1;
        let layers = fold.strips.map_or(1, |strips| strips + 1);
        Self {
            sums: vec![[0.0; WIDTHS]; places],
            least: vec![(f64::INFINITY, Run::NONE); places * layers],
            best: Vec::with_capacity(places),
        }
    }

    /// The smallest footprint at which all tiles fit; leaves the runs that make it in `best`.
    fn smallest(&mut self, fold: &Fold) -> Option<f64> {
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut footprint = fold.first;
        let mut found = None;
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..ROUNDS {
            let total = self.partition(footprint, fold);
            if total <= fold.map_width {
                high = footprint;
                found = Some(footprint);
                self.keep(fold);
            } else {
                low = footprint;
            }
            // Widths fall at least as footprints grow.
            let close = (1.0 - PRECISION) * fold.map_width;
            let narrow = high.is_finite() && high - low <= PRECISION * high;
            if narrow || (close..=fold.map_width).contains(&total) {
                break;
            }

            // Aim by the slope between the last two rounds, or as areas fall: with the square of the footprint. Aim just
            // past the goal, so as to close in from both sides.
            let past = if total <= fold.map_width { 1.0 - 0.3 * PRECISION } else { 1.0 + 0.3 * PRECISION };
            let excess = libm::log(total / fold.map_width);
            let slope = last.map(|(other, before)| (excess - before) / libm::log(footprint / other));
            let slope = slope.filter(|slope| (-4.0..-0.5).contains(slope)).unwrap_or(-2.0);
            last = excess.is_finite().then_some((footprint, excess));
            let aim = footprint * libm::exp((excess / -slope).min(1.4)) * past;
            footprint = match (aim > low && aim < high, high.is_finite()) {
                (true, _) => aim,
                (false, true) => 0.5 * (low + high),
                (false, false) => 2.0 * footprint,
            };
        }
        found
    }

    /// Least total width of strips that reach a footprint; infinite where there are none.
    fn partition(&mut self, footprint: f64, fold: &Fold) -> f64 {
        // Add up the lengths at each width; too long is too long: sums keep their precision.
        let tiles = fold.curves.len();
        let (per_footprint, longest) = (1.0 / footprint, 2.0 * fold.map_height);
        let mut sum = [0.0; WIDTHS];
        for (curve, place) in fold.curves.iter().zip(&mut self.sums[1..]) {
            for (sum, length) in sum.iter_mut().zip(&curve.lengths) {
                let side = length * per_footprint + fold.gutters;
                let side = if side > fold.smallest_side { side } else { fold.smallest_side };
                *sum += if side < longest { side } else { longest };
            }
            *place = sum;
        }

        // least[strips][to]: the first `to` tiles, in so many strips where their number is declared.
        let places = tiles + 1;
        self.least.fill((f64::INFINITY, Run::NONE));
        self.least[0].0 = 0.0;
        let step = usize::from(fold.strips.is_some());
        let layers = self.least.len() / places;
        for to in 1..=tiles {
            let mut start = 0;
            for from in (0..to).rev() {
                // Longer runs need more width.
                let Some(width) = fold.width(&self.sums[from], &self.sums[to], &mut start) else { break };
                let side = width * per_footprint + fold.gutters;
                let side = if side > fold.smallest_side { side } else { fold.smallest_side };
                if step == 0 && side >= self.least[to].0 {
                    break;
                }
                for layer in step..layers {
                    let total = self.least[(layer - step) * places + from].0 + side;
                    let least = &mut self.least[layer * places + to];
                    if total < least.0 {
                        *least = (total, Run { from, to, width });
                    }
                }
            }
        }
        self.least[layers * places - 1].0
    }

    /// Keeps the runs of the last partition: walks back from the last tile.
    fn keep(&mut self, fold: &Fold) {
        let places = fold.curves.len() + 1;
        let step = usize::from(fold.strips.is_some());
        let (mut layer, mut to) = (self.least.len() / places - 1, places - 1);
        self.best.clear();
        while to > 0 {
            let (_, run) = self.least[layer * places + to];
            self.best.push(run);
            to = run.from;
            layer = layer.saturating_sub(step);
        }
        self.best.reverse();
    }
}
