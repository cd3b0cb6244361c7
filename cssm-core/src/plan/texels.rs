//! What texels span on the screen at single points.

use glam::{DVec3, DVec4};

use crate::facet::FacetRows;
use crate::layout::Gram;
use crate::remap::Remap;
use crate::technique::Situation;

/// What single texels of a tile span.
#[derive(Debug, Clone, Copy)]
pub(super) struct Texels {
    /// Rows of x/w in texels, y/w and w.
    rows: [DVec4; 3],
    remap: Remap,
    /// Texels of the tile's inner part up.
    height: f64,
    /// Square of the pixels of a tangent of 1, in halves.
    scale: f64,
}

impl Texels {
    /// Texels of a window in a tile whose inner part has this size.
    pub(super) fn of(rows: &FacetRows, width: f64, height: f64, situation: &Situation<'_>) -> Self {
        let FacetRows { x, y, w, remap, .. } = *rows;
        let pixels = 2.0 * situation.view.pixels_per_tangent();
        Self { rows: [x * width, y, w], remap, height, scale: pixels * pixels }
    }

    /// Square of the major axis of the texel at a point, in pixels: as [`gram`] has it, with one division.
    pub(super) fn major_square(&self, point: DVec3) -> f64 {
        let [x, y, w] = self.rows;
        let homogeneous = point.extend(1.0);
        let (across, up, unit) = (x.dot(homogeneous), y.dot(homogeneous), w.dot(homogeneous));
        let slope = if self.remap.is_none() { 1.0 } else { self.remap.slope(up / unit) };
        let one = x.truncate() * unit - w.truncate() * across;
        let two = (y.truncate() * unit - w.truncate() * up) * (slope * self.height);
        let (a, b, c) = (two.length_squared(), one.length_squared(), one.dot(two));
        let square = unit * unit;
        let shared = self.scale * square * square / (one.cross(two).length_squared() * point.z * point.z);
        shared * (0.5 * (a + b) + (0.25 * (a - b) * (a - b) + c * c).sqrt())
    }
}

/// Products of the pixel vectors that span the whole clip space at a point: displacements across the light that change
/// x/w alone and y/w alone, which are reciprocal to the gradients of both.
pub(super) fn gram(rows: &FacetRows, situation: &Situation<'_>, point: DVec3) -> Option<Gram> {
    let homogeneous = point.extend(1.0);
    let per_w = 1.0 / rows.w.dot(homogeneous);
    let (x, y) = (rows.x.dot(homogeneous) * per_w, rows.y.dot(homogeneous) * per_w);
    let w = rows.w.truncate();
    let gradient_x = (rows.x.truncate() - w * x) * per_w;
    let slope = if rows.remap.is_none() { 1.0 } else { rows.remap.slope(y) };
    let gradient_y = (rows.y.truncate() - w * y) * (per_w * slope);
    let area = gradient_x.cross(gradient_y).length_squared();
    let pixels = 2.0 * situation.view.pixels_per_tangent() / -point.z;
    let scale = pixels * pixels / area;
    let gram = Gram {
        xx: gradient_y.length_squared() * scale,
        yy: gradient_x.length_squared() * scale,
        xy: -gradient_x.dot(gradient_y) * scale,
    };
    (gram.xx.is_finite() && gram.yy.is_finite()).then_some(gram)
}
