//! Cube: six plain projections around a point light along the camera's axes; the reference for every other configuration
//! of a local light.
//!
//! The plane of the light's depth parts a front from a back half; in each, half-planes through the diagonals around the
//! view axis part four sectors; in each of these the face before or behind is told from the one at the side.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::plan::PlanError;
use crate::receivers::{BodyPlace, DEPTH_ROW};
use crate::remap::Curve;
use crate::schema::{Choice, Word};
use crate::technique::{ConfigurationSpec, Drafts, FacetDraft, Region, Sides, Situation, TileRequest};

/// Faces around the view axis.
const SECTORS: u32 = 4;
/// Faces of a cube.
const FACES: f64 = 6.0;

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("cube", "six plain projections around a light; the reference"),
    lights: &[LightKind::Spot, LightKind::Omni],
    takes_distribution: false,
    serves: |_| true,
    shape: |_, _| FacetShape { halves: 2, sectors: SECTORS, bands: 2, ..FacetShape::ONE },
    draft,
};

/// Outward axes of the faces around the view axis, in walking order.
const SIDES: [DVec3; 4] = [DVec3::X, DVec3::Y, DVec3::NEG_X, DVec3::NEG_Y];

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let light = situation.light;
    if light.w == 0.0 {
        return Ok(());
    }
    let from_light = |axis: DVec3| axis.extend(-axis.dot(light.truncate()));

    // The walk: a half's own axis beats the side's where it is longer.
    let draft = drafts.open(SPEC.choice.name, (SECTORS, 2));
    draft.reserve(FACES as usize);
    let selection = &mut draft.selection;
    selection.split = Some(DEPTH_ROW + DVec4::W * light.z);
    for along in [DVec3::NEG_Z, DVec3::Z] {
        for side in SIDES {
            let diagonal = side + side.cross(DVec3::Z);
            let past = DVec3::Z.cross(diagonal).normalize();
            selection.borders.push(from_light(past));
            selection.distances.push(from_light(along - side));
            selection.thresholds.push(0.0);
        }
    }

    // The faces, each over all cells that it wins.
    let around = |half: u32| (0..SECTORS).map(move |sector| Cell { half, sector, band: 1 }).collect();
    for (half, axis) in [DVec3::NEG_Z, DVec3::Z].into_iter().enumerate() {
        draft.push_cut(face(situation, axis, DVec3::Y, around(half as u32)), &situation.receivers);
    }
    for (sector, side) in SIDES.into_iter().enumerate() {
        let cells = (0..2).map(|half| Cell { half, sector: sector as u32, band: 0 }).collect();
        draft.push_cut(face(situation, side, DVec3::Z, cells), &situation.receivers);
    }
    Ok(())
}

/// The projection through the face with an outward axis.
fn face(situation: &Situation<'_>, axis: DVec3, up: DVec3, cells: SmallVec<[Cell; 4]>) -> FacetDraft {
    let light = situation.light.truncate();
    let from_light = |axis: DVec3| axis.extend(-axis.dot(light));
    let right = axis.cross(up);
    let sides = [axis + right, axis - right, axis + up, axis - up];
    let select: Sides = sides.map(|side| from_light(side.normalize())).into_iter().collect();
    FacetDraft {
        cells,
        x: from_light(right),
        y: from_light(up),
        curve: Curve::Straight,
        w: from_light(axis),
        receivers: BodyPlace::default(),
        select,
        region: Region::Whole(TileRequest::Share(1.0 / FACES)),
    }
}
