//! Lights of a frame.

use glam::{DVec2, DVec3, DVec4};

use crate::view::View;

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

/// Where a directional light stands to a view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LightPosition {
    /// In the view or exactly opposite: the light ray through the eye runs inside the frustum (dueling frusta).
    Dueling,
    /// Just outside: an image rectangle that takes the ray in is at most half as large again as the view's.
    Border,
    /// Anywhere else.
    General,
}

/// Margin around the light ray, in sides of the image, with which it is taken in.
pub(crate) const BORDER_MARGIN: f64 = 0.05;
/// Distance from the image, in its sides, within which the light ray counts as near.
const NEAR_SIZES: f64 = 2.0;
/// Largest area of the image rectangle with the ray taken in, in areas of the image.
const BORDER_AREA: f64 = 1.5;

impl LightPosition {
    /// The position of a light, given as the direction towards it in camera axes.
    pub fn of(view: &View, toward_camera: DVec3) -> Self {
        let (low, high) = (DVec2::new(view.left, view.bottom), DVec2::new(view.right, view.top));
        let Some(ray) = Self::ray(toward_camera) else { return Self::General };
        if ray.cmpgt(low).all() && ray.cmplt(high).all() {
            return Self::Dueling;
        }
        let size = high - low;
        let (low, high) = Self::take_in(low, high, ray, size * BORDER_MARGIN);
        let enlarged = high - low;
        if enlarged.x * enlarged.y <= BORDER_AREA * size.x * size.y { Self::Border } else { Self::General }
    }

    /// A rectangle of tangents, enlarged until it holds the light ray with a margin around it.
    pub(crate) fn take_in(low: DVec2, high: DVec2, ray: DVec2, margin: DVec2) -> (DVec2, DVec2) {
        (low.min(ray - margin), high.max(ray + margin))
    }

    /// Tangents of the light ray through the eye; `None` for light parallel to the image.
    pub fn ray(toward_camera: DVec3) -> Option<DVec2> {
        let ray = DVec2::new(toward_camera.x, toward_camera.y) / -toward_camera.z;
        ray.is_finite().then_some(ray)
    }

    /// Whether the light ray runs so near the view that receivers may lie far along their own rays.
    pub(crate) fn is_near(view: &View, ray: DVec2) -> bool {
        let (low, high) = (DVec2::new(view.left, view.bottom), DVec2::new(view.right, view.top));
        let reach = (high - low) * NEAR_SIZES;
        ray.cmpgt(low - reach).all() && ray.cmplt(high + reach).all()
    }

    /// Name for reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dueling => "in or opposite the view",
            Self::Border => "just outside the view",
            Self::General => "outside the view",
        }
    }
}
