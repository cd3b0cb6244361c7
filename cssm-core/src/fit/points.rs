//! Places where pixels are, as many as there are pixels.
//!
//! Points follow a low-discrepancy sequence through cumulative distributions, so that each moves continuously as what is
//! known of the pixels changes.

use glam::{DVec2, DVec3, DVec4};

use super::{BINS, DepthHistogram, bin};
use crate::facet::FacetRows;
use crate::polygon;
use crate::receivers::{DEPTH_ROW, Polytope};
use crate::remap::Remap;
use crate::samples::SAMPLED_HORIZON_METRES;
use crate::view::View;

/// Points in all.
const POINTS: usize = 1024;
/// Deepest point of what has no end, in nearest depths.
const FARTHEST_PER_NEAREST: f64 = 1e3;

/// The sequence's point of an index: powers of the plastic number's next of kin, as in [`crate::samples::receivers`].
fn unit(index: usize) -> DVec3 {
    const STEP: DVec3 = DVec3::new(0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_1);
    (STEP * (index as f64 + 0.5)).fract()
}

/// Points of a late measurement, moved with the world to where this frame's camera sees them; camera space. Also the share
/// of them that it does see.
pub(super) fn measured(depth: &DepthHistogram, view: &View, receivers: &Polytope) -> (Vec<DVec3>, f64) {
    let points = reprojected(depth, view, receivers);
    let trust = points.len() as f64 / POINTS as f64;
    (points, trust)
}

/// Points of a measurement that this frame's camera sees.
fn reprojected(depth: &DepthHistogram, view: &View, receivers: &Polytope) -> Vec<DVec3> {
    let then = &depth.view;
    let to_world = then.camera_from_world.transpose();
    let size = DVec2::new(f64::from(then.size_pixels.0), f64::from(then.size_pixels.1));
    let total = depth.pixels();
    let point = |index: usize| {
        // Invert the distribution of depth, then pick a place in the bin's rectangle.
        let unit = unit(index);
        let mut left = unit.z * total;
        let mut found = None;
        for (index, bin) in depth.bins.iter().enumerate() {
            if bin.pixels > 0.0 {
                found = Some((index, (left / bin.pixels).clamp(0.0, 1.0)));
                left -= bin.pixels;
                if left < 0.0 {
                    break;
                }
            }
        }
        let (index, share) = found?;
        let (low, high) = depth.part(index)?;
        let metres = low * libm::pow(high / low, share);
        let [x, y, right, lower] = depth.bins[index].rectangle_pixels;
        let pixel = DVec2::new(x + (right - x) * unit.x, y + (lower - y) * unit.y) / size;
        let across = then.left + (then.right - then.left) * pixel.x;
        let up = then.top + (then.bottom - then.top) * pixel.y;
        let world = then.eye_world + to_world * (DVec3::new(across, up, -1.0) * metres);
        Some(view.camera_from_world * (world - view.eye_world))
    };
    let seen = |point: &DVec3| receivers.contains(point.extend(1.0));
    (0..POINTS).filter_map(point).filter(seen).collect()
}

/// Points in parts that hold everything seen: even over the screen, or, with a late measurement, as often as each depth
/// was seen.
pub(super) fn within(parts: &[Polytope], view: &View, depth: Option<&DepthHistogram>) -> Vec<DVec3> {
    let rows = FacetRows { x: DVec4::X, y: DVec4::Y, z: DEPTH_ROW, w: DEPTH_ROW, remap: Remap::NONE };
    let outlines: Vec<Vec<DVec2>> =
        parts.iter().map(|part| polygon::outline(&rows, &part.vertices)).collect();
    let mut weights: Vec<f64> = outlines.iter().map(|outline| polygon::area(outline).max(0.0)).collect();
    if let Some(depth) = depth {
        weigh(&mut weights, parts, view, depth);
    }
    let total: f64 = weights.iter().sum();
    if total <= 0.0 {
        return Vec::new();
    }

    // Walk through the parts in even steps of weight.
    let (mut part, mut passed) = (0, 0.0);
    let point = |index: usize| {
        let target = (index as f64 + 0.5) / POINTS as f64 * total;
        while part + 1 < weights.len() && passed + weights[part] <= target {
            passed += weights[part];
            part += 1;
        }
        inner_point(&parts[part], &outlines[part], unit(index))
    };
    (0..POINTS).filter_map(point).collect()
}

/// Changes the weights of parts so that each depth has as many points as pixels, but for the floor.
fn weigh(weights: &mut [f64], parts: &[Polytope], view: &View, depth: &DepthHistogram) {
    let everywhere = Polytope::frustum(view, view.far_metres);
    let seen = reprojected(depth, view, &everywhere);
    let near = view.near_metres;
    let binned = |metres: f64| bin((metres / near) as f32);
    let mut wanted = [0.0; BINS];
    for point in &seen {
        wanted[binned(-point.z)] += 1.0 / POINTS as f64;
    }
    let middle = |part: &Polytope| {
        let (low, high) = part.range(DEPTH_ROW);
        (low.max(near) * high.min(FARTHEST_PER_NEAREST * low.max(near))).sqrt()
    };
    let bins: Vec<usize> = parts.iter().map(|part| binned(middle(part))).collect();
    let total: f64 = weights.iter().sum();
    let mut had = [0.0; BINS];
    for (bin, weight) in bins.iter().zip(weights.iter()) {
        had[*bin] += weight / total;
    }
    let held: f64 = (0..BINS).filter(|bin| had[*bin] > 0.0).map(|bin| wanted[bin]).sum();
    for (bin, weight) in bins.iter().zip(weights.iter_mut()) {
        if had[*bin] > 0.0 {
            *weight *= (1.0 - held) + wanted[*bin] / had[*bin];
        }
    }
}

/// A point of a part: even over its outline on the screen, and in the logarithm of depth behind it.
fn inner_point(part: &Polytope, outline: &[DVec2], unit: DVec3) -> Option<DVec3> {
    let [first, rest @ ..] = outline else { return None };

    // Pick a triangle of the fan by area, and a place in it.
    let mut left = unit.x * polygon::area(outline);
    let mut place = *first;
    for pair in rest.windows(2) {
        let (one, two) = (pair[0] - *first, pair[1] - *first);
        let area = 0.5 * one.perp_dot(two);
        if area <= 0.0 {
            continue;
        }
        let share = (left / area).clamp(0.0, 1.0);
        let root = share.sqrt();
        place = *first + (one * (1.0 - unit.y) + two * unit.y) * root;
        left -= area;
        if left < 0.0 {
            break;
        }
    }

    // Find where the pixel's ray runs in the part.
    let ray = DVec3::new(place.x, place.y, -1.0);
    let (mut low, mut high) = (0.0_f64, f64::INFINITY);
    for plane in &part.planes {
        let slope = plane.truncate().dot(ray);
        let end = -plane.w / slope;
        if slope > 0.0 {
            low = low.max(end);
        } else if slope < 0.0 {
            high = high.min(end);
        }
    }
    let high = high.min((FARTHEST_PER_NEAREST * low).max(SAMPLED_HORIZON_METRES));
    let metres = if low < high { low * libm::pow(high / low, unit.z) } else { 0.5 * (low + high) };
    let point = ray * metres;
    (metres > 0.0 && point.is_finite()).then_some(point)
}
