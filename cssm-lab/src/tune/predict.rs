//! The first stage: what every variant will have, from its plans alone.
//!
//! A map's shadow edge lies somewhere in the texel that the true edge runs through, on average a quarter of it off: on an
//! edge pixel, the texel's footprint says how many pixels come out wrong.

use cssm_core::facet::Facet;
use cssm_core::{LightCase, footprint};
use rayon::prelude::*;

use super::bench::planned;
use super::budget::Metric;
use super::cost::Cost;
use super::sites::Sites;
use crate::progress::Progress;
use crate::score::statistics::quantile;

/// Wrong pixels per edge pixel and pixel of footprint.
const MISPLACED: f64 = 0.25;
/// 95th percentile of how far off an edge lies, in footprints.
const MISPLACED_P95: f64 = 0.5;
/// Largest footprint that counts, pixels: a shadow that is gone is gone.
const LARGEST_PIXELS: f64 = 64.0;

/// What is expected of a variant.
#[derive(Debug, Clone)]
pub struct Prediction {
    /// The variant.
    pub case: LightCase,
    /// Expected error, in the metric's unit.
    pub error: f64,
    /// Mean cost of a frame.
    pub cost: Cost,
}

/// Variants that can be planned, and why the others cannot.
#[derive(Debug, Clone, Default)]
pub struct Predictions {
    /// What is expected of each, in the order of the variants.
    pub possible: Vec<Prediction>,
    /// Number of variants that some station's plan refuses, and the last reason.
    pub refused: (usize, String),
}

/// Plans every variant on every site.
pub fn predict(
    sites: &Sites<'_>,
    variants: Vec<LightCase>,
    metric: Metric,
    progress: Progress,
) -> Predictions {
    let bar = progress.bar(variants.len() as u64, "planning variants");
    let predicted: Vec<Result<Prediction, String>> = variants
        .into_par_iter()
        .map(|case| {
            let prediction = one(sites, case, metric);
            bar.inc(1);
            prediction
        })
        .collect();
    bar.finish_and_clear();
    let mut predictions = Predictions::default();
    for prediction in predicted {
        match prediction {
            Ok(prediction) => predictions.possible.push(prediction),
            Err(reason) => predictions.refused = (predictions.refused.0 + 1, reason),
        }
    }
    predictions
}

fn one(sites: &Sites<'_>, case: LightCase, metric: Metric) -> Result<Prediction, String> {
    let mut error = 0.0_f64;
    let mut cost = Cost::default();
    for site in &sites.sites {
        let plan = planned(&case, site).map_err(|error| error.to_string())?;
        cost += Cost::of_frame(&case, &plan, sites.casters(site), &site.sight);
        let at = |index: usize| -> Option<(&Facet, &crate::truth::Visible)> {
            let pixel = site.sight.frame.pixels[index].as_ref()?;
            Some((plan.facet(plan.selection.cell(pixel.position.extend(1.0)))?, pixel))
        };
        let surface = |index: &usize| {
            let (facet, pixel) = at(*index)?;
            Some(footprint::surface(facet, &site.sight.view, pixel.position, pixel.normal))
        };
        let volume = |index: &usize| {
            let (facet, pixel) = at(*index)?;
            Some(footprint::volume(facet, &site.sight.view, pixel.position).major_pixels)
        };
        error = error.max(match metric {
            Metric::Mismatch => {
                let footprints = capped(site.edges.iter().map(surface));
                let mean = footprints.iter().sum::<f64>() / footprints.len().max(1) as f64;
                MISPLACED * mean * site.edge_pixels as f64 / site.judged_pixels() as f64
            }
            Metric::EdgePx => MISPLACED_P95 * quantile(&capped(site.edges.iter().map(surface)), 0.95),
            Metric::FootprintP95 => quantile(&capped(site.visible.iter().map(volume)), 0.95),
        });
    }
    Ok(Prediction { case, error, cost: cost.of(sites.sites.len()) })
}

/// Footprints in ascending order; none counts as the largest.
fn capped(footprints: impl Iterator<Item = Option<f64>>) -> Vec<f64> {
    let small = |pixels: &f64| *pixels < LARGEST_PIXELS;
    let mut found: Vec<f64> =
        footprints.map(|pixels| pixels.filter(small).unwrap_or(LARGEST_PIXELS)).collect();
    found.sort_by(f64::total_cmp);
    found
}
