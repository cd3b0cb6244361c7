//! The depth row of a facet: from the facet's own receivers, so that casters above them may be clamped.
//!
//! Any functional zeta with zeta.L < 0 grows along the light and is affine over every triangle's image, so hardware
//! depth is exact. The range is that of the receivers alone ("pancaking"): casters above clamp to 0, which is right
//! because they are above every receiver of their texel.

use glam::DVec4;

use crate::receivers::Polytope;

/// A depth row and its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DepthRow {
    /// z row: z/w in [0, 1] on receivers, margins included.
    pub row: DVec4,
    /// Change of z/w times w per metre away from the light.
    pub depth_per_metre: f64,
}

/// Longest range along the light in widths w of the facet. Receivers beyond it lie within 1/8192 rad of the light's own
/// direction (or its opposite) as seen from the eye, less than a pixel; they share depth 0 or 1.
const DEPTH_RANGE_PER_WIDTH: f64 = 8192.0;

/// Finds the row with the steepest slope along the light; `margin_metres_per_w` is kept free, in metres along the light
/// per w, before and behind the receivers. `None` when the receivers have no usable extent.
pub(crate) fn depth_row(w: DVec4, light: DVec4, receivers: &Polytope, margin_metres_per_w: f64) -> Option<DepthRow> {
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
        let (first, last) = bounded_range(zeta, w, slope, light, receivers)?;
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

/// Range of zeta/w over the receivers. Where the view looks along the light, a facet near that axis holds receivers at
/// any distance: the end away from the eye is cut.
fn bounded_range(zeta: DVec4, w: DVec4, slope: f64, light: DVec4, receivers: &Polytope) -> Option<(f64, f64)> {
    let (first, last) = receivers.ratio_range(zeta, w);
    let longest = DEPTH_RANGE_PER_WIDTH * slope;
    if last - first <= longest {
        return Some((first, last));
    }
    // Camera space: a light behind the eye has z > 0 and meets receivers near the eye first.
    let range = if light.z >= 0.0 { (first, first + longest) } else { (last - longest, last) };
    (range.0.is_finite() && range.1.is_finite()).then_some(range)
}
