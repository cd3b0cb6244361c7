//! Measuring one variant on all stations by ray-cast truth, no further than needed, and never twice.

use std::collections::BTreeMap;

use cssm_core::case::Casters;
use cssm_core::{LightCase, PlanError, SceneBounds, ShadowPlan, plan};
use rayon::prelude::*;

use super::budget::{Metric, Promise};
use super::cost::Cost;
use super::sites::{Path, Site, Sites, facing};
use super::space::key;
use crate::score::LIT_VISIBILITY;
use crate::score::footprints::Assignment;
use crate::score::statistics::{quantile, share};
use crate::twin;

/// Stations that are judged side by side before it is asked whether the rest is needed.
const STATIONS_AT_ONCE: usize = 4;

/// What a variant has on all stations.
#[derive(Debug, Clone, PartialEq)]
pub struct Errors {
    /// Largest error of a single view, in the metric's unit.
    pub error: f64,
    /// Each path.
    pub of_paths: Vec<PathError>,
    /// Largest mismatch of a single view.
    pub mismatch: f64,
    /// Mean cost of a frame.
    pub cost: Cost,
    /// Configurations that plans took, with the number of stations.
    pub configurations: Vec<(&'static str, usize)>,
}

/// Errors of a path.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PathError {
    /// All its views together, as `cssm-lab measure` reports it.
    pub together: f64,
    /// The worst of its views.
    pub worst: f64,
}

/// What measuring a variant found.
#[derive(Debug, Clone, PartialEq)]
pub enum Measured {
    /// All of it.
    Whole(Errors),
    /// The promise is broken already; the error is at least this.
    Broken {
        /// A lower bound of the error.
        at_least: f64,
    },
    /// It cannot be planned on every station.
    Unplannable {
        /// The first reason.
        reason: String,
    },
}

impl Measured {
    /// Whether a promise is kept.
    pub fn keeps(&self, promise: &Promise) -> bool {
        match self {
            Self::Whole(errors) => errors.error <= promise.limit && errors.mismatch <= promise.mismatch_limit,
            Self::Broken { .. } | Self::Unplannable { .. } => false,
        }
    }

    /// The error, as far as it is known.
    pub const fn error(&self) -> Option<f64> {
        match self {
            Self::Whole(errors) => Some(errors.error),
            Self::Broken { at_least } => Some(*at_least),
            Self::Unplannable { .. } => None,
        }
    }
}

/// Measures variants on sites.
pub struct Bench<'s, 'a> {
    /// Where.
    pub sites: &'s Sites<'a>,
    /// What.
    pub metric: Metric,
    known: BTreeMap<String, Measured>,
    /// Variants that were measured by ray-cast truth so far.
    pub measured: usize,
}

/// What one station adds to its path.
struct Found {
    path: usize,
    wrong_pixels: u64,
    /// Light-facing pixels, or as many as make a share mean something.
    pixels: u64,
    /// Sum over true edges of the 95th percentile of the displacement, and their number.
    edges: (f64, u64),
    footprints: Vec<f64>,
    cost: Cost,
    configuration: &'static str,
}

/// What the stations of a path have together.
#[derive(Default, Clone)]
struct Sum {
    wrong_pixels: u64,
    edges: (f64, u64),
    footprints: Vec<f64>,
}

impl Sum {
    fn add(&mut self, found: Found) {
        self.wrong_pixels += found.wrong_pixels;
        self.edges.0 += found.edges.0;
        self.edges.1 += found.edges.1;
        self.footprints.extend(found.footprints);
    }

    /// The error of the path, as `cssm-lab measure` reports it.
    fn error(mut self, metric: Metric, path: &Path) -> f64 {
        match metric {
            Metric::Mismatch => share(self.wrong_pixels, path.facing_pixels),
            Metric::EdgePx => self.edges.0 / self.edges.1.max(1) as f64,
            Metric::FootprintP95 => {
                self.footprints.sort_by(f64::total_cmp);
                quantile(&self.footprints, 0.95)
            }
        }
    }
}

impl Found {
    fn mismatch(&self) -> f64 {
        share(self.wrong_pixels, self.pixels)
    }

    /// The error of the view by itself.
    fn error(&mut self, metric: Metric) -> f64 {
        match metric {
            Metric::Mismatch => self.mismatch(),
            Metric::EdgePx => self.edges.0 / self.edges.1.max(1) as f64,
            Metric::FootprintP95 => {
                self.footprints.sort_by(f64::total_cmp);
                quantile(&self.footprints, 0.95)
            }
        }
    }
}

impl<'s, 'a> Bench<'s, 'a> {
    /// A bench that has measured nothing yet.
    pub const fn new(sites: &'s Sites<'a>, metric: Metric) -> Self {
        Self { sites, metric, known: BTreeMap::new(), measured: 0 }
    }

