//! Local geometry of a facet: how its tile coordinates change around a point.

use glam::{DVec3, DVec4};

use crate::facet::FacetRows;

/// First-order change of a facet's clip coordinates around a point, in NDC per metre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gradients {
    /// Clip coordinates x/w, y/w, z/w of the point.
    pub ndc: DVec3,
    /// w of the point.
    pub w: f64,
    /// Change of x/w per metre of displacement.
    pub x: DVec3,
    /// Change of y/w per metre of displacement.
    pub y: DVec3,
    /// Change of z/w per metre of displacement.
    pub z: DVec3,
}

impl Gradients {
    /// Gradients at a finite point in the space of the rows.
    pub fn at(rows: &FacetRows, point: DVec3) -> Self {
        let homogeneous = point.extend(1.0);
        let w = rows.w.dot(homogeneous);
        let ratios =
            DVec3::new(rows.x.dot(homogeneous), rows.y.dot(homogeneous), rows.z.dot(homogeneous)) / w;
        let gradient = |row: DVec4, value: f64| (row.truncate() - rows.w.truncate() * value) / w;
        let slope = rows.remap.slope(ratios.y);
        Self {
            ndc: DVec3::new(ratios.x, rows.remap.y(ratios.y), ratios.z),
            w,
            x: gradient(rows.x, ratios.x),
            y: gradient(rows.y, ratios.y) * slope,
            z: gradient(rows.z, ratios.z),
        }
    }

    /// Displacements across the light ray, in metres, that change x/w alone and y/w alone by one.
    pub fn across_light(&self) -> (DVec3, DVec3) {
        let normal = self.x.cross(self.y);
        let area = normal.length_squared();
        (self.y.cross(normal) / area, normal.cross(self.x) / area)
    }

    /// Displacements along a surface with this normal, in metres, that change x/w alone and y/w alone by one.
    pub fn along_surface(&self, normal: DVec3) -> (DVec3, DVec3) {
        let area = normal.dot(self.x.cross(self.y));
        (self.y.cross(normal) / area, normal.cross(self.x) / area)
    }

    /// Change of z/w per unit of x/w and of y/w along a surface with this normal.
    pub fn depth_along_surface(&self, normal: DVec3) -> (f64, f64) {
        let (across, up) = self.along_surface(normal);
        (self.z.dot(across), self.z.dot(up))
    }
}

/// Largest and smallest singular value of the 3 x 2 matrix [u v].
pub fn singular_values(u: DVec3, v: DVec3) -> (f64, f64) {
    let (uu, vv, uv) = (u.length_squared(), v.length_squared(), u.dot(v));
    let mean = 0.5 * (uu + vv);
    let spread = (0.25 * (uu - vv) * (uu - vv) + uv * uv).sqrt();
    let largest = (mean + spread).sqrt();
    // The product of both is the area, which does not cancel.
    let area = u.cross(v).length();
    (largest, if largest > 0.0 { area / largest } else { 0.0 })
}
