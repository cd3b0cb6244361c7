//! How long a tile must be, at each width, for the same footprint.
//!
//! Sides are measured in texels times the footprint in pixels: a tile of inner width w / f and inner length l / f has
//! the footprint f, whatever f is. Where a texel spans the vectors x / width and y / length of a sample, its major axis
//! is at most f exactly where (w^2 - x.x) (l^2 - y.y) >= (x.y)^2. Over many samples the quantiles of x.x and y.y bound
//! both sides, and the third figure, found a little above the least width, says how they trade between.

use smallvec::SmallVec;

use super::Gram;

/// Number of widths.
pub(super) const WIDTHS: usize = 48;
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
/// Largest values that are kept sorted while values pass by; more are selected.
const FEW: usize = 8;

/// Scratch for values that are selected.
type Values = SmallVec<[f64; 64]>;

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
pub(super) struct Curve {
    /// Least length at each width, upright or turned, whichever is shorter.
    pub(super) lengths: [f64; WIDTHS],
    /// Whether the turned one is shorter.
    pub(super) turned: [bool; WIDTHS],
}

impl Spread {
    /// A tile that spans nothing.
    pub const NONE: Self = Self { upright: Extent::NONE, lying: Extent::NONE };

    /// What some samples span.
    pub(crate) fn of(grams: &[Gram], may_turn: bool) -> Self {
        let mut values = Values::new();
        let across = quantile(grams.iter().map(|gram| gram.xx), &mut values);
        let along = quantile(grams.iter().map(|gram| gram.yy), &mut values);
        let mut extent = |across: f64, along: f64, of: fn(&Gram) -> (f64, f64)| {
            let square = TRADED * across;
            let least = |gram: &Gram| {
                let (across, along) = of(gram);
                let free = square - across;
                if free > 0.0 { along + gram.xy * gram.xy / free } else { f64::INFINITY }
            };
            let length = quantile(grams.iter().map(least), &mut values);
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
        let upright = widths.map(|width| self.upright.length(width));
        if !may_turn {
            return Curve { lengths: upright, turned: [false; WIDTHS] };
        }
        let lying = widths.map(|width| self.lying.length(width));
        Curve {
            lengths: std::array::from_fn(|index| upright[index].min(lying[index])),
            turned: std::array::from_fn(|index| lying[index] < upright[index]),
        }
    }
}

impl Extent {
    const NONE: Self = Self { across: 0.0, along: 0.0, shear: 0.0 };

    /// Least length at a width.
    fn length(&self, width: f64) -> f64 {
        let free = width * width - self.across;
        if free > 0.0 { (self.along + self.shear / free).sqrt().min(LONGEST) } else { LONGEST }
    }
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
fn quantile(values: impl ExactSizeIterator<Item = f64>, list: &mut Values) -> f64 {
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
