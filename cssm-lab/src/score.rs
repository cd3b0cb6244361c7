//! Scores: how far a shadow map's verdicts are from the truth, in numbers that mean something.
//!
//! * **leak**: truth says shadowed, the map lit; **acne**: truth says lit, the map shadowed. Shares of all visible
//!   pixels that face the light ([`FACING_COSINE`]), each split by place: in the *edge band* around true shadow
//!   edges, where a map of finite size must err; in the *crease band* around depth or normal discontinuities,
//!   silhouettes, changes of facing and the image's border; *interior* otherwise. Interior errors are bugs.
//! * **grazing** pixels, which face away or almost so, are counted apart, and so are those that the light's range or
//!   cone leaves out; light-facing surfaces at 1 to 3 degrees ([`SHALLOW_COSINES`]) are judged once more by themselves.
//! * **edge displacement**, from the map's edges to the nearest true edge and back, in pixels and in local surface
//!   footprints.
//! * **seam**: edge displacement in a strip along facet boundaries against elsewhere.
//!
//! With filtering, lit means visibility of at least [`LIT_VISIBILITY`]. Distances are measured between places on a
//! lattice of half pixels, because an edge lies between two pixels.

mod bands;
mod displacement;
mod distance;
mod edges;
pub mod footprints;
mod seam;
pub mod statistics;
mod true_edges;

pub use bands::{Place, Split};
pub use displacement::{Displacement, Distances};
pub use edges::FineEdges;
pub use footprints::PixelFootprint;
pub use seam::{Meeting, Seam};
pub use true_edges::TrueEdges;

use serde::Serialize;

pub use crate::truth::FACING_COSINE;
use crate::truth::{Frame, Visible};
use edges::Marks;
use true_edges::faces_shallowly;

/// Cosines of surfaces that rise 1 to 3 degrees out of the light's direction.
pub const SHALLOW_COSINES: std::ops::Range<f64> = 0.017_452_406..0.052_335_956;

/// Filtered visibility from which a pixel counts as lit.
pub const LIT_VISIBILITY: f32 = 0.5;

/// What is judged: a traced frame and, pixel by pixel, what the map says about it.
#[derive(Debug, Clone, Copy)]
pub struct Judged<'a> {
    /// The truth.
    pub frame: &'a Frame,
    /// Visibility that the map gives each pixel.
    pub visibility: &'a [f32],
    /// Footprints of the map at each pixel; `None` for sky and where the plan has no facet.
    pub footprints: &'a [Option<PixelFootprint>],
    /// Facet of each pixel; [`NO_FACET`] for sky.
    pub facets: &'a [u32],
    /// The frame's true edges.
    pub true_edges: &'a TrueEdges,
}

/// Facet index of pixels without one.
pub const NO_FACET: u32 = u32::MAX;

/// The verdict on one frame.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Score {
    /// Pixels that see a surface.
    pub visible_pixels: u64,
    /// Visible pixels that face the light; the shares below are shares of these.
    pub facing_pixels: u64,
    /// Visible pixels that do not, although the light reaches them.
    pub grazing_pixels: u64,
    /// Visible pixels that the light's range or cone leaves out.
    pub unreached_pixels: u64,
    /// Light-facing pixels in true shadow, as a share.
    pub shadowed: f64,
    /// Places on true shadow edges.
    pub true_edge_pixels: u64,
    /// Light-facing pixels that are interior, as a share.
    pub interior_area: f64,
    /// Pixels that the map wrongly calls lit.
    pub leak: Split,
    /// Pixels that the map wrongly calls shadowed.
    pub acne: Split,
    /// Light-facing pixels that are wrong, as a share.
    pub mismatch: f64,
    /// Light-facing interior pixels that are wrong.
    pub interior_wrong_pixels: u64,
    /// Pixels that do not face the light.
    pub grazing: Aside,
    /// Pixels whose surfaces face the light at 1 to 3 degrees.
    pub shallow: Aside,
    /// Distances between true edges and the map's.
    pub edge_displacement: Displacement,
    /// The same with edges on surfaces that face the light at 1 to 3 degrees.
    pub wide_edge_displacement: Displacement,
    /// Facet boundaries against elsewhere; absent with one facet.
    pub seam: Option<Seam>,
}

/// Pixels that are judged apart.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Aside {
    /// How many there are.
    pub pixels: u64,
    /// Share of them that the map wrongly calls lit.
    pub leak: f64,
    /// Share of them that the map wrongly calls shadowed.
    pub acne: f64,
    /// Share of them that is wrong in the interior.
    pub interior: f64,
}

