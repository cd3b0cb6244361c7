//! Bands: the logarithm of distance in equal steps, each step affine in 1 / distance. Straight lines stay straight, so
//! ordinary rasterisation is exact; the last band reaches to infinity where the view does.

use super::{DistanceRange, DistributionSpec, Piece};
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
            Field {
                name: "horizon",
                summary: "depth up to which bands have equal ratios when the far plane is infinite",
                kind: Kind::Number { min: 0.0, max: 1e9, open: true, unit: Unit::Length },
                default: Default::Value("100 km"),
            },
        ],
    },
    pieces: count,
    split,
};

/// Distance, in cores, that counts as below zero.
const BELOW_ZERO: f64 = 1e-9;

fn count(arguments: &Arguments) -> u32 {
    arguments.count("count").unwrap_or(8)
}

fn split(arguments: &Arguments, range: &DistanceRange) -> Vec<Piece> {
    let count = count(arguments);
    let horizon = arguments.number("horizon").unwrap_or(1e5);
    let core = range.core_metres;

    // Equal ratios of distance + core; with an infinite far plane the ratio is that up to the horizon.
    let start = range.nearest_metres + core;
    let farthest = range.farthest_metres;
    let end = if farthest.is_finite() { farthest + core } else { horizon.max(2.0 * start) };
    let ratio = libm::pow(end / start, 1.0 / f64::from(count));
    let limit = |index: u32| match index {
        0 => range.nearest_metres,
        index if index == count => farthest,
        index => start * libm::pow(ratio, f64::from(index)) - core,
    };

    // Only the nearest band sees the difference between distance and depth, unless distances fall below zero.
    let below_zero = range.nearest_metres < -BELOW_ZERO * core;
    let piece = |index: u32| Piece {
        nearest_metres: limit(index),
        farthest_metres: limit(index + 1),
        push_back_metres: if index == 0 || below_zero { core } else { 0.0 },
    };
    (0..count).map(piece).collect()
}
