//! Lights of a frame.

use glam::{DVec3, DVec4};

use crate::case::LightKind;

mod position;

pub(crate) use position::BORDER_MARGIN;
pub use position::LightPosition;

/// A light in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// Parallel rays.
    Directional {
        /// Unit vector from the scene towards the light, world axes.
        toward_light_world: DVec3,
    },
    /// Rays from a point within a cone.
    Spot {
        /// Where the light stands, world space, metres.
        position_world: DVec3,
        /// Unit vector along the cone's axis, away from the light, world axes.
        direction_world: DVec3,
        /// Angle between the cone's axis and its edge, above 0 and below a quarter turn, radians.
        half_angle_radians: f64,
        /// Distance beyond which nothing is lit, metres; may be infinite.
        range_metres: f64,
    },
    /// Rays from a point to all sides.
    Omni {
        /// Where the light stands, world space, metres.
        position_world: DVec3,
        /// Distance beyond which nothing is lit, metres; may be infinite.
        range_metres: f64,
    },
}

/// A light that makes no sense.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum LightError {
    /// The direction has no length or is not finite.
    #[error("the light's direction {0} has no finite length; give a direction vector that is not zero")]
    Direction(DVec3),
    /// The position is not finite.
    #[error("the light's position {0} is not finite; give finite numbers")]
    Position(DVec3),
    /// The range is not positive.
    #[error("the light's range of {0} m is not positive; give a positive or infinite range")]
    Range(f64),
    /// The cone is empty or no cone.
    #[error(
        "a half angle of {0} rad makes no cone; give an angle above 0 and below pi / 2, or use an omni light"
    )]
    HalfAngle(f64),
}

impl Light {
    /// A directional light that travels along `direction_world` (any length but zero).
    ///
    /// # Errors
    /// [`LightError::Direction`] when the direction is zero or not finite.
    pub fn directional_travelling(direction_world: DVec3) -> Result<Self, LightError> {
        Ok(Self::Directional { toward_light_world: -unit(direction_world)? })
    }

    /// A spot light that shines along `direction_world` (any length but zero).
    ///
    /// # Errors
    /// A [`LightError`] that names the argument at fault.
    pub fn spot(
        position_world: DVec3,
        direction_world: DVec3,
        half_angle_radians: f64,
        range_metres: f64,
    ) -> Result<Self, LightError> {
        let direction_world = unit(direction_world)?;
        Self::Spot { position_world, direction_world, half_angle_radians, range_metres }.checked()
    }

    /// An omni light.
    ///
    /// # Errors
    /// A [`LightError`] that names the argument at fault.
    pub fn omni(position_world: DVec3, range_metres: f64) -> Result<Self, LightError> {
        Self::Omni { position_world, range_metres }.checked()
    }

    /// The light as a homogeneous point relative to the eye, world axes: w = 0 for a directional light.
    pub fn homogeneous(&self, eye_world: DVec3) -> DVec4 {
        match self {
            Self::Directional { toward_light_world } => toward_light_world.extend(0.0),
            Self::Spot { position_world, .. } | Self::Omni { position_world, .. } => {
                (*position_world - eye_world).extend(1.0)
            }
        }
    }

    /// Its kind.
    pub const fn kind(&self) -> LightKind {
        match self {
            Self::Directional { .. } => LightKind::Directional,
            Self::Spot { .. } => LightKind::Spot,
            Self::Omni { .. } => LightKind::Omni,
        }
    }

    /// Unit vector from a point in world space towards the light.
    pub fn toward_world(&self, point_world: DVec3) -> DVec3 {
        match self {
            Self::Directional { toward_light_world } => *toward_light_world,
            Self::Spot { position_world, .. } | Self::Omni { position_world, .. } => {
                (*position_world - point_world).normalize_or(DVec3::Y)
            }
        }
    }

    /// Distance to the light from a point in world space; infinite for a directional light.
    pub fn distance_metres(&self, point_world: DVec3) -> f64 {
        match self {
            Self::Directional { .. } => f64::INFINITY,
            Self::Spot { position_world, .. } | Self::Omni { position_world, .. } => {
                position_world.distance(point_world)
            }
        }
    }

    /// Whether the light could reach a point in world space if nothing stood in its way.
    pub fn reaches(&self, point_world: DVec3) -> bool {
        match *self {
            Self::Directional { .. } => true,
            Self::Omni { position_world, range_metres } => {
                position_world.distance(point_world) <= range_metres
            }
            Self::Spot { position_world, direction_world, half_angle_radians, range_metres } => {
                let from_light = point_world - position_world;
                let distance = from_light.length();
                distance <= range_metres
                    && from_light.dot(direction_world) >= libm::cos(half_angle_radians) * distance
            }
        }
    }

    /// The light, if every number of it makes sense.
    ///
    /// # Errors
    /// A [`LightError`] that names the number at fault.
    pub fn checked(self) -> Result<Self, LightError> {
        let point = |position: DVec3, range: f64| match (position.is_finite(), range > 0.0) {
            (false, _) => Err(LightError::Position(position)),
            (true, false) => Err(LightError::Range(range)),
            (true, true) => Ok(()),
        };
        match self {
            Self::Directional { toward_light_world } => {
                unit(toward_light_world)?;
            }
            Self::Omni { position_world, range_metres } => point(position_world, range_metres)?,
            Self::Spot { position_world, direction_world, half_angle_radians, range_metres } => {
                point(position_world, range_metres)?;
                unit(direction_world)?;
                if !(half_angle_radians > 0.0 && half_angle_radians < std::f64::consts::FRAC_PI_2) {
                    return Err(LightError::HalfAngle(half_angle_radians));
                }
            }
        }
        Ok(self)
    }
}

/// The unit vector of a direction of any length.
fn unit(direction: DVec3) -> Result<DVec3, LightError> {
    // Scale by the largest component first, so that tiny and huge vectors keep their direction.
    let largest = direction.abs().max_element();
    if !direction.is_finite() || largest == 0.0 {
        return Err(LightError::Direction(direction));
    }
    Ok((direction / largest).normalize())
}
