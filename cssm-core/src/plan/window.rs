//! Windows: each facet's rows fitted to its own receivers, and what a texel would span at sample receivers.

use std::ops::Range;

use glam::{DVec2, DVec3, DVec4};
use smallvec::SmallVec;

use super::inner;
use crate::facet::FacetRows;
use crate::layout::{Gram, Spread, is_balanced};
use crate::polygon::{self, Outline};
use crate::receivers::Polytope;
use crate::remap::{Curve, Remap};
use crate::samples;
use crate::technique::{Draft, FacetDraft, Region, Situation, TileRequest};

/// Sample receivers of a view by which tiles are sized and drafts compared.
const SAMPLES: usize = 1024;
/// Sample receivers of a view where neither is done.
const ALONE: usize = 128;
/// Fewest samples of a facet; the rest come from its own polytope.
const FEWEST_SAMPLES: usize = 24;
/// Extent in x/w or y/w, relative to its size, below which a facet holds no receivers of any area.
const EMPTY_EXTENT: f64 = 1e-12;
/// Area in clip space, of 4, below which a facet's receivers lie on a line in the light's view.
const EMPTY_AREA: f64 = 1e-9;

/// A visible point of a facet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// The point, camera space.
    pub(super) point: DVec3,
    /// What the facet's whole clip space spans there.
    pub(super) gram: Gram,
}

/// A facet whose receivers fill its clip space from -1 to 1 across and up; its depth row is not found yet.
#[derive(Debug)]
pub(super) struct Window<'a> {
    pub(super) draft: &'a FacetDraft,
    /// x, y and w rows; z is the w row until depth is found.
    pub(super) rows: FacetRows,
    /// The receivers in x/w and y/w.
    pub(super) outline: Outline,
    /// Its samples in the list of all.
    samples: Range<usize>,
    /// How many of its samples, the first ones, are samples of the view.
    pub(super) seen: usize,
    /// Footprint that its texels are to have, in those of the other windows.
    coarser: f64,
    /// Pixels that each sample of the view stands for, in those of the other windows.
    pub(super) weight: f64,
}

/// The windows of a draft.
#[derive(Debug)]
pub(super) struct Windows<'a> {
    pub(super) list: Vec<Window<'a>>,
    samples: Vec<Sample>,
    /// Samples of the view that have no facet.
    pub(super) outside: usize,
}

impl Windows<'_> {
    /// Samples of a window.
    pub(super) fn samples(&self, window: &Window<'_>) -> &[Sample] {
        &self.samples[window.samples.clone()]
    }

    /// Turns a window's clip space by a quarter: y runs along x.
    pub(super) fn turn(&mut self, index: usize) {
        let window = &mut self.list[index];
        (window.rows.x, window.rows.y) = (window.rows.y, -window.rows.x);
        for corner in &mut window.outline {
            *corner = DVec2::new(corner.y, -corner.x);
        }
        for sample in &mut self.samples[window.samples.clone()] {
            sample.gram = sample.gram.turned();
        }
    }

    /// Scales a window's clip space and then shifts it.
    pub(super) fn moved(&mut self, index: usize, scale: DVec2, shift: DVec2) {
        let window = &mut self.list[index];
        let rows = &mut window.rows;
        (rows.x, rows.y) = (rows.x * scale.x + rows.w * shift.x, rows.y * scale.y + rows.w * shift.y);
        for corner in &mut window.outline {
            *corner = *corner * scale + shift;
        }
        for Sample { gram, .. } in &mut self.samples[window.samples.clone()] {
            gram.xx /= scale.x * scale.x;
            gram.yy /= scale.y * scale.y;
            gram.xy /= scale.x * scale.y;
        }
    }

    /// Gives more texels to windows with more pixels.
    fn share(&mut self, draft: &Draft, situation: &Situation<'_>, counts: &[usize]) {
        let texels = |sample: &Sample| (sample.gram.xx * sample.gram.yy).sqrt();
        let mean = |window: &Window<'_>| {
            let samples = self.samples(window);
            samples.iter().map(texels).sum::<f64>() / samples.len().max(1) as f64
        };
        let own = |window: &Window<'_>| {
            let mut facets = draft.facets.iter().zip(counts);
            facets.find(|(facet, _)| std::ptr::eq(*facet, window.draft)).map_or(0, |(_, count)| *count)
        };
        let wanted: Vec<f64> = self.list.iter().map(mean).collect();
        let points: Vec<usize> = self.list.iter().map(own).collect();
        let coarser = situation.sighted.coarser(&wanted, &points);
        for ((window, coarser), points) in self.list.iter_mut().zip(coarser).zip(points) {
            window.coarser = coarser;
            window.weight = points as f64 / window.seen.max(1) as f64;
        }
    }

    /// What the tile of some windows must span, who share it. `grams` is scratch.
    pub(super) fn spread(&self, windows: &[usize], grams: &mut Vec<Gram>) -> Spread {
        grams.clear();
        let mut may_turn = true;
        for index in windows {
            let window = &self.list[*index];
            may_turn &= window.may_turn();
            let samples = self.samples(window).iter();
            match request(window.draft) {
                TileRequest::Coarser { times, focus_metres } => {
                    let grown = |depth: f64| window.coarser * times * (depth / focus_metres).max(1.0);
                    grams.extend(samples.map(|sample| sample.gram.shortened(grown(-sample.point.z))));
                }
                _ if window.coarser != 1.0 => {
                    grams.extend(samples.map(|sample| sample.gram.shortened(window.coarser)));
                }
                _ => grams.extend(samples.map(|sample| sample.gram)),
            }
        }
        Spread::of(grams, may_turn)
    }
}

