//! Where a pixel lies: near a true edge, near a crease, or in the interior.

use serde::Serialize;

use super::statistics;

/// Bands reach at least this far.
const BAND_PIXELS: f64 = 3.0;

/// Bands reach at least this many local footprints.
const BAND_FOOTPRINTS: f64 = 2.0;

/// Where a pixel lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Near a true shadow edge.
    Edge,
    /// Near a discontinuity, but not near an edge.
    Crease,
    /// Everywhere else.
    Interior,
}

/// Wrong pixels by place, as shares of the light-facing pixels.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Split {
    /// All of them.
    pub total: f64,
    /// In the edge band.
    pub edge: f64,
    /// In the crease band.
    pub crease: f64,
    /// Elsewhere.
    pub interior: f64,
}

impl Split {
    /// Shares from counts in the order of [`Place`].
    pub(super) fn of(counts: &[u64; 3], total: u64) -> Self {
        let share = |count| statistics::share(count, total);
        Self {
            total: share(counts.iter().sum()),
            edge: share(counts[Place::Edge as usize]),
            crease: share(counts[Place::Crease as usize]),
            interior: share(counts[Place::Interior as usize]),
        }
    }
}

/// Distances that decide a pixel's place.
pub(super) struct Bands<'a> {
    to_edge: &'a [f64],
    to_crease: &'a [f64],
}

impl<'a> Bands<'a> {
    pub(super) const fn new(to_edge: &'a [f64], to_crease: &'a [f64]) -> Self {
        Self { to_edge, to_crease }
    }

    /// The place of a pixel, given its place on the lattice and its surface footprint in pixels.
    pub(super) fn place(&self, lattice_place: usize, footprint_pixels: f64) -> Place {
        let reach = BAND_PIXELS.max(BAND_FOOTPRINTS * footprint_pixels);
        if self.to_edge[lattice_place] <= reach {
            Place::Edge
        } else if self.to_crease[lattice_place] <= reach {
            Place::Crease
        } else {
            Place::Interior
        }
    }
}
