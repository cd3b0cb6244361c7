//! Filters in declarations: their names and arguments.

use super::MOST_GROUND_PLANES;
use crate::schema::{Choice, Default, Field, Kind, Unit};

/// Filters in declarations.
pub(in crate::case) const FILTERS: &[Choice] = &[
    Choice::plain("none", "nearest texel, hard edge"),
    Choice::plain("hardware_2x2", "comparison sampler: one reference for four texels"),
    Choice::plain("gather_2x2", "four texels, each compared with its own reference"),
    Choice {
        name: "pcf_3x3",
        summary: "a box of up to 3 x 3 texels, each with its own reference",
        arguments: PCF,
    },
    Choice {
        name: "pcf_5x5",
        summary: "a box of up to 5 x 5 texels, each with its own reference",
        arguments: PCF,
    },
    Choice {
        name: "pcf_7x7",
        summary: "a box of up to 7 x 7 texels, each with its own reference",
        arguments: PCF,
    },
    Choice {
        name: "pcss",
        summary: "a box as wide as the light's extent makes the shadow's edge, in metres",
        arguments: PCSS,
    },
    Choice {
        name: "evsm_2",
        summary: "moments of warped depth, blurred ahead of resolving; for directional lights",
        arguments: EVSM,
    },
    Choice {
        name: "ground_masks",
        summary: "shadows on given planes, blurred ahead of resolving; gather_2x2 on all else",
        arguments: GROUND,
    },
];

const PCF: &[Field] = &[Field {
    name: "kernel",
    summary: "width of the box, along each axis of the map by itself",
    kind: Kind::Choice(&[
        Choice::plain("texels", "as many texels as the filter takes"),
        Choice {
            name: "metres",
            summary: "a distance across the light, between one texel and what the filter takes",
            arguments: &[Field {
                name: "width",
                summary: "the distance",
                kind: Kind::Number { min: 0.0, max: 1e3, open: true, unit: Unit::Length },
                default: Default::Value("5 cm"),
            }],
        },
        Choice {
            name: "pixels",
            summary: "a distance across the light that spans so many screen pixels at the receiver's depth, between \
                      one texel and what the filter takes",
            arguments: &[Field {
                name: "width",
                summary: "the pixels",
                kind: Kind::Number { min: 0.0, max: 1e3, open: true, unit: Unit::Pixels },
                default: Default::Value("3 px"),
            }],
        },
    ]),
    default: Default::Value("texels"),
}];

const PCSS: &[Field] = &[
    Field {
        name: "angle",
        summary: "angular diameter of a directional light",
        kind: Kind::Number { min: 0.0, max: 45.0, open: true, unit: Unit::Degrees },
        default: Default::Absent("the sun's, 0.53 degrees, where the light is directional"),
    },
    Field {
        name: "radius",
        summary: "radius of a local light",
        kind: Kind::Number { min: 0.0, max: 1e3, open: true, unit: Unit::Length },
        default: Default::Absent("5 cm where the light is local"),
    },
    Field {
        name: "reach",
        summary: "texels that shadows' edges may spread to either side; tiles have gutters of as many",
        kind: Kind::Count { min: 1, max: 15 },
        default: Default::Value("5"),
    },
];

const EVSM: &[Field] = &[
    Field {
        name: "exponent",
        summary: "exponent over the whole depth of a facet; the larger, the less light leaks",
        kind: Kind::Number { min: 1.0, max: 42.0, open: false, unit: Unit::None },
        default: Default::Value("20"),
    },
    Field {
        name: "blur",
        summary: "texels to either side that moments are blurred over, within the tile",
        kind: Kind::Count { min: 1, max: 8 },
        default: Default::Value("2"),
    },
    Field {
        name: "bleeding",
        summary: "share of light below which a receiver is dark, against light that leaks between casters",
        kind: Kind::Number { min: 0.0, max: 0.95, open: false, unit: Unit::None },
        default: Default::Value("0.1"),
    },
];

const GROUND: &[Field] = &[
    Field {
        name: "planes",
        summary: "planes, each with a channel of its own",
        kind: Kind::Count { min: 1, max: MOST_GROUND_PLANES as u32 },
        default: Default::Value("1"),
    },
    Field {
        name: "blur",
        summary: "standard deviation of the blur on the plane",
        kind: Kind::Number { min: 0.0, max: 1e3, open: true, unit: Unit::Length },
        default: Default::Value("10 cm"),
    },
    Field {
        name: "reach",
        summary: "texels to either side that the blur is cut off at; tiles have gutters of two more",
        kind: Kind::Count { min: 1, max: 31 },
        default: Default::Value("8"),
    },
];
