//! Windows: each facet's rows fitted to its own receivers, and what a texel would span there.

use std::borrow::Cow;

use glam::{DVec2, DVec3, DVec4};
use smallvec::SmallVec;

use super::beams::{Beams, Seen};
use super::inner;
use super::texels::gram;
use crate::facet::FacetRows;
use crate::fit::Cut;
use crate::layout::{Gram, Spread, is_balanced};
use crate::polygon::{self, Outline};
use crate::receivers::{DEPTH_ROW, Polytope, is_negligible};
use crate::remap::{Curve, Remap};
use crate::samples::{self, COUNTED, Points, SAMPLED_HORIZON_METRES};
use crate::technique::{Draft, FacetDraft, Region, Situation, TileRequest};

/// Fewest known pixels of a facet that say what its texels span.
const FEWEST_PIXELS: usize = 24;
/// Fewest bands of a column of which none reaches far in depth.
const FEWEST_BANDS: u32 = 4;
/// Samples of the view by which a facet's depth is judged.
const MOST_JUDGED: usize = 32;
/// Fewest samples of the view that are enough for it.
const FEWEST_JUDGED: usize = 12;
/// Fewest receivers of a facet that say what its depths are.
const FEWEST_SAMPLES: usize = 4;
/// Part of the way from the middle of flat receivers to a vertex.
const INNER: f64 = 0.7;
/// Horizon of a facet that begins beyond the sampled one, in depths of its nearest receiver.
const FARTHEST_PER_NEAREST: f64 = 4.0;
/// Extent in x/w or y/w, relative to its size, below which a facet holds no receivers of any area.
const EMPTY_EXTENT: f64 = 1e-12;
/// Area in clip space, of 4, below which a facet's receivers lie on a line in the light's view.
const EMPTY_AREA: f64 = 1e-9;

/// A receiver of a facet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// The point, camera space.
    pub(super) point: DVec3,
    /// What the facet's whole clip space spans there.
    pub(super) gram: Gram,
}

/// Some receivers of a facet.
pub(super) type Samples = SmallVec<[Sample; MOST_JUDGED]>;

/// A facet whose receivers fill its clip space from -1 to 1 across and up; its depth row is not found yet.
#[derive(Debug)]
pub(super) struct Window<'a> {
    pub(super) draft: &'a FacetDraft,
    /// x, y and w rows; z is the w row until depth is found.
    pub(super) rows: FacetRows,
    /// The receivers in x/w and y/w.
    pub(super) outline: Outline,
    /// Rays through its receivers, where its tile is sized by them.
    beams: Option<Beams>,
    /// How many samples of the view lie in it.
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
    /// Window of each sample of the view; [`OUTSIDE`] where it has none.
    owners: SmallVec<[u32; 512]>,
    /// Whether tiles are sized by samples of the view.
    is_counted: bool,
}

/// Stands for the window of samples that have none.
const OUTSIDE: u32 = u32::MAX;

