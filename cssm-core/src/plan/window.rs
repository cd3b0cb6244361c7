//! Windows: each facet's rows fitted to its own receivers, and what a texel would span at sample receivers.

use glam::{DVec3, DVec4};

use crate::facet::FacetRows;
use crate::homography::Gradients;
use crate::layout::{Gram, TileDemand};
use crate::polygon;
use crate::receivers::DEPTH_ROW;
use crate::samples::{self, SAMPLED_HORIZON_METRES};
use crate::technique::{Draft, FacetDraft, Region, Situation};

/// Sample receivers of a view.
const SAMPLES: usize = 1024;
/// Fewest samples of a facet; the rest come from its own polytope.
const FEWEST_SAMPLES: usize = 24;
/// Deepest inner point of a facet that begins beyond the sampled horizon, in depths of its nearest receiver.
const FARTHEST_PER_NEAREST: f64 = 4.0;
/// Extent in x/w or y/w, relative to its size, below which a facet holds no receivers of any area.
const EMPTY_EXTENT: f64 = 1e-12;
/// Area in clip space, of 4, below which a facet's receivers lie on a line in the light's view.
const EMPTY_AREA: f64 = 1e-9;

/// A facet whose receivers fill its clip space from -1 to 1 across and up; its depth row is not found yet.
#[derive(Debug)]
pub(super) struct Window<'a> {
    pub(super) draft: &'a FacetDraft,
    /// x, y and w rows; z is the w row until depth is found.
    pub(super) rows: FacetRows,
    /// Visible points of the facet, camera space.
    pub(super) samples: Vec<DVec3>,
    /// What a texel spans at each sample that has an extent.
    pub(super) grams: Vec<Gram>,
    /// How many of `grams`, the first ones, come from samples of the view.
    pub(super) seen: usize,
}

impl Window<'_> {
    pub(super) fn demand(&self) -> TileDemand {
        let request = match self.draft.region {
            Region::Tile(request) | Region::Triangle { request, .. } => request,
        };
        TileDemand { request, samples: self.grams.clone() }
    }
}

/// Visible points of a situation, camera space, by which every draft is judged.
pub(super) fn samples(situation: &Situation<'_>) -> Vec<DVec3> {
    samples::receivers(situation.view, &situation.receivers, SAMPLES)
}

/// Fits the window of every facet that has receivers; also says how many samples of the view have no facet.
pub(super) fn fit<'a>(
    draft: &'a Draft,
    situation: &Situation<'_>,
    samples: &[DVec3],
) -> (Vec<Window<'a>>, usize) {
    // Walk each sample to its facet.
    let bands = draft.selection.bands;
    let index = |facet: &FacetDraft| (facet.sector * bands + facet.band) as usize;
    let count = draft.facets.iter().map(|facet| index(facet) + 1).max().unwrap_or(0);
    let mut by_facet = vec![Vec::new(); count];
    let mut outside = 0;
    for point in samples {
        match by_facet.get_mut(draft.selection.facet(point.extend(1.0)) as usize) {
            Some(list) => list.push(*point),
            None => outside += 1,
        }
    }

    // Fit the rows of each facet to its receivers.
    let mut windows = Vec::with_capacity(draft.facets.len());
    for facet in &draft.facets {
        let mut samples = std::mem::take(&mut by_facet[index(facet)]);
        let Some(rows) = rows(facet) else {
            outside += samples.len();
            continue;
        };
        let inside = |point: &DVec3| facet.receivers.contains(point.extend(1.0));
        outside += samples.iter().filter(|point| !inside(point)).count();
        let usable = |points: &[DVec3]| -> Vec<Gram> {
            points.iter().filter_map(|point| gram(&rows, situation, *point)).collect()
        };
        let mut grams = usable(&samples);
        let seen = grams.len();
        if samples.len() < FEWEST_SAMPLES {
            let added = inner_points(facet, FEWEST_SAMPLES - samples.len());
            grams.extend(usable(&added));
            samples.extend(added);
        }
        windows.push(Window { draft: facet, rows, samples, grams, seen });
    }
    (windows, outside)
}

/// The rows of a facet fitted to its receivers, if there are any.
fn rows(facet: &FacetDraft) -> Option<FacetRows> {
    if facet.receivers.is_empty() {
        return None;
    }
    let (x, y) = (fitted(facet.x, facet)?, fitted(facet.y, facet)?);
    let whole = FacetRows { x, y, z: facet.w, w: facet.w };
    let outline = polygon::outline(&whole, &facet.receivers.vertices);
    if polygon::area(&outline) <= EMPTY_AREA {
        return None;
    }
    Some(match facet.region {
        Region::Tile(_) => whole,
        Region::Triangle { .. } => FacetRows { x: facet.x, y: facet.y, z: facet.w, w: facet.w },
    })
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
