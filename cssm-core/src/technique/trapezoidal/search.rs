//! The focus line with which the focus region covers most of the map: searched row by row, or looked up in a table over
//! the angle between light and view axis (trapezoidal shadow maps, sections 6.2 and 6.3).

use glam::DVec4;

use super::{FocusRule, Focused};
use crate::facet::FacetRows;
use crate::polygon;
use crate::receivers::{Polytope, extremes};
use crate::remap::Remap;
use crate::technique::Situation;
use crate::technique::warp::{LightPlane, Warped};

/// Rows of which one is tried at first; its neighbours follow.
const COARSE_STEPS: u32 = 32;

/// The share of the map's rows before the focus line, searched downwards from the rule's share, that gives the focus region
/// most of the map.
pub(super) fn largest_region(
    plane: &LightPlane,
    receivers: &Polytope,
    region: &Polytope,
    rule: &FocusRule,
    rows: u32,
) -> f64 {
    let outline = outline(plane, receivers);
    let focus = self::outline(plane, region);
    let covered = |share: f64| region_area(plane, (receivers, &outline), &focus, rule.strength(share));

    // Below its own share the region's line is where a uniform map has it: nothing changes any more.
    let (low, high) = (rule.region.min(rule.share), rule.share);
    let best = |from: f64, to: f64, steps: u32| {
        let shares = (0..=steps).map(|step| to - (to - from) * f64::from(step) / f64::from(steps));
        let judged = shares.map(|share| (share, covered(share)));
        judged.reduce(|best, next| if next.1 > best.1 { next } else { best }).unwrap_or((to, 0.0)).0
    };
    let around = best(low, high, COARSE_STEPS);
    let coarse = (high - low) / f64::from(COARSE_STEPS);
    let fine = (2.0 * coarse * f64::from(rows)).ceil().clamp(1.0, f64::from(rows)) as u32;
    best((around - coarse).max(low), (around + coarse).min(high), fine)
}

/// Share of the map that a region covers under a warp of the receivers.
pub(super) fn region_area(
    plane: &LightPlane,
    (receivers, outline): (&Polytope, &[DVec4]),
    region: &[DVec4],
    strength: f64,
) -> f64 {
    let [x, y, w] = plane.rows(receivers, strength);
    let extent = |row: DVec4| extremes(outline.iter().map(|vertex| row.dot(*vertex) / w.dot(*vertex)));
    let ((left, right), (bottom, top)) = (extent(x), extent(y));
    let rows = FacetRows { x, y, z: w, w, remap: Remap::NONE };
    let area = polygon::area(&polygon::outline(&rows, region));
    area / ((right - left) * (top - bottom))
}

/// Vertices of some receivers that can touch their outline.
pub(super) fn outline(plane: &LightPlane, receivers: &Polytope) -> Vec<DVec4> {
    receivers.vertices.iter().copied().filter(|vertex| plane.unit.dot(*vertex) > 0.0).collect()
}

/// Best focus lines over the angle between light and view axis, for one view with the light in the plane of its up
/// vector: independent of the scene, so that one table serves every frame.
#[derive(Debug, Clone, PartialEq)]
pub struct FocusTable {
    /// Share of the map's rows before the focus line, at equal steps of the angle from 0 to a right angle.
    shares: Vec<f64>,
}

impl FocusTable {
    /// A table of `steps` + 1 angles from 0 to a right angle. `situation` gives, for an angle in radians, the view with
    /// its light.
    pub fn build<'a>(steps: u32, mut situation: impl FnMut(f64) -> Situation<'a>) -> Self {
        let share = |step: u32| {
            let angle = std::f64::consts::FRAC_PI_2 * f64::from(step) / f64::from(steps.max(1));
            let situation = situation(angle);
            let warped = Warped::of_view(&situation);
            Focused::of(&warped).best_share(&warped)
        };
        Self { shares: (0..=steps.max(1)).map(share).collect() }
    }

    /// The share for an angle in radians, between those of the table.
    pub fn share(&self, angle_radians: f64) -> f64 {
        let last = self.shares.len() - 1;
        let place = (angle_radians / std::f64::consts::FRAC_PI_2).clamp(0.0, 1.0) * last as f64;
        let below = (place as usize).min(last.saturating_sub(1));
        let part = place - below as f64;
        self.shares[below] + (self.shares[(below + 1).min(last)] - self.shares[below]) * part
    }
}