impl Windows<'_> {
    /// Turns a window's clip space by a quarter: y runs along x.
    pub(super) fn turn(&mut self, index: usize) {
        let window = &mut self.list[index];
        (window.rows.x, window.rows.y) = (window.rows.y, -window.rows.x);
        for corner in &mut window.outline {
            *corner = DVec2::new(corner.y, -corner.x);
        }
        window.beams = window.beams.map(Beams::turned);
    }

    /// Samples of the view, each with the window that it lies in.
    pub(super) fn owned<'b>(
        &'b self,
        samples: &'b [DVec3],
    ) -> impl Iterator<Item = (&'b DVec3, Option<usize>)> {
        let window = |owner: &u32| (*owner != OUTSIDE).then_some(*owner as usize);
        samples.iter().zip(self.owners.iter().map(window))
    }

    /// Scales a window's clip space and then shifts it.
    pub(super) fn moved(&mut self, index: usize, scale: DVec2, shift: DVec2) {
        let window = &mut self.list[index];
        let rows = &mut window.rows;
        (rows.x, rows.y) = (rows.x * scale.x + rows.w * shift.x, rows.y * scale.y + rows.w * shift.y);
        for corner in &mut window.outline {
            *corner = *corner * scale + shift;
        }
        // Rays are found anew when they are asked for.
        window.beams = None;
    }

    /// Gives more texels to windows with more pixels.
    fn share(&mut self, draft: &Draft, situation: &Situation<'_>, samples: &[DVec3], counts: &[usize]) {
        let own = |window: &Window<'_>| {
            let mut facets = draft.facets.iter().zip(counts);
            facets.find(|(facet, _)| std::ptr::eq(*facet, window.draft)).map_or(0, |(_, count)| *count)
        };
        let wanted = (0..self.list.len()).map(|index| self.mean_texels(index, situation, samples));
        let wanted: Vec<f64> = wanted.collect();
        let points: Vec<usize> = self.list.iter().map(own).collect();
        let coarser = situation.sighted.coarser(&wanted, &points);
        let seen: usize = self.list.iter().map(|window| window.seen).sum();
        let even = points.iter().sum::<usize>() as f64 / seen.max(1) as f64;
        let trust = situation.sighted.trust();
        for ((window, coarser), points) in self.list.iter_mut().zip(coarser).zip(points) {
            window.coarser = coarser;
            let weight = points as f64 / window.seen.max(1) as f64 / even.max(f64::MIN_POSITIVE);
            window.weight = (1.0 - trust) + trust * weight;
        }
    }

    /// Receivers of a window by which its depth is judged: those that sized it, or else samples of the view, which are many
    /// where receivers are near.
    pub(super) fn judged(&self, index: usize, situation: &Situation<'_>, samples: &[DVec3]) -> Samples {
        let window = &self.list[index];
        if window.beams.is_some() {
            return window.samples(situation);
        }
        let own = self.owned(samples).filter(|(_, owner)| *owner == Some(index));
        let own = own.step_by(window.seen.div_ceil(MOST_JUDGED).max(1));
        let sample =
            |point: &DVec3| gram(&window.rows, situation, *point).map(|gram| Sample { point: *point, gram });
        let mut judged: Samples = own.filter_map(|(point, _)| sample(point)).collect();
        if judged.len() < FEWEST_JUDGED {
            judged.extend(window.samples(situation));
        }
        judged
    }

    /// Samples of the view in a window; where they are few, others as well.
    fn known(&self, index: usize, situation: &Situation<'_>, samples: &[DVec3]) -> Vec<Sample> {
        let rows = &self.list[index].rows;
        let own = self.owned(samples).filter(|(_, owner)| *owner == Some(index));
        let sample = |point: &DVec3| gram(rows, situation, *point).map(|gram| Sample { point: *point, gram });
        let mut known: Vec<Sample> = own.filter_map(|(point, _)| sample(point)).collect();
        if known.len() < FEWEST_PIXELS {
            let missing = FEWEST_PIXELS - known.len();
            inner::points(self.list[index].draft, missing, &mut |point| known.extend(sample(&point)));
        }
        known
    }

    /// How many texels a window's clip space wants at a footprint of one pixel, in the mean.
    fn mean_texels(&self, index: usize, situation: &Situation<'_>, samples: &[DVec3]) -> f64 {
        if !self.is_counted {
            return self.list[index].beams(situation).mean_texels();
        }
        let known = self.known(index, situation, samples);
        let texels = |sample: &Sample| (sample.gram.xx * sample.gram.yy).sqrt();
        known.iter().map(texels).sum::<f64>() / known.len().max(1) as f64
    }

    /// What the tile of a window must span. `samples` are those of the view.
    pub(super) fn spread(&self, index: usize, situation: &Situation<'_>, samples: &[DVec3]) -> Spread {
        let window = &self.list[index];
        let (times, focus_metres) = match request(window.draft) {
            TileRequest::Coarser { times, focus_metres } => (window.coarser * times, focus_metres),
            _ => (window.coarser, f64::INFINITY),
        };

        if self.is_counted {
            let grown = |depth: f64| times * (depth / focus_metres).max(1.0);
            let known = self.known(index, situation, samples);
            let grams = known.iter().map(|sample| sample.gram.shortened(grown(-sample.point.z)));
            return Spread::of(&grams.collect::<Vec<_>>(), window.may_turn());
        }
        let per_square = 1.0 / (times * times);
        if focus_metres.is_infinite() {
            return Spread::of_beams(&window.beams(situation), window.may_turn(), |square, _| {
                square * per_square
            });
        }
        let focus_square = focus_metres * focus_metres;
        Spread::of_beams(&window.beams(situation), window.may_turn(), |square, unit| {
            square * per_square * (focus_square * square * unit * unit).min(1.0)
        })
    }
}

