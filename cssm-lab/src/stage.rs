//! A stage: one view of a scene under one light, traced once and uploaded, on which cases are tried.

use std::time::Instant;

use cssm_core::case::Casters;
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{FrameStatistics, PreparedFrame};

use crate::error::LabError;
use crate::gpu::{CaseRunner, Gpu, PassTimes, ResolveMethod, SceneBuffers, Stopwatch, Surface};
use crate::progress::Progress;
use crate::scene::Scene;
use crate::score::footprints::{Assignment, FrameFootprint};
use crate::score::statistics::quantile;
use crate::score::{FineEdges, Judged, Score, Verdict, score};
use crate::truth::{Frame, Tracer};

/// Plans are timed this often; the median counts.
const PLAN_RUNS: usize = 9;

/// One view of a scene under one light.
pub struct Stage<'a> {
    gpu: &'a Gpu,
    /// The scene.
    pub scene: &'a Scene,
    /// The view.
    pub view: View,
    /// The light.
    pub light: Light,
    /// What planning is told of the scene.
    pub bounds: SceneBounds,
    /// The truth.
    pub frame: Frame,
    /// True edges finer than pixels, if they were asked for.
    pub fine: Option<FineEdges>,
    buffers: SceneBuffers,
    surface: Surface,
}

/// How a stage is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StageOptions {
    /// Traces true edges with four times four samples a pixel, for surfaces thinner than a pixel.
    pub supersample: bool,
    /// Whether progress is shown.
    pub progress: Progress,
}

impl<'a> Stage<'a> {
    /// Traces the view and uploads what it sees.
    ///
    /// # Errors
    /// When the device refuses.
    pub fn new(
        gpu: &'a Gpu,
        scene: &'a Scene,
        tracer: &Tracer,
        view: View,
        light: Light,
        options: StageOptions,
    ) -> Result<Self, LabError> {
        let rows = u64::from(view.size_pixels.1);
        let bar = options.progress.bar(rows, "tracing pixels");
        let frame = Frame::trace(tracer, &view, &light, &|rows| bar.inc(rows));
        bar.finish_and_clear();
        let fine = if options.supersample {
            let bar = options.progress.bar(4 * rows, "tracing 4 x 4 samples a pixel");
            let fine = FineEdges::trace(tracer, &view, &light, &|rows| bar.inc(rows))?;
            bar.finish_and_clear();
            Some(fine)
        } else {
            None
        };
        Ok(Self {
            gpu,
            scene,
            view,
            light,
            bounds: SceneBounds { receivers: scene.bounds_world() },
            buffers: SceneBuffers::new(gpu, scene)?,
            surface: Surface::new(gpu, &view, &frame)?,
            frame,
            fine,
        })
    }

    /// Plans, generates and prepares a case.
    ///
    /// # Errors
    /// Whatever planning, the generator or the device says.
    pub fn attempt(&self, case: &LightCase, method: ResolveMethod) -> Result<Attempt<'_>, LabError> {
        let mut times = Vec::with_capacity(PLAN_RUNS);
        for _ in 1..PLAN_RUNS {
            let start = Instant::now();
            plan(case, &self.view, &self.light, &self.bounds)?;
            times.push(start.elapsed().as_secs_f64() * 1e6);
        }
        times.sort_by(f64::total_cmp);
        let plan = plan(case, &self.view, &self.light, &self.bounds)?;
        let mut attempt = self.attempt_with_plan(case, plan, method)?;
        attempt.plan_microseconds = quantile(&times, 0.5);
        Ok(attempt)
    }

    /// Prepares a case with a plan of the caller's own, such as a deliberately wrong one. On a scene with alpha masks the
    /// case's casters are alpha-tested, whatever it declares.
    ///
    /// # Errors
    /// Whatever the generator or the device says.
    pub fn attempt_with_plan(
        &self,
        case: &LightCase,
        plan: ShadowPlan,
        method: ResolveMethod,
    ) -> Result<Attempt<'_>, LabError> {
        // A scene with alpha masks needs shaders that read them.
        let mut case = case.clone();
        if self.scene.has_masks() {
            case.casters = Casters::AlphaTested;
        }

        let start = Instant::now();
        let generated = cssm_codegen::generate(&case)?;
        let generate_milliseconds = start.elapsed().as_secs_f64() * 1e3;
        let mut runner =
            CaseRunner::new(self.gpu, &case, &generated.table, self.scene, &self.buffers, method)?;
        let prepared = runner.prepare(&plan, &self.view)?;
        Ok(Attempt {
            stage: self,
            case,
            method,
            plan,
            plan_microseconds: 0.0,
            generate_milliseconds,
            runner,
            prepared,
        })
    }

    /// The device.
    pub const fn gpu(&self) -> &Gpu {
        self.gpu
    }
}

/// A case that is ready to run on a stage.
pub struct Attempt<'a> {
    stage: &'a Stage<'a>,
    /// The case.
    pub case: LightCase,
    /// How it resolves.
    pub method: ResolveMethod,
    /// Its plan.
    pub plan: ShadowPlan,
    /// Median time of planning; 0 for a plan of the caller's own.
    pub plan_microseconds: f64,
    /// Time of generating shaders and tables.
    pub generate_milliseconds: f64,
    runner: CaseRunner,
    prepared: PreparedFrame,
}

/// What a case made of a stage.
#[derive(Debug, Clone)]
pub struct Outcome {
    /// Visibility of each pixel.
    pub visibility: Vec<f32>,
    /// Facets, footprints and use of the map.
    pub assignment: Assignment,
    /// Footprints over the visible pixels.
    pub footprint: FrameFootprint,
    /// The score.
    pub score: Score,
    /// What was found at each pixel.
    pub verdicts: Vec<Option<Verdict>>,
}

impl Attempt<'_> {
    /// Captures, resolves and judges.
    ///
    /// # Errors
    /// What the device says.
    pub fn outcome(&self) -> Result<Outcome, LabError> {
        let Stage { gpu, view, frame, fine, surface, .. } = self.stage;
        let visibility = self.runner.visibility(gpu, &self.prepared, surface)?;
        let assignment = Assignment::new(&self.plan, view, frame, self.case.filter);
        let (score, verdicts) = score(&Judged {
            frame,
            visibility: &visibility,
            footprints: &assignment.footprints,
            facets: &assignment.facets,
            fine: fine.as_ref(),
        });
        let footprint = assignment.frame_footprint(frame);
        Ok(Outcome { visibility, assignment, footprint, score, verdicts })
    }

    /// Captures and resolves once, timed.
    ///
    /// # Errors
    /// What the device says.
    pub fn time(&self, stopwatch: &Stopwatch) -> Result<PassTimes, LabError> {
        Ok(self.runner.time(self.stage.gpu, &self.prepared, &self.stage.surface, stopwatch)?)
    }

    /// Depths of the map after the last capture.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn map(&self) -> Result<Vec<f32>, LabError> {
        Ok(self.runner.map()?)
    }

    /// Draws and triangles.
    pub fn statistics(&self) -> &FrameStatistics {
        self.prepared.statistics()
    }

    /// The stage it runs on.
    pub const fn stage(&self) -> &Stage<'_> {
        self.stage
    }
}
