//! Where lights stand: in the usual places, and at and a hair off every special direction of a view.

use cssm_core::case::LightKind;
use cssm_core::glam::DVec3;
use cssm_core::{Light, View};

use crate::error::LabError;
use crate::scene::random::Random;

/// Where a light stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Direction towards it, camera space, any length.
    toward_camera: DVec3,
    /// Distance of a local light from the eye, as the exponent of a share between near distance and reach; directional
    /// lights have none.
    share: f64,
    /// Distance in which a local light is seen, in its own distances from the eye; infinite: anywhere.
    lights_times: f64,
}

/// Beyond so many of its distances from the eye a lamp and the eye are one point to f32.
const LIGHTS_TIMES: f64 = 3e3;
/// Depth of the point that spot lights shine at, in near distances.
const SHONE_AT_NEARS: f64 = 40.0;
/// Half angle of spot lights' cones, radians.
const HALF_ANGLE: f64 = 0.7;

impl Place {
    /// The light of a kind there.
    ///
    /// # Errors
    /// When the light makes no sense.
    pub fn light(&self, kind: LightKind, view: &View, reach_metres: f64) -> Result<Light, LabError> {
        let toward = view.camera_from_world.transpose() * self.toward_camera;
        let distance = view.near_metres * libm::pow(reach_metres / view.near_metres, self.share);
        let position = view.eye_world + toward * distance;
        let range = self.lights_times * distance;
        Ok(match kind {
            LightKind::Directional => Light::directional_travelling(-toward)?,
            LightKind::Omni => Light::omni(position, range)?,
            LightKind::Spot => {
                let (width, height) = view.size_pixels;
                let ahead = view.ray_world(0.4 * f64::from(width), 0.7 * f64::from(height));
                let depth = (SHONE_AT_NEARS * view.near_metres).min(0.5 * reach_metres);
                let target = view.eye_world + ahead * depth.max(1.2 * view.near_metres);
                let axis = target - position;
                let axis = if axis.length() > 0.0 { axis } else { ahead };
                Light::spot(position, axis, HALF_ANGLE, range)?
            }
        })
    }
}

/// Lights of every class that other axes are swept under.
pub fn usual(kind: LightKind) -> Vec<(String, Place)> {
    let toward = |elevation: f64, azimuth: f64| {
        let (elevation, azimuth) = (elevation.to_radians(), azimuth.to_radians());
        DVec3::new(
            libm::cos(elevation) * libm::sin(azimuth),
            libm::sin(elevation),
            -libm::cos(elevation) * libm::cos(azimuth),
        )
    };
    let directions = [
        ("light above", toward(60.0, 150.0)),
        ("light low at the side", toward(5.0, 80.0)),
        ("light ahead in the view", toward(10.0, 5.0)),
        ("light behind, opposite the view", toward(4.0, 177.0)),
        ("light at the border", toward(31.0, 180.0)),
    ];
    // A quarter of the way a local light is some steps off; a sun has no distance.
    let share = if kind.is_local() { 0.45 } else { 0.0 };
    let place = |(name, toward_camera): (&str, DVec3)| {
        (name.to_owned(), Place { toward_camera, share, lights_times: f64::INFINITY })
    };
    directions.into_iter().map(place).collect()
}

/// Lights at every special direction of a view, both ways, exactly and off it by so many radians; local lights near and
/// far, and at the eye and in the near plane.
pub fn special(kind: LightKind, view: &View, offs: &[f64]) -> Vec<(String, Place)> {
    let upward = view.camera_from_world * DVec3::Y;
    let sideways = view.camera_from_world * DVec3::X;
    let middle = 0.3 * view.left + 0.7 * view.right;
    let directions = [
        ("view axis", DVec3::NEG_Z),
        ("upper right corner ray", DVec3::new(view.right, view.top, -1.0)),
        ("lower left corner ray", DVec3::new(view.left, view.bottom, -1.0)),
        ("upper edge ray", DVec3::new(middle, view.top, -1.0)),
        ("right edge ray", DVec3::new(view.right, 0.4 * view.bottom, -1.0)),
        ("camera's x", DVec3::X),
        ("in the near plane", DVec3::new(0.6, 0.8, 0.0)),
        ("straight up", upward),
        ("sideways", sideways),
    ];
    let shares: &[f64] = if kind.is_local() { &[0.3, 0.7] } else { &[0.0] };
    let mut random = Random::new(23);
    let mut list = Vec::new();
    for (name, direction) in directions {
        let direction = direction.normalize();
        for off in offs {
            for (way, sign) in [("", 1.0), (" backwards", -1.0)] {
                for share in shares {
                    let angle = random.between(0.0, std::f64::consts::TAU);
                    let (across, up) = direction.any_orthonormal_pair();
                    let aside = (across * libm::cos(angle) + up * libm::sin(angle)) * *off;
                    let toward_camera = (direction + aside) * sign;
                    let place = Place { toward_camera, share: *share, lights_times: LIGHTS_TIMES };
                    let distance = if kind.is_local() { format!(" at {share}") } else { String::new() };
                    list.push((format!("{off:e} rad off {name}{way}{distance}"), place));
                }
            }
        }
    }
    if kind.is_local() {
        let near = [("at the eye", 0.0), ("a tenth of near before the eye", 0.1), ("in the near plane", 1.0)];
        for (name, times) in near {
            let toward_camera = DVec3::new(0.1, 0.05, -1.0) * times;
            let place = Place { toward_camera, share: 0.0, lights_times: f64::INFINITY };
            list.push((format!("light {name}"), place));
        }
    }
    list
}