impl Window<'_> {
    /// Whether its tile may be turned: triangles of one square keep their places beside each other; bends belong to y.
    pub(super) fn may_turn(&self) -> bool {
        matches!(self.draft.region, Region::Tile(_)) && self.rows.remap.is_none()
    }

    /// Rays through its receivers.
    fn beams(&self, situation: &Situation<'_>) -> Cow<'_, Beams> {
        let made = || Cow::Owned(beams(&self.rows, &self.outline, self.draft, situation));
        self.beams.as_ref().map_or_else(made, Cow::Borrowed)
    }

    /// Receivers of it.
    fn samples(&self, situation: &Situation<'_>) -> Samples {
        let sample = |(point, gram)| Sample { point, gram };
        let mut samples: Samples = self.beams(situation).middles().map(sample).collect();
        if samples.len() < FEWEST_SAMPLES {
            // Flat receivers have no rays in them: take points between their middle and their vertices.
            let finite = self.draft.receivers.vertices.iter().filter(|vertex| vertex.w > 0.0);
            let count = finite.clone().count().max(1) as f64;
            let middle = finite.clone().map(|vertex| vertex.truncate() / vertex.w).sum::<DVec3>() / count;
            samples.extend(finite.filter_map(|vertex| {
                let point = middle.lerp(vertex.truncate() / vertex.w, INNER);
                gram(&self.rows, situation, point).map(|gram| Sample { point, gram })
            }));
        }
        samples
    }
}

/// Rays through what a facet holds of a view to its horizon.
fn beams(rows: &FacetRows, outline: &[DVec2], draft: &FacetDraft, situation: &Situation<'_>) -> Beams {
    let seen = |outline, receivers| Seen {
        rows,
        outline,
        receivers,
        light: situation.light,
        pixels_per_tangent: situation.view.pixels_per_tangent(),
    };
    let mut at_infinity = draft.receivers.vertices.iter().filter(|vertex| vertex.w == 0.0);
    if at_infinity.all(|vertex| is_negligible(rows.w.dot(*vertex), rows.w, *vertex)) {
        // It ends before, but for what lies along the light.
        return Beams::of(&seen(outline, &draft.receivers));
    }
    let (nearest, _) = draft.receivers.range(DEPTH_ROW);
    let horizon = SAMPLED_HORIZON_METRES.max(FARTHEST_PER_NEAREST * nearest);
    let receivers = draft.receivers.cut_by(&[DVec4::W * horizon - DEPTH_ROW]);
    let outline = polygon::small_outline(rows, &receivers.vertices);
    Beams::of(&seen(&outline, &receivers))
}

/// Visible points of a situation, camera space, by which drafts are judged, and how many were asked for.
pub(super) fn samples(situation: &Situation<'_>, drafts: &[Draft]) -> (Points, u32) {
    if let Some(seen) = situation.sighted.samples() {
        return (Points::from_slice(seen), COUNTED);
    }
    let is_sized = |draft: &Draft| draft.facets.len() > 1 && draft.facets.iter().any(is_sized);
    let is_counted = |draft: &Draft| is_counted(draft, situation) && is_sized(draft);
    let count = if situation.sighted.is_known() || drafts.iter().any(is_counted) {
        COUNTED
    } else {
        samples::count(drafts.len(), drafts.first().map_or(0, |draft| draft.facets.len()))
    };
    let mut points = Points::new();
    samples::sample(situation.view, &situation.receivers, count, &mut points);
    (points, count)
}

