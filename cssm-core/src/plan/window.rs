//! Windows: each facet's rows fitted to its own receivers, and what a texel would span there.

use glam::{DVec2, DVec3, DVec4};
use smallvec::SmallVec;

use super::beams::{Beams, Seen};
use super::fitting::Known;
use super::inner;
use super::rows;
use super::texels::gram;
use crate::facet::FacetRows;
use crate::fit::Cut;
use crate::layout::{Gram, Spread, is_balanced};
use crate::polygon;
use crate::receivers::{Body, DEPTH_ROW, is_negligible};
use crate::samples::{self, COUNTED, SAMPLED_HORIZON_METRES};
use crate::technique::{Draft, FacetDraft, NO_FACET, Region, Situation, TileRequest};

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
/// Corners that most outlines have no more of.
const USUAL_CORNERS: usize = 10;
/// Corners that an outline is found in.
const MOST_CORNERS: usize = 48;
/// Facets whose lists need no allocation.
const MOST_FACETS: usize = 136;

/// A receiver of a facet.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sample {
    /// The point, camera space.
    pub(super) point: DVec3,
    /// What the facet's whole clip space spans there.
    pub(super) gram: Gram,
}

/// Receivers of a facet by which its depth is judged.
pub(crate) type Judged = SmallVec<[Sample; MOST_JUDGED]>;
/// Visible points by which drafts are judged; most need no allocation.
pub(crate) type Visible = SmallVec<[DVec3; 128]>;

/// Corners of outlines.
pub(super) type Corners = SmallVec<[DVec2; 64]>;

/// A draft in its situation, with visible points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame<'a> {
    pub(super) draft: &'a Draft,
    pub(super) situation: &'a Situation<'a>,
    /// Visible points by which the draft is judged.
    pub(super) samples: &'a [DVec3],
}

/// A facet whose receivers fill its clip space from -1 to 1 across and up; its depth row is not found yet.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    /// Which facet of the draft it is.
    pub(super) facet: usize,
    /// x, y and w rows; z is the w row until depth is found.
    pub(super) rows: FacetRows,
    /// Where its outline begins and ends among the corners.
    corners: (u32, u32),
    /// Rays through its receivers, where its tile is sized by them.
    beams: Option<u32>,
    /// How many samples of the view lie in it.
    pub(super) seen: usize,
    /// Footprint that its texels are to have, in those of the other windows.
    coarser: f64,
    /// Pixels that each sample of the view stands for, in those of the other windows.
    pub(super) weight: f64,
}

/// The windows of a draft.
#[derive(Debug, Default)]
pub(super) struct Windows {
    pub(super) list: SmallVec<[Window; 4]>,
    /// The receivers of all windows in x/w and y/w.
    corners: Corners,
    /// Rays through the receivers of windows that are sized by them.
    beams: Vec<Beams>,
    /// Window of each sample of the view; [`NO_FACET`] where it has none.
    owners: SmallVec<[u32; 128]>,
    /// Whether tiles are sized by samples of the view.
    is_counted: bool,
}

impl<'a> Frame<'a> {
    /// The facet of a window.
    pub(super) fn facet(&self, window: &Window) -> &'a FacetDraft {
        &self.draft.facets[window.facet]
    }

    /// The receivers of a window.
    pub(super) fn receivers(&self, window: &Window) -> Body<'a> {
        self.draft.receivers(self.facet(window))
    }

    fn sample(&self, rows: &FacetRows, point: DVec3) -> Option<Sample> {
        gram(rows, self.situation, point).map(|gram| Sample { point, gram })
    }
}

impl Windows {
    /// Forgets all windows and makes room for so many.
    pub(super) fn begin(&mut self, most: usize) {
        self.list.clear();
        self.list.reserve(most);
        self.corners.clear();
        self.corners.reserve(USUAL_CORNERS * most + MOST_CORNERS);
        self.beams.clear();
        if most > self.list.inline_size() {
            self.beams.reserve(most);
        }
        self.owners.clear();
    }

    /// Makes room for so many samples of the view.
    pub(super) fn expect_samples(&mut self, count: usize) {
        self.owners.reserve(count);
    }

