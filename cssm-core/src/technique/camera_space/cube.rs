//! Cube: six plain projections around a point light along the camera's axes; the reference for every other configuration
//! of a local light.
//!
//! The plane of the light's depth parts a front from a back half; in each, half-planes through the diagonals around the
//! view axis part four sectors; in each of these the face before or behind is told from the one at the side.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use crate::case::LightKind;
use crate::facet::{Cell, FacetShape, Selection};
use crate::plan::PlanError;
use crate::receivers::DEPTH_ROW;
use crate::remap::Curve;
use crate::schema::{Choice, Word};
use crate::technique::{ConfigurationSpec, Draft, FacetDraft, Region, Sides, Situation, TileRequest};

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

fn draft(situation: &Situation<'_>, _: &Word) -> Result<Vec<Draft>, PlanError> {
    let light = situation.light;
    if light.w == 0.0 {
        return Ok(Vec::new());
    }
    let from_light = |axis: DVec3| axis.extend(-axis.dot(light.truncate()));

    // The walk: a half's own axis beats the side's where it is longer.
    let mut selection =
        Selection { split: Some(DEPTH_ROW + DVec4::W * light.z), ..Selection::around(SECTORS, 2) };
    for along in [DVec3::NEG_Z, DVec3::Z] {
        for side in SIDES {
            let diagonal = side + side.cross(DVec3::Z);
            let past = DVec3::Z.cross(diagonal).normalize();
            selection.borders.push(from_light(past));
            selection.distances.push(from_light(along - side));
            selection.thresholds.push(vec![0.0]);
        }
    }

    // The faces, each over all cells that it wins.
    let around = |half: u32| (0..SECTORS).map(move |sector| Cell { half, sector, band: 1 }).collect();
    let mut facets = vec![
        face(situation, DVec3::NEG_Z, DVec3::Y, around(0)),
        face(situation, DVec3::Z, DVec3::Y, around(1)),
    ];
    for (sector, side) in SIDES.into_iter().enumerate() {
        let cells = (0..2).map(|half| Cell { half, sector: sector as u32, band: 0 }).collect();
        facets.push(face(situation, side, DVec3::Z, cells));
    }
    Ok(vec![Draft {
        configuration: SPEC.choice.name,
        form: "",
        complete: true,
        fallback: None,
        selection,
        facets,
    }])
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
        receivers: situation.receivers.cut_by(&select),
        select,
        region: Region::Whole(TileRequest::Share(1.0 / FACES)),
    }
}
