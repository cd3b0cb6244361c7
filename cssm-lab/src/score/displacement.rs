//! How far the map's shadow edges lie from the true ones.

use serde::Serialize;

use super::PixelFootprint;
use super::edges::{Lattice, Marks};
use super::statistics::Percentiles;
use super::true_edges::EdgeSet;

/// Edge displacement in both directions.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Displacement {
    /// From each edge of the map to the nearest true edge.
    pub map_to_true: Distances,
    /// From each true edge to the nearest edge of the map.
    pub true_to_map: Distances,
    /// The same from true edges with no crease within a footprint, behind which the map's edge might lie unseen.
    pub open: Distances,
}

/// Distances from one set of edges to another.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Distances {
    /// Number of edge pixels they start from.
    pub count: u64,
    /// In screen pixels.
    pub pixels: Percentiles,
    /// In surface footprints at the start.
    pub footprints: Percentiles,
}

impl Displacement {
    pub(super) fn between(
        (map_edges, to_map): (&Marks, &[f64]),
        EdgeSet { edges: true_edges, distances: to_true }: &EdgeSet,
        to_crease: &[f64],
        footprints: &[Option<PixelFootprint>],
    ) -> Self {
        let lattice = map_edges.lattice;
        let is_open = |place: &usize| {
            surface_footprint(footprints, lattice, *place)
                .is_some_and(|footprint| to_crease[*place] > footprint)
        };
        Self {
            map_to_true: Distances::from(map_edges.places(), to_true, footprints, lattice),
            true_to_map: Distances::from(true_edges.places(), to_map, footprints, lattice),
            open: Distances::from(true_edges.places().filter(is_open), to_map, footprints, lattice),
        }
    }
}

impl Distances {
    fn from(
        edges: impl Iterator<Item = usize>,
        to_other: &[f64],
        footprints: &[Option<PixelFootprint>],
        lattice: Lattice,
    ) -> Self {
        let edges: Vec<usize> = edges.collect();
        let pixels: Vec<f64> = edges.iter().map(|place| to_other[*place]).collect();
        let relative = edges
            .iter()
            .copied()
            .filter_map(|place| Some(to_other[place] / surface_footprint(footprints, lattice, place)?))
            .collect();
        Self {
            count: pixels.len() as u64,
            pixels: Percentiles::of(pixels),
            footprints: Percentiles::of(relative),
        }
    }
}

/// Surface footprint in pixels at an edge: the mean of both sides. Below one pixel the screen, not the map, limits
/// what can be seen, so it counts as one.
pub(super) fn surface_footprint(
    footprints: &[Option<PixelFootprint>],
    lattice: Lattice,
    place: usize,
) -> Option<f64> {
    let (one, two) = lattice.pixels_beside(place);
    let mean = 0.5 * (footprints[one]?.surface_pixels + footprints[two]?.surface_pixels);
    Some(mean.max(1.0))
}
