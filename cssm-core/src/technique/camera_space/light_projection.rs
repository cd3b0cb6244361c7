//! Light projection: one plain projection from a spot light along its cone, fitted to what is visible of it. It is as good
//! as any map while the light stands near the camera or before it (camera space shadow maps, section 6.2).

use glam::DVec3;

use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::plan::PlanError;
use crate::schema::{Choice, Word};
use crate::technique::{ConfigurationSpec, Drafts, FacetDraft, Region, Sides, Situation, TileRequest};

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("light_projection", "one plain projection along a spot light's cone"),
    lights: &[LightKind::Spot],
    takes_distribution: false,
    serves: |_| true,
    shape: |_, _| FacetShape::ONE,
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let Some(cone) = situation.cone else { return Ok(()) };
    let light = situation.light.truncate();
    let from_light = |axis: DVec3| axis.extend(-axis.dot(light));

    // Rows run along the camera's y as far as the cone's axis leaves it.
    let along = cone.direction;
    let up = [DVec3::Y, DVec3::NEG_Z, DVec3::X].into_iter().find(|axis| axis.cross(along).length() > 0.1);
    let across = along.cross(up.unwrap_or(DVec3::Y)).normalize();
    let facet = FacetDraft::straight(
        Cell::FIRST,
        [from_light(across), from_light(across.cross(along)), from_light(along)],
        Sides::new(),
        Region::Tile(TileRequest::Footprint),
    );
    drafts.open(SPEC.choice.name, (1, 1)).push(facet, situation.receivers.body());
    Ok(())
}
