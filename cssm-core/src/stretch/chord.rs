//! How a remap bends an edge between two k. The rows of every remap bend to one side.

use crate::remap::{Curve, Remap};

/// How rows bend between two k, in NDC.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bend {
    /// Least change of NDC per change of k.
    pub least: f64,
    /// Greatest change.
    pub most: f64,
    /// Whether rows lie above the chord.
    pub up: bool,
    /// Whether rows lie below the chord.
    pub down: bool,
}

/// How the rows bend from one k to a larger one.
pub fn bend(remap: &Remap, low: f64, high: f64) -> Bend {
    let (start, end) = (remap.slope(low), remap.slope(high));
    Bend { least: start.min(end), most: start.max(end), up: start > end, down: start < end }
}

/// Largest distance, in NDC, between the bent rows from one k to a larger one and the chord across them.
pub fn chord_error(remap: &Remap, low: f64, high: f64) -> f64 {
    let span = high - low;
    if span.is_nan() || span <= 0.0 {
        return 0.0;
    }

    // The gap is widest where the curve runs along the chord.
    let (start, secant) = (remap.y(low), (remap.y(high) - remap.y(low)) / span);
    let widest = match remap.curve {
        Curve::Straight => return 0.0,
        Curve::Perspective { push_back_metres } => {
            (libm::sqrt(remap.scale / secant) - 1.0) / push_back_metres
        }
        Curve::Logarithmic { .. } => -remap.scale / secant,
    };
    if !(widest > low && widest < high) {
        return 0.0;
    }
    (remap.y(widest) - start - secant * (widest - low)).abs()
}

/// No less than [`chord_error`], and no more than the shaders' own estimate of it up to rounding, which no point needs to
/// be searched for: the second derivative is largest where the curve begins.
pub fn chord_bound(remap: &Remap, low: f64, high: f64) -> f64 {
    match remap.curve {
        Curve::Straight => 0.0,
        Curve::Perspective { .. } => chord_error(remap, low, high),
        Curve::Logarithmic { horizon_metres, .. } => {
            let horizon = 1.0 / horizon_metres;
            let relative = (high - low) / low.max(horizon);
            if high <= horizon { 0.0 } else { 0.125 * relative * relative * remap.scale.abs() }
        }
    }
}