    /// Fits the window of every facet that has receivers.
    pub(super) fn fit(&mut self, frame: &Frame<'_>, known: &mut Known) {
        let Frame { draft, situation, samples } = *frame;
        // Fit the rows of each facet to its receivers.
        self.is_counted = is_counted(draft, situation);
        let is_shared = draft.facets.len() > 1;
        let by_rays = is_shared && !self.is_counted;
        let mut window_of: SmallVec<[u32; MOST_FACETS]> = SmallVec::new();
        for (index, facet) in draft.facets.iter().enumerate() {
            let receivers = draft.receivers(facet);
            let start = self.corners.len();
            let Some(rows) = rows::fitted(facet, receivers, &mut self.corners) else {
                window_of.push(NO_FACET);
                continue;
            };
            let has_beams = by_rays && is_sized(facet);
            if has_beams {
                self.beams.push(beams(&rows, &self.corners[start..], receivers, situation));
            }
            window_of.push(self.list.len() as u32);
            self.list.push(Window {
                facet: index,
                rows,
                corners: (start as u32, self.corners.len() as u32),
                beams: has_beams.then(|| self.beams.len() as u32 - 1),
                seen: 0,
                coarser: 1.0,
                weight: 1.0,
            });
        }

        // Walk each sample to its window; it need not lie in it where facets do not hold everything.
        self.owners.reserve(samples.len());
        let owners = draft.owners();
        let is_loose = !draft.complete || !is_shared || *situation.sighted.cut() != Cut::None;
        let mut cuts: SmallVec<[&[DVec4]; MOST_FACETS]> = SmallVec::new();
        if is_loose {
            let all = situation.receivers.body();
            cuts.extend(self.list.iter().map(|window| own_cuts(frame.receivers(window), all)));
        }
        let has_one_cell = owners.len() == 2 && draft.selection.dominant.is_none();
        let list = &mut self.list;
        let owner = |point: &DVec3| {
            let homogeneous = point.extend(1.0);
            let cell = if has_one_cell { 0 } else { draft.selection.cell(homogeneous) };
            let facet = owners.get(cell as usize).copied().unwrap_or(NO_FACET);
            let index = window_of.get(facet as usize).copied().unwrap_or(NO_FACET);
            let Some(window) = list.get_mut(index as usize) else { return NO_FACET };
            window.seen += 1;
            let cuts = cuts.get(index as usize).copied().unwrap_or(&[]);
            if cuts.iter().any(|cut| cut.dot(homogeneous) < 0.0) { NO_FACET } else { index }
        };
        self.owners.extend(samples.iter().map(owner));
        if let Some(counts) = situation.sighted.counts(draft) {
            self.share(frame, &counts, known);
        }
    }

    /// The receivers of a window in x/w and y/w.
    pub(super) fn outline(&self, index: usize) -> &[DVec2] {
        let (start, end) = self.list[index].corners;
        &self.corners[start as usize..end as usize]
    }

    fn outline_mut(&mut self, index: usize) -> &mut [DVec2] {
        let (start, end) = self.list[index].corners;
        &mut self.corners[start as usize..end as usize]
    }

    /// Turns a window's clip space by a quarter: y runs along x.
    pub(super) fn turn(&mut self, index: usize) {
        let rows = &mut self.list[index].rows;
        (rows.x, rows.y) = (rows.y, -rows.x);
        for corner in self.outline_mut(index) {
            *corner = DVec2::new(corner.y, -corner.x);
        }
        if let Some(beams) = self.list[index].beams {
            self.beams[beams as usize].turn();
        }
    }

