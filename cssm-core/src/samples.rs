//! Sample receivers: visible points spread over the screen and, evenly in their logarithm, over depth.

use glam::{DVec2, DVec3, DVec4};
use smallvec::SmallVec;

use crate::receivers::{DEPTH_ROW, Polytope};
use crate::view::View;

/// Depth to which an infinite view is sampled, in metres and at least in near distances.
pub const SAMPLED_HORIZON_METRES: f64 = 1e5;

/// Up to `count` points of the receivers in camera space, by a low-discrepancy sequence (generalised golden ratio):
/// uniform over the part of the frustum's cross-section that holds receivers, log-uniform in depth.
pub fn receivers(view: &View, receivers: &Polytope, count: usize) -> Vec<DVec3> {
    let mut points = Vec::with_capacity(count);
    spread(view, receivers, count, &mut |point| points.push(point));
    points
}

/// [`receivers`], one after the other.
fn spread(view: &View, receivers: &Polytope, count: usize, add: &mut impl FnMut(DVec3)) {
    // Powers of 1/g with g^4 = g + 1: the three-dimensional sequence of lowest known discrepancy of its kind.
    const STEP: DVec3 = DVec3::new(0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_1);
    let (nearest, farthest) = receivers.range(DEPTH_ROW);
    let nearest = nearest.max(f64::MIN_POSITIVE);
    let farthest = if farthest.is_finite() { farthest } else { SAMPLED_HORIZON_METRES.max(1e3 * nearest) };
    let logarithm = libm::log(farthest / nearest);

    // Only what is no frustum of the view needs a test.
    let is_whole = receivers.is_frustum();
    let (left, right) = (view.left, view.right);
    let (bottom, top) = (view.bottom, view.top);
    for index in 0..count {
        let place = STEP * (index as f64 + 0.5);
        let unit = place - DVec3::new(whole(place.x), whole(place.y), whole(place.z));
        let depth = nearest * libm::exp(logarithm * unit.z);
        let x = left + (right - left) * unit.x;
        let y = bottom + (top - bottom) * unit.y;
        let point = DVec3::new(x, y, -1.0) * depth;
        if is_whole || receivers.contains(point.extend(1.0)) {
            add(point);
        }
    }
}

/// Sample receivers of a view at most, unless tiles are sized by them or its pixels are known.
pub(crate) const MOST: usize = (TRIES * COMPARED) as usize;
/// Sample receivers; so many need no allocation.
pub(crate) type Points = SmallVec<[DVec3; MOST]>;

/// Sample receivers of a view by which drafts for a light at infinity are compared.
const COMPARED: u32 = 256;
/// The same for a light that is not: twice as many are tried where it does not reach all.
const COMPARED_LOCAL: u32 = 128;
/// Sample receivers of a view where there is one draft: footprints go with depth, in which samples are even.
const ALONE: u32 = 64;
/// Sample receivers of a view where tiles are sized by them, or its pixels are known.
pub(crate) const COUNTED: u32 = 1024;
/// Points that are tried for each sample of receivers that are no whole frustum.
const TRIES: u32 = 2;

/// Sample receivers by which so many drafts are judged for a light at infinity or for one that is not.
pub(crate) const fn count(drafts: usize, is_local: bool) -> u32 {
    match (drafts, is_local) {
        (0 | 1, _) => ALONE,
        (_, true) => COMPARED_LOCAL,
        (_, false) => COMPARED,
    }
}

/// So many sample receivers of a view.
pub(crate) fn sample(view: &View, within: &Polytope, count: u32, add: &mut impl FnMut(DVec3)) {
    if count > COMPARED {
        spread(view, within, count as usize, add);
    } else {
        visible(within, count, add);
    }
}

/// Visible points of the receivers in camera space, from near to far, out of `count` that are tried: even over the part
/// of the screen that holds receivers, even in the logarithm of depth.
fn visible(receivers: &Polytope, count: u32, add: &mut impl FnMut(DVec3)) {
    // Powers of 1/g with g^3 = g + 1: the plane's sequence of lowest known discrepancy of its kind.
    const STEP: DVec2 = DVec2::new(0.754_877_666_246_692_7, 0.569_840_290_998_053_2);
    let (nearest, farthest) = receivers.range(DEPTH_ROW);
    let nearest = nearest.max(f64::MIN_POSITIVE);
    let farthest = if farthest.is_finite() { farthest } else { SAMPLED_HORIZON_METRES.max(1e3 * nearest) };
    let (left, right) = receivers.ratio_range(DVec4::X, DEPTH_ROW);
    let (bottom, top) = receivers.ratio_range(DVec4::Y, DEPTH_ROW);

    // Of the box around receivers that are no frustum they fill a part. Depths grow by a constant ratio.
    let is_whole = receivers.is_frustum();
    let count = if is_whole { count } else { TRIES * count };
    let ratio = libm::exp(libm::log(farthest / nearest) / f64::from(count));
    let mut depth = nearest * ratio.sqrt();
    let mut place = DVec2::splat(0.5);
    for _ in 0..count {
        let (x, y) = (left + (right - left) * place.x, bottom + (top - bottom) * place.y);
        let point = DVec3::new(x, y, -1.0) * depth;
        if is_whole || receivers.contains(point.extend(1.0)) {
            add(point);
        }
        depth *= ratio;
        place += STEP;
        place -= DVec2::new(whole(place.x), whole(place.y));
    }
}

/// The whole part of a small positive number.
fn whole(value: f64) -> f64 {
    f64::from(value as u32)
}
