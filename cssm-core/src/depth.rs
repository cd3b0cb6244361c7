//! The depth row of a facet: from the facet's own receivers, so that casters above them may be clamped.
//!
//! Any functional zeta with zeta.L < 0 grows along the light and is affine over every triangle's image, so hardware
//! depth is exact. The range is that of the receivers alone ("pancaking"): casters above clamp to 0, which is right
//! because they are above every receiver of their texel.

use glam::DVec4;

use crate::receivers::{DEPTH_ROW, Polytope};

/// A depth row and its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DepthRow {
    /// z row: z/w in [0, 1] on receivers, margins included.
    pub row: DVec4,
    /// Change of z/w times w per metre away from the light.
    pub depth_per_metre: f64,
}

/// Finds the row with the steepest slope along the light; `margin_metres_per_w` is kept free, in metres along the light
/// per w, before and behind the receivers; receivers deeper than
/// `farthest_metres_per_w` share depth 0 or 1. `None` when the receivers have no usable extent.
pub(crate) fn depth_row(
    w: DVec4,
    light: DVec4,
    receivers: &Polytope,
    margin_metres_per_w: f64,
    farthest_metres_per_w: f64,
) -> Option<DepthRow> {
    // Where the view looks along the light, a facet near that axis holds receivers at any distance: leave out those
    // that are too far to be told apart on the screen.
    let receivers = receivers.cut_by(&[w * farthest_metres_per_w - DEPTH_ROW]);

    // Try every face of the polytope and the plane across the light (facet algebra: zeta0 = -sign(pi.L) pi).
    let toward = light.truncate();
    let across_light = (-toward).extend(0.0);
    let faces = receivers.planes.iter().map(|plane| {
        let plane = *plane / plane.truncate().length();
        if plane.dot(light) > 0.0 { -plane } else { plane }
    });
    let candidate = |zeta: DVec4| {
        let slope = -zeta.dot(light);
        if slope < 1e-9 {
            return None;
        }
        let (first, last) = receivers.ratio_range(zeta, w);
        let margin = margin_metres_per_w * slope;
        let extent = last - first + 2.0 * margin;
        if !(extent > 0.0 && extent.is_finite()) {
            return None;
        }
        let row = (zeta - w * (first - margin)) / extent;
        Some(DepthRow { row, depth_per_metre: slope / extent })
    };
    std::iter::once(across_light)
        .chain(faces)
        .filter_map(candidate)
        .max_by(|one, two| one.depth_per_metre.total_cmp(&two.depth_per_metre))
}
