//! The figures of one plan: footprints over the visible volume and on the ground, and use of the map.

use cssm_core::footprint::{self, VolumeScore, quantile};
use cssm_core::glam::DVec3;
use cssm_core::{Light, LightCase, PlanError, SceneBounds, ShadowPlan, View, plan};
use serde::Serialize;

/// The figures, in the order in which tables show them.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Figures {
    /// Median volume footprint, pixels.
    pub median: f64,
    /// 95th percentile.
    pub p95: f64,
    /// 99th percentile.
    pub p99: f64,
    /// Largest.
    pub max: f64,
    /// 95th percentile of the geometric footprint.
    pub geometric_p95: f64,
    /// Median surface footprint on the ground.
    pub ground_median: f64,
    /// Its 95th percentile.
    pub ground_p95: f64,
    /// Share of texels whose beam meets the visible volume.
    pub beam_utilisation: f64,
}

impl Figures {
    /// Names in tables.
    pub const NAMES: [&'static str; 8] =
        ["median", "p95", "p99", "max", "geo95", "ground50", "ground95", "util"];

    /// The numbers in order.
    pub const fn array(&self) -> [f64; 8] {
        [
            self.median,
            self.p95,
            self.p99,
            self.max,
            self.geometric_p95,
            self.ground_median,
            self.ground_p95,
            self.beam_utilisation,
        ]
    }

    /// Figures from the numbers in order.
    pub const fn from_array(numbers: [f64; 8]) -> Self {
        let [median, p95, p99, max, geometric_p95, ground_median, ground_p95, beam_utilisation] = numbers;
        Self { median, p95, p99, max, geometric_p95, ground_median, ground_p95, beam_utilisation }
    }

    /// The median of every figure by itself.
    pub fn medians(all: &[Self]) -> Self {
        Self::from_array(std::array::from_fn(|column| {
            let mut values: Vec<f64> = all.iter().map(|figures| figures.array()[column]).collect();
            values.sort_by(f64::total_cmp);
            quantile(&values, 0.5)
        }))
    }
}

/// What a case did under one light.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// The configuration that the plan took.
    pub configuration: &'static str,
    /// Its facets.
    pub facets: usize,
    /// The figures.
    pub figures: Figures,
    /// Samples without a facet or outside its window.
    pub unassigned: usize,
    /// Samples in several facets.
    pub multiply_assigned: usize,
}

/// Height of the eye over the reference ground.
const EYE_HEIGHT_METRES: f64 = 1.7;

/// Plans a case and scores the plan, to a finite depth.
///
/// # Errors
/// What planning says.
pub fn measure(
    case: &LightCase,
    view: &View,
    light: &Light,
    far_metres: f64,
    samples: usize,
) -> Result<Measured, PlanError> {
    let plan = plan(case, view, light, &SceneBounds::default())?;
    let VolumeScore {
        median_pixels,
        p95_pixels,
        p99_pixels,
        max_pixels,
        geometric_p95_pixels,
        beam_utilisation,
        unassigned,
        multiply_assigned,
    } = footprint::score_volume(&plan, view, far_metres, samples);
    let ground = ground(&plan, view, far_metres, samples);
    Ok(Measured {
        configuration: plan.configuration,
        facets: plan.facets.len(),
        figures: Figures {
            median: median_pixels,
            p95: p95_pixels,
            p99: p99_pixels,
            max: max_pixels,
            geometric_p95: geometric_p95_pixels,
            ground_median: quantile(&ground, 0.5),
            ground_p95: quantile(&ground, 0.95),
            beam_utilisation,
        },
        unassigned,
        multiply_assigned,
    })
}

/// Surface footprints, ascending, on level ground below a level camera, at pixels spread evenly over the image.
fn ground(plan: &ShadowPlan, view: &View, far_metres: f64, samples: usize) -> Vec<f64> {
    let side = (samples as f64).sqrt().ceil() as usize;
    let up = view.camera_from_world.transpose() * DVec3::Y;
    let mut footprints = Vec::new();
    for index in 0..side * side {
        let along = |step: usize, size: u32| (step as f64 + 0.5) / side as f64 * f64::from(size);
        let ray =
            view.ray_world(along(index % side, view.size_pixels.0), along(index / side, view.size_pixels.1));
        let depth = -EYE_HEIGHT_METRES / ray.dot(up);
        if !(view.near_metres..far_metres).contains(&depth) {
            continue;
        }
        let point = ray * depth;
        if let Some(facet) = plan.facet(plan.selection.cell(point.extend(1.0))) {
            footprints.push(footprint::surface(facet, view, point, up));
        }
    }
    footprints.sort_by(f64::total_cmp);
    footprints
}
