//! Lamps: local lights in every position to a view that asks for another configuration.

use std::f64::consts::FRAC_PI_8;

use cssm_core::glam::DVec3;
use cssm_core::{Light, View};

use super::Viewpoint;
use crate::error::LabError;

/// A local light with a view to see it from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lamp {
    /// What it is called on the command line and in reports; says where it stands to the view.
    pub name: &'static str,
    /// Where it is seen from.
    pub viewpoint: Viewpoint,
    /// The light.
    pub light: Light,
}

impl Lamp {
    /// What is seen from its viewpoint with the customary camera of the lab's pictures, and the light.
    ///
    /// # Errors
    /// When the viewpoint makes no sense.
    pub fn pictured(&self, size_pixels: (u32, u32)) -> Result<(View, Light), LabError> {
        let (view, _) = self.viewpoint.pictured(size_pixels)?;
        Ok((view, self.light))
    }
}

/// Half angle of the spot lights.
const HALF_ANGLE_RADIANS: f64 = 1.5 * FRAC_PI_8;

/// Places for a scene's lamps, in metres to the right, up and ahead of a viewpoint's camera.
pub(super) struct Places {
    /// A lamp within the image.
    pub(super) in_view: [f64; 3],
    /// A lamp behind the eye whose ray through the eye runs on into the image.
    pub(super) behind: [f64; 3],
    /// A lamp before the eye plane, just outside the image.
    pub(super) beside: [f64; 3],
    /// A lamp far outside the image.
    pub(super) outside: [f64; 3],
    /// A lamp beside the eye.
    pub(super) at_eye: [f64; 3],
    /// A lamp 5 cm from a wall, in world space.
    pub(super) wall_world: [f64; 3],
    /// A spot light near the eye that shines ahead: place and a point on its axis.
    pub(super) ahead: [[f64; 3]; 2],
    /// A spot light whose cone leaves the eye out.
    pub(super) aside: [[f64; 3]; 2],
    /// A spot light before the eye that shines towards it.
    pub(super) dueling: [[f64; 3]; 2],
}

/// The lamps of a viewpoint.
pub(super) fn around(viewpoint: Viewpoint, places: &Places) -> Vec<Lamp> {
    let ahead = (viewpoint.target_world - viewpoint.eye_world).normalize_or(DVec3::NEG_Z);
    let right = ahead.cross(DVec3::Y).normalize_or(DVec3::X);
    let up = right.cross(ahead);
    let place = |[x, y, z]: [f64; 3]| viewpoint.eye_world + right * x + up * y + ahead * z;
    let omni = |position_world| Light::Omni { position_world, range_metres: f64::INFINITY };
    let spot = |[from, to]: [[f64; 3]; 2]| Light::Spot {
        position_world: place(from),
        direction_world: (place(to) - place(from)).normalize_or(DVec3::NEG_Y),
        half_angle_radians: HALF_ANGLE_RADIANS,
        range_metres: f64::INFINITY,
    };
    [
        ("omni-in-view", omni(place(places.in_view))),
        ("omni-beside", omni(place(places.beside))),
        ("omni-outside", omni(place(places.outside))),
        ("omni-behind", omni(place(places.behind))),
        ("omni-at-eye", omni(place(places.at_eye))),
        ("omni-at-wall", omni(places.wall_world.into())),
        ("spot-dueling", spot(places.dueling)),
        ("spot-aside", spot(places.aside)),
        ("spot-ahead", spot(places.ahead)),
    ]
    .map(|(name, light)| Lamp { name, viewpoint, light })
    .to_vec()
}
