//! How long a tile must be, at each width, for the same footprint.
//!
//! Sides are measured in texels times the footprint in pixels: a tile of inner width w / f and inner length l / f has
//! the footprint f, whatever f is. Where a texel spans the vectors x / width and y / length of a sample, its major axis
//! is at most f exactly where (w^2 - x.x) (l^2 - y.y) >= (x.y)^2. Over many samples the quantiles of x.x and y.y bound
//! both sides, and the third figure, found a little above the least width, says how they trade between.

use std::array::from_fn;

use super::Gram;
use crate::plan::beams::{BEAMS, Beams};

/// Number of widths.
pub(super) const WIDTHS: usize = 32;
/// Largest width, in lengths of the longest vector.
const WIDEST: f64 = 2.0;
/// Share of a facet's samples that must not exceed the footprint.
const SHARE: f64 = 0.95;
/// Square of the width at which both sides are traded, in squares of the least width.
const TRADED: f64 = 1.5;
/// Largest growth of the squared length there, in squares of the least length.
const MOST_TRADED: f64 = 2.0;
/// Stands for infinite lengths.
const LONGEST: f64 = 1e15;
/// Rounds of the search for a quantile; four are usual.
const ROUNDS: u32 = 24;
/// Sums that are made side by side.
const LANES: usize = 3;
/// Where the search begins, as a share of the largest value.
const FIRST: f64 = 0.75;
/// Relative precision of the share above a quantile.
const CLOSE: f64 = 1e-9;
/// Shortest interval, relative to its end.
const SHORTEST: f64 = 1e-6;
/// Largest values that are kept sorted while values pass by; more are selected.
const FEW: usize = 8;

/// What the tile of some samples must span, upright or turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    upright: Extent,
    lying: Extent,
}

/// Sides of a tile: length^2 = along + shear / (width^2 - across).
#[derive(Debug, Clone, Copy, PartialEq)]
struct Extent {
    /// Square of the least width.
    across: f64,
    /// Square of the least length.
    along: f64,
    /// How both trade.
    shear: f64,
}

/// Least lengths of a tile, upright or turned.
#[derive(Debug)]
pub(super) struct Curve {
    /// Least length at each width, upright or turned, whichever is shorter.
    pub(super) lengths: [f64; WIDTHS],
    /// Whether the turned one is shorter.
    pub(super) turned: [bool; WIDTHS],
}

impl Spread {
    /// A tile that spans nothing.
    pub const NONE: Self = Self { upright: Extent::NONE, lying: Extent::NONE };

    /// What rays through receivers span, with squares of inverse depths as they count in footprints: `counted` takes a
    /// square and the homogeneous w of its points.
    pub(crate) fn of_beams(beams: &Beams, may_turn: bool, counted: impl Fn(f64, f64) -> f64) -> Self {
        let low = from_fn(|i| counted(beams.low[i], beams.unit[i]));
        let high = from_fn(|i| counted(beams.high[i], beams.unit[i]));
        let tail = Tail::of(&beams.weight, low, high);
        let across = tail.quantile(&beams.grams.map(|gram| gram.xx));
        let along = tail.quantile(&beams.grams.map(|gram| gram.yy));

        // How both trade, somewhat above the least width; one sample trades turned as it does upright.
        let (square, longest) = (TRADED * across, (1.0 + MOST_TRADED) * along);
        let least = |gram: &Gram, place: f64| {
            let (free, shear) = (square - gram.xx * place, gram.xy * place);
            if free > 0.0 { (gram.yy * place + shear * shear / free).min(longest) } else { longest }
        };
        let low = from_fn(|i| least(&beams.grams[i], low[i]));
        let high = from_fn(|i| least(&beams.grams[i], high[i]));
        let length = Tail::of(&beams.weight, low, high).quantile(&[1.0; BEAMS]);
        let shear = (length - along).max(0.0) * (square - across);
        let upright = Extent { across, along, shear };
        let lying = if may_turn { Extent { across: along, along: across, shear } } else { Extent::NONE };
        Self { upright, lying }
    }

