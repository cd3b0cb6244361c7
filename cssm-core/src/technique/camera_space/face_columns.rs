//! Face columns: every light ray that meets the view frustum belongs to the side face where it has its smallest depth;
//! each face is a column of the map whose rows run with depth.
//!
//! On the face through the corners c_k, c_(k+1) a point moved along the light is s c_k + t c_(k+1); its depth there is
//! D = s + t and (t - s) / D runs across the face from -1 to 1. Both are constant along the light. From one face (light
//! from above a level camera) to all four (light in or behind the view) the entered faces tile the silhouette, so no
//! situation needs another configuration (generalises one-plane and four-plane camera space maps; per-face warping
//! after Lloyd et al.).

use glam::{DVec3, DVec4};

use super::columns::{self, Column};
use super::side_faces;
use crate::distribution;
use crate::facet::{FacetShape, Selection};
use crate::plan::PlanError;
use crate::schema::{Choice, Word};
use crate::technique::{ConfigurationSpec, Draft, Situation};

/// A frustum has four side faces.
const SECTORS: u32 = 4;

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("face_columns", "a column on each frustum side face that rays enter first"),
    takes_distribution: true,
    serves: |_| true,
    shape: |case, _| FacetShape { sectors: SECTORS, bands: distribution::pieces(case), clips: 0 },
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word) -> Result<Vec<Draft>, PlanError> {
    let corners = situation.view.corner_tangents().map(|(x, y)| DVec3::new(x, y, -1.0));
    let faces = side_faces::entered_first(DVec3::ZERO, corners, situation.light.truncate());
    let bands = distribution::pieces(situation.case);
    let mut selection =
        Selection { borders: Vec::new(), distances: Vec::new(), thresholds: Vec::new(), bands };
    let mut facets = Vec::new();
    for (sector, face) in faces.iter().enumerate() {
        let sides = face.sides();
        let column = Column {
            sector: sector as u32,
            across: face.t - face.s,
            distance: face.s + face.t,
            sides: sides.to_vec(),
            receivers: situation.receivers.cut_by(&sides),
        };
        let (drafts, limits) = columns::facets(&column, situation);
        facets.extend(drafts);

        // The outer borders of a run that does not close are the frustum's own silhouette: nothing is past them.
        let closed = faces.len() == SECTORS as usize;
        selection.borders.push(if sector > 0 || closed { face.start } else { DVec4::W });
        if bands > 1 {
            selection.distances.push(column.distance);
            selection.thresholds.push(limits);
        }
    }
    Ok(vec![Draft { configuration: SPEC.choice.name, form: "", selection, facets }])
}
