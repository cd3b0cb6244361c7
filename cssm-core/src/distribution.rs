//! Distributions: how the rows of a column of the map are spent over depth. One file each; a distribution knows
//! nothing of the configuration that uses it.

mod bands;
mod perspective;

pub use perspective::perspective_piece;

use crate::case::LightCase;
use crate::schema::{Arguments, Choice};

/// What the house knows about a distribution.
#[derive(Debug, Clone, Copy)]
pub struct DistributionSpec {
    /// Name, summary and parameters as declared.
    pub choice: Choice,
    /// Number of pieces that every column has.
    pub pieces: fn(&Arguments) -> u32,
    /// The pieces of one column, nearest first.
    pub split: fn(&Arguments, &DistanceRange) -> Vec<Piece>,
}

/// Every distribution: the one place outside its own file that names it.
pub const DISTRIBUTIONS: &[DistributionSpec] = &[bands::SPEC, perspective::SPEC];

/// Their declared names and parameters.
pub const CHOICES: &[Choice] = &choices();

const fn choices() -> [Choice; DISTRIBUTIONS.len()] {
    let mut choices = [DISTRIBUTIONS[0].choice; DISTRIBUTIONS.len()];
    let mut index = 0;
    while index < choices.len() {
        choices[index] = DISTRIBUTIONS[index].choice;
        index += 1;
    }
    choices
}

/// The distances that a column holds: values of a row that annihilates the light, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DistanceRange {
    /// Smallest distance of a receiver.
    pub nearest_metres: f64,
    /// Largest; may be infinite.
    pub farthest_metres: f64,
    /// How much nearer than the near plane the distance falls although receivers do not: distance + core is what
    /// screen size goes with.
    pub core_metres: f64,
}

/// A part of a column that is affine in 1 / (distance + push-back).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Where it begins.
    pub nearest_metres: f64,
    /// Where it ends; may be infinite.
    pub farthest_metres: f64,
    /// Added to the distance for the divisor; infinite: rows are uniform.
    pub push_back_metres: f64,
}

/// Number of pieces in every column of a case.
pub fn pieces(case: &LightCase) -> u32 {
    let (spec, arguments) = of(case);
    (spec.pieces)(arguments)
}

/// The pieces of one column of a case.
pub fn split(case: &LightCase, range: &DistanceRange) -> Vec<Piece> {
    let (spec, arguments) = of(case);
    (spec.split)(arguments, range)
}

/// The entry of a case's distribution; the first where it has none.
fn of(case: &LightCase) -> (&'static DistributionSpec, &Arguments) {
    static NONE: Arguments = Arguments(Vec::new());
    let word = case.distribution.as_ref();
    let spec = word.and_then(|word| DISTRIBUTIONS.iter().find(|spec| spec.choice.name == word.name));
    (spec.unwrap_or(&DISTRIBUTIONS[0]), word.map_or(&NONE, |word| &word.arguments))
}
