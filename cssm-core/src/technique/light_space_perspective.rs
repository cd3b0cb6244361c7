//! Light space perspective: a warp parallel to the light's image plane, so that the light stays directional (Wimmer et al.,
//! Light space perspective shadow maps). Its centre lies where errors across are equal at the near and the far plane:
//! n_opt = (n + sqrt(n (n + d sin))) / sin before the near edge, for an extent d and the angle between light and view
//! axis.
//!
//! Towards the view axis n_opt grows without bound, so the warp fades by itself; but with the eye inside the silhouette
//! it would still magnify an edge that lies behind the eye. There it gives way to a uniform map.
//!
//! The authors' early notes are kept beside it, faults included: a fixed warp of 1 to 30, an up vector that divides by
//! the light's y, and an x axis that is scaled by 30 about the eye and fitted to nothing.

use glam::DVec3;

use super::warp::{self, LightPlane, Warp, WarpSpec, Warped};
use super::{
    ConfigurationSpec, Drafts, FacetDraft, Fallback, Region, Sides, Situation, TechniqueSpec, TileRequest,
    only_directional,
};
use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::plan::PlanError;
use crate::schema::{Choice, Default, Field, Kind, Word};

const RULES: &[Choice] = &[
    Choice::plain("optimal", "equal errors across at the near and the far plane"),
    Choice::plain("early_notes", "the authors' first sketch: fixed warp, up vector and width"),
];

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "light_space_perspective",
        summary: "one map warped along the light's image plane",
        arguments: &[Field {
            name: "rule",
            summary: "where the centre of projection lies",
            kind: Kind::Choice(RULES),
            default: Default::Value("optimal"),
        }],
    },
    configurations: &[ConfigurationSpec {
        choice: Choice::plain("light_space", "one warped facet over the whole map"),
        lights: &[LightKind::Directional],
        takes_distribution: false,
        serves: |_| true,
        shape: |_, _| FacetShape::ONE,
        draft,
    }],
    default_configurations: |light| only_directional(light, &["light_space"]),
    distribution: None,
    fits_infinity: false,
    follows_camera: true,
    variants: &["light_space_perspective", "light_space_perspective { rule: early_notes }"],
    check: |_| Vec::new(),
};

/// Its warp.
pub(super) const WARP: WarpSpec = WarpSpec {
    choice: Choice::plain("light_space_perspective", "equal errors across at both ends of the slab"),
    warp: optimal,
};

/// Near and far distance of the early notes' warp.
const EARLY_NEAR: f64 = 1.0;
const EARLY_FAR: f64 = 30.0;

fn draft(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let rule = situation.case.technique.arguments.word("rule").map(|rule| rule.name);
    if rule == Some("early_notes") {
        early_notes(situation, word, drafts)
    } else {
        warp::draft(&WARP, word.name, situation, drafts)
    }
}

fn optimal(warped: &Warped<'_>) -> Warp {
    let (near, _) = warped.depths_metres;
    let (_, extent) = warped.plane.extent(warped.receivers);
    let sine = warped.plane.sine;
    warped.outside_silhouette(optimal_strength(near, extent, sine))
}

/// Strength of the warp whose errors across are equal at both ends, for receivers of an extent along the image plane
/// (metres) that begin at a depth (metres).
pub(super) fn optimal_strength(near_metres: f64, extent_metres: f64, sine: f64) -> f64 {
    let grown = near_metres + extent_metres * sine;
    extent_metres * sine / (near_metres + (near_metres * grown).max(0.0).sqrt())
}

/// The early notes' map: rows of fixed width, clip space as it comes.
fn early_notes(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let receivers = &situation.receivers;
    if receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }

    // Turn the view direction about the world's y into the light's image plane; divided by light.y it has no limit.
    let world = situation.view.camera_from_world.transpose();
    let (light, axis) = (world * situation.light.truncate(), world * DVec3::NEG_Z);
    let up = DVec3::new(axis.x * light.y, -light.z * axis.z - light.x * axis.x, axis.z * light.y);
    let up = up * light.y.signum();
    let plane = LightPlane::along(situation, situation.view.camera_from_world * up);

    // Warp the box of the receivers from 1 to 30 and widen it by 30 about the eye.
    let (left, right) = receivers.ratio_range(plane.across, plane.unit);
    let (low, extent) = plane.extent(receivers);
    if !(right > left && extent > 0.0) {
        warp::single(drafts, word.name, [plane.across, plane.along, plane.unit], receivers.body());
        return Ok(());
    }
    let t = (plane.along - plane.unit * low) / extent;
    let distance = plane.unit * EARLY_NEAR + t * (EARLY_FAR - EARLY_NEAR);
    let x = plane.across * (2.0 * EARLY_FAR / (right - left));
    let sum = EARLY_FAR + EARLY_NEAR;
    let y = (distance * sum - plane.unit * (2.0 * EARLY_FAR * EARLY_NEAR)) / (EARLY_FAR - EARLY_NEAR);

    // What it cuts off has no shadow.
    let beyond = receivers.vertices.iter().any(|vertex| x.dot(*vertex).abs() > distance.dot(*vertex));
    let region = Region::Whole(TileRequest::Share(1.0));
    let facet = FacetDraft::straight(Cell::FIRST, [x, y, distance], Sides::new(), region);
    let why = "the width of its map is fitted to nothing";
    let draft = drafts.open(word.name, (1, 1));
    (draft.form, draft.complete) = ("early notes", !beyond);
    draft.fallback = Fallback::of("no shadow at the sides", why, if beyond { 1.0 } else { 0.0 });
    draft.push(facet, receivers.cut_by(&[distance - x, distance + x]).body());
    Ok(())
}
