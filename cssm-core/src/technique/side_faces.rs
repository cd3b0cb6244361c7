//! Side faces of a pyramid of view, as the light sees them.
//!
//! Through the apex and two neighbouring corner directions c_k, c_(k+1) runs a side face. A point X, moved along its
//! light ray onto that plane, is u apex + s c_k + t c_(k+1); s, t and u are functionals that annihilate the light. The
//! faces with positive signed area in the light's view are those that hold the smallest depth along a ray; they tile the
//! pyramid's silhouette without gap or overlap. With rays that run away from the view plane these are the faces turned
//! towards the light, with rays that come back those turned away from it.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

/// Signed area, relative to the largest, below which a face is too thin for f32: its rays go to its neighbours, whose
/// gutters hold them.
const AREA_TOLERANCE: f64 = 1e-4;

/// A side face that rays enter first.
#[derive(Debug, Clone, Copy)]
pub(super) struct SideFace {
    /// Index of its first corner; the second is the next one.
    pub(super) corner: usize,
    /// Row that is zero on the border through the face's first corner and positive towards the face.
    pub(super) start: DVec4,
    /// Row that is zero on the border through the face's second corner and positive past it.
    pub(super) end: DVec4,
    /// Coordinate along the first corner's direction.
    pub(super) s: DVec4,
    /// Coordinate along the second corner's direction.
    pub(super) t: DVec4,
    /// Weight of the apex: 1 for a directional light.
    pub(super) unit: DVec4,
}

/// The faces that rays enter first.
pub(super) type Faces = SmallVec<[SideFace; 4]>;

/// Which way rays run as seen from the view.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Course {
    /// Depth grows along the ray.
    Away,
    /// Depth falls along the ray.
    Back,
}

impl Course {
    /// The course of a directional light's rays; parallel to the image counts as away.
    pub(super) fn of_directional(toward_light: DVec3) -> Self {
        if toward_light.z >= 0.0 { Self::Away } else { Self::Back }
    }
}

impl SideFace {
    /// Half-spaces of the points that belong to the face.
    pub(super) fn sides(&self) -> [DVec4; 2] {
        [self.start, -self.end]
    }
}

/// The faces that rays of a course enter first, in walking order. The light is a homogeneous point; corners lie at depth
/// 1 below the apex, counter-clockwise as the camera sees them.
pub(super) fn entered_first(apex: DVec3, corners: [DVec3; 4], light: DVec4, course: Course) -> Faces {
    // Orient areas as the image rectangle is oriented in the light's view.
    let sign = if course == Course::Away { 1.0 } else { -1.0 };
    let from_apex = light.truncate() - apex * light.w;
    let normals: [DVec3; 4] = std::array::from_fn(|k| corners[k].cross(corners[(k + 1) % 4]));
    let areas = normals.map(|normal| sign * normal.dot(from_apex));
    let largest = areas.iter().fold(0.0_f64, |largest, area| largest.max(area.abs()));
    let entered = |k: usize| areas[k % 4] > AREA_TOLERANCE * largest;

    // Entered faces follow each other around the pyramid: begin behind one that is not entered.
    let first = (0..4).find(|k| entered(*k) && !entered(k + 3)).unwrap_or(0);
    let row = |normal: DVec3| normal.extend(-normal.dot(apex));
    (first..first + 4)
        .take_while(|k| entered(*k))
        .map(|k| {
            let (one, two) = (corners[k % 4], corners[(k + 1) % 4]);
            let start = sign * from_apex.cross(one);
            let end = sign * from_apex.cross(two);
            let (normal, area) = (normals[k % 4], areas[k % 4]);
            // Cramer's rule for X = u apex + s one + t two + m L.
            SideFace {
                corner: k % 4,
                start: row(start.normalize()),
                end: row(end.normalize()),
                s: row(-end / area),
                t: row(start / area),
                unit: if light.w > 0.0 {
                    (normal * -light.w).extend(normal.dot(light.truncate())) * (sign / area)
                } else {
                    DVec4::W
                },
            }
        })
        .collect()
}
