//! Omni lights around the view: the configurations that hold them against a cube.

use cssm_core::case::CaseError;
use cssm_core::glam::DVec3;
use cssm_core::{Light, PlanError, View};

use super::cases;
use super::figures::{Measured, measure};

/// One configuration under one lamp, camera space, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The configuration; the only one that the case declares.
    pub configuration: &'static str,
    /// Where the lamp stands.
    pub position: [f64; 3],
    /// 95th percentile of the volume footprint that the prototype measured, pixels.
    pub reference_p95: f64,
}

const fn place(configuration: &'static str, position: [f64; 3], reference_p95: f64) -> Place {
    Place { configuration, position, reference_p95 }
}

/// Lamps in the view, ascending in distance, in which the bipyramid is compared with the cube.
pub const IN_VIEW: [[f64; 3]; 4] =
    [[1.0, 1.0, -3.0], [0.0, 1.0, -10.0], [2.0, 2.0, -30.0], [3.0, 4.0, -60.0]];

/// How many times the cube's footprints are larger than the bipyramid's there, at least.
pub const LEAST_GAIN: [f64; 4] = [4.9, 12.0, 25.0, 40.0];

/// Every measured place.
pub const PLACES: [Place; 31] = [
    place("cube", IN_VIEW[0], 19.6),
    place("cube", IN_VIEW[1], 70.6),
    place("cube", IN_VIEW[2], 216.0),
    place("cube", IN_VIEW[3], 435.0),
    place("tetrahedron", IN_VIEW[0], 20.2),
    place("tetrahedron", IN_VIEW[1], 29.6),
    place("tetrahedron", IN_VIEW[2], 91.0),
    place("tetrahedron", IN_VIEW[3], 179.0),
    place("eight_plane", IN_VIEW[0], 4.0),
    place("eight_plane", IN_VIEW[1], 5.9),
    place("eight_plane", IN_VIEW[2], 8.5),
    place("eight_plane", IN_VIEW[3], 10.7),
    place("eight_plane", [0.0, 5.6, -10.0], 5.4),
    place("eight_plane", [0.0, 5.9, -10.0], 5.4),
    place("eight_plane", [0.0, 6.6, -10.0], 5.6),
    place("eight_plane", [0.0, 8.0, -10.0], 6.2),
    place("eight_plane", [0.0, 10.0, -10.0], 6.9),
    place("four_plane", [1.0, 1.0, 20.0], 8.6),
    place("four_plane", [0.2, 0.3, 2.0], 1.9),
    place("cube", [1.0, 1.0, 20.0], 148.0),
    place("cube", [0.2, 0.3, 2.0], 16.8),
    place("tetrahedron", [1.0, 1.0, 20.0], 256.0),
    place("face_columns", [1.0, 1.0, 20.0], 3.5),
    place("face_columns", [0.2, 0.3, 2.0], 3.4),
    place("face_columns", [0.0, 15.0, -10.0], 5.8),
    place("face_columns", [0.0, 30.0, -20.0], 6.0),
    place("one_plane", [0.0, 6.6, -10.0], 28.0),
    place("one_plane", [0.0, 8.0, -10.0], 11.0),
    place("one_plane", [0.0, 10.0, -10.0], 6.9),
    place("one_plane", [0.0, 15.0, -10.0], 8.6),
    place("one_plane", [0.0, 30.0, -10.0], 12.7),
];

/// Why a place has no figures.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OmniError {
    /// The declaration is wrong.
    #[error("{0:?}; correct the list of built-in cases")]
    Case(Vec<CaseError>),
    /// No plan.
    #[error(transparent)]
    Plan(#[from] PlanError),
}

impl Place {
    /// Scores the configuration in a map of about `side` times `side` texels.
    ///
    /// # Errors
    /// What the declaration or planning says.
    pub fn measure(
        &self,
        view: &View,
        side: u32,
        focus_metres: f64,
        far_metres: f64,
        samples: usize,
    ) -> Result<Measured, OmniError> {
        let map = map_size(self.configuration, side);
        let case = cases::omni(self.configuration, map, focus_metres).map_err(OmniError::Case)?;
        let position = view.eye_world + view.camera_from_world.transpose() * DVec3::from(self.position);
        let light = Light::Omni { position_world: position, range_metres: f64::INFINITY };
        Ok(measure(&case, view, &light, far_metres, samples)?)
    }
}

/// Width and height of the map: the six squares of a cube fill one of three to two, the two of a bipyramid one of two to
/// one, everything else a square one.
fn map_size(configuration: &str, side: u32) -> (u32, u32) {
    let scaled = |factor: f64| (f64::from(side) * factor).round() as u32;
    match configuration {
        "cube" => {
            let face = scaled(1.0 / 6.0_f64.sqrt());
            (3 * face, 2 * face)
        }
        "eight_plane" => {
            let face = scaled(0.5_f64.sqrt());
            (2 * face, face)
        }
        _ => (side, side),
    }
}
