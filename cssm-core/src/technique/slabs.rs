//! Depth slabs along the view: where their limits lie, and how many texels each has (parallel-split slides, "view frustum
//! split").

use glam::DVec4;
use smallvec::SmallVec;

use super::{Draft, FacetDraft, Sides};

use crate::case::{CaseError, LightCase};
use crate::facet::Selection;
use crate::receivers::{DEPTH_ROW, Polytope, Slices};
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

/// `splits`, the number of slabs.
pub(super) const SPLITS: Field = Field {
    name: "splits",
    summary: "number of slabs",
    kind: Kind::Count { min: 2, max: 8 },
    default: Default::Value("4"),
};

/// `scheme`, where their limits lie.
pub(super) const SCHEME: Field = Field {
    name: "scheme",
    summary: "where the slabs' limits lie",
    kind: Kind::Choice(SCHEMES),
    default: Default::Value("practical { lambda: 0.5 }"),
};

/// `sizes`, the tile of each.
pub(super) const SIZES: Field = Field {
    name: "sizes",
    summary: "tile size of each slab, nearest first",
    kind: Kind::SizeList { min: 32, max: crate::case::MAP_SIDE_LIMIT_TEXELS },
    default: Default::Absent("the map in equal tiles"),
};

/// Declared number of slabs.
pub(super) fn count(case: &LightCase) -> u32 {
    case.technique.arguments.count(SPLITS.name).unwrap_or(4)
}

/// Contradictions of a declaration.
pub(super) fn check(case: &LightCase) -> Vec<CaseError> {
    let splits = count(case);
    match case.technique.arguments.sizes(SIZES.name) {
        Some(sizes) if sizes.len() != splits as usize => vec![CaseError {
            field: "technique.sizes".into(),
            message: format!("{} sizes are given for {splits} splits", sizes.len()),
            remedy: "give one size per split or leave sizes out".into(),
        }],
        _ => Vec::new(),
    }
}

/// Half-spaces of a slab's own receivers. A slab does not contain the light, so no caster may be cut with them.
pub(super) fn select(limits_metres: &[f64], slab: usize) -> Sides {
    let farther = slab.checked_sub(1).and_then(|before| limits_metres.get(before));
    let farther = farther.map(|limit| DEPTH_ROW - DVec4::W * *limit);
    let nearer = limits_metres.get(slab).map(|limit| DVec4::W * *limit - DEPTH_ROW);
    farther.into_iter().chain(nearer).collect()
}

/// The receivers as they are cut at ascending limits.
pub(super) fn slices<'a>(limits_metres: &[f64], receivers: &'a Polytope) -> Option<Slices<'a>> {
    let ascend = limits_metres.windows(2).all(|pair| pair[0] < pair[1]);
    ascend.then(|| Slices::of(receivers.body(), DEPTH_ROW, DVec4::W)).flatten()
}

/// Adds a slab with the receivers up to its limit: the next slice of them, or what its own half-spaces leave.
pub(super) fn push(
    facet: FacetDraft,
    limit_metres: Option<f64>,
    (slices, all): (Option<&mut Slices<'_>>, &Polytope),
    draft: &mut Draft,
) {
    match slices {
        Some(slices) => {
            let receivers = slices.next(limit_metres, &mut draft.bodies);
            draft.facets.push(FacetDraft { receivers, ..facet });
        }
        None => draft.push_cut(facet, all),
    }
}

/// Adds inner limits between slabs to their walk.
pub(super) fn select_by(limits_metres: &[f64], selection: &mut Selection) {
    selection.distances.push(DEPTH_ROW);
    selection.thresholds.extend_from_slice(limits_metres);
}

/// Depths of the inner limits, ascending (parallel-split slides, "split schemes").
pub(super) fn limits_metres(case: &LightCase, near: f64, far: f64) -> SmallVec<[f64; 8]> {
    let splits = count(case);
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
