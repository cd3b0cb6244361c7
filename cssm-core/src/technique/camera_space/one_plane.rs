//! One plane: the whole view is one column on a plane that runs from one end of the near plane to the opposite end of
//! the far plane (camera space shadow maps, section 3, general case).
//!
//! The camera is rolled about its axis until the light stands above it, without a component across. The field of view
//! is fitted around the rolled frustum. With the light behind, the plane runs from the near bottom edge to the far top
//! edge; with the light ahead from the near top edge to the far bottom edge (the paper's opposite points), so that the
//! light always stands above it. A point light serves the receivers that lie below it as seen from the plane, which always
//! rises away from the eye. A receiver moved along the light onto the plane has a distance there, which rows run
//! with, and keeps its place across.
//!
//! The closer the light comes to the view's own rays, the wider the map must reach across: (m + B) / (m - B) for
//! elevation tangent m and half field of view tangent B. With the light in the view, distances on the plane turn
//! negative; the eye is then pushed back behind them, and an infinite view is cut at the horizon: the configuration
//! still answers, badly.

use glam::DVec4;
use smallvec::smallvec;

use crate::case::LightKind;
use crate::distribution;
use crate::facet::FacetShape;
use crate::light::LightPosition;
use crate::plan::PlanError;
use crate::receivers::{DEPTH_ROW, Polytope};
use crate::samples::SAMPLED_HORIZON_METRES;
use crate::schema::{Choice, Word};
use crate::technique::columns::{self, Column};
use crate::technique::{ConfigurationSpec, Drafts, Sides, Situation};

/// Share of a point light's own distance from the plane that receivers must lie below it.
const SMALLEST_UNIT: f64 = 1e-3;

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("one_plane", "the whole view on one plane; for light from outside the view"),
    lights: &[LightKind::Directional, LightKind::Spot, LightKind::Omni],
    takes_distribution: true,
    serves: LightPosition::is_general,
    shape: |case, _| FacetShape { bands: distribution::pieces(case), ..FacetShape::ONE },
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let column = column(situation);
    let bands = distribution::pieces(situation.case);
    let draft = drafts.open(SPEC.choice.name, (1, bands));
    draft.complete = is_complete(&column, situation);
    columns::add(&column, situation, draft);
    if bands > 1 {
        draft.selection.distances.push(column.distance);
        draft.selection.units.extend((situation.light.w > 0.0).then_some(column.unit));
    }
    Ok(())
}

/// Whether no receiver was left out of the column.
pub(super) fn is_complete(column: &Column, situation: &Situation<'_>) -> bool {
    column.sides.iter().all(|side| situation.receivers.vertices.iter().all(|vertex| side.dot(*vertex) >= 0.0))
}

/// The column on the plane.
pub(super) fn column(situation: &Situation<'_>) -> Column {
    let light = situation.light;
    let view = situation.view;

    // Roll the camera so that the light has no component across and none downwards.
    let length = libm::hypot(light.x, light.y);
    let (cosine, sine) = if length > 0.0 { (light.y / length, light.x / length) } else { (1.0, 0.0) };
    let across = DVec4::new(cosine, -sine, 0.0, 0.0);
    let up = DVec4::new(sine, cosine, 0.0, 0.0);

    // Fit the field of view along the rolled vertical.
    let tangents = view.corner_tangents().map(|(x, y)| sine * x + cosine * y);
    let top = tangents.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let bottom = tangents.into_iter().fold(f64::INFINITY, f64::min);

    // Lay the plane from the near edge on one side to the far edge on the other.
    let near = view.near_metres;
    let (_, far) = situation.receivers.range(DEPTH_ROW);
    let opposite = light.w == 0.0 && light.z < 0.0;
    let (near_tangent, far_tangent) = if opposite { (top, bottom) } else { (bottom, top) };
    let (rise, run) = if far.is_finite() {
        (far_tangent - near_tangent * near / far, 1.0 - near / far)
    } else {
        (far_tangent, 1.0)
    };
    let start = DVec4::W * near;
    let plane = (up - start * near_tangent) * run - (DEPTH_ROW - start) * rise;

    // Move points along the light onto the plane; a directional light stands above it on either side.
    let toward_plane = plane.dot(light);
    let onto = |row: DVec4| row - plane * (row.dot(light) / toward_plane);
    let (distance, unit) = (onto(DEPTH_ROW), if light.w > 0.0 { onto(DVec4::W) } else { DVec4::W });

    // Receivers that do not lie below a point light cannot be moved onto the plane.
    let (sides, receivers) = if light.w > 0.0 {
        let below: Sides = smallvec![unit - DVec4::W * SMALLEST_UNIT];
        let receivers = situation.receivers.cut_by(&below);
        (below, receivers)
    } else {
        (Sides::new(), situation.receivers.clone())
    };
    Column {
        half: 0,
        sector: 0,
        across,
        distance,
        slant: 0.0,
        unit,
        sides,
        receivers: bounded(&receivers, distance, unit),
    }
}

/// The receivers, cut at a horizon where their distances have no lower end.
fn bounded(receivers: &Polytope, distance: DVec4, unit: DVec4) -> Polytope {
    if receivers.quotient_range(distance, unit).0.is_finite() {
        return receivers.clone();
    }
    receivers.cut_by(&[DVec4::W * SAMPLED_HORIZON_METRES - DEPTH_ROW])
}
