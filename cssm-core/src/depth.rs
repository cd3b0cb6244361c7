//! The depth row of a facet: from the facet's own receivers, so that casters above them may be clamped.
//!
//! Any functional zeta with zeta.L < 0 grows along the light and is affine over every triangle's image, so hardware
//! depth is exact. The range is that of the receivers alone ("pancaking"): casters above clamp to the near end, which
//! is right because they are above every receiver of their texel.

use glam::{DVec2, DVec3, DVec4};
use smallvec::SmallVec;

use crate::facet::FacetRows;
use crate::plan::DepthOrder;
use crate::receivers::{Body, DEPTH_ROW, Polytope, is_negligible};

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
    pub receivers: Body<'a>,
    /// Kept free before and behind the receivers, metres along the light per w.
    pub margin_metres_per_w: f64,
    /// Kept free before the receivers besides, for casters whose distance is to be told, metres along the light per w, or, for
    /// a local light, multiples of their own distance from it.
    pub headroom_per_w: f64,
    /// Receivers deeper than this times w share the ends of the range.
    pub farthest_metres_per_w: f64,
    /// Smallest w of receivers of a local light; nearer ones share the near end of the range.
    pub near_w: Option<f64>,
    /// Which ends of stored depth may lie towards the light; two at most.
    pub orders: &'a [DepthOrder],
    /// Shear of positions; see [`crate::ShadowPlan::shear`].
    pub shear: DVec2,
}

/// Samples by which candidates are compared.
pub(crate) const COMPARED_SAMPLES: usize = 48;
/// Smallest change along the light of a usable candidate, per metre.
const SMALLEST_SLOPE: f64 = 1e-9;
/// Percentage of the samples that rounding is judged by.
const JUDGED_PERCENT: usize = 95;

/// Finds the row that f32 evaluates and stores best over some visible points of the facet, for each order. `None` when
/// the receivers have no usable extent.
pub(crate) fn depth_rows(
    rows: &FacetRows,
    needs: &DepthNeeds<'_>,
    samples: impl ExactSizeIterator<Item = DVec3>,
) -> [Option<DepthRow>; 2] {
    // Where the view looks along the light, a facet near that axis holds receivers at any distance: leave out those
    // that are too far to be told apart on the screen.
    let w = rows.w;
    let (mut told_apart, mut from_light) = (Polytope::empty(), Polytope::empty());
    let far = w * needs.farthest_metres_per_w - DEPTH_ROW;
    let (receivers, beyond) = part(needs.receivers, far, &mut told_apart);

    // A local light among the receivers needs a near plane; floats keep their precision whatever it is.
    let (receivers, before) = match needs.near_w {
        Some(near_w) => part(receivers, w - DVec4::W * near_w, &mut from_light),
        None => (receivers, None),
    };
    let beside = [beyond, before].into_iter().flatten();
    let mut places = Places::new();
    list_places(receivers, w, needs.light, &mut places);
    let mut terms = Terms { samples: SmallVec::new(), shear: needs.shear };
    terms.list(w, needs, samples);

    // Try every face of the polytope and the plane across the light (facet algebra: zeta0 = -sign(pi.L) pi).
    let across_light = if needs.light.w > 0.0 { -DVec4::W } else { (-needs.light.truncate()).extend(0.0) };
    let faces = receivers.planes.iter().copied().chain(beside).filter_map(|plane| {
        let (slope, square) = (plane.dot(needs.light), plane.truncate().length_squared());
        // Most planes between facets contain the light.
        let is_usable = slope * slope >= 0.5 * SMALLEST_SLOPE * SMALLEST_SLOPE * square;
        let plane = plane / if is_usable { square.sqrt() } else { return None };
        Some(if slope > 0.0 { -plane } else { plane })
    });
    let mut best: [Option<DepthRow>; 2] = [None; 2];
    for zeta in std::iter::once(across_light).chain(faces) {
        let slope = -zeta.dot(needs.light);
        if slope.is_nan() || slope < SMALLEST_SLOPE {
            continue;
        }
        let (first, last) = range(zeta, &places, needs.margin_metres_per_w * slope);
        let first = first - needs.headroom_per_w * slope;
        let extent = last - first;
        if !(extent > 0.0 && extent.is_finite()) {
            continue;
        }
        for (order, best) in needs.orders.iter().zip(&mut best) {
            let row = match order {
                DepthOrder::Standard => zeta - w * first,
                DepthOrder::Reversed => w * last - zeta,
            };
            // Rounding is the same at any scale of the row.
            let limit = best.map_or(f64::INFINITY, |best| best.rounding);
            let rounding = match terms.samples.is_empty() {
                true => Some(extent / slope),
                false => terms.rounding(row, slope, limit),
            };
            let Some(rounding) = rounding else { continue };
            if best.is_none() || rounding < limit {
                let per_extent = 1.0 / extent;
                let (row, depth_per_metre) = (row * per_extent, slope * per_extent);
                *best = Some(DepthRow { row, depth_per_metre, rounding });
            }
        }
    }
    best
}

