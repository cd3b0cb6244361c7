//! The camera's post-projective space: x, y and z in [-1, 1] over the view, from an eye that may have slid back.

use glam::{DVec3, DVec4};

use super::SLIDE_BACK;
use crate::distribution::push_back_metres;
use crate::receivers::DEPTH_ROW;
use crate::technique::{Fallback, Situation};

/// Post-projective space and the light in it.
#[derive(Debug, Clone, Copy)]
pub(super) struct PostSpace {
    /// Rows x, y, z of the projection.
    axes: [DVec4; 3],
    /// Row w: depth from the eye that slid back.
    pub(super) depth: DVec4,
    /// The light, homogeneous.
    light: DVec4,
    /// How far the eye slid back against the declaration.
    pub(super) fallback: Option<Fallback>,
}

/// Largest ratio of far to near depth from the eye: beyond it the light all but touches the cube.
const LARGEST_RATIO: f64 = 1e4;
/// Half the depth of post-projective space lies before the focus.
const SHARE: f64 = 0.5;
/// Farthest slide in farthest depths: uniform to any eye.
const FARTHEST_SLIDE: f64 = 1e3;
/// Sine of the angle between the light camera's axis and an up vector below which that is none.
const SMALLEST_SINE: f64 = 1e-3;

impl PostSpace {
    /// The space whose near and far planes enclose what is seen.
    pub(super) fn of(situation: &Situation<'_>, seen: &[DVec4]) -> Self {
        let depths = seen.iter().map(|point| DEPTH_ROW.dot(*point) / point.w);
        let (near, far) =
            depths.fold((f64::INFINITY, 0.0_f64), |range, depth| (range.0.min(depth), range.1.max(depth)));
        let (slide, fallback) = slide_back(situation, near, far);

        let view = situation.view;
        let depth = DEPTH_ROW + DVec4::W * slide;
        let side = |row: DVec4, low: f64, high: f64| (row * 2.0 - depth * (high + low)) / (high - low);
        let (near, far) = (near + slide, far + slide);
        // Things of one depth still have a place.
        let range = (far - near).max(1e-9 * far);
        let axes = [
            side(DVec4::X, view.left, view.right),
            side(DVec4::Y, view.bottom, view.top),
            depth * ((far + near) / range) - DVec4::W * (2.0 * far * near / range),
        ];
        let light = situation.light;
        let [x, y, z] = axes.map(|axis| axis.dot(light));
        Self { axes, depth, light: DVec4::new(x, y, z, depth.dot(light)), fallback }
    }

    /// The direction from the light, or for one behind the camera towards its inverse, to a point.
    pub(super) fn ray_to(&self, point: DVec4) -> DVec3 {
        let [x, y, z] = self.axes.map(|axis| axis.dot(point));
        let place = DVec3::new(x, y, z) / self.depth.dot(point);
        (place * self.light.w - self.light.truncate()).normalize_or_zero()
    }

    /// Rows x, y and w of a light camera that looks along an axis; `None` where that runs along its up vector.
    pub(super) fn looking(&self, axis: DVec3, up: DVec3) -> Option<[DVec4; 3]> {
        let across = axis.cross(up);
        if across.length() < SMALLEST_SINE {
            return None;
        }
        let across = across.normalize();
        let rows = [across, across.cross(axis), axis].map(|direction| {
            let place = (0..3).fold(DVec4::ZERO, |row, k| row + self.axes[k] * direction[k]);
            let row = place * self.light.w - self.depth * direction.dot(self.light.truncate());
            row / self.light.length()
        });
        Some(rows)
    }
}

/// How far the eye slides back for receivers between two depths, metres.
pub(super) fn slide_back(situation: &Situation<'_>, near: f64, far: f64) -> (f64, Option<Fallback>) {
    let declared = match situation.case.technique.arguments.number(SLIDE_BACK.name) {
        Some(focus) if focus < far => push_back_metres(focus, SHARE, near, far).min(FARTHEST_SLIDE * far),
        Some(_) => FARTHEST_SLIDE * far,
        None => 0.0,
    };
    let least = (far - LARGEST_RATIO * near) / (LARGEST_RATIO - 1.0);
    if least <= declared {
        return (declared, None);
    }
    let why = "the light all but touches the view in post-projective space";
    let share = (least - declared) / (least - declared + near);
    (least, Fallback::of("an eye that slides back", why, share))
}