/// Scores a frame, and says of each pixel what was found there.
pub fn score(judged: &Judged<'_>) -> (Score, Vec<Option<Verdict>>) {
    let (frame, truth) = (judged.frame, judged.true_edges);
    let lattice = truth.lattice;

    // Mark where the map changes, also on surfaces that face the light at but a degree.
    let map_at = |index: usize| judged.visibility[index] >= LIT_VISIBILITY;
    let map_edges = Marks::edges(frame, lattice, Visible::faces_light, map_at);
    let wide_map_edges = Marks::edges(frame, lattice, faces_shallowly, map_at);
    let (bands, wide_bands) = (truth.bands(), truth.shallow_bands());

    // Judge every pixel.
    let mut tally = Tally::default();
    let verdicts: Vec<_> = (0..frame.pixels.len())
        .map(|index| {
            let pixel = frame.pixels[index].as_ref()?;
            let footprint = judged.footprints[index].map_or(0.0, |footprint| footprint.surface_pixels);
            let place = bands.place(lattice.of_pixel(index), footprint);
            let verdict = Verdict {
                place,
                truth_lit: pixel.lit,
                map_lit: judged.visibility[index] >= LIT_VISIBILITY,
                facing: pixel.faces_light(),
            };
            tally.count(&verdict, pixel);
            if pixel.reached && SHALLOW_COSINES.contains(&pixel.cosine) {
                let place = wide_bands.place(lattice.of_pixel(index), footprint);
                tally.shallow.count(&Verdict { place, ..verdict });
            }
            Some(verdict)
        })
        .collect();

    let to_map_edge = distance::transform(&map_edges);
    let displacement =
        Displacement::between((&map_edges, &to_map_edge), &truth.facing, &truth.to_crease, judged.footprints);
    let to_wide_map_edge = distance::transform(&wide_map_edges);
    let wide_displacement = Displacement::between(
        (&wide_map_edges, &to_wide_map_edge),
        &truth.shallow,
        &truth.to_crease,
        judged.footprints,
    );
    let displacements = (displacement, wide_displacement);
    let boundaries = Marks::boundaries(frame, lattice, judged.facets);
    let meetings = Marks::meetings(frame, lattice, judged.facets);
    let edges = (&truth.facing.edges, &to_map_edge[..]);
    let seam = Seam::along((&boundaries, &meetings), edges, judged.footprints, &verdicts, lattice);
    (tally.score(truth.facing.edges.count(), displacements, seam), verdicts)
}

fn truth_at(frame: &Frame, index: usize) -> bool {
    frame.pixels[index].as_ref().is_some_and(|pixel| pixel.lit)
}

/// What was found at one visible pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Verdict {
    /// Where it lies.
    pub place: Place,
    /// What the truth says.
    pub truth_lit: bool,
    /// What the map says.
    pub map_lit: bool,
    /// Whether it faces the light, and the light reaches it.
    pub facing: bool,
}

impl Verdict {
    /// Whether the map is wrong.
    pub const fn wrong(&self) -> bool {
        self.truth_lit != self.map_lit
    }
}

/// Counts that become a [`Score`].
#[derive(Default)]
struct Tally {
    visible: u64,
    unreached: u64,
    facing: u64,
    shadowed: u64,
    interior: u64,
    leak: [u64; 3],
    acne: [u64; 3],
    grazing: AsideTally,
    shallow: AsideTally,
}

#[derive(Default)]
struct AsideTally {
    pixels: u64,
    leak: u64,
    acne: u64,
    interior: u64,
}

impl AsideTally {
    fn count(&mut self, verdict: &Verdict) {
        self.pixels += 1;
        self.leak += u64::from(verdict.wrong() && verdict.map_lit);
        self.acne += u64::from(verdict.wrong() && verdict.truth_lit);
        self.interior += u64::from(verdict.wrong() && verdict.place == Place::Interior);
    }

    fn aside(&self) -> Aside {
        let share = |count| statistics::share(count, self.pixels);
        Aside {
            pixels: self.pixels,
            leak: share(self.leak),
            acne: share(self.acne),
            interior: share(self.interior),
        }
    }
}

impl Tally {
    fn count(&mut self, verdict: &Verdict, pixel: &Visible) {
        self.visible += 1;
        if !pixel.reached {
            self.unreached += 1;
            return;
        }
        if !verdict.facing {
            self.grazing.count(verdict);
            return;
        }
        self.facing += 1;
        self.shadowed += u64::from(!verdict.truth_lit);
        self.interior += u64::from(verdict.place == Place::Interior);
        if verdict.wrong() {
            let split = if verdict.map_lit { &mut self.leak } else { &mut self.acne };
            split[verdict.place as usize] += 1;
        }
    }

    fn score(
        &self,
        true_edges: usize,
        (edge_displacement, wide_edge_displacement): (Displacement, Displacement),
        seam: Option<Seam>,
    ) -> Score {
        let share = |count| statistics::share(count, self.facing);
        let (leak, acne) = (Split::of(&self.leak, self.facing), Split::of(&self.acne, self.facing));
        let interior = Place::Interior as usize;
        Score {
            visible_pixels: self.visible,
            facing_pixels: self.facing,
            grazing_pixels: self.visible - self.facing - self.unreached,
            unreached_pixels: self.unreached,
            shadowed: share(self.shadowed),
            true_edge_pixels: true_edges as u64,
            interior_area: share(self.interior),
            leak,
            acne,
            mismatch: share(self.leak.iter().chain(&self.acne).sum()),
            interior_wrong_pixels: self.leak[interior] + self.acne[interior],
            grazing: self.grazing.aside(),
            shallow: self.shallow.aside(),
            edge_displacement,
            wide_edge_displacement,
            seam,
        }
    }
}

#[cfg(test)]
mod tests;