impl Window<'_> {
    /// Whether its tile may be turned: triangles of one square keep their places beside each other; bends belong to y.
    pub(super) fn may_turn(&self) -> bool {
        matches!(self.draft.region, Region::Tile(_)) && self.rows.remap.is_none()
    }
}

/// Visible points of a situation, camera space, by which drafts are judged: few where nothing depends on them but figures
/// of single facets.
pub(super) fn samples(situation: &Situation<'_>, drafts: &[Draft]) -> Vec<DVec3> {
    let count = match drafts {
        [draft] if draft.facets.len() == 1 || !draft.facets.iter().any(is_sized) => ALONE,
        _ => SAMPLES,
    };
    let everywhere = || samples::receivers(situation.view, &situation.receivers, count);
    situation.sighted.samples().map_or_else(everywhere, <[DVec3]>::to_vec)
}

/// Whether the facet's tile has a size that samples decide; a square is alone in the map.
fn is_sized(facet: &FacetDraft) -> bool {
    !matches!(facet.region, Region::Triangle { .. }) && is_balanced(request(facet))
}

/// What the technique asked for.
pub(super) fn request(facet: &FacetDraft) -> TileRequest {
    match facet.region {
        Region::Tile(request) | Region::Whole(request) | Region::Triangle { request, .. } => request,
    }
}

