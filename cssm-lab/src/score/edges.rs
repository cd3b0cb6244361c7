//! Where truth, map, surface and facets change, as marks on a lattice of half pixels.

use cssm_core::view::ViewError;
use cssm_core::{Light, View};

use crate::truth::{Frame, Tracer, Visible};

/// Neighbours whose normals differ by more than this lie on different surfaces (one degree).
const SAME_SURFACE_COSINE: f64 = 0.999_847_7;

/// Neighbours lie on one plane when neither leaves the other's by more than this share of their distance.
const SAME_PLANE_SHARE: f64 = 0.01;

/// Rounding of positions, relative to depth.
const POSITION_ROUNDING: f64 = 1e-9;

/// Supersampled truth has this many samples a pixel along each axis.
const FINE_SAMPLES: u32 = 4;

/// A lattice of half pixels: pixel (x, y) has its centre at (2 x + 1, 2 y + 1); between neighbours lies one place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Lattice {
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Lattice {
    pub(super) const fn of(frame: &Frame) -> Self {
        Self { width: 2 * frame.width + 1, height: 2 * frame.height + 1 }
    }

    /// Place of a pixel's centre.
    pub(super) const fn of_pixel(self, pixel: usize) -> usize {
        let width = self.width / 2;
        (2 * (pixel / width) + 1) * self.width + 2 * (pixel % width) + 1
    }

    /// The two pixels on both sides of a place between neighbours.
    pub(super) const fn pixels_beside(self, place: usize) -> (usize, usize) {
        let (x, y, width) = (place % self.width, place / self.width, self.width / 2);
        if x % 2 == 0 {
            let second = y / 2 * width + x / 2;
            (second - 1, second)
        } else {
            let second = y / 2 * width + x / 2;
            (second - width, second)
        }
    }
}

/// Marked places.
#[derive(Debug, Clone)]
pub(super) struct Marks {
    pub(super) lattice: Lattice,
    pub(super) marked: Vec<bool>,
}

impl Marks {
    /// Shadow edges: neighbours on one surface, both facing the light, one lit and one not.
    pub(super) fn edges(
        frame: &Frame,
        lattice: Lattice,
        faces_light: impl Fn(&Visible) -> bool,
        lit: impl Fn(usize) -> bool,
    ) -> Self {
        Self::between(frame, lattice, |one, two| {
            let faces = |index: usize| frame.pixels[index].as_ref().filter(|pixel| faces_light(pixel));
            let (Some(first), Some(second)) = (faces(one), faces(two)) else {
                return false;
            };
            lit(one) != lit(two) && same_surface(first, second)
        })
    }

    /// Discontinuities of depth or normal, silhouettes, changes of facing, and the image's border, behind which
    /// edges may hide.
    pub(super) fn creases(frame: &Frame, lattice: Lattice) -> Self {
        let mut marks =
            Self::between(frame, lattice, |one, two| match (&frame.pixels[one], &frame.pixels[two]) {
                (None, None) => false,
                (Some(first), Some(second)) => {
                    first.faces_light() != second.faces_light() || !same_surface(first, second)
                }
                _ => true,
            });
        for x in 0..lattice.width {
            marks.marked[x] = true;
            marks.marked[(lattice.height - 1) * lattice.width + x] = true;
        }
        for y in 0..lattice.height {
            marks.marked[y * lattice.width] = true;
            marks.marked[y * lattice.width + lattice.width - 1] = true;
        }
        marks
    }

    /// Boundaries between facets on visible surfaces, silhouettes before surfaces of other facets included.
    pub(super) fn boundaries(frame: &Frame, lattice: Lattice, facets: &[u32]) -> Self {
        Self::between(frame, lattice, |one, two| {
            frame.pixels[one].is_some() && frame.pixels[two].is_some() && facets[one] != facets[two]
        })
    }

    /// Boundaries on which two facets meet on one surface.
    pub(super) fn meetings(frame: &Frame, lattice: Lattice, facets: &[u32]) -> Self {
        Self::between(frame, lattice, |one, two| match (&frame.pixels[one], &frame.pixels[two]) {
            (Some(first), Some(second)) => facets[one] != facets[two] && same_surface(first, second),
            _ => false,
        })
    }

