//! Two segments: the logarithm of distance on either side of a focus, with a declared share of the map before it. It stands
//! for the paper's arbitrary distance distribution.
//!
//! The focus is a fold: rows on either side are even, and the tiles before it are finer by what the share asks.

use super::bands::HORIZON;
use super::logarithmic::{folded, logarithmic_piece};
use super::perspective::{SHARE, share};
use super::{DistanceRange, DistributionSpec, Piece, Pieces, RemapKind, folds};
use crate::focus;
use crate::schema::{Arguments, Choice};

pub(super) const SPEC: DistributionSpec = DistributionSpec {
    choice: Choice {
        name: "two_segment",
        summary: "logarithmic on either side of a focus that a share of the map lies before; needs stretching",
        arguments: &[focus::FIELD, SHARE, HORIZON, folds::field(2, "8")],
    },
    pieces: folds::count,
    bent: RemapKind::Logarithmic,
    straight: false,
    split,
};

/// Logarithm of the distance ratio on either side of the focus below which the column is not parted there.
const SMALLEST_PART: f64 = 0.01;
/// Largest ratio of densities on either side of the focus: beyond it tiles would go to receivers of no extent.
const LARGEST_RATIO: f64 = 64.0;

fn split(arguments: &Arguments, range: &DistanceRange) -> Pieces {
    let whole = logarithmic_piece(arguments, range);
    let count = folds::count(arguments).max(2);
    let core = range.core_metres;
    let (start, farthest) = (range.nearest_metres + core, range.farthest_metres + core);
    let focus = range.focus_metres(arguments);
    let value = |distance: f64| whole.curve.value(1.0 / distance);
    let parts = [value(focus) - value(start), value(farthest) - value(focus)];
    if parts.iter().any(|part| part.is_nan() || *part < SMALLEST_PART) {
        return folded(&whole, count);
    }

    // Densities on either side: the share before the focus over its part of the whole, were it even.
    let share = share(arguments);
    let near = range.unlit_near_metres.unwrap_or(start);
    let (before, after) = (value(focus) - value(near), value(farthest) - value(focus));
    let ratio = (share / (1.0 - share) * after / before).clamp(1.0 / LARGEST_RATIO, LARGEST_RATIO);

    // Areas go with the square of what texels span.
    let near_count = ((share * f64::from(count)).round() as u32).clamp(1, count - 1);
    let near = Piece { farthest_metres: focus - core, weight: ratio.sqrt(), ..whole };
    let far = Piece { nearest_metres: focus - core, ..whole };
    folded(&near, near_count).into_iter().chain(folded(&far, count - near_count)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::schema::Value;

    #[test]
    fn densities_on_either_side_of_the_focus_give_the_declared_share() {
        for (farthest, share) in [(1000.0, 0.5), (1000.0, 0.8), (f64::INFINITY, 0.65)] {
            let arguments = Arguments(vec![("focus", Value::Number(10.0)), ("share", Value::Number(share))]);
            let range = DistanceRange {
                nearest_metres: 0.1,
                farthest_metres: farthest,
                core_metres: 0.1,
                unlit_near_metres: None,
                eye_height_metres: None,
                seen: None,
                bends: true,
            };
            let pieces = split(&arguments, &range);
            assert!(pieces.windows(2).all(|pair| pair[0].farthest_metres == pair[1].nearest_metres));
            assert!(pieces.iter().any(|piece| (piece.farthest_metres - 9.9).abs() < 1e-9));
            let area = |piece: &Piece| {
                let value = |distance: f64| piece.curve.value(1.0 / (distance + 0.1));
                (value(piece.farthest_metres) - value(piece.nearest_metres)) * piece.weight * piece.weight
            };
            let before: f64 = pieces.iter().filter(|piece| piece.farthest_metres < 10.0).map(area).sum();
            let all: f64 = pieces.iter().map(area).sum();
            assert!((before / all - share).abs() < 1e-9, "{farthest} {share} {}", before / all);
        }
    }
}
