//! Equal footprints: tiles stand in the order of their facets, neighbours may share a strip, and the partition whose
//! tiles all reach the smallest footprint is taken.
//!
//! At a footprint, every run of neighbours needs a certain width to fit into the height of a strip; the least total
//! width over all partitions is found by dynamic programming. The footprint at which it equals the map's width is the
//! answer: a minimum of continuous functions of view and light, and so continuous itself.

use super::spread::{self, Curve, Spread, WIDTHS};
use super::strips;
use super::{MapArea, Placement, Placements, TileDemand};
use crate::facet::Tile;
use crate::plan::PlanError;

/// Rounds of the search for the footprint; three are usual.
const ROUNDS: u32 = 40;
/// Relative precision of the footprint.
const PRECISION: f64 = 1e-4;
/// Widths that are passed at once where all are too narrow.
const STRIDE: usize = 3;
/// Rounds in which one partition is made to fill the map; three are usual.
const FILLINGS: u32 = 12;
/// Relative precision of the width that it fills.
const CLOSE: f64 = 1e-6;
/// Share of the map that tiles of least sides would fill, where the search begins.
const FIRST_FILL: f64 = 0.8;

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

/// The map and the footprint's bounds.
#[derive(Debug, Clone, Copy)]
struct Fold {
    widths: [f64; WIDTHS],
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
        let (map_width, map_height) = (f64::from(area.width), f64::from(area.height));
        let least: f64 = demands.iter().map(|demand| demand.spread.least_area()).sum();
        let first = (least / (FIRST_FILL * map_width * map_height)).sqrt();
        Self {
            first: if first.is_normal() { first } else { widths[WIDTHS - 1] / map_width },
            widths,
            map_width,
            map_height,
            gutters: 2.0 * f64::from(area.gutter),
            smallest_side: f64::from(area.smallest_side()),
            strips: area.strips.map(|strips| (strips as usize).min(demands.len())),
        }
    }

    /// Inner width at which the lengths of a run add up to the map's height, near another width; `None` where no width is
    /// enough.
    fn run_width(&self, curves: &[Curve], near: f64, footprint: f64) -> Option<f64> {
        let per_footprint = 1.0 / footprint;
        let sum = |index: usize| -> f64 {
            let sides = curves.iter().map(|curve| {
                let side = curve.lengths[index] * per_footprint + self.gutters;
                if side > self.smallest_side { side } else { self.smallest_side }
            });
            sides.sum()
        };
        let mut high = self.widths.partition_point(|width| *width < near).min(WIDTHS - 1);
        let mut two = sum(high);
        while two > self.map_height {
            high += 1;
            two = if high < WIDTHS { sum(high) } else { return None };
        }
        loop {
            if high == 0 {
                return Some(self.widths[0]);
            }
            let one = sum(high - 1);
            if one > self.map_height {
                return Some(self.interpolated(high, one, two));
            }
            (high, two) = (high - 1, one);
        }
    }

    /// The width at which a falling sum comes to the map's height, between two neighbouring widths.
    fn interpolated(&self, high: usize, one: f64, two: f64) -> f64 {
        // Lengths fall like 1 / width: interpolate their reciprocals.
        let height = self.map_height;
        let part = (one - height) * two / (height * (one - two));
        self.widths[high - 1] + (self.widths[high] - self.widths[high - 1]) * part
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
}

/// The search for the footprint, and what its rounds share.
#[derive(Debug, Default)]
pub(super) struct Search {
    curves: Vec<Curve>,
    /// Running sums of the lengths at each width.
    sums: Vec<[f64; WIDTHS]>,
    /// Least width and last run of the first tiles, in each number of strips where that is declared.
    least: Vec<(f64, Run)>,
    /// Runs of the best partition so far.
    best: Vec<Run>,
    /// Wishes of the strips, then of the tiles of one.
    wishes: Vec<f64>,
}

impl Search {
    /// Places one tile for each demand.
    pub(super) fn place(
        &mut self,
        demands: &[TileDemand],
        area: &MapArea,
        placed: &mut Placements,
    ) -> Result<(), PlanError> {
        if let [TileDemand { spread: Spread::NONE, .. }] = demands {
            // Nobody asks what it spans.
            let MapArea { width, height, gutter, .. } = *area;
            let tile = Tile { x: 0, y: 0, width, height, gutter };
            placed.clear();
            placed.push(Placement { tile, turned: false });
            let fits = width.min(height) >= area.smallest_side();
            return if fits { Ok(()) } else { Err(area.too_small(1)) };
        }
        let fold = Fold::new(demands, area);
        self.begin(demands, &fold);
        let footprint = self.smallest(&fold);
        let is_placed = footprint.and_then(|footprint| self.cut(footprint, &fold, area, placed));
        is_placed.ok_or_else(|| area.too_small(demands.len()))
    }

    /// Makes room for so many tiles.
    pub(super) fn make_room(&mut self, most: usize) {
        self.curves.clear();
        self.curves.reserve(most);
        self.sums.clear();
        self.sums.reserve(most + 1);
        self.least.clear();
        self.least.reserve(most + 1);
        self.best.clear();
        self.best.reserve(most + 1);
        self.wishes.clear();
        self.wishes.reserve(most + 1);
    }

    fn begin(&mut self, demands: &[TileDemand], fold: &Fold) {
        let places = demands.len() + 1;
        let layers = fold.strips.map_or(1, |strips| strips + 1);
        self.curves.clear();
        let curve = |demand: &TileDemand| demand.spread.curve(demand.may_turn, &fold.widths);
        self.curves.extend(demands.iter().map(curve));
        self.sums.clear();
        self.sums.resize(places, [0.0; WIDTHS]);
        self.least.clear();
        self.least.resize(places * layers, (f64::INFINITY, Run::NONE));
        self.best.clear();
        self.best.reserve(places);
    }

