//! Windows: each facet's rows fitted to its own receivers, and what a texel would span at sample receivers.

use glam::{DVec3, DVec4};

use crate::facet::FacetRows;
use crate::homography::Gradients;
use crate::layout::{Gram, TileDemand};
use crate::polygon;
use crate::receivers::DEPTH_ROW;
use crate::remap::{Curve, Remap};
use crate::samples::{self, SAMPLED_HORIZON_METRES};
use crate::technique::{Draft, FacetDraft, Region, Situation, TileRequest};

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
    /// Depth of each of those samples, metres.
    depths: Vec<f64>,
    /// How many of `grams`, the first ones, come from samples of the view.
    pub(super) seen: usize,
}

impl Window<'_> {
    pub(super) fn demand(&self) -> TileDemand {
        let request = match self.draft.region {
            Region::Tile(request) | Region::Whole(request) | Region::Triangle { request, .. } => request,
        };
        // Triangles of one square keep their places beside each other; bends belong to y.
        let may_turn = matches!(self.draft.region, Region::Tile(_)) && self.rows.remap.is_none();
        let samples = match request {
            TileRequest::Coarser { times, focus_metres } => {
                let grams = self.grams.iter().zip(&self.depths);
                let grown = |depth: f64| times * (depth / focus_metres).max(1.0);
                grams.map(|(gram, depth)| gram.shortened(grown(*depth))).collect()
            }
            _ => self.grams.clone(),
        };
        TileDemand { request, samples, may_turn }
    }

    /// Turns the clip space by a quarter: y runs along x.
    pub(super) fn turn(&mut self) {
        (self.rows.x, self.rows.y) = (self.rows.y, -self.rows.x);
        for gram in &mut self.grams {
            *gram = gram.turned();
        }
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
    let owners = draft.owners();
    let mut by_facet = vec![Vec::new(); draft.facets.len()];
    let mut outside = 0;
    for point in samples {
        match owners.get(draft.selection.cell(point.extend(1.0)) as usize) {
            Some(Some(facet)) => by_facet[*facet].push(*point),
            _ => outside += 1,
        }
    }

    // Fit the rows of each facet to its receivers.
    let mut windows = Vec::with_capacity(draft.facets.len());
    for (facet, mut samples) in draft.facets.iter().zip(by_facet) {
        let Some(rows) = rows(facet) else {
            outside += samples.len();
            continue;
        };
        let inside = |point: &DVec3| facet.receivers.contains(point.extend(1.0));
        outside += samples.iter().filter(|point| !inside(point)).count();
        let usable = |points: &[DVec3]| -> (Vec<Gram>, Vec<f64>) {
            let one = |point: &DVec3| Some((gram(&rows, situation, *point)?, -point.z));
            points.iter().filter_map(one).unzip()
        };
        let (mut grams, mut depths) = usable(&samples);
        let seen = grams.len();
        if samples.len() < FEWEST_SAMPLES {
            let added = inner_points(facet, FEWEST_SAMPLES - samples.len());
            let more = usable(&added);
            grams.extend(more.0);
            depths.extend(more.1);
            samples.extend(added);
        }
        windows.push(Window { draft: facet, rows, samples, grams, depths, seen });
    }
    (windows, outside)
}

/// The rows of a facet fitted to its receivers, if there are any.
fn rows(facet: &FacetDraft) -> Option<FacetRows> {
    if facet.receivers.is_empty() {
        return None;
    }
    let whole = whole(facet)?;
    let outline = polygon::outline(&whole, &facet.receivers.vertices);
    if polygon::area(&polygon::image(&whole, &outline)) <= EMPTY_AREA {
        return None;
    }
    Some(match facet.region {
        Region::Tile(_) => whole,
        Region::Whole(_) | Region::Triangle { .. } => {
            FacetRows { x: facet.x, y: facet.y, z: facet.w, w: facet.w, remap: Remap::NONE }
        }
    })
}

/// The rows of a facet fitted to its receivers, where they have an extent.
fn whole(facet: &FacetDraft) -> Option<FacetRows> {
    let x = fitted(facet.x, facet)?;
    if facet.curve == Curve::Straight {
        let y = fitted(facet.y, facet)?;
        return Some(FacetRows { x, y, z: facet.w, w: facet.w, remap: Remap::NONE });
    }
    // Bent rows keep 1 / distance and fit what it goes through.
    let (low, high) = facet.receivers.ratio_range(facet.y, facet.w);
    let remap = Remap::fitted(facet.curve, low.max(0.0), high)?;
    Some(FacetRows { x, y: facet.y, z: facet.w, w: facet.w, remap })
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

/// Points spread inside a facet's receivers as the view's samples are: evenly in the logarithm of depth, to the
/// sampled horizon, and over the cut at that depth.
fn inner_points(facet: &FacetDraft, count: usize) -> Vec<DVec3> {
    const STEP: f64 = 0.618_033_988_749_894_9;
    let nearest = facet.receivers.range(DEPTH_ROW).0;
    let horizon = SAMPLED_HORIZON_METRES.max(FARTHEST_PER_NEAREST * nearest);
    let near = facet.receivers.cut_by(&[DVec4::W * horizon - DEPTH_ROW]);
    let depth = |vertex: &DVec4| DEPTH_ROW.dot(*vertex) / vertex.w;
    let farthest = near.vertices.iter().map(depth).fold(nearest, f64::max);
    let logarithm = libm::log(farthest / nearest);
    let point = |index: usize| {
        let limit = nearest * libm::exp(logarithm * (index as f64 + 0.5) / count as f64);
        let (above, below): (Vec<DVec4>, Vec<DVec4>) =
            near.vertices.iter().partition(|vertex| depth(vertex) <= limit);

        // A triangle between points of the cut, each on a line between vertices on either side.
        let unit = |k: usize| ((index * 37 + k * 11 + 1) as f64 * STEP).fract();
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
        let (a, b, c) = (corner(0)?, corner(1)?, corner(2)?);
        Some(a + (b - a) * u + (c - a) * v)
    };
    (0..count).filter_map(point).filter(|point| point.is_finite()).collect()
}