/// Fits the window of every facet that has receivers.
pub(super) fn fit<'a>(draft: &'a Draft, situation: &Situation<'_>, samples: &[DVec3]) -> Windows<'a> {
    // Walk each sample to its facet.
    let owners = draft.owners();
    let facets = draft.facets.len();
    let mut counts: SmallVec<[usize; 40]> = SmallVec::from_elem(0, facets + 1);
    let mut owner_of: Vec<u32> = Vec::with_capacity(samples.len());
    for point in samples {
        let owner = owners.get(draft.selection.cell(point.extend(1.0)) as usize).copied().flatten();
        let owner = owner.unwrap_or(facets);
        counts[owner] += 1;
        owner_of.push(owner as u32);
    }
    let mut outside = counts[facets];

    // Sort them by facet.
    let mut next: SmallVec<[usize; 40]> = SmallVec::new();
    let mut start = 0;
    for count in &counts {
        next.push(start);
        start += count;
    }
    let mut sorted = vec![DVec3::ZERO; samples.len()];
    for (point, owner) in samples.iter().zip(&owner_of) {
        let place = &mut next[*owner as usize];
        sorted[*place] = *point;
        *place += 1;
    }

    // Fit the rows of each facet to its receivers.
    let mut list = Vec::with_capacity(facets);
    let mut all = Vec::with_capacity(samples.len() + facets * FEWEST_SAMPLES / 2);
    for (index, facet) in draft.facets.iter().enumerate() {
        let own = &sorted[next[index] - counts[index]..next[index]];
        let Some((rows, outline)) = rows(facet) else {
            outside += own.len();
            continue;
        };
        let cuts = own_cuts(&facet.receivers, &situation.receivers);
        let start = all.len();
        let mut add = |point: DVec3| {
            if let Some(gram) = gram(&rows, situation, point) {
                all.push(Sample { point, gram });
            }
        };
        for point in own {
            let homogeneous = point.extend(1.0);
            outside += usize::from(cuts.iter().any(|cut| cut.dot(homogeneous) < 0.0));
            add(*point);
        }
        if own.len() < FEWEST_SAMPLES {
            inner::points(facet, FEWEST_SAMPLES - own.len(), &mut add);
        }
        let seen = own.len().min(all.len() - start);
        let samples = start..all.len();
        list.push(Window { draft: facet, rows, outline, samples, seen, coarser: 1.0, weight: 1.0 });
    }
    let mut windows = Windows { list, samples: all, outside };
    if let Some(counts) = situation.sighted.counts(draft) {
        windows.share(draft, situation, &counts);
    }
    windows
}

/// The planes of a facet's receivers that all receivers do not have.
fn own_cuts<'a>(receivers: &'a Polytope, all: &Polytope) -> &'a [DVec4] {
    match receivers.planes.get(..all.planes.len()) {
        Some(shared) if *shared == all.planes[..] => &receivers.planes[all.planes.len()..],
        _ => &receivers.planes,
    }
}

/// The rows of a facet fitted to its receivers, if there are any, and their outline.
fn rows(facet: &FacetDraft) -> Option<(FacetRows, Outline)> {
    if facet.receivers.is_empty() {
        return None;
    }
    let whole = whole(facet)?;
    let outline = polygon::small_outline(&whole, &facet.receivers.vertices);
    let bent = outline.iter().map(|corner| DVec2::new(corner.x, whole.remap.y(corner.y)));
    let bent: Outline = if whole.remap.is_none() { outline.clone() } else { bent.collect() };
    if polygon::area(&bent).abs() <= EMPTY_AREA {
        return None;
    }
    Some(match facet.region {
        Region::Tile(_) => (whole, outline),
        Region::Whole(_) | Region::Triangle { .. } => {
            let rows = FacetRows { x: facet.x, y: facet.y, z: facet.w, w: facet.w, remap: Remap::NONE };
            let outline = polygon::small_outline(&rows, &facet.receivers.vertices);
            (rows, outline)
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

/// Products of the pixel vectors that span the whole clip space at a point: displacements across the light that change
/// x/w alone and y/w alone, which are reciprocal to the gradients of both.
fn gram(rows: &FacetRows, situation: &Situation<'_>, point: DVec3) -> Option<Gram> {
    let homogeneous = point.extend(1.0);
    let per_w = 1.0 / rows.w.dot(homogeneous);
    let (x, y) = (rows.x.dot(homogeneous) * per_w, rows.y.dot(homogeneous) * per_w);
    let w = rows.w.truncate();
    let gradient_x = (rows.x.truncate() - w * x) * per_w;
    let slope = if rows.remap.is_none() { 1.0 } else { rows.remap.slope(y) };
    let gradient_y = (rows.y.truncate() - w * y) * (per_w * slope);
    let area = gradient_x.cross(gradient_y).length_squared();
    let pixels = 2.0 * situation.view.pixels_per_tangent() / -point.z;
    let scale = pixels * pixels / area;
    let gram = Gram {
        xx: gradient_y.length_squared() * scale,
        yy: gradient_x.length_squared() * scale,
        xy: -gradient_x.dot(gradient_y) * scale,
    };
    (gram.xx.is_finite() && gram.yy.is_finite()).then_some(gram)
}
