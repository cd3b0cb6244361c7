//! Whether facet boundaries show: edge displacement beside them against elsewhere, and against their surroundings, where
//! shadows are of the same kind: fine ones are displaced more than coarse ones in any map.

use serde::Serialize;

use super::displacement::surface_footprint;
use super::distance;
use super::edges::{Lattice, Marks};
use super::statistics::Percentiles;
use super::{PixelFootprint, Place, Verdict};

/// Edges at most this far from a facet boundary lie in its strip.
const STRIP_PIXELS: f64 = 2.0;

/// Edges outside the strip and at most this far from a boundary lie in its surroundings.
const NEARBY_PIXELS: f64 = 16.0;

/// Edge displacement beside facet boundaries and elsewhere, from true edges to the map's, in surface footprints.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Seam {
    /// True edge pixels in the strip.
    pub strip_edge_pixels: u64,
    /// True edge pixels elsewhere.
    pub elsewhere_edge_pixels: u64,
    /// True edge pixels in the strip's surroundings, which are a part of elsewhere.
    pub nearby_edge_pixels: u64,
    /// Mean displacement in the strip; 0 without edges.
    pub strip_mean: f64,
    /// Mean displacement elsewhere; 0 without edges.
    pub elsewhere_mean: f64,
    /// Mean displacement in the strip's surroundings; 0 without edges.
    pub nearby_mean: f64,
    /// Displacement in the strip.
    pub strip: Percentiles,
    /// Displacement elsewhere.
    pub elsewhere: Percentiles,
    /// Mean displacement in the strip over that elsewhere; absent where either has no edges or no displacement.
    pub mean_ratio: Option<f64>,
    /// p95 in the strip over p95 elsewhere; absent likewise.
    pub p95_ratio: Option<f64>,
    /// Light-facing interior pixels of the strip that are wrong.
    pub interior_wrong_pixels: u64,
    /// The same where facets meet on one surface.
    pub meeting: Meeting,
}

/// Edge displacement beside boundaries on which two facets meet on one surface: a seam can show there alone. Elsewhere
/// the boundary is the silhouette of one surface before another, and what lies beside it differs from its surroundings
/// in more than the facet: leaves, stems and railings are narrower than a filter's kernel.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Meeting {
    /// True edge pixels in the strip.
    pub strip_edge_pixels: u64,
    /// True edge pixels in the strip's surroundings.
    pub nearby_edge_pixels: u64,
    /// Mean displacement in the strip; 0 without edges.
    pub strip_mean: f64,
    /// Mean displacement in the strip's surroundings; 0 without edges.
    pub nearby_mean: f64,
}

impl Seam {
    /// Along all boundaries and those on one surface; `to_map` is the distance from each place to the map's edges. Absent when no boundary is visible.
    pub(super) fn along(
        (boundaries, meetings): (&Marks, &Marks),
        (true_edges, to_map): (&Marks, &[f64]),
        footprints: &[Option<PixelFootprint>],
        verdicts: &[Option<Verdict>],
        lattice: Lattice,
    ) -> Option<Self> {
        boundaries.places().next()?;
        let to_boundary = distance::transform(boundaries);
        let to_meeting = distance::transform(meetings);
        let (mut strip, mut elsewhere, mut nearby) = (Vec::new(), Vec::new(), Vec::new());
        let (mut meeting_strip, mut meeting_nearby) = (Vec::new(), Vec::new());
        for place in true_edges.places() {
            let Some(footprint) = surface_footprint(footprints, lattice, place) else {
                continue;
            };
            let displacement = to_map[place] / footprint;
            if to_boundary[place] <= STRIP_PIXELS {
                strip.push(displacement);
            } else {
                elsewhere.push(displacement);
                nearby.extend((to_boundary[place] <= NEARBY_PIXELS).then_some(displacement));
            }
            if to_meeting[place] <= STRIP_PIXELS {
                meeting_strip.push(displacement);
            } else {
                meeting_nearby.extend((to_meeting[place] <= NEARBY_PIXELS).then_some(displacement));
            }
        }
        let interior_wrong = verdicts.iter().enumerate().filter(|(index, verdict)| {
            verdict
                .is_some_and(|verdict| verdict.facing && verdict.wrong() && verdict.place == Place::Interior)
                && to_boundary[lattice.of_pixel(*index)] <= STRIP_PIXELS
        });
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len().max(1) as f64;
        let ratio = |one: f64, two: f64| Some(one / two).filter(|ratio| ratio.is_finite());
        let (strip_mean, elsewhere_mean) = (mean(&strip), mean(&elsewhere));
        let mean_ratio = ratio(strip_mean, elsewhere_mean).filter(|_| !strip.is_empty());
        let (strip_edge_pixels, elsewhere_edge_pixels) = (strip.len() as u64, elsewhere.len() as u64);
        let (strip, elsewhere) = (Percentiles::of(strip), Percentiles::of(elsewhere));
        Some(Self {
            strip_edge_pixels,
            elsewhere_edge_pixels,
            nearby_edge_pixels: nearby.len() as u64,
            strip_mean,
            elsewhere_mean,
            nearby_mean: mean(&nearby),
            strip,
            elsewhere,
            mean_ratio,
            p95_ratio: if strip_edge_pixels == 0 { None } else { ratio(strip.p95, elsewhere.p95) },
            interior_wrong_pixels: interior_wrong.count() as u64,
            meeting: Meeting {
                strip_edge_pixels: meeting_strip.len() as u64,
                nearby_edge_pixels: meeting_nearby.len() as u64,
                strip_mean: mean(&meeting_strip),
                nearby_mean: mean(&meeting_nearby),
            },
        })
    }
}
