//! Camera space shadow maps: facets whose texels follow the viewing camera's.

mod anchors;
mod cube;
mod eight_plane;
mod face_columns;
mod four_plane;
mod light_projection;
mod one_plane;
mod tetrahedron;

use super::TechniqueSpec;
use crate::case::LightKind;
use crate::schema::Choice;

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice::plain("camera_space", "facets whose texels follow the viewing camera's"),
    configurations: &[
        face_columns::SPEC,
        one_plane::SPEC,
        four_plane::SPEC,
        eight_plane::SPEC,
        tetrahedron::SPEC,
        cube::SPEC,
        light_projection::SPEC,
    ],
    default_configurations: |light| match light {
        LightKind::Directional => &["face_columns"],
        LightKind::Spot => &["light_projection", "face_columns", "eight_plane", "cube"],
        LightKind::Omni => &["face_columns", "eight_plane", "cube"],
    },
    distribution: Some("bands(8)"),
    fits_infinity: true,
    follows_camera: true,
    variants: &["camera_space"],
    check: |_| Vec::new(),
};