    /// A tile that spans both.
    pub(crate) fn max(self, other: Self) -> Self {
        Self { upright: self.upright.max(other.upright), lying: self.lying.max(other.lying) }
    }

    /// What some samples span.
    pub(crate) fn of(grams: &[Gram], may_turn: bool, values: &mut Vec<f64>) -> Self {
        let across = quantile(grams.iter().map(|gram| gram.xx), values);
        let along = quantile(grams.iter().map(|gram| gram.yy), values);
        let mut extent = |across: f64, along: f64, of: fn(&Gram) -> (f64, f64)| {
            let square = TRADED * across;
            let least = |gram: &Gram| {
                let (across, along) = of(gram);
                let free = square - across;
                if free > 0.0 { along + gram.xy * gram.xy / free } else { f64::INFINITY }
            };
            let length = quantile(grams.iter().map(least), values);
            // Where many samples are as wide as the tile the length has no bound; what it may grow by has one.
            let rest = (length - along).clamp(0.0, MOST_TRADED * along);
            Extent { across, along, shear: rest * (square - across) }
        };
        let upright = extent(across, along, |gram| (gram.xx, gram.yy));
        let lying = if may_turn { extent(along, across, |gram| (gram.yy, gram.xx)) } else { Extent::NONE };
        Self { upright, lying }
    }

    /// Product of the least sides, in squares of texels times footprint.
    pub(super) fn least_area(&self) -> f64 {
        (self.upright.across * self.upright.along).sqrt()
    }

    /// Square of the longest side that its widths should reach.
    fn longest(&self, may_turn: bool) -> f64 {
        if may_turn { self.upright.across.max(self.upright.along) } else { self.upright.across }
    }

    /// Its least lengths.
    pub(super) fn curve(&self, may_turn: bool, widths: &[f64; WIDTHS]) -> Curve {
        let mut curve = Curve { lengths: [LONGEST; WIDTHS], turned: [false; WIDTHS] };
        let lengths = curve.lengths.iter_mut().zip(&mut curve.turned);
        for ((length, turned), width) in lengths.zip(widths) {
            let upright = self.upright.square(width * width);
            let lying = if may_turn { self.lying.square(width * width) } else { LONGEST * LONGEST };
            *turned = lying < upright;
            *length = if *turned { lying } else { upright }.sqrt();
        }
        curve
    }
}

impl Extent {
    const NONE: Self = Self { across: 0.0, along: 0.0, shear: 0.0 };

    fn max(self, other: Self) -> Self {
        Self {
            across: self.across.max(other.across),
            along: self.along.max(other.along),
            shear: self.shear.max(other.shear),
        }
    }

    /// Square of the least length at the square of a width.
    fn square(&self, width: f64) -> f64 {
        let free = width - self.across;
        let square = self.along + self.shear / free;
        if free > 0.0 && square < LONGEST * LONGEST { square } else { LONGEST * LONGEST }
    }
}

/// Values that are even over intervals, one for each ray, as a share of the whole.
struct Tail<'a> {
    weight: &'a [f64; BEAMS],
    high: [f64; BEAMS],
    /// Weight per length of each interval.
    density: [f64; BEAMS],
    /// Weight between 0 and the end of each, were it as long.
    top: [f64; BEAMS],
    /// The quantile of each alone.
    alone: [f64; BEAMS],
    /// Weight above the quantile.
    above: f64,
}

impl<'a> Tail<'a> {
    fn of(weight: &'a [f64; BEAMS], low: [f64; BEAMS], high: [f64; BEAMS]) -> Self {
        // Intervals of no length are as good as very short ones.
        let low: [f64; BEAMS] = from_fn(|i| low[i].min(high[i] * (1.0 - SHORTEST)));
        let density: [f64; BEAMS] =
            from_fn(|i| if weight[i] > 0.0 { weight[i] / (high[i] - low[i]) } else { 0.0 });
        let above = (1.0 - SHARE) * weight.iter().sum::<f64>();
        let top = from_fn(|i| high[i] * density[i]);
        let alone = from_fn(|i| high[i] - (high[i] - low[i]) * (above / weight[i]));
        Self { weight, high, density, top, alone, above }
    }

