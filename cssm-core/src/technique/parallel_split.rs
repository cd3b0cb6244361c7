//! Parallel-split shadow maps: depth slabs along the view, one uniform facet each.

use super::TechniqueSpec;
use crate::case::{CaseError, LightCase};
use crate::facet::FacetShape;
use crate::schema::{Choice, Default, Field, Kind, Unit};

const SCHEMES: &[Choice] = &[
    Choice::plain("uniform", "slabs of equal depth"),
    Choice::plain("logarithmic", "slabs of equal depth ratio"),
    Choice {
        name: "practical",
        summary: "blend of logarithmic and uniform limits",
        arguments: &[Field {
            name: "lambda",
            summary: "weight of the logarithmic limit",
            kind: Kind::Number { min: 0.0, max: 1.0, open: false, unit: Unit::None },
            default: Default::Value("0.5"),
        }],
    },
];

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "parallel_split",
        summary: "depth slabs along the view, one uniform map each",
        arguments: &[
            Field {
                name: "splits",
                summary: "number of slabs",
                kind: Kind::Count { min: 2, max: 8 },
                default: Default::Value("4"),
            },
            Field {
                name: "scheme",
                summary: "where the slabs' limits lie",
                kind: Kind::Choice(SCHEMES),
                default: Default::Value("practical { lambda: 0.5 }"),
            },
            Field {
                name: "sizes",
                summary: "tile size of each slab, nearest first",
                kind: Kind::SizeList { min: 32, max: crate::case::MAP_SIDE_LIMIT_TEXELS },
                default: Default::Absent("the map in equal tiles"),
            },
        ],
    },
    configurations: &[Choice::plain("slabs", "one facet per depth slab")],
    distribution: None,
    shape: |case| FacetShape { sectors: 1, bands: case.technique.arguments.count("splits").unwrap_or(4) },
    check,
};

fn check(case: &LightCase) -> Vec<CaseError> {
    let splits = case.technique.arguments.count("splits").unwrap_or(4);
    match case.technique.arguments.sizes("sizes") {
        Some(sizes) if sizes.len() != splits as usize => vec![CaseError {
            field: "technique.sizes".into(),
            message: format!("{} sizes are given for {splits} splits", sizes.len()),
            remedy: "give one size per split or leave sizes out".into(),
        }],
        _ => Vec::new(),
    }
}