    /// Samples of the view, each with the window that it lies in.
    pub(super) fn owned<'b>(
        &'b self,
        samples: &'b [DVec3],
    ) -> impl Iterator<Item = (&'b DVec3, Option<usize>)> {
        let window = |owner: &u32| (*owner != NO_FACET).then_some(*owner as usize);
        samples.iter().zip(self.owners.iter().map(window))
    }

    /// Scales a window's clip space and then shifts it.
    pub(super) fn moved(&mut self, index: usize, scale: DVec2, shift: DVec2) {
        let window = &mut self.list[index];
        let rows = &mut window.rows;
        (rows.x, rows.y) = (rows.x * scale.x + rows.w * shift.x, rows.y * scale.y + rows.w * shift.y);
        // Rays are found anew when they are asked for.
        window.beams = None;
        for corner in self.outline_mut(index) {
            *corner = *corner * scale + shift;
        }
    }

    /// Gives more texels to windows with more pixels.
    fn share(&mut self, frame: &Frame<'_>, counts: &[usize], known: &mut Known) {
        let sighted = &frame.situation.sighted;
        let wanted = (0..self.list.len()).map(|index| self.mean_texels(index, frame, known));
        let wanted: Vec<f64> = wanted.collect();
        let points: Vec<usize> = self.list.iter().map(|window| counts[window.facet]).collect();
        let coarser = sighted.coarser(&wanted, &points);
        let seen: usize = self.list.iter().map(|window| window.seen).sum();
        let even = points.iter().sum::<usize>() as f64 / seen.max(1) as f64;
        let trust = sighted.trust();
        for ((window, coarser), points) in self.list.iter_mut().zip(coarser).zip(points) {
            window.coarser = coarser;
            let weight = points as f64 / window.seen.max(1) as f64 / even.max(f64::MIN_POSITIVE);
            window.weight = (1.0 - trust) + trust * weight;
        }
    }

    /// Lists receivers of a window by which its depth is judged: those that sized it, or else samples of the view, which are
    /// many where receivers are near.
    pub(super) fn judged(&self, index: usize, frame: &Frame<'_>, judged: &mut Judged) {
        let window = &self.list[index];
        judged.clear();
        if window.beams.is_none() {
            let own = self.owned(frame.samples).filter(|(_, owner)| *owner == Some(index));
            let own = own.step_by(window.seen.div_ceil(MOST_JUDGED).max(1));
            judged.extend(own.filter_map(|(point, _)| frame.sample(&window.rows, *point)));
        }
        if judged.len() < FEWEST_JUDGED {
            self.add_middles(index, frame, judged);
        }
    }

    /// Adds receivers of a window in the middle of light rays.
    fn add_middles(&self, index: usize, frame: &Frame<'_>, samples: &mut Judged) {
        let before = samples.len();
        self.with_beams(index, frame, |beams| {
            samples.extend(beams.middles().map(|(point, gram)| Sample { point, gram }));
        });
        if samples.len() < before + FEWEST_SAMPLES {
            // Flat receivers have no rays in them: take points between their middle and their vertices.
            let window = &self.list[index];
            let receivers = frame.receivers(window);
            let finite = receivers.vertices.iter().filter(|vertex| vertex.w > 0.0);
            let count = finite.clone().count().max(1) as f64;
            let middle = finite.clone().map(|vertex| vertex.truncate() / vertex.w).sum::<DVec3>() / count;
            samples.extend(finite.filter_map(|vertex| {
                frame.sample(&window.rows, middle.lerp(vertex.truncate() / vertex.w, INNER))
            }));
        }
    }

    /// Looks at the rays through a window's receivers.
    fn with_beams<T>(&self, index: usize, frame: &Frame<'_>, look: impl FnOnce(&Beams) -> T) -> T {
        let window = &self.list[index];
        match window.beams {
            Some(beams) => look(&self.beams[beams as usize]),
            None => {
                let receivers = frame.receivers(window);
                look(&beams(&window.rows, self.outline(index), receivers, frame.situation))
            }
        }
    }

    /// Lists samples of the view in a window; where they are few, others as well.
    fn list_known(&self, index: usize, frame: &Frame<'_>, known: &mut Vec<Sample>) {
        let window = &self.list[index];
        known.clear();
        let own = self.owned(frame.samples).filter(|(_, owner)| *owner == Some(index));
        known.extend(own.filter_map(|(point, _)| frame.sample(&window.rows, *point)));
        if known.len() < FEWEST_PIXELS {
            let missing = FEWEST_PIXELS - known.len();
            let add = &mut |point| known.extend(frame.sample(&window.rows, point));
            inner::points(frame.receivers(window), missing, add);
        }
    }

    /// How many texels a window's clip space wants at a footprint of one pixel, in the mean.
    fn mean_texels(&self, index: usize, frame: &Frame<'_>, known: &mut Known) -> f64 {
        if !self.is_counted {
            return self.with_beams(index, frame, Beams::mean_texels);
        }
        self.list_known(index, frame, &mut known.samples);
        let texels = |sample: &Sample| (sample.gram.xx * sample.gram.yy).sqrt();
        known.samples.iter().map(texels).sum::<f64>() / known.samples.len().max(1) as f64
    }

    /// What the tile of a window must span.
    pub(super) fn spread(&self, index: usize, frame: &Frame<'_>, known: &mut Known) -> Spread {
        let window = &self.list[index];
        let (times, focus_metres) = match request(frame.facet(window)) {
            TileRequest::Coarser { times, focus_metres } => (window.coarser * times, focus_metres),
            _ => (window.coarser, f64::INFINITY),
        };
        let may_turn = window.may_turn(frame.draft);
        if self.is_counted {
            let grown = |depth: f64| times * (depth / focus_metres).max(1.0);
            self.list_known(index, frame, &mut known.samples);
            known.grams.clear();
            let shortened = |sample: &Sample| sample.gram.shortened(grown(-sample.point.z));
            known.grams.extend(known.samples.iter().map(shortened));
            return Spread::of(&known.grams, may_turn, &mut known.values);
        }
        let per_square = 1.0 / (times * times);
        if focus_metres.is_infinite() {
            return self.with_beams(index, frame, |beams| {
                Spread::of_beams(beams, may_turn, |square, _| square * per_square)
            });
        }
        let focus_square = focus_metres * focus_metres;
        self.with_beams(index, frame, |beams| {
            Spread::of_beams(beams, may_turn, |square, unit| {
                square * per_square * (focus_square * square * unit * unit).min(1.0)
            })
        })
    }
}