    /// The value that a share of all does not exceed, where each interval is stretched by a factor: the root of a
    /// function that falls in straight pieces.
    fn quantile(&self, factors: &[f64; BEAMS]) -> f64 {
        if self.above <= 0.0 {
            return 0.0;
        }
        // The largest value that one interval alone would make is no larger than all make together.
        let most = largest(|i| self.high[i] * factors[i]);
        let alone = largest(|i| if self.weight[i] > self.above { self.alone[i] * factors[i] } else { 0.0 });
        let mut limits = (alone, most);
        let mut value = if alone > 0.0 { alone } else { FIRST * most };
        let per_factor = |factor: f64| if factor == 1.0 { 1.0 } else { 1.0 / factor };
        let stretched: [f64; BEAMS] =
            from_fn(|i| if factors[i] > 0.0 { self.density[i] * per_factor(factors[i]) } else { f64::MAX });
        for _ in 0..ROUNDS {
            // Sums in lanes, which processors add side by side.
            let (mut above, mut slope) = ([0.0; LANES], [0.0; LANES]);
            for start in (0..BEAMS).step_by(LANES) {
                for lane in 0..LANES {
                    let i = start + lane;
                    let part = self.top[i] - value * stretched[i];
                    let part = if part > 0.0 { part } else { 0.0 };
                    above[lane] += if part < self.weight[i] { part } else { self.weight[i] };
                    let inside = (part > 0.0) & (part < self.weight[i]);
                    slope[lane] += if inside { stretched[i] } else { 0.0 };
                }
            }
            let excess = above.iter().sum::<f64>() - self.above;
            if excess.abs() <= CLOSE * self.above {
                break;
            }
            if excess > 0.0 {
                limits.0 = value;
            } else {
                limits.1 = value;
            }
            let next = value + excess / slope.iter().sum::<f64>();
            value = if next > limits.0 && next < limits.1 { next } else { 0.5 * (limits.0 + limits.1) };
        }
        value
    }
}

/// The largest of some values of rays, or 0.
fn largest(value: impl Fn(usize) -> f64) -> f64 {
    (0..BEAMS).map(value).fold(0.0, |largest, value| if value > largest { value } else { largest })
}

/// Widths at which curves are known: a square law, dense where tiles are narrow.
pub(super) fn widths(spreads: impl Iterator<Item = (Spread, bool)>) -> [f64; WIDTHS] {
    let longest = spreads.map(|(spread, may_turn)| spread.longest(may_turn));
    let longest = longest.fold(f64::MIN_POSITIVE, f64::max).sqrt();
    std::array::from_fn(|index| {
        let part = (index + 1) as f64 / WIDTHS as f64;
        WIDEST * longest * part * part
    })
}

/// The value that a share of the samples does not exceed; harmonic between neighbours, so that infinity is reached
/// continuously. `list` is scratch.
fn quantile(values: impl ExactSizeIterator<Item = f64>, list: &mut Vec<f64>) -> f64 {
    let count = values.len();
    let position = SHARE * count.saturating_sub(1) as f64;
    let (below, part) = (position as usize, position.fract());
    let largest = count - below.min(count);
    let (below, above) = if largest <= FEW {
        // Keep the largest values in falling order.
        let mut kept = [f64::NEG_INFINITY; FEW];
        let kept = &mut kept[..largest];
        for value in values {
            let mut value = value;
            for place in kept.iter_mut() {
                if value > *place {
                    std::mem::swap(place, &mut value);
                }
            }
        }
        match *kept {
            [] => return 0.0,
            [only] => return only,
            [.., above, below] => (below, above),
        }
    } else {
        list.clear();
        list.extend(values);
        let (_, below, rest) = list.select_nth_unstable_by(below, f64::total_cmp);
        (*below, rest.iter().copied().fold(f64::INFINITY, f64::min))
    };
    if below > 0.0 { 1.0 / ((1.0 - part) / below + part / above) } else { below }
}