/// A polytope cut by a plane, in `cut`, if there is anything to cut off and anything left; and the plane, where it is none
/// of the polytope's.
fn part<'a>(whole: Body<'a>, plane: DVec4, cut: &'a mut Polytope) -> (Body<'a>, Option<DVec4>) {
    if whole.vertices.iter().all(|vertex| plane.dot(*vertex) >= 0.0) {
        return (whole, Some(plane));
    }
    whole.cut_into(&[plane], cut);
    (if cut.is_empty() { whole } else { cut.body() }, None)
}

/// Points with w = 1, and how much a metre along the light counts there.
type Places = SmallVec<[(DVec4, f64); 48]>;

/// Lists the receivers' vertices with w = 1: a metre along the light counts the less, the farther a local light is. Vertices
/// whose w vanishes are passed over, see [`Body::ratio_range`].
fn list_places(receivers: Body<'_>, w: DVec4, light: DVec4, places: &mut Places) {
    for vertex in receivers.vertices {
        let scale = w.dot(*vertex);
        if !is_negligible(scale, w, *vertex) {
            let per_metre = if light.w == 0.0 {
                1.0
            } else {
                1.0 / light_distance(light, *vertex).max(f64::MIN_POSITIVE)
            };
            places.push((*vertex * (1.0 / scale), per_metre));
        }
    }
}

/// Smallest and largest zeta/w over the receivers, with a margin along the light.
fn range(zeta: DVec4, places: &[(DVec4, f64)], margin: f64) -> (f64, f64) {
    let mut ends = (f64::INFINITY, f64::NEG_INFINITY);
    for (place, per_metre) in places {
        let (value, margin) = (zeta.dot(*place), margin * per_metre);
        let (low, high) = (value - margin, value + margin);
        if low < ends.0 {
            ends.0 = low;
        }
        if high > ends.1 {
            ends.1 = high;
        }
    }
    ends
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

/// Sizes of the terms of a depth row at sample receivers.
struct Terms {
    /// Sheared coordinates and 1, and what their sum counts: distance from the light over w.
    samples: SmallVec<[(DVec4, f64); COMPARED_SAMPLES]>,
    shear: DVec2,
}

impl Terms {
    fn list(&mut self, w: DVec4, needs: &DepthNeeds<'_>, samples: impl ExactSizeIterator<Item = DVec3>) {
        let step = samples.len().div_ceil(COMPARED_SAMPLES).max(1);
        for point in samples.step_by(step) {
            let sheared = needs.shear * point.z + DVec2::new(point.x, point.y);
            let terms = DVec4::new(sheared.x, sheared.y, point.z, 1.0).abs();
            let homogeneous = point.extend(1.0);
            self.samples.push((terms, light_distance(needs.light, homogeneous) / w.dot(homogeneous)));
        }
    }

    /// How far rounding moves depth along the light: the 95th percentile over samples, in float steps and metres per w.
    /// `None` where that is above a limit.
    fn rounding(&self, row: DVec4, slope: f64, limit: f64) -> Option<f64> {
        /// Largest values that can matter.
        const LARGEST: usize = COMPARED_SAMPLES - COMPARED_SAMPLES * JUDGED_PERCENT / 100;
        let along = row.z - self.shear.dot(DVec2::new(row.x, row.y));
        let row = DVec4::new(row.x, row.y, along, row.w).abs();
        let count = self.samples.len();

        // Keep as many of the largest values, in falling order, as lie at and above the rank.
        let rank = (count - count * JUDGED_PERCENT / 100).min(LARGEST);
        let mut largest = [f64::NEG_INFINITY; LARGEST];
        let largest = &mut largest[..rank];
        let limit = limit * slope;
        if let [only] = largest {
            for (terms, weight) in &self.samples {
                let value = row.dot(*terms) * weight;
                if value > *only {
                    *only = value;
                }
            }
            return (*only <= limit).then_some(*only / slope);
        }
        for (terms, weight) in &self.samples {
            let mut value = row.dot(*terms) * weight;
            for place in largest.iter_mut() {
                if value > *place {
                    std::mem::swap(place, &mut value);
                }
            }
            if largest[rank - 1] > limit {
                return None;
            }
        }
        Some(largest[rank - 1] / slope)
    }
}
