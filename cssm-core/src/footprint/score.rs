//! Footprint figures of a whole plan over the visible volume.

use glam::{DVec3, DVec4};

use super::{beam_utilisation, quantile, volume};
use crate::facet::Facet;
use crate::plan::ShadowPlan;
use crate::receivers::Polytope;
use crate::samples;
use crate::view::View;

/// Figures over sample receivers: uniform over the frustum's cross-section, log-uniform in depth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VolumeScore {
    /// Median volume footprint, pixels.
    pub median_pixels: f64,
    /// 95th percentile.
    pub p95_pixels: f64,
    /// 99th percentile.
    pub p99_pixels: f64,
    /// Largest.
    pub max_pixels: f64,
    /// 95th percentile of the geometric footprint.
    pub geometric_p95_pixels: f64,
    /// Share of map texels whose beam meets the visible volume.
    pub beam_utilisation: f64,
    /// Samples without a facet, or outside their facet's window.
    pub unassigned: usize,
    /// Samples inside the select half-spaces of more than one facet.
    pub multiply_assigned: usize,
}

/// Relative distance from a border within which a point may belong to either side.
const BORDER: f64 = 1e-12;

/// Scores a plan at about `samples` points of the view, up to `far_metres` (finite).
pub fn score_volume(plan: &ShadowPlan, view: &View, far_metres: f64, samples: usize) -> VolumeScore {
    let frustum = Polytope::frustum(view, far_metres);
    let world_from_camera = view.camera_from_world.transpose();
    let (mut major, mut geometric) = (Vec::with_capacity(samples), Vec::with_capacity(samples));
    let (mut unassigned, mut multiply_assigned) = (0, 0);
    for point in samples::receivers(view, &frustum, samples) {
        let point = world_from_camera * point;
        let accepting = plan.facets.iter().filter(|facet| accepts(facet, point)).count();
        multiply_assigned += usize::from(accepting > 1);
        let facet = plan.facet(plan.selection.cell(point.extend(1.0)));
        let Some(facet) = facet.filter(|facet| in_window(facet, point)) else {
            unassigned += 1;
            continue;
        };
        let footprint = volume(facet, view, point);
        major.push(footprint.major_pixels);
        geometric.push(footprint.geometric_pixels);
    }
    major.sort_by(f64::total_cmp);
    geometric.sort_by(f64::total_cmp);
    VolumeScore {
        median_pixels: quantile(&major, 0.5),
        p95_pixels: quantile(&major, 0.95),
        p99_pixels: quantile(&major, 0.99),
        max_pixels: quantile(&major, 1.0),
        geometric_p95_pixels: quantile(&geometric, 0.95),
        beam_utilisation: beam_utilisation(plan),
        unassigned,
        multiply_assigned,
    }
}

/// Whether a point lies inside all of a facet's select half-spaces, clear of their borders.
pub fn accepts(facet: &Facet, point_from_eye: DVec3) -> bool {
    let point = point_from_eye.extend(1.0);
    facet.select.iter().all(|plane| plane.dot(point) > BORDER * plane.abs().dot(point.abs()))
}

/// Whether a point lands inside its facet's tile without the gutter, up to rounding.
fn in_window(facet: &Facet, point_from_eye: DVec3) -> bool {
    let point = point_from_eye.extend(1.0);
    let w = facet.rows.w.dot(point);
    let inner = |side: u32| f64::from(side - 2 * facet.tile.gutter) / f64::from(side) + 1e-9;
    let x = facet.rows.x.dot(point) / w;
    let y = facet.rows.remap.y(facet.rows.y.dot(point) / w);
    let clipped = |clip: &DVec4| clip.dot(point) < 0.0;
    w > 0.0
        && !facet.clip.iter().any(clipped)
        && x.abs() <= inner(facet.tile.width)
        && y.abs() <= inner(facet.tile.height)
}
