//! Parallel-split shadow maps: depth slabs along the view, one uniform facet each.

use glam::DVec4;

use super::standard::light_plane_axes;
use super::{
    ConfigurationSpec, Draft, FacetDraft, Region, Situation, TechniqueSpec, TileRequest, only_directional,
};
use crate::case::{CaseError, LightCase, LightKind};
use crate::facet::{Cell, FacetShape, Selection};
use crate::plan::PlanError;
use crate::receivers::DEPTH_ROW;
use crate::schema::{Choice, Default, Field, Kind, Unit, Word};

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
    configurations: &[CONFIGURATION],
    default_configurations: |light| only_directional(light, &["slabs"]),
    distribution: None,
    fits_infinity: false,
    follows_camera: false,
    variants: &[
        "parallel_split { splits: 4, scheme: logarithmic }",
        "parallel_split { splits: 4, scheme: practical { lambda: 0.5 } }",
        "parallel_split { splits: 4, scheme: uniform }",
    ],
    check,
};

const CONFIGURATION: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("slabs", "one facet per depth slab"),
    lights: &[LightKind::Directional],
    takes_distribution: false,
    serves: |_| true,
    shape: |case, _| FacetShape {
        bands: case.technique.arguments.count("splits").unwrap_or(4),
        ..FacetShape::ONE
    },
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word) -> Result<Vec<Draft>, PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }
    let arguments = &situation.case.technique.arguments;
    let splits = arguments.count("splits").unwrap_or(4);
    let (near, far) = situation.receivers.range(DEPTH_ROW);
    let limits = split_limits(situation.case, near, far, splits);
    let (x, y) = light_plane_axes(situation.light);

    // A slab selects receivers; it does not contain the light, so no caster may be cut with it.
    let facets = (0..splits).map(|index| {
        let slab = index as usize;
        let mut select = Vec::new();
        if index > 0 {
            select.push(DEPTH_ROW - DVec4::W * limits[slab - 1]);
        }
        if index + 1 < splits {
            select.push(DVec4::W * limits[slab] - DEPTH_ROW);
        }
        let receivers = situation.receivers.cut_by(&select);
        let region = Region::Tile(match arguments.sizes("sizes") {
            Some(sizes) => TileRequest::Fixed(sizes[slab].0, sizes[slab].1),
            None => TileRequest::Share(1.0 / f64::from(splits)),
        });
        FacetDraft::straight(Cell::of(0, index), [x, y, DVec4::W], (select, receivers), region)
    });
    Ok(vec![Draft {
        configuration: CONFIGURATION.choice.name,
        form: "",
        complete: true,
        facets: facets.collect(),
        selection: Selection {
            distances: vec![DEPTH_ROW],
            thresholds: vec![limits],
            ..Selection::around(1, splits)
        },
    }])
}

/// Depths of the inner limits, ascending (parallel-split slides, "split schemes").
fn split_limits(case: &LightCase, near: f64, far: f64, splits: u32) -> Vec<f64> {
    let scheme = case.technique.arguments.word("scheme");
    let lambda = match scheme.map(|word| word.name) {
        Some("uniform") => 0.0,
        Some("logarithmic") => 1.0,
        _ => scheme.and_then(|word| word.arguments.number("lambda")).unwrap_or(0.5),
    };
    let limit = |index: u32| {
        let share = f64::from(index) / f64::from(splits);
        let logarithmic = near * libm::pow(far / near, share);
        let uniform = near + (far - near) * share;
        lambda * logarithmic + (1.0 - lambda) * uniform
    };
    (1..splits).map(limit).collect()
}

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