/// Whether a draft's tiles are sized by the view's own samples: where it is known exactly what is seen, and where facets reach
/// so far in depth that rays through them may miss what is near, or may be even over depth, as those of techniques that
/// never fit infinity.
fn is_counted(draft: &Draft, situation: &Situation<'_>) -> bool {
    situation.sighted.samples().is_some()
        || !situation.case.technique_spec().fits_infinity
        || draft.selection.bands < FEWEST_BANDS
}

/// Whether the facet's tile has a size that its receivers decide; a square is alone in the map.
fn is_sized(facet: &FacetDraft) -> bool {
    matches!(facet.region, Region::Tile(_)) && is_balanced(request(facet))
}

/// What the technique asked for.
pub(super) fn request(facet: &FacetDraft) -> TileRequest {
    match facet.region {
        Region::Tile(request) | Region::Whole(request) | Region::Triangle { request, .. } => request,
    }
}

/// Fits the window of every facet that has receivers.
pub(super) fn fit<'a>(draft: &'a Draft, situation: &Situation<'_>, samples: &[DVec3]) -> Windows<'a> {
    // Fit the rows of each facet to its receivers.
    let mut list: Vec<Window<'a>> = Vec::with_capacity(draft.facets.len());
    let mut window_of: SmallVec<[u32; 40]> = SmallVec::new();
    let is_shared = draft.facets.len() > 1;
    let is_counted = is_counted(draft, situation);
    let by_rays = is_shared && !is_counted;
    for facet in &draft.facets {
        let Some((rows, outline)) = rows(facet) else {
            window_of.push(OUTSIDE);
            continue;
        };
        let beams = (by_rays && is_sized(facet)).then(|| beams(&rows, &outline, facet, situation));
        window_of.push(list.len() as u32);
        list.push(Window { draft: facet, rows, outline, beams, seen: 0, coarser: 1.0, weight: 1.0 });
    }

    // Walk each sample to its window; it need not lie in it where facets do not hold everything.
    let owners = draft.owners();
    let is_loose = !draft.complete || !is_shared || *situation.sighted.cut() != Cut::None;
    let cuts: SmallVec<[&[DVec4]; 40]> = list
        .iter()
        .map(
            |window| {
                if is_loose { own_cuts(&window.draft.receivers, &situation.receivers) } else { &[][..] }
            },
        )
        .collect();
    let has_one_cell = owners.len() == 2 && draft.selection.dominant.is_none();
    let owner = |point: &DVec3| {
        let homogeneous = point.extend(1.0);
        let cell = if has_one_cell { 0 } else { draft.selection.cell(homogeneous) };
        let facet = owners.get(cell as usize).copied().flatten();
        let window = facet.map_or(OUTSIDE, |facet| window_of[facet]);
        let Some(cuts) = cuts.get(window as usize) else { return OUTSIDE };
        list[window as usize].seen += 1;
        if cuts.iter().any(|cut| cut.dot(homogeneous) < 0.0) { OUTSIDE } else { window }
    };
    let owners = samples.iter().map(owner).collect();
    let mut windows = Windows { list, owners, is_counted };
    if let Some(counts) = situation.sighted.counts(draft) {
        windows.share(draft, situation, samples, &counts);
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
    let area = if whole.remap.is_none() {
        polygon::area(&outline)
    } else {
        let bent = outline.iter().map(|corner| DVec2::new(corner.x, whole.remap.y(corner.y)));
        polygon::area(&bent.collect::<Outline>())
    };
    if area.abs() <= EMPTY_AREA {
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