    /// Measures a variant, but stops as soon as a promise is broken if one is given.
    pub fn measure(&mut self, case: &LightCase, promise: Option<&Promise>) -> Measured {
        let key = key(case);
        if let Some(known) = self.known.get(&key) {
            // What broke one promise may keep another.
            let needs_more = match (known, promise) {
                (Measured::Broken { at_least }, Some(promise)) => *at_least <= promise.limit,
                (Measured::Broken { .. }, None) => true,
                _ => false,
            };
            if !needs_more {
                return known.clone();
            }
        }
        self.measured += 1;
        let measured = self.measure_anew(case, promise);
        self.known.insert(key, measured.clone());
        measured
    }

    fn measure_anew(&self, case: &LightCase, promise: Option<&Promise>) -> Measured {
        let paths = &self.sites.paths;
        let mut sums = vec![Sum::default(); paths.len()];
        let mut of_paths = vec![PathError::default(); paths.len()];
        let (mut cost, mut mismatch) = (Cost::default(), 0.0_f64);
        let mut configurations: Vec<(&'static str, usize)> = Vec::new();
        for sites in self.sites.sites.chunks(STATIONS_AT_ONCE) {
            let found: Vec<Result<Found, PlanError>> =
                sites.par_iter().map(|site| self.station(case, site)).collect();
            for found in found {
                let mut found = match found {
                    Ok(found) => found,
                    Err(error) => return Measured::Unplannable { reason: error.to_string() },
                };
                cost += found.cost;
                match configurations.iter_mut().find(|(name, _)| *name == found.configuration) {
                    Some((_, count)) => *count += 1,
                    None => configurations.push((found.configuration, 1)),
                }
                mismatch = mismatch.max(found.mismatch());
                let worst = &mut of_paths[found.path].worst;
                *worst = worst.max(found.error(self.metric));
                sums[found.path].add(found);
            }

            // One view is enough to break a promise.
            let error = largest(&of_paths, |path| path.worst);
            if promise.is_some_and(|kept| error > kept.limit || mismatch > kept.mismatch_limit) {
                return Measured::Broken { at_least: error };
            }
        }
        for ((of_path, sum), path) in of_paths.iter_mut().zip(sums).zip(paths) {
            of_path.together = sum.error(self.metric, path);
        }
        configurations.sort_unstable();
        let error = largest(&of_paths, |path| path.worst);
        let cost = cost.of(self.sites.sites.len());
        Measured::Whole(Errors { error, of_paths, mismatch, cost, configurations })
    }

    /// What one station adds to its path.
    fn station(&self, case: &LightCase, site: &Site<'a>) -> Result<Found, PlanError> {
        let plan = planned(case, site)?;
        let casters = self.sites.casters(site);
        let cost = Cost::of_frame(case, &plan, casters, &site.sight);

        // Draw what the declaration draws: without alpha test, leaves are whole.
        let opaque = self.sites.has_masks && case.casters == Casters::Opaque;
        let solid = opaque.then(|| casters.without_holes());
        let (_, visibility) = twin::visibility(&site.sight, solid.as_ref().unwrap_or(casters), case, &plan);
        let lit = |index: usize| visibility[index] >= LIT_VISIBILITY;
        let wrong = facing(&site.sight.frame).filter(|(index, pixel)| lit(*index) != pixel.lit);
        let mut found = Found {
            path: site.path,
            wrong_pixels: wrong.count() as u64,
            pixels: site.judged_pixels(),
            edges: (0.0, 0),
            footprints: Vec::new(),
            cost,
            configuration: plan.configuration,
        };
        match self.metric {
            Metric::Mismatch => {}
            Metric::EdgePx => {
                let displacement = site.sight.judge(&plan, case.filter, visibility).score.edge_displacement;
                let (there, back) = (&displacement.map_to_true, &displacement.true_to_map);
                found.edges = (there.pixels.p95.max(back.pixels.p95) * back.count as f64, back.count);
            }
            Metric::FootprintP95 => {
                let sight = &site.sight;
                let assignment = Assignment::new(&plan, &sight.view, &sight.frame, case.filter);
                let footprints = assignment.footprints.iter().flatten();
                found.footprints = footprints.map(|footprint| footprint.volume_pixels).collect();
            }
        }
        Ok(found)
    }
}

/// The plan of a case on a station. Bounds are known only to cases that promise them, and nothing is known of what is
/// visible: no declaration can ask for that.
pub fn planned(case: &LightCase, site: &Site<'_>) -> Result<ShadowPlan, PlanError> {
    let bounds = if case.scene_bounds { site.sight.bounds } else { SceneBounds::default() };
    plan(case, &site.sight.view, &site.sight.light, &bounds)
}

/// The largest figure of the paths.
pub fn largest(of_paths: &[PathError], figure: impl Fn(&PathError) -> f64) -> f64 {
    of_paths.iter().map(figure).fold(0.0, f64::max)
}
