//! Parallel-split shadow maps: depth slabs along the view, one facet each. Slabs are uniform, or each has a warp of its own
//! (parallel-split slides, "any algorithm can be applied to any layer").

use glam::{DVec3, DVec4};

use super::standard::light_plane_axes;
use super::warp::{LightPlane, WARPS, Warp, WarpSpec, Warped};
use super::{
    ConfigurationSpec, Drafts, FacetDraft, Fallback, Region, Situation, TechniqueSpec, TileRequest,
    only_directional, slabs,
};
use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::plan::PlanError;
use crate::receivers::{DEPTH_ROW, Polytope};
use crate::schema::{Arguments, Choice, Default, Field, Kind, Word};

/// `warp`, the warp of each slab.
const WARP: Field = Field {
    name: "warp",
    summary: "warp of each slab",
    kind: Kind::Choice(&WARP_CHOICES),
    default: Default::Value("none"),
};

const WARP_CHOICES: [Choice; WARPS.len() + 1] = {
    let mut choices = [Choice::plain("none", "uniform slabs"); WARPS.len() + 1];
    let mut index = 0;
    while index < WARPS.len() {
        choices[index + 1] = WARPS[index].choice;
        index += 1;
    }
    choices
};

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "parallel_split",
        summary: "depth slabs along the view, one map each",
        arguments: &[slabs::SPLITS, slabs::SCHEME, slabs::SIZES, WARP],
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
        "parallel_split { splits: 4, scheme: logarithmic, warp: light_space_perspective }",
        "parallel_split { splits: 4, scheme: practical { lambda: 0.5 }, warp: light_space_perspective }",
        "parallel_split { splits: 4, scheme: logarithmic, warp: trapezoidal }",
    ],
    check: slabs::check,
};

const CONFIGURATION: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("slabs", "one facet per depth slab"),
    lights: &[LightKind::Directional],
    takes_distribution: false,
    serves: |_| true,
    shape: |case, _| FacetShape { bands: slabs::count(case), ..FacetShape::ONE },
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }
    let arguments = &situation.case.technique.arguments;
    let splits = slabs::count(situation.case);
    let (near, far) = situation.receivers.range(DEPTH_ROW);
    let limits = slabs::limits_metres(situation.case, near, far);

    let draft = drafts.open(CONFIGURATION.choice.name, (1, splits));
    draft.reserve(splits as usize);
    let warp = arguments.word(WARP.name);
    let warp = warp.and_then(|word| Some((word, WARPS.iter().find(|known| known.choice.name == word.name)?)));
    let mut slices = warp.is_none().then(|| slabs::slices(&limits, &situation.receivers)).flatten();
    let (x, y) = light_plane_axes(situation.light);
    for index in 0..splits {
        let slab = index as usize;
        let select = slabs::select(&limits, slab);
        let region = Region::Tile(match arguments.sizes("sizes") {
            Some(sizes) => {
                let (width, height) = situation.tile_size(sizes[slab]);
                TileRequest::Fixed(width, height)
            }
            None => TileRequest::Share(1.0 / f64::from(splits)),
        });
        let facet = FacetDraft::straight(Cell::of(0, index), [x, y, DVec4::W], select, region);
        let Some((word, known)) = warp else {
            let limit = limits.get(slab).copied();
            slabs::push(facet, limit, (slices.as_mut(), &situation.receivers), draft);
            continue;
        };
        let receivers = situation.receivers.cut_by(&facet.select);
        let (rows, given) = warped(situation, (&word.arguments, known), &receivers);
        let [x, y, w] = rows.unwrap_or([x, y, DVec4::W]);
        let fallbacks = [draft.fallback, given].into_iter().flatten();
        draft.fallback = fallbacks.max_by(|one, two| one.share.total_cmp(&two.share));
        draft.push(FacetDraft { x, y, w, ..facet }, receivers.body());
    }
    slabs::select_by(&limits, &mut draft.selection);
    Ok(())
}

/// Rows x, y and w of a warped slab, if it holds receivers, and how far its warp gives way.
fn warped(
    situation: &Situation<'_>,
    (arguments, known): (&Arguments, &WarpSpec),
    receivers: &Polytope,
) -> (Option<[DVec4; 3]>, Option<Fallback>) {
    if receivers.is_empty() {
        return (None, None);
    }
    let warped = Warped {
        situation,
        arguments,
        receivers,
        depths_metres: receivers.range(DEPTH_ROW),
        plane: LightPlane::along(situation, DVec3::NEG_Z),
    };
    let Warp { plane, strength, fallback } = (known.warp)(&warped);
    (Some(plane.rows(receivers, strength)), fallback)
}
