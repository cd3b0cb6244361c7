//! Bands: the logarithm of distance in equal steps, each step affine in 1 / (distance + push-back). Straight lines
//! stay straight, so ordinary rasterisation is exact; the last band reaches to infinity where the view does.

use smallvec::SmallVec;

use super::{DistanceRange, DistributionSpec, Piece, Pieces, RemapKind};
use crate::remap::Curve;
use crate::schema::{Arguments, Choice, Default, Field, Kind, Unit};

pub(super) const SPEC: DistributionSpec = DistributionSpec {
    choice: Choice {
        name: "bands",
        summary: "bands of equal depth ratio, each affine in 1/depth",
        arguments: &[
            Field {
                name: "count",
                summary: "number of bands",
                kind: Kind::Count { min: 1, max: 16 },
                default: Default::Value("8"),
            },
            HORIZON,
        ],
    },
    pieces: count,
    bent: RemapKind::None,
    straight: true,
    split,
};

/// Where an infinite far plane stands in for.
pub(super) const HORIZON: Field = Field {
    name: "horizon",
    summary: "depth up to which rows follow the logarithm when the far plane is infinite",
    kind: Kind::Number { min: 0.0, max: 1e9, open: true, unit: Unit::Length },
    default: Default::Value("100 km"),
};
/// Horizon where a declaration holds none, metres.
const DEFAULT_HORIZON_METRES: f64 = 1e5;
/// Distance, in cores, that counts as below zero.
const BELOW_ZERO: f64 = 1e-9;

/// Push-back in geometric means of a band's ends: rows grow less along the band, the far end narrows.
const PUSH_BACK: f64 = 0.6;

fn count(arguments: &Arguments) -> u32 {
    arguments.count("count").unwrap_or(8)
}

/// The declared horizon, beyond a start.
pub(super) fn horizon(arguments: &Arguments, start: f64) -> f64 {
    arguments.number(HORIZON.name).unwrap_or(DEFAULT_HORIZON_METRES).max(2.0 * start)
}

fn split(arguments: &Arguments, range: &DistanceRange) -> Pieces {
    let count = count(arguments);
    let core = range.core_metres;

    // Equal ratios of distance + core; with an infinite far plane the ratio is that up to the horizon.
    let start = range.nearest_metres + core;
    let farthest = range.farthest_metres;
    let end = if farthest.is_finite() { farthest + core } else { horizon(arguments, start) };
    let ratio = libm::pow(end / start, 1.0 / f64::from(count));
    let mut power = start / ratio;
    let ends = (0..=count).map(|index| {
        power *= ratio;
        match range.seen {
            Some(seen) => seen.mixed(f64::from(index) / f64::from(count), start, end),
            None => power,
        }
    });
    let ends: SmallVec<[f64; 17]> = ends.collect();
    let end_of = |index: u32| ends[index as usize];
    let limit = |index: u32| match index {
        0 => range.nearest_metres,
        index if index == count => farthest,
        index => end_of(index) - core,
    };

    // Only the nearest band sees the difference between distance and depth, unless distances fall below zero.
    let below_zero = range.nearest_metres < -BELOW_ZERO * core;
    let piece = |index: u32| {
        let from_core = if index == 0 || below_zero { core } else { 0.0 };
        let far_end = end_of(index + 1);
        let ratio = if range.seen.is_some() { far_end / end_of(index) } else { ratio };
        Piece {
            nearest_metres: limit(index),
            farthest_metres: limit(index + 1),
            push_back_metres: from_core + far_end * PUSH_BACK / ratio.sqrt(),
            curve: Curve::Straight,
            weight: 1.0,
            focus_metres: f64::INFINITY,
        }
    };
    (0..count).map(piece).collect()
}