    /// Marks the places between neighbours for which `differ` holds.
    fn between(frame: &Frame, lattice: Lattice, differ: impl Fn(usize, usize) -> bool) -> Self {
        let mut marked = vec![false; lattice.width * lattice.height];
        for y in 0..frame.height {
            for x in 0..frame.width {
                let (pixel, place) = (y * frame.width + x, (2 * y + 1) * lattice.width + 2 * x + 1);
                if x + 1 < frame.width && differ(pixel, pixel + 1) {
                    marked[place + 1] = true;
                }
                if y + 1 < frame.height && differ(pixel, pixel + frame.width) {
                    marked[place + lattice.width] = true;
                }
            }
        }
        Self { lattice, marked }
    }

    /// The union of two sets of marks on one lattice.
    pub(super) fn with(&self, other: &Self) -> Self {
        let marked = self.marked.iter().zip(&other.marked).map(|(one, two)| *one || *two).collect();
        Self { lattice: self.lattice, marked }
    }

    /// Places of all marks.
    pub(super) fn places(&self) -> impl Iterator<Item = usize> {
        self.marked.iter().enumerate().filter_map(|(place, marked)| marked.then_some(place))
    }

    /// Number of marks.
    pub(super) fn count(&self) -> usize {
        self.places().count()
    }

    /// Marks of a frame with several samples a pixel, moved to the nearest places of a coarser lattice.
    fn coarsened(&self, lattice: Lattice, samples: usize) -> Self {
        let mut marked = vec![false; lattice.width * lattice.height];
        for place in self.places() {
            let (x, y) = (place % self.lattice.width, place / self.lattice.width);
            let nearest = |fine: usize| (fine + samples / 2) / samples;
            marked[nearest(y) * lattice.width + nearest(x)] = true;
        }
        Self { lattice, marked }
    }
}

/// True shadow edges and creases found with four times four samples a pixel.
#[derive(Debug, Clone)]
pub struct FineEdges {
    pub(super) edges: Marks,
    pub(super) creases: Marks,
}

impl FineEdges {
    /// Traces the view at four times its resolution. `progress` is called with the number of rows finished.
    ///
    /// # Errors
    /// When the finer image would have more pixels than a view can.
    pub fn trace(
        tracer: &Tracer,
        view: &View,
        light: &Light,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Self, ViewError> {
        let (width, height) = view.size_pixels;
        let scaled = |side: u32| side.checked_mul(FINE_SAMPLES).ok_or(ViewError::NoPixels);
        let fine_view = View { size_pixels: (scaled(width)?, scaled(height)?), ..*view };
        let fine = Frame::trace(tracer, &fine_view, light, progress);
        Ok(Self::of(&fine, FINE_SAMPLES as usize))
    }

    pub(super) fn of(fine: &Frame, samples: usize) -> Self {
        let lattice =
            Lattice { width: 2 * (fine.width / samples) + 1, height: 2 * (fine.height / samples) + 1 };
        let fine_lattice = Lattice::of(fine);
        let lit = |index: usize| fine.pixels[index].as_ref().is_some_and(|pixel| pixel.lit);
        Self {
            edges: Marks::edges(fine, fine_lattice, Visible::faces_light, lit).coarsened(lattice, samples),
            creases: Marks::creases(fine, fine_lattice).coarsened(lattice, samples),
        }
    }
}

/// Whether two neighbours see one smooth surface.
fn same_surface(one: &Visible, two: &Visible) -> bool {
    if one.triangle == two.triangle {
        return true;
    }
    let step = two.position - one.position;
    let leaves = one.normal.dot(step).abs().max(two.normal.dot(step).abs());
    one.normal.dot(two.normal) >= SAME_SURFACE_COSINE
        && leaves <= SAME_PLANE_SHARE * step.length() + POSITION_ROUNDING * one.depth.max(two.depth)
}