    /// Whole-texel tiles of the best partition, strips side by side. `None` when the smallest sides do not fit.
    fn cut(&mut self, footprint: f64, fold: &Fold, area: &MapArea, placed: &mut Placements) -> Option<()> {
        self.wishes.clear();
        self.wishes.extend(self.best.iter().map(|run| fold.side(run.width, footprint)));
        let strip_sides = strips::share(&self.wishes, area.width, area.smallest_side())?;
        placed.clear();
        let mut x = 0;
        for (run, width) in self.best.iter().zip(strip_sides) {
            let (above, part) = fold.between(run);
            let curves = &self.curves[run.from..run.to];
            let length = |curve: &Curve| {
                let (one, two) = (curve.lengths[above - 1], curve.lengths[above]);
                fold.side(1.0 / ((1.0 - part) / one + part / two), footprint)
            };
            self.wishes.clear();
            self.wishes.extend(curves.iter().map(length));
            let sides = strips::share(&self.wishes, area.height, area.smallest_side())?;
            let mut y = 0;
            for (curve, height) in curves.iter().zip(sides) {
                let tile = Tile { x, y, width, height, gutter: area.gutter };
                placed.push(Placement { tile, turned: curve.turned[above] });
                y += height;
            }
            x += width;
        }
        Some(())
    }

    /// The smallest footprint at which all tiles fit; leaves the runs that make it in `best`.
    fn smallest(&mut self, fold: &Fold) -> Option<f64> {
        // Take the best partition at a footprint, fill the map with it, and see whether another is better there.
        let (mut footprint, mut known) = (fold.first, None);
        for _ in 0..ROUNDS {
            let total = self.partition(footprint, fold);
            if total.is_infinite() && known.is_none() {
                footprint *= 2.0;
                continue;
            }
            if known.is_some() && total >= (1.0 - PRECISION) * fold.map_width {
                return known;
            }
            self.keep();
            let Some(filling) = self.filling(footprint, fold) else { break };
            if known.is_some_and(|known| filling >= (1.0 - 0.5 * PRECISION) * known) {
                return Some(filling);
            }
            (known, footprint) = (Some(filling), filling);
        }
        self.bracketed(fold)
    }

    /// [`Self::smallest`] where no partition fills the map by itself: searched between bounds.
    fn bracketed(&mut self, fold: &Fold) -> Option<f64> {
        let (mut low, mut high) = (0.0, f64::INFINITY);
        let mut footprint = fold.first;
        let mut found = None;
        let mut last: Option<(f64, f64)> = None;
        for _ in 0..ROUNDS {
            let total = self.partition(footprint, fold);
            if total <= fold.map_width {
                high = footprint;
                found = Some(footprint);
                self.keep();
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

    /// The footprint at which the strips of the best partition fill the map, sought from one at which they are that.
    /// `None` where they do not come to it.
    fn filling(&mut self, start: f64, fold: &Fold) -> Option<f64> {
        let (mut footprint, mut last) = (start, None::<(f64, f64)>);
        for _ in 0..FILLINGS {
            let mut total = 0.0;
            for run in &mut self.best {
                run.width = fold.run_width(&self.curves[run.from..run.to], run.width, footprint)?;
                total += fold.side(run.width, footprint);
            }
            let ratio = total / fold.map_width;
            if (ratio - 1.0).abs() <= CLOSE {
                return Some(footprint);
            }

            // Aim by the slope between the last two rounds, or as areas fall.
            let excess = libm::log(ratio);
            let slope = last.map(|(other, before)| (excess - before) / libm::log(footprint / other));
            let slope = slope.filter(|slope| (-4.0..-0.5).contains(slope)).unwrap_or(-2.0);
            last = Some((footprint, excess));
            footprint *= libm::exp(-excess / slope);
        }
        None
    }

    /// Least total width of strips that reach a footprint; infinite where there are none.
    fn partition(&mut self, footprint: f64, fold: &Fold) -> f64 {
        // Add up the lengths at each width; too long is too long: sums keep their precision.
        let tiles = self.curves.len();
        let (per_footprint, longest) = (1.0 / footprint, 2.0 * fold.map_height);
        let mut sum = [0.0; WIDTHS];
        for (curve, place) in self.curves.iter().zip(&mut self.sums[1..]) {
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
        let side = |width: f64| {
            let side = width * per_footprint + fold.gutters;
            if side > fold.smallest_side { side } else { fold.smallest_side }
        };
        for to in 1..=tiles {
            let after = &self.sums[to];
            let mut high = 0;
            for from in (0..to).rev() {
                // Longer runs need more width.
                let before = &self.sums[from];
                while high + STRIDE < WIDTHS && after[high + STRIDE] - before[high + STRIDE] > fold.map_height
                {
                    high += STRIDE + 1;
                }
                while high < WIDTHS && after[high] - before[high] > fold.map_height {
                    high += 1;
                }
                if high == WIDTHS {
                    break;
                }
                let narrower = high.saturating_sub(1);
                if step == 0 {
                    let least = side(fold.widths[narrower]);
                    if least >= self.least[to].0 {
                        break;
                    }
                    if self.least[from].0 + least >= self.least[to].0 {
                        continue;
                    }
                }
                let width = if high == 0 {
                    fold.widths[0]
                } else {
                    fold.interpolated(high, after[narrower] - before[narrower], after[high] - before[high])
                };
                for layer in step..layers {
                    let total = self.least[(layer - step) * places + from].0 + side(width);
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
    fn keep(&mut self) {
        let places = self.curves.len() + 1;
        let step = usize::from(self.least.len() > places);
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
