//! Where a light stands to a view: what decides which configurations are made for it.

use glam::{DVec2, DVec4};

use crate::case::LightKind;
use crate::view::View;

/// Where a light stands to a view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LightPosition {
    /// In the view at infinity, exactly opposite, or a point behind the eye on a ray that continues into the view: the
    /// light ray through the eye runs inside the frustum and no light is between (dueling frusta).
    Dueling,
    /// Just outside: an image rectangle that takes the ray in is at most half as large again as the view's.
    Border,
    /// Anywhere else outside the view.
    General,
    /// A point in the view, before the near plane or beyond it.
    InView,
    /// A point just outside the view's sides, as [`Self::Border`].
    BesideView,
    /// A point within a few near distances of the eye.
    AtEye,
}

/// Margin around the light ray, in sides of the image, with which it is taken in.
pub(crate) const BORDER_MARGIN: f64 = 0.05;
/// Distance from the image, in its sides, within which the light ray counts as near.
const NEAR_SIZES: f64 = 2.0;
/// Largest area of the image rectangle with the ray taken in, in areas of the image.
const BORDER_AREA: f64 = 1.5;
/// Distance from the eye, in near distances, within which a point light is at the eye.
const AT_EYE_NEARS: f64 = 5.0;

impl LightPosition {
    /// The position of a light, given as a homogeneous point in camera space.
    pub fn of(view: &View, light_camera: DVec4) -> Self {
        let (low, high) = (DVec2::new(view.left, view.bottom), DVec2::new(view.right, view.top));
        let is_point = light_camera.w > 0.0;
        let from_eye = light_camera.truncate().length();
        if is_point && from_eye < AT_EYE_NEARS * view.near_metres * light_camera.w {
            return Self::AtEye;
        }
        let Some(ray) = Self::ray(light_camera) else { return Self::General };
        let ahead = is_point && light_camera.z < 0.0;
        if ray.cmpgt(low).all() && ray.cmplt(high).all() {
            return if ahead { Self::InView } else { Self::Dueling };
        }
        let size = high - low;
        let (low, high) = Self::take_in(low, high, ray, size * BORDER_MARGIN);
        let enlarged = high - low;
        match (enlarged.x * enlarged.y <= BORDER_AREA * size.x * size.y, ahead) {
            (true, true) => Self::BesideView,
            (true, false) => Self::Border,
            (false, _) => Self::General,
        }
    }

    /// A rectangle of tangents, enlarged until it holds the light ray with a margin around it.
    pub(crate) fn take_in(low: DVec2, high: DVec2, ray: DVec2, margin: DVec2) -> (DVec2, DVec2) {
        (low.min(ray - margin), high.max(ray + margin))
    }

    /// Tangents of the light ray through the eye; `None` for light parallel to the image.
    pub fn ray(light_camera: DVec4) -> Option<DVec2> {
        let ray = DVec2::new(light_camera.x, light_camera.y) / -light_camera.z;
        ray.is_finite().then_some(ray)
    }

    /// Whether the light ray runs so near the view that receivers may lie far along their own rays.
    pub(crate) fn is_near(view: &View, ray: DVec2) -> bool {
        let (low, high) = (DVec2::new(view.left, view.bottom), DVec2::new(view.right, view.top));
        let reach = (high - low) * NEAR_SIZES;
        ray.cmpgt(low - reach).all() && ray.cmplt(high + reach).all()
    }

    /// Whether it is outside the view, with nothing to take in.
    pub(crate) fn is_general(self) -> bool {
        self == Self::General
    }

    /// The positions that a kind of light can have.
    pub const fn of_kind(kind: LightKind) -> &'static [Self] {
        const ALL: &[LightPosition] = &[
            LightPosition::General,
            LightPosition::Border,
            LightPosition::Dueling,
            LightPosition::InView,
            LightPosition::BesideView,
            LightPosition::AtEye,
        ];
        let (at_infinity, _) = ALL.split_at(3);
        if kind.is_local() { ALL } else { at_infinity }
    }

    /// Name for reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dueling => "in or opposite the view",
            Self::Border => "just outside the view",
            Self::General => "outside the view",
            Self::InView => "in the view",
            Self::BesideView => "just beside the view",
            Self::AtEye => "at the eye",
        }
    }
}
