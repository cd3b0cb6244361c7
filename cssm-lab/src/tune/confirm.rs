//! The check that follows tuning: the same paths at stations that nothing was tuned on.

use cssm_core::LightCase;

use super::bench::{Bench, Measured, PathError};
use super::budget::{Metric, Promise};
use super::sites::{Path, Sites};
use crate::error::LabError;
use crate::gpu::Gpu;
use crate::measure::bench::{self as measure, BenchOptions, JudgeKind, Receivers};
use crate::measure::evaluate::Candidate;
use crate::measure::paths::ViewPath;
use crate::progress::Progress;
use crate::scene::Scene;
use crate::truth::Tracer;

/// What a declaration has on views that tuning did not see.
#[derive(Debug, Clone, PartialEq)]
pub struct Confirmation {
    /// The paths and what each has.
    pub of_paths: Vec<(Path, PathError)>,
    /// Why a view cannot be planned, if one cannot.
    pub refused: Option<String>,
    /// What was promised of every path.
    pub promised: f64,
}

impl Confirmation {
    /// Measures a case on other sites.
    pub fn of(case: &LightCase, sites: &Sites<'_>, promise: &Promise) -> Self {
        let mut bench = Bench::new(sites, promise.metric);
        let (of_paths, refused) = match bench.measure(case, None) {
            Measured::Whole(errors) => (sites.paths.iter().cloned().zip(errors.of_paths).collect(), None),
            Measured::Unplannable { reason } => (Vec::new(), Some(reason)),
            Measured::Broken { .. } => (Vec::new(), Some("it was not measured to the end".to_owned())),
        };
        Self { of_paths, refused, promised: promise.promised }
    }

    /// Whether the promise holds on every path.
    pub fn holds(&self) -> bool {
        self.refused.is_none() && self.of_paths.iter().all(|(_, error)| error.together <= self.promised)
    }

    /// The check in words.
    pub fn lines(&self, metric: Metric) -> Vec<String> {
        if let Some(reason) = &self.refused {
            return vec![format!("On views that tuning did not see it has no plan, NOT KEPT: {reason}.")];
        }
        let words = |holds: bool| if holds { "kept" } else { "NOT KEPT" };
        let mut lines =
            vec![format!("On views that tuning did not see the promise is {}:", words(self.holds()))];
        lines.extend(self.of_paths.iter().map(|(path, error)| {
            let kept = words(error.together <= self.promised);
            format!("  {}, {kept}", path_text(path, error, metric))
        }));
        lines
    }
}

/// What a declaration has through its generated shaders, as an engine runs them.
#[derive(Debug, Clone, PartialEq)]
pub struct Shown {
    /// The device.
    pub adapter: String,
    /// Paths by name, whether tuning saw their views, and the error of all views together.
    pub of_paths: Vec<(String, bool, f64)>,
    /// What was promised of every path.
    pub promised: f64,
}

impl Shown {
    /// Draws a case on the views that it was tuned on and on others.
    ///
    /// # Errors
    /// When there is no device or it is lost.
    pub fn of(
        scene: &Scene,
        tracer: &Tracer,
        case: &LightCase,
        (seen, unseen): (&[ViewPath], &[ViewPath]),
        promise: &Promise,
        progress: Progress,
    ) -> Result<Self, LabError> {
        let size = seen.iter().flat_map(|path| &path.stations).fold((1, 1), |size: (u32, u32), station| {
            let (width, height) = station.view.size_pixels;
            (size.0.max(width), size.1.max(height))
        });
        let gpu = Gpu::open(&[case], size)?;
        let options = BenchOptions {
            supersample: false,
            judge: JudgeKind::Gpu,
            receivers: Receivers::None,
            flicker: false,
            progress,
        };
        let mut of_paths = Vec::new();
        for (paths, is_seen) in [(seen, true), (unseen, false)] {
            let bench = measure::Bench::new(scene, tracer, paths, Some(&gpu), options)?;
            let mut candidate = Candidate::new(&bench, case)?;
            for path in &bench.paths {
                let evaluation = candidate.evaluate(path)?;
                let whole = evaluation.figures.filter(|_| evaluation.refusals.is_empty());
                let error = whole.map_or(f64::INFINITY, |figures| match promise.metric {
                    Metric::Mismatch => figures.mismatch,
                    Metric::EdgePx => figures.edge_pixels_p95,
                    Metric::FootprintP95 => figures.footprint.p95,
                });
                of_paths.push((path.name.clone(), is_seen, error));
            }
        }
        Ok(Self { adapter: gpu.adapter(), of_paths, promised: promise.promised })
    }

    /// What was shown, in words.
    pub fn lines(&self, metric: Metric) -> Vec<String> {
        let mut lines = vec![format!("Through the generated shaders on {}:", self.adapter)];
        lines.extend(self.of_paths.iter().map(|(name, is_seen, error)| {
            let views = if *is_seen { "views it was tuned on" } else { "other views" };
            let kept = if *error <= self.promised { "kept" } else { "NOT KEPT" };
            format!("  {name}, {views}: {}, {kept}", metric.text(*error))
        }));
        lines
    }
}

/// What a path has.
pub fn path_text(path: &Path, error: &PathError, metric: Metric) -> String {
    format!(
        "{}: {}; the worst of its {} views {}",
        path.name,
        metric.text(error.together),
        path.stations,
        metric.text(error.worst)
    )
}
