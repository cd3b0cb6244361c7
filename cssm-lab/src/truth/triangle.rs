//! The ray and triangle test: two-sided, without any epsilon.

use cssm_core::glam::DVec3;

/// A triangle in world space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Triangle {
    pub(super) corner: DVec3,
    pub(super) edges: [DVec3; 2],
}

/// Where a ray meets a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Meeting {
    /// Ray parameter.
    pub(super) distance: f64,
    /// Weights of the second and the third corner; the first has the rest of 1.
    pub(super) weights: [f64; 2],
}

impl Triangle {
    /// The hit (Moeller and Trumbore, "Fast, Minimum Storage Ray-Triangle Intersection", 1997); `None` for a miss
    /// and for a ray in the triangle's plane.
    #[inline]
    pub(super) fn hit(&self, origin: DVec3, direction: DVec3) -> Option<Meeting> {
        let [along, across] = self.edges;
        let lifted = direction.cross(across);
        let determinant = along.dot(lifted);
        let offset = origin - self.corner;
        let u = offset.dot(lifted) / determinant;
        let turned = offset.cross(along);
        let v = direction.dot(turned) / determinant;
        let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
        let distance = across.dot(turned) / determinant;
        (inside && distance.is_finite()).then_some(Meeting { distance, weights: [u, v] })
    }
}