impl Window {
    /// Whether its tile may be turned: triangles of one square keep their places beside each other; bends belong to y.
    pub(super) fn may_turn(&self, draft: &Draft) -> bool {
        matches!(draft.facets[self.facet].region, Region::Tile(_)) && self.rows.remap.is_none()
    }
}

/// Rays through what a facet holds of a view to its horizon.
fn beams(rows: &FacetRows, outline: &[DVec2], whole: Body<'_>, situation: &Situation<'_>) -> Beams {
    let seen = |outline, receivers| Seen {
        rows,
        outline,
        receivers,
        light: situation.light,
        pixels_per_tangent: situation.view.pixels_per_tangent(),
    };
    let mut at_infinity = whole.vertices.iter().filter(|vertex| vertex.w == 0.0);
    if at_infinity.all(|vertex| is_negligible(rows.w.dot(*vertex), rows.w, *vertex)) {
        // It ends before, but for what lies along the light.
        return Beams::of(&seen(outline, whole));
    }
    let (nearest, _) = whole.range(DEPTH_ROW);
    let horizon = SAMPLED_HORIZON_METRES.max(FARTHEST_PER_NEAREST * nearest);
    let receivers = whole.cut_by(&[DVec4::W * horizon - DEPTH_ROW]);
    let outline = polygon::small_outline(rows, &receivers.vertices);
    Beams::of(&seen(&outline, receivers.body()))
}

/// Lists visible points of a situation, camera space, by which drafts are judged, and says how many were asked for.
pub(super) fn samples(situation: &Situation<'_>, drafts: &[Draft], points: &mut Visible) -> u32 {
    points.clear();
    if let Some(seen) = situation.sighted.samples() {
        points.extend_from_slice(seen);
        return COUNTED;
    }
    let is_sized = |draft: &Draft| draft.facets.len() > 1 && draft.facets.iter().any(is_sized);
    let is_counted = |draft: &Draft| is_counted(draft, situation) && is_sized(draft);
    let count = if situation.sighted.is_known() || drafts.iter().any(is_counted) {
        COUNTED
    } else {
        samples::count(drafts.len(), situation.light.w > 0.0)
    };
    points.reserve(count as usize);
    samples::sample(situation.view, &situation.receivers, count, &mut |point| points.push(point));
    count
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

/// The planes of a facet's receivers that all receivers do not have.
fn own_cuts<'a>(receivers: Body<'a>, all: Body<'_>) -> &'a [DVec4] {
    match receivers.planes.get(..all.planes.len()) {
        Some(shared) if shared == all.planes => &receivers.planes[all.planes.len()..],
        _ => receivers.planes,
    }
}
