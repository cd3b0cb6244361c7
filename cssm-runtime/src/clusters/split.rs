//! Where a list of triangles is cut in two: across the axis and at the place that leave the two halves smallest.

use cssm_core::BoundingBox;
use cssm_core::glam::DVec3;

use super::CLUSTER_TRIANGLES;

/// Cuts are tried after multiples of this many triangles, so that no cluster gets much smaller.
const STEP_TRIANGLES: usize = CLUSTER_TRIANGLES / 4;

/// Reorders triangles, named by their numbers, and visits each cluster's range and box in the new order.
pub(super) fn ranges(boxes: &[BoundingBox], order: &mut [u32], visit: &mut impl FnMut(&[u32], BoundingBox)) {
    let mut sweep = Sweep { boxes, after: Vec::new(), tried: Vec::new() };
    let all = 0..order.len();
    let mut open = vec![all];
    while let Some(range) = open.pop() {
        let part = &mut order[range.clone()];
        if part.len() <= CLUSTER_TRIANGLES {
            if let Some(bounds) = around(part.iter().map(|triangle| boxes[*triangle as usize])) {
                visit(part, bounds);
            }
            continue;
        }
        // Take the left half next: the stack keeps neighbours side by side.
        let cut = range.start + sweep.cut(part);
        open.push(cut..range.end);
        open.push(range.start..cut);
    }
}

/// Tries cuts along every axis.
struct Sweep<'a> {
    boxes: &'a [BoundingBox],
    /// Size of the box around what follows each tried cut.
    after: Vec<f64>,
    /// Twice the triangles' centres along the axis being tried, in order, and the triangles.
    tried: Vec<(f64, u32)>,
}

impl Sweep<'_> {
    /// Orders more than [`STEP_TRIANGLES`] triangles along their best axis and returns where to cut: where the sum of both
    /// halves' triangles times the size of their boxes, the triangles that passing facets will draw, is smallest.
    fn cut(&mut self, part: &mut [u32]) -> usize {
        let mut best = (f64::INFINITY, part.len() / 2, 0);
        for axis in 0..3 {
            self.sort_along(axis, part);
            let (cost, cut) = self.cheapest_cut();
            if cost < best.0 {
                best = (cost, cut, axis);
            }
        }
        self.sort_along(best.2, part);
        part.iter_mut().zip(&self.tried).for_each(|(triangle, (_, tried))| *triangle = *tried);
        best.1
    }

    /// Fills `tried` in the order of the triangles' centres along an axis; equal ones keep the order given to the mesh.
    fn sort_along(&mut self, axis: usize, part: &[u32]) {
        let placed = |triangle: &u32| {
            let bounds = &self.boxes[*triangle as usize];
            (bounds.min[axis] + bounds.max[axis], *triangle)
        };
        self.tried.clear();
        self.tried.extend(part.iter().map(placed));
        self.tried.sort_unstable_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
    }

    /// Cost and place of the best cut of `tried`.
    fn cheapest_cut(&mut self) -> (f64, usize) {
        // From the end: what lies behind each cut.
        let count = self.tried.len();
        let cuts = (count - 1) / STEP_TRIANGLES;
        self.after.clear();
        let (mut end, mut bounds) = (count, None);
        for cut in (1..=cuts).rev().map(|cut| cut * STEP_TRIANGLES) {
            bounds = self.grown(bounds, cut..end);
            self.after.push(bounds.as_ref().map_or(0.0, size));
            end = cut;
        }

        // From the start: what lies before it.
        let (mut start, mut bounds) = (0, None);
        let mut best = (f64::INFINITY, count / 2);
        for (cut, after) in (1..=cuts).map(|cut| cut * STEP_TRIANGLES).zip(self.after.iter().rev()) {
            bounds = self.grown(bounds, start..cut);
            let before = bounds.as_ref().map_or(0.0, size);
            let cost = before * cut as f64 + after * (count - cut) as f64;
            if cost < best.0 {
                best = (cost, cut);
            }
            start = cut;
        }
        best
    }

    /// A box and the boxes of a range of `tried`.
    fn grown(&self, bounds: Option<BoundingBox>, range: std::ops::Range<usize>) -> Option<BoundingBox> {
        let more = self.tried[range].iter().map(|(_, triangle)| self.boxes[*triangle as usize]);
        around(bounds.into_iter().chain(more))
    }
}

/// The box around boxes.
fn around(boxes: impl Iterator<Item = BoundingBox>) -> Option<BoundingBox> {
    boxes.reduce(|one, other| BoundingBox { min: one.min.min(other.min), max: one.max.max(other.max) })
}

/// How likely a facet's border passes through a box, up to a factor: its mean width.
fn size(bounds: &BoundingBox) -> f64 {
    (bounds.max - bounds.min).dot(DVec3::ONE)
}
