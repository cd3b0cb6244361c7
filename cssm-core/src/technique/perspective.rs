//! Perspective: the map is seen in the camera's post-projective space, where near things are large (Stamminger and Drettakis;
//! Kozlov, Perspective shadow maps: care and feeding).
//!
//! * `single`: the light camera stands at the light's post-projective place and looks along the axis of the narrowest
//!   cone around what is seen (unit-cube clipping, section 14.2.2). Rows x, y and w are functionals that annihilate the
//!   light, and the depth row is found for them as for every facet, so casters behind the camera need no virtual camera:
//!   the paper's inverse projection is that depth row.
//! * `cube_faces`: the back faces of the unit cube, seen from the light, are the map (cube map form); for directional
//!   and local lights.
//!
//! The slide-back keeps the near plane in place and moves the eye back, which balances near against far. Where far is so
//! much farther than near that the light touches the cube, the eye slides back by itself until it does not. With far at
//! infinity a directional light lies in the cube's far face: there is no such map.

mod cone;
mod cube_faces;
mod post_space;

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use self::post_space::PostSpace;
use super::{ConfigurationSpec, Drafts, Situation, TechniqueSpec, enclosing, warp};
use crate::case::LightKind;
use crate::facet::FacetShape;
use crate::plan::PlanError;
use crate::schema::{Choice, Default, Field, Kind, Unit, Word};

/// `slide_back`, how far the eye moves back.
const SLIDE_BACK: Field = Field {
    name: "slide_back",
    summary: "focus before which half the depth of post-projective space lies after sliding the eye back, or `none`",
    kind: Kind::NumberOr {
        min: 0.0,
        max: f64::INFINITY,
        open: true,
        unit: Unit::Length,
        choices: &[Choice::plain("none", "the eye stays where it is")],
    },
    default: Default::Value("10 m"),
};

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "perspective",
        summary: "maps in the camera's post-projective space",
        arguments: &[SLIDE_BACK],
    },
    configurations: &[SINGLE, cube_faces::SPEC],
    default_configurations: |light| match light {
        LightKind::Directional => &["single"],
        LightKind::Spot | LightKind::Omni => &["cube_faces"],
    },
    distribution: None,
    fits_infinity: false,
    follows_camera: true,
    variants: &["perspective", "perspective { slide_back: none }"],
    check: |_| Vec::new(),
};

const SINGLE: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("single", "one facet, seen along the narrowest cone around what is seen"),
    lights: &[LightKind::Directional],
    takes_distribution: false,
    serves: |_| true,
    shape: |_, _| FacetShape::ONE,
    draft,
};

/// Up vectors of the light camera in post-projective space.
const UPS: [(&str, DVec3); 2] = [("up along the view", DVec3::Z), ("up along the image", DVec3::Y)];

fn draft(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }
    let seen = situation.seen();
    if situation.receivers.is_empty() {
        let rows = [DVec4::X, DVec4::Y, DVec4::W];
        warp::single(drafts, word.name, rows, situation.receivers.body());
        return Ok(());
    }
    let space = PostSpace::of(situation, seen);
    let directions: SmallVec<[_; 16]> = seen.iter().map(|point| space.ray_to(*point)).collect();
    let axis = cone::narrowest(&directions);

    // The paper takes any up vector; how the map's square lies around the outline matters all the same, so that the better
    // of two is used.
    for (form, up) in UPS {
        let Some(rows) = space.looking(axis, up) else { continue };
        // What lies outside the cone is not seen.
        let receivers = situation.receivers.cut_by(&enclosing(&rows, seen));
        let draft = warp::single(drafts, word.name, rows, receivers.body());
        (draft.form, draft.fallback) = (form, space.fallback);
    }
    Ok(())
}
