//! The depth row of a facet: from the facet's own receivers, so that casters above them may be clamped.
//!
//! Any functional zeta with zeta.L < 0 grows along the light and is affine over every triangle's image, so hardware
//! depth is exact. The range is that of the receivers alone ("pancaking"): casters above clamp to the near end, which
//! is right because they are above every receiver of their texel.

use glam::{DVec2, DVec3, DVec4};

use crate::facet::FacetRows;
use crate::plan::DepthOrder;
use crate::receivers::{DEPTH_ROW, Polytope, is_negligible};

/// A depth row and its slope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct DepthRow {
    /// z row: z/w in [0, 1] on receivers, margins included.
    pub row: DVec4,
    /// Change of z/w times w per metre along the light, positive; for a local light also times the distance from it.
    pub depth_per_metre: f64,
    /// How far rounding moves depth along the light, in float steps and metres per w.
    pub rounding: f64,
}

/// What a depth row has to serve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DepthNeeds<'a> {
    /// The light as a homogeneous point, camera axes.
    pub light: DVec4,
    /// Everything that needs a depth.
    pub receivers: &'a Polytope,
    /// Visible points of the facet, camera axes.
    pub samples: &'a [DVec3],
    /// Kept free before and behind the receivers, metres along the light per w.
    pub margin_metres_per_w: f64,
    /// Kept free before the receivers besides, for casters whose distance is to be told, metres along the light per w, or, for
    /// a local light, multiples of their own distance from it.
    pub headroom_per_w: f64,
    /// Receivers deeper than this times w share the ends of the range.
    pub farthest_metres_per_w: f64,
    /// Smallest w of receivers of a local light; nearer ones share the near end of the range.
    pub near_w: Option<f64>,
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

    // A local light among the receivers needs a near plane; floats keep their precision whatever it is.
    let from_light = needs.near_w.map(|near_w| receivers.cut_by(&[w - DVec4::W * near_w]));
    let receivers = from_light.as_ref().filter(|cut| !cut.is_empty()).unwrap_or(receivers);

    // Try every face of the polytope and the plane across the light (facet algebra: zeta0 = -sign(pi.L) pi).
    let across_light = if needs.light.w > 0.0 { -DVec4::W } else { (-needs.light.truncate()).extend(0.0) };
    let faces = receivers.planes.iter().map(|plane| {
        let plane = *plane / plane.truncate().length();
        if plane.dot(needs.light) > 0.0 { -plane } else { plane }
    });
    let candidate = |zeta: DVec4| {
        let slope = -zeta.dot(needs.light);
        if slope < SMALLEST_SLOPE {
            return None;
        }
        let (first, last) = range(zeta, w, receivers, slope, needs);
        let extent = last - first;
        if !(extent > 0.0 && extent.is_finite()) {
            return None;
        }
        let row = match needs.order {
            DepthOrder::Standard => zeta - w * first,
            DepthOrder::Reversed => w * last - zeta,
        };
        let found = DepthRow { row: row / extent, depth_per_metre: slope / extent, rounding: 0.0 };
        Some(DepthRow { rounding: rounding(&found, w, needs), ..found })
    };
    let best = std::iter::once(across_light).chain(faces).filter_map(candidate);
    best.min_by(|one, two| one.rounding.total_cmp(&two.rounding))
}

/// Smallest and largest zeta/w over the receivers, margins included. A metre along a local light counts the less the
/// farther the light is.
fn range(zeta: DVec4, w: DVec4, receivers: &Polytope, slope: f64, needs: &DepthNeeds<'_>) -> (f64, f64) {
    let margin = needs.margin_metres_per_w * slope;
    let headroom = needs.headroom_per_w * slope;
    if needs.light.w == 0.0 {
        let (first, last) = receivers.ratio_range(zeta, w);
        return (first - margin - headroom, last + margin);
    }
    let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
    for vertex in &receivers.vertices {
        let scale = w.dot(*vertex);
        if is_negligible(scale, w, *vertex) {
            continue;
        }
        let value = zeta.dot(*vertex) / scale;
        let margin = margin / light_distance(needs.light, *vertex).max(f64::MIN_POSITIVE);
        ends = (ends.0.min(value - margin), ends.1.max(value + margin));
    }
    (ends.0 - headroom, ends.1)
}

/// Distance of a homogeneous point from a local light in metres, infinite at infinity; 1 for a directional light.
pub(crate) fn light_distance(light: DVec4, point: DVec4) -> f64 {
    if light.w == 0.0 {
        1.0
    } else if point.w > 0.0 {
        (point.truncate() / point.w).distance(light.truncate())
    } else {
        f64::INFINITY
    }
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
        let homogeneous = point.extend(1.0);
        row.dot(terms) / w.dot(homogeneous) * light_distance(needs.light, homogeneous)
    });
    let mut terms: Vec<f64> = terms.collect();
    let rank = terms.len() * 95 / 100;
    if terms.is_empty() {
        return 1.0 / depth.depth_per_metre;
    }
    let (_, term, _) = terms.select_nth_unstable_by(rank, f64::total_cmp);
    *term / depth.depth_per_metre
}
