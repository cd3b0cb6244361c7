//! Lights of a frame.

use glam::{DVec3, DVec4};

/// A light in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Light {
    /// Parallel rays.
    Directional {
        /// Unit vector from the scene towards the light, world axes.
        toward_light_world: DVec3,
    },
}

/// A light that makes no sense.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum LightError {
    /// The direction has no length or is not finite.
    #[error("the light's direction {0} has no finite length; give a direction vector that is not zero")]
    Direction(DVec3),
}

impl Light {
    /// A directional light that travels along `direction_world` (any length but zero).
    ///
    /// # Errors
    /// [`LightError::Direction`] when the direction is zero or not finite.
    pub fn directional_travelling(direction_world: DVec3) -> Result<Self, LightError> {
        // Scale by the largest component first, so that tiny and huge vectors keep their direction.
        let largest = direction_world.abs().max_element();
        if !direction_world.is_finite() || largest == 0.0 {
            return Err(LightError::Direction(direction_world));
        }
        let unit = (direction_world / largest).normalize();
        Ok(Self::Directional { toward_light_world: -unit })
    }

    /// The light as a homogeneous point relative to the eye, world axes: w = 0 for a directional light.
    pub fn homogeneous(&self) -> DVec4 {
        match self {
            Self::Directional { toward_light_world } => toward_light_world.extend(0.0),
        }
    }
}
