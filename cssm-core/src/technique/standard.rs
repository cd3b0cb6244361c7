//! Standard shadow map: one uniform facet, fitted to the receivers along fixed axes of the light plane.

use glam::{DVec3, DVec4};

use super::{
    ConfigurationSpec, Drafts, FacetDraft, Region, Sides, Situation, TechniqueSpec, TileRequest,
    only_directional,
};
use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::plan::PlanError;
use crate::schema::{Choice, Word};

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice::plain("standard", "one uniform map fitted to the receivers, up = the camera's y"),
    configurations: &[CONFIGURATION],
    default_configurations: |light| only_directional(light, &["single"]),
    distribution: None,
    fits_infinity: false,
    follows_camera: false,
    variants: &["standard"],
    check: |_| Vec::new(),
};

const CONFIGURATION: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("single", "one facet over the whole map"),
    lights: &[LightKind::Directional],
    takes_distribution: false,
    serves: |_| true,
    shape: |_, _| FacetShape::ONE,
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }
    let (x, y) = light_plane_axes(situation.light);
    let region = Region::Tile(TileRequest::Share(1.0));
    let facet = FacetDraft::straight(Cell::FIRST, [x, y, DVec4::W], Sides::new(), region);
    drafts.open(CONFIGURATION.choice.name, (1, 1)).push(facet, situation.receivers.body());
    Ok(())
}

/// Rows of two orthonormal axes of the light plane (camera space): the second is the camera's y seen along the light,
/// or the view direction where the light comes along y.
pub(crate) fn light_plane_axes(light: DVec4) -> (DVec4, DVec4) {
    let toward = light.truncate();
    let up = [DVec3::Y, DVec3::NEG_Z].into_iter().find(|axis| axis.cross(toward).length_squared() > 1e-12);
    let x = up.unwrap_or(DVec3::X).cross(toward).normalize();
    let y = toward.cross(x);
    (x.extend(0.0), y.extend(0.0))
}
