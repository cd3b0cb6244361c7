//! Folds: a long narrow column cut into pieces of equal rows, which lie side by side in a regular map. Each piece is as wide
//! as its own receivers.

use super::{Piece, Pieces};
use crate::remap::Curve;
use crate::schema::{Arguments, Default, Field, Kind};

/// Largest number of pieces.
const MOST: u32 = 16;

/// The declared field, with its smallest value and its default.
pub(super) const fn field(min: u32, default: &'static str) -> Field {
    Field {
        name: "folds",
        summary: "pieces of equal rows that a column is folded into",
        kind: Kind::Count { min, max: MOST },
        default: Default::Value(default),
    }
}

/// The declared number of pieces.
pub(super) fn count(arguments: &Arguments) -> u32 {
    arguments.count("folds").unwrap_or(1)
}

/// A whole column in so many pieces, whose rows run with a curve of 1 / (distance + offset).
pub(super) fn folded(whole: Piece, rows: Curve, offset_metres: f64, count: u32) -> Pieces {
    let value = |distance: f64| rows.value(1.0 / (distance + offset_metres));
    let (first, last) = (value(whole.nearest_metres), value(whole.farthest_metres));
    let limit = |index: u32| match index {
        0 => whole.nearest_metres,
        index if index == count => whole.farthest_metres,
        index => {
            let share = f64::from(index) / f64::from(count);
            1.0 / rows.inverse(first + (last - first) * share) - offset_metres
        }
    };
    let piece =
        |index: u32| Piece { nearest_metres: limit(index), farthest_metres: limit(index + 1), ..whole };
    (0..count).map(piece).collect()
}
