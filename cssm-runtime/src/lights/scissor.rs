//! Which pixels of a view a light can reach.

use cssm_core::{ShadowPlan, View};

/// Share of its depth that a point must lie before the eye to have a place in the image.
const SMALLEST_DEPTH: f64 = 1e-6;

/// The rectangle of the image around all receivers of a plan's facets, x, y, width and height in pixels; `None` where
/// some lie beside or behind the eye. The plan is relative to the view's eye.
pub(super) fn scissor(plan: &ShadowPlan, view: &View) -> Option<[u32; 4]> {
    let size = [f64::from(view.size_pixels.0), f64::from(view.size_pixels.1)];
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for vertex in plan.facets.iter().flat_map(|facet| &facet.receivers) {
        let point = view.camera_from_world * vertex.truncate();
        let depth = -point.z;
        if depth.is_nan() || depth <= SMALLEST_DEPTH * point.length() {
            return None;
        }
        let across = (point.x / depth - view.left) / (view.right - view.left);
        let down = (view.top - point.y / depth) / (view.top - view.bottom);
        for (axis, place) in [across * size[0], down * size[1]].into_iter().enumerate() {
            low[axis] = low[axis].min(place);
            high[axis] = high[axis].max(place);
        }
    }

    // Round outwards by a pixel; what is empty stays empty.
    let [x, y] = [0, 1].map(|axis| (low[axis].floor() - 1.0).clamp(0.0, size[axis]));
    let [right, bottom] = [0, 1].map(|axis| (high[axis].ceil() + 1.0).clamp(0.0, size[axis]));
    let span = |from: f64, to: f64| (to - from).max(0.0) as u32;
    Some([x as u32, y as u32, span(x, right), span(y, bottom)])
}
