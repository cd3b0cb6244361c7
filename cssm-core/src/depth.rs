//! The depth row of a facet: from the facet's own receivers, so that casters above them may be clamped.
//!
//! Any functional zeta with zeta.L < 0 grows along the light and is affine over every triangle's image, so hardware
//! depth is exact. The range is that of the receivers alone ("pancaking"): casters above clamp to the near end, which
//! is right because they are above every receiver of their texel.

use glam::{DVec2, DVec3, DVec4};

use crate::facet::FacetRows;
use crate::plan::DepthOrder;
use crate::receivers::{DEPTH_ROW, Polytope};

/// A depth row and its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DepthRow {
    /// z row: z/w in [0, 1] on receivers, margins included.
    pub row: DVec4,
    /// Change of z/w times w per metre along the light, positive.
    pub depth_per_metre: f64,
}

/// What a depth row has to serve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DepthNeeds<'a> {
    /// Direction towards the light, camera axes.
    pub light: DVec4,
    /// Everything that needs a depth.
    pub receivers: &'a Polytope,
    /// Visible points of the facet, camera axes.
    pub samples: &'a [DVec3],
    /// Kept free before and behind the receivers, metres along the light per w.
    pub margin_metres_per_w: f64,
    /// Receivers deeper than this times w share the ends of the range.
    pub farthest_metres_per_w: f64,
    /// Which end of stored depth lies towards the light.
    pub order: DepthOrder,
    /// Shear of positions; see [`crate::ShadowPlan::shear`].
    pub shear: DVec2,
}

/// Samples by which candidates are compared.
const COMPARED_SAMPLES: usize = 48;
/// Smallest change along the light of a usable candidate, per metre.
const SMALLEST_SLOPE: f64 = 1e-9;

/// Finds the row that f32 evaluates and stores best. `None` when the receivers have no usable extent.
pub(crate) fn depth_row(rows: &FacetRows, needs: &DepthNeeds<'_>) -> Option<DepthRow> {
    // Where the view looks along the light, a facet near that axis holds receivers at any distance: leave out those
    // that are too far to be told apart on the screen.
    let w = rows.w;
    let told_apart = needs.receivers.cut_by(&[w * needs.farthest_metres_per_w - DEPTH_ROW]);
    let receivers = if told_apart.is_empty() { needs.receivers } else { &told_apart };

    // Try every face of the polytope and the plane across the light (facet algebra: zeta0 = -sign(pi.L) pi).
    let across_light = (-needs.light.truncate()).extend(0.0);
    let faces = receivers.planes.iter().map(|plane| {
        let plane = *plane / plane.truncate().length();
        if plane.dot(needs.light) > 0.0 { -plane } else { plane }
    });
    let candidate = |zeta: DVec4| {
        let slope = -zeta.dot(needs.light);
        if slope < SMALLEST_SLOPE {
            return None;
        }
        let (first, last) = receivers.ratio_range(zeta, w);
        let margin = needs.margin_metres_per_w * slope;
        let extent = last - first + 2.0 * margin;
        if !(extent > 0.0 && extent.is_finite()) {
            return None;
        }
        let row = match needs.order {
            DepthOrder::Standard => zeta - w * (first - margin),
            DepthOrder::Reversed => w * (last + margin) - zeta,
        };
        let found = DepthRow { row: row / extent, depth_per_metre: slope / extent };
        Some((found, rounding(&found, w, needs)))
    };
    let best = std::iter::once(across_light).chain(faces).filter_map(candidate);
    best.min_by(|(_, one), (_, two)| one.total_cmp(two)).map(|(row, _)| row)
}

/// How far rounding moves depth along the light: the 95th percentile over samples, in float steps and metres per w.
fn rounding(depth: &DepthRow, w: DVec4, needs: &DepthNeeds<'_>) -> f64 {
    let row = depth.row;
    let along = row.z - needs.shear.dot(DVec2::new(row.x, row.y));
    let row = DVec4::new(row.x, row.y, along, row.w).abs();
    let step = needs.samples.len().div_ceil(COMPARED_SAMPLES).max(1);
    let terms = needs.samples.iter().step_by(step).map(|point| {
        let sheared = needs.shear * point.z + DVec2::new(point.x, point.y);
        let terms = DVec4::new(sheared.x, sheared.y, point.z, 1.0).abs();
        row.dot(terms) / w.dot(point.extend(1.0))
    });
    let mut terms: Vec<f64> = terms.collect();
    let rank = terms.len() * 95 / 100;
    if terms.is_empty() {
        return 1.0 / depth.depth_per_metre;
    }
    let (_, term, _) = terms.select_nth_unstable_by(rank, f64::total_cmp);
    *term / depth.depth_per_metre
}
