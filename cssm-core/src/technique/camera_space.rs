//! Camera space shadow maps: facets whose texels follow the viewing camera's.

mod columns;
mod face_columns;
mod four_plane;
mod one_plane;
mod side_faces;

use super::TechniqueSpec;
use crate::schema::Choice;

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice::plain("camera_space", "facets whose texels follow the viewing camera's"),
    configurations: &[face_columns::SPEC, one_plane::SPEC, four_plane::SPEC],
    distribution: Some("bands(8)"),
    fits_infinity: true,
    follows_camera: true,
    check: |_| Vec::new(),
};
