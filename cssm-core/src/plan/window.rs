//! Windows: each facet's rows fitted to its own receivers, and what a texel would span at sample receivers.

use glam::{DVec3, DVec4};

use crate::facet::FacetRows;
use crate::homography::Gradients;
use crate::layout::{Gram, TileDemand};
use crate::receivers::DEPTH_ROW;
use crate::samples::{self, SAMPLED_HORIZON_METRES};
use crate::technique::{Draft, FacetDraft, Situation};

/// Sample receivers of a view.
const SAMPLES: usize = 1024;
/// Fewest samples of a facet; the rest come from its own polytope.
const FEWEST_SAMPLES: usize = 24;
/// Deepest inner point of a facet that begins beyond the sampled horizon, in depths of its nearest receiver.
const FARTHEST_PER_NEAREST: f64 = 4.0;
/// Extent in x/w or y/w, relative to its size, below which a facet holds no receivers of any area.
const EMPTY_EXTENT: f64 = 1e-12;

/// A facet whose receivers fill its clip space from -1 to 1 across and up; its depth row is not found yet.
#[derive(Debug)]
pub(super) struct Window<'a> {
    pub(super) draft: &'a FacetDraft,
    /// x, y and w rows; z is the w row until depth is found.
    pub(super) rows: FacetRows,
    /// Visible points of the facet, camera space.
    pub(super) samples: Vec<DVec3>,
    grams: Vec<Gram>,
}

impl Window<'_> {
    pub(super) fn demand(&self) -> TileDemand {
        TileDemand { request: self.draft.tile, samples: self.grams.clone() }
    }
}

/// Fits the window of every facet that has receivers.
pub(super) fn fit<'a>(draft: &'a Draft, situation: &Situation<'_>) -> Vec<Window<'a>> {
    let count = draft.facets.iter().map(|facet| facet.index as usize + 1).max().unwrap_or(0);
    let mut by_facet = vec![Vec::new(); count];
    for point in samples::receivers(situation.view, &situation.receivers, SAMPLES) {
        if let Some(list) = by_facet.get_mut(draft.selection.facet(point.extend(1.0)) as usize) {
            list.push(point);
        }
    }
    let fit = |facet: &'a FacetDraft| {
        if facet.receivers.is_empty() {
            return None;
        }
        let x = fitted(facet.x, facet)?;
        let y = fitted(facet.y, facet)?;
        let rows = FacetRows { x, y, z: facet.w, w: facet.w };
        let mut samples = std::mem::take(&mut by_facet[facet.index as usize]);
        if samples.len() < FEWEST_SAMPLES {
            samples.extend(inner_points(facet, FEWEST_SAMPLES - samples.len()));
        }
        let grams = samples.iter().filter_map(|point| gram(&rows, situation, *point)).collect();
        Some(Window { draft: facet, rows, samples, grams })
    };
    draft.facets.iter().filter_map(fit).collect()
}

/// The row scaled and shifted so that its ratio to w runs from -1 to 1 over the facet's receivers.
fn fitted(row: DVec4, facet: &FacetDraft) -> Option<DVec4> {
    let (low, high) = facet.receivers.ratio_range(row, facet.w);
    let extent = high - low;
    let usable = extent.is_finite() && extent > EMPTY_EXTENT * low.abs().max(high.abs());
    usable.then(|| (row * 2.0 - facet.w * (high + low)) / extent)
}

/// Products of the pixel vectors that span the whole clip space at a point.
fn gram(rows: &FacetRows, situation: &Situation<'_>, point: DVec3) -> Option<Gram> {
    let (across, up) = Gradients::at(rows, point).across_light();
    let pixels = 2.0 * situation.view.pixels_per_tangent() / -point.z;
    let (across, up) = (across * pixels, up * pixels);
    let gram = Gram { xx: across.length_squared(), yy: up.length_squared(), xy: across.dot(up) };
    (gram.xx.is_finite() && gram.yy.is_finite()).then_some(gram)
}

/// Points spread inside a facet's receivers, to the sampled horizon: random positive weights on its vertices.
fn inner_points(facet: &FacetDraft, count: usize) -> Vec<DVec3> {
    const STEP: f64 = 0.618_033_988_749_894_9;
    let horizon = SAMPLED_HORIZON_METRES.max(FARTHEST_PER_NEAREST * facet.receivers.range(DEPTH_ROW).0);
    let near = facet.receivers.cut_by(&[DVec4::W * horizon - DEPTH_ROW]);
    let point = |index: usize| {
        let mut sum = DVec4::ZERO;
        for (k, vertex) in near.vertices.iter().enumerate() {
            let unit = ((index * 37 + k * 11 + 1) as f64 * STEP).fract();
            sum += *vertex * -libm::log(unit.max(1e-9));
        }
        sum.truncate() / sum.w
    };
    (0..count).map(point).filter(|point| point.is_finite()).collect()
}
