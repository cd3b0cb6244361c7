//! Logarithmic: rows run with the logarithm of distance, so that every texel spans the same share of it. No homography
//! does that; rows are bent.

use super::bands::{HORIZON, horizon};
use super::{DistanceRange, DistributionSpec, Piece, Pieces, RemapKind, folds};
use crate::remap::Curve;
use crate::schema::{Arguments, Choice};

pub(super) const SPEC: DistributionSpec = DistributionSpec {
    choice: Choice {
        name: "logarithmic",
        summary: "rows run with the logarithm of depth, without steps; needs stretching",
        arguments: &[HORIZON, folds::field(1, "8")],
    },
    pieces: folds::count,
    bent: RemapKind::Logarithmic,
    straight: false,
    split,
};

fn split(arguments: &Arguments, range: &DistanceRange) -> Pieces {
    folded(&logarithmic_piece(arguments, range), folds::count(arguments))
}

/// A whole column whose rows run with the logarithm.
pub(super) fn logarithmic_piece(arguments: &Arguments, range: &DistanceRange) -> Piece {
    let core = range.core_metres;
    let start = range.nearest_metres + core;
    let bounded = range.farthest_metres.is_finite();
    let horizon_metres = if bounded { f64::INFINITY } else { horizon(arguments, start) };
    Piece {
        nearest_metres: range.nearest_metres,
        farthest_metres: range.farthest_metres,
        push_back_metres: core,
        curve: Curve::Logarithmic { reference_metres: start, horizon_metres },
        weight: 1.0,
        focus_metres: f64::INFINITY,
    }
}

/// Its pieces of equal rows.
pub(super) fn folded(whole: &Piece, count: u32) -> Pieces {
    folds::folded(*whole, whole.curve, whole.push_back_metres, count)
}
