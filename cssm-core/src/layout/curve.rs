//! How long a tile must be, at each width, for the same footprint.
//!
//! Sides are measured in texels times the footprint in pixels: a tile of inner width w / f and inner length l / f has
//! the footprint f, whatever f is. Where a texel spans the vectors x / width and y / length of a sample, its major axis
//! is at most f exactly where (w^2 - x.x) (l^2 - y.y) >= (x.y)^2: solved for l, the least length.

use super::{Gram, TileDemand};

/// Number of widths.
pub(super) const WIDTHS: usize = 56;
/// Largest width, in lengths of the longest vector.
const WIDEST: f64 = 2.0;
/// Share of a facet's samples that must not exceed the footprint.
const SHARE: f64 = 0.95;
/// Stands for infinite lengths.
const LONGEST: f64 = 1e15;

/// Least lengths of a tile, upright or turned.
pub(super) struct Curve {
    /// Least length at each width, upright or turned, whichever is shorter.
    pub(super) lengths: [f64; WIDTHS],
    /// Whether the turned one is shorter.
    pub(super) turned: [bool; WIDTHS],
}

/// Widths at which curves are known: a square law, dense where tiles are narrow.
pub(super) fn widths(demands: &[TileDemand]) -> [f64; WIDTHS] {
    let longest = |demand: &TileDemand| {
        let square = |gram: &Gram| if demand.may_turn { gram.xx.max(gram.yy) } else { gram.xx };
        Quantile::of(demand.samples.len()).find(demand.samples.iter().map(square), &mut Vec::new())
    };
    let longest = demands.iter().map(longest).fold(f64::MIN_POSITIVE, f64::max).sqrt();
    std::array::from_fn(|index| {
        let part = (index + 1) as f64 / WIDTHS as f64;
        WIDEST * longest * part * part
    })
}

impl Curve {
    pub(super) fn new(demand: &TileDemand, widths: &[f64; WIDTHS]) -> Self {
        let quantile = Quantile::of(demand.samples.len());
        let samples = quantile.decisive(&demand.samples);
        let mut largest = Vec::with_capacity(samples.len());
        let mut length = |width: f64, turned: bool| {
            let one = |gram: &Gram| {
                let (across, along) = if turned { (gram.yy, gram.xx) } else { (gram.xx, gram.yy) };
                let free = width * width - across;
                if free > 0.0 { along + gram.xy * gram.xy / free } else { f64::INFINITY }
            };
            quantile.find(samples.iter().map(one), &mut largest).sqrt().min(LONGEST)
        };
        let mut curve = Self { lengths: [0.0; WIDTHS], turned: [false; WIDTHS] };
        for (index, width) in widths.iter().enumerate() {
            curve.lengths[index] = length(*width, false);
            if demand.may_turn {
                let turned = length(*width, true);
                curve.turned[index] = turned < curve.lengths[index];
                curve.lengths[index] = turned.min(curve.lengths[index]);
            }
        }
        curve
    }
}

/// The value that a share of samples does not exceed: which of the largest ones, and how far to the next.
#[derive(Debug, Clone, Copy)]
struct Quantile {
    /// How many of the largest values are needed.
    largest: usize,
    /// Way from the last of them to the one before.
    part: f64,
}

impl Quantile {
    fn of(count: usize) -> Self {
        let position = SHARE * count.saturating_sub(1) as f64;
        let below = position as usize;
        Self { largest: count - below.min(count), part: position - below as f64 }
    }

    /// The quantile; harmonic between neighbours, so that infinity is reached continuously.
    fn find(&self, values: impl Iterator<Item = f64>, largest: &mut Vec<f64>) -> f64 {
        // Keep the largest values in falling order.
        largest.clear();
        for value in values {
            if largest.len() == self.largest {
                if largest.last().is_none_or(|last| value <= *last) {
                    continue;
                }
                largest.pop();
            }
            let place = largest.iter().rposition(|other| *other >= value).map_or(0, |other| other + 1);
            largest.insert(place, value);
        }
        match largest[..] {
            [] => 0.0,
            [.., above, below] if below > 0.0 => 1.0 / ((1.0 - self.part) / below + self.part / above),
            [.., below] => below,
        }
    }

    /// The samples that can be among the largest: those that fewer others exceed in every respect.
    fn decisive(&self, samples: &[Gram]) -> Vec<Gram> {
        const MOST_COMPARED: usize = 128;
        if samples.len() > MOST_COMPARED {
            return samples.to_vec();
        }
        let exceeds =
            |one: &Gram, two: &Gram| one.xx > two.xx && one.yy > two.yy && one.xy.abs() > two.xy.abs();
        let decides = |sample: &&Gram| {
            samples.iter().filter(|other| exceeds(other, sample)).take(self.largest).count() < self.largest
        };
        samples.iter().filter(decides).copied().collect()
    }
}
