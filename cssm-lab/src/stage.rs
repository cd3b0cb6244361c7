//! A stage: a sight, uploaded, on which cases are tried as engines run them.

use std::ops::Deref;
use std::time::Instant;

use cssm_core::case::Casters;
use cssm_core::{Light, LightCase, ShadowPlan, View};
use cssm_runtime::{FrameStatistics, PreparedFrame};

use crate::convergence::{Convergence, converge};
use crate::error::LabError;
use crate::gpu::{CaseRunner, Gpu, PassTimes, ResolveMethod, SceneBuffers, Stopwatch, Surface};
use crate::scene::Scene;
use crate::score::statistics::quantile;
pub use crate::sight::{Outcome, Sight, StageOptions};
use crate::truth::Tracer;

/// Plans are timed this often; the median counts.
const PLAN_RUNS: usize = 9;

/// A [`Sight`] on a device.
pub struct Stage<'a> {
    gpu: &'a Gpu,
    sight: Sight<'a>,
    buffers: SceneBuffers,
    surface: Surface,
}

impl<'a> Deref for Stage<'a> {
    type Target = Sight<'a>;

    fn deref(&self) -> &Sight<'a> {
        &self.sight
    }
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
        Self::of(gpu, Sight::trace(scene, tracer, view, light, options)?)
    }

    /// Uploads what a sight sees.
    ///
    /// # Errors
    /// When the device refuses.
    pub fn of(gpu: &'a Gpu, sight: Sight<'a>) -> Result<Self, LabError> {
        let buffers = SceneBuffers::new(gpu, sight.scene)?;
        let surface = Surface::new(gpu, &sight.view, &sight.frame)?;
        Ok(Self { gpu, sight, buffers, surface })
    }

    /// Plans, generates and prepares a case.
    ///
    /// # Errors
    /// Whatever planning, the generator or the device says.
    pub fn attempt(&self, case: &LightCase, method: ResolveMethod) -> Result<Attempt<'_>, LabError> {
        let mut times = Vec::with_capacity(PLAN_RUNS);
        for _ in 1..PLAN_RUNS {
            let start = Instant::now();
            self.sight.plan(case)?;
            times.push(start.elapsed().as_secs_f64() * 1e6);
        }
        times.sort_by(f64::total_cmp);
        let plan = self.sight.plan(case)?;
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

/// Tries a case on a stage with square maps of several sizes.
///
/// # Errors
/// [`LabError::NothingJudged`] when no level could be judged; else whatever planning or the device says.
pub fn convergence(
    stage: &Stage<'_>,
    case: &LightCase,
    method: ResolveMethod,
    sides: &[u32],
) -> Result<Convergence, LabError> {
    converge(case, sides, |case| Ok(stage.attempt(case, method)?.outcome()?.score))
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

impl Attempt<'_> {
    /// Captures, resolves and judges.
    ///
    /// # Errors
    /// What the device says.
    pub fn outcome(&self) -> Result<Outcome, LabError> {
        let Stage { gpu, sight, surface, .. } = self.stage;
        let visibility = self.runner.visibility(gpu, &self.prepared, surface)?;
        Ok(sight.judge(&self.plan, self.case.filter, visibility))
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
