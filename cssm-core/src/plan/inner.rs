//! Sample receivers of a facet that holds few samples of the view.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use crate::receivers::{Body, DEPTH_ROW, Polytope};
use crate::samples::SAMPLED_HORIZON_METRES;

/// Deepest inner point of a facet that begins beyond the sampled horizon, in depths of its nearest receiver.
const FARTHEST_PER_NEAREST: f64 = 4.0;
/// Fractional part of the golden ratio.
const STEP: f64 = 0.618_033_988_749_894_9;

/// Points spread inside a facet's receivers as the view's samples are: evenly in the logarithm of depth, to the
/// sampled horizon, and over the cut at that depth.
pub(super) fn points(receivers: Body<'_>, count: usize, add: &mut impl FnMut(DVec3)) {
    let (nearest, farthest) = receivers.range(DEPTH_ROW);
    let horizon = SAMPLED_HORIZON_METRES.max(FARTHEST_PER_NEAREST * nearest);
    let cut = (farthest > horizon).then(|| receivers.cut_by(&[DVec4::W * horizon - DEPTH_ROW]));
    let near = cut.as_ref().map_or(receivers, Polytope::body);
    let depth = |vertex: &DVec4| DEPTH_ROW.dot(*vertex) / vertex.w;
    let farthest = near.vertices.iter().map(depth).fold(nearest, f64::max);
    let logarithm = libm::log(farthest / nearest);
    let (mut above, mut below) = (SmallVec::<[DVec4; 24]>::new(), SmallVec::<[DVec4; 24]>::new());
    for index in 0..count {
        let limit = nearest * libm::exp(logarithm * (index as f64 + 0.5) / count as f64);
        above.clear();
        below.clear();
        for vertex in near.vertices {
            if depth(vertex) <= limit { above.push(*vertex) } else { below.push(*vertex) }
        }

        // A triangle between points of the cut, each on a line between vertices on either side.
        let unit = |k: usize| {
            let place = (index * 37 + k * 11 + 1) as f64 * STEP;
            place - f64::from(place as u32)
        };
        let pick = |list: &[DVec4], k: usize| list.get((unit(k) * list.len() as f64) as usize).copied();
        let corner = |k: usize| {
            let (one, two) = (pick(&above, 2 * k)?, pick(&below, 2 * k + 1)?);
            let part = (limit - depth(&one)) / (depth(&two) - depth(&one));
            Some((one / one.w).lerp(two / two.w, part).truncate())
        };
        let (mut u, mut v) = (unit(6), unit(7));
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        if let (Some(a), Some(b), Some(c)) = (corner(0), corner(1), corner(2)) {
            let point = a + (b - a) * u + (c - a) * v;
            if point.is_finite() {
                add(point);
            }
        }
    }
}
