//! The work of a frame that needs no device: planning, and building the commands of the capture pass.

use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use cssm_core::{
    Light, LightCase, PlanError, PlanRequest, Planner, SceneBounds, ShadowPlan, View, ViewMargin, plan,
};
use cssm_lab::case_file::pick_case;
use cssm_lab::gpu::{Gpu, SceneBuffers};
use cssm_lab::scene::Scene;
use cssm_lab::timing::Interval;
use cssm_runtime::{CasterInstance, FrameStatistics, Options, ServiceError, ShadowService};
use shaders_gen::shipped;

use crate::error::BenchError;
use crate::report::CpuTimes;
use crate::situation::{IMAGE_PIXELS, situations};

/// A plan to be made.
#[derive(Debug, Clone)]
pub struct PlanJob {
    /// Case and position of the light.
    pub name: String,
    /// The case.
    pub case: LightCase,
    view: View,
    light: Light,
    bounds: SceneBounds,
}

impl PlanJob {
    /// Makes the plan.
    ///
    /// # Errors
    /// What planning says.
    pub fn run(&self) -> Result<ShadowPlan, PlanError> {
        plan(&self.case, &self.view, &self.light, &self.bounds)
    }

    /// The view of an even or an odd frame, one centimetre apart.
    fn view_of(&self, frame: u8) -> View {
        let mut view = self.view;
        view.eye_world.x += 0.01 * f64::from(frame);
        view
    }

    /// What a frame of a moving view does: makes the plan in the place of the last one, with memory that is kept.
    ///
    /// # Errors
    /// What planning says.
    pub fn remade(&self) -> Result<impl FnMut() -> bool + '_, PlanError> {
        let (mut planner, mut plan) = (Planner::new(), ShadowPlan::empty());
        planner.plan(&PlanRequest::new(&self.case, &self.view, &self.light, self.bounds), &mut plan)?;
        let mut frame = 0_u8;
        Ok(move || {
            frame = 1 - frame;
            let view = self.view_of(frame);
            let request = PlanRequest::new(&self.case, &view, &self.light, self.bounds);
            planner.plan(&request, &mut plan).is_ok()
        })
    }

    /// What a frame does with a plan that it holds: brings it to an eye a centimetre away, asks whether it covers what is seen
    /// and how good it is.
    ///
    /// # Errors
    /// What planning says.
    pub fn held(&self) -> Result<impl FnMut() -> Option<f64> + '_, PlanError> {
        let request = PlanRequest::new(&self.case, &self.view, &self.light, self.bounds);
        let margin = ViewMargin { turn_radians: 0.0, move_metres: 0.05 };
        let mut held = PlanRequest { margin, ..request }.plan()?;
        let mut frame = 0_u8;
        Ok(move || {
            frame = 1 - frame;
            let view = self.view_of(frame);
            held.rebase(&view);
            let covers = held.covers(&PlanRequest { view: &view, ..request });
            covers.then(|| held.p95_pixels(&view))
        })
    }
}

/// Declarations under the sun outside the image, under the sun in the image, and under lamps.
const GENERAL: [&str; 5] =
    [shipped::STANDARD, shipped::PSSM4_LOG, shipped::ONE_PLANE, shipped::SUN, shipped::SUN_LOG];
const DUELING: [&str; 3] = [shipped::FOUR_PLANE, shipped::PLANES, shipped::SUN];
const LAMPS: [(&str, &str); 6] = [
    (shipped::LAMP, "omni-in-view"),
    (shipped::LAMP, "omni-behind"),
    (shipped::LAMP, "omni-outside"),
    (shipped::SPOT, "spot-ahead"),
    (shipped::SPOT, "spot-aside"),
    (shipped::SPOT, "spot-dueling"),
];

/// Calls of a job in each turn.
const CALLS_PER_TURN: usize = 5;

/// Cases whose commands are built.
const CULLED: [&str; 4] = ["Standard", "FourPlane", "Sun", "Lamp"];

/// The declarations that ship, each with a light that it is made for; `Standard` comes first.
///
/// # Errors
/// When the scene lacks views or lamps.
pub fn plan_jobs(scene: &Scene) -> Result<Vec<PlanJob>, BenchError> {
    let [general, dueling] = situations(scene, IMAGE_PIXELS)?;
    let bounds = general.bounds;
    let mut jobs = Vec::new();
    for (situation, texts, suffix) in
        [(general, &GENERAL[..], "sun outside"), (dueling, &DUELING[..], "sun in image")]
    {
        for text in texts {
            let case = shipped_case(text)?;
            let name = format!("{}, {suffix}", case.name);
            jobs.push(PlanJob { name, case, view: situation.view, light: situation.light, bounds });
        }
    }
    for (text, lamp) in LAMPS {
        let case = shipped_case(text)?;
        let (view, light) = scene.lamp(lamp)?.pictured(IMAGE_PIXELS)?;
        jobs.push(PlanJob { name: format!("{}, {lamp}", case.name), case, view, light, bounds });
    }
    Ok(jobs)
}

/// Commands to be built: casters are culled for every facet of a plan.
#[derive(Debug)]
pub struct CommandJob {
    /// Case and position of the light.
    pub name: String,
    service: ShadowService,
    casters: Vec<CasterInstance>,
    plan: ShadowPlan,
}

impl CommandJob {
    /// Gives the service of a plan's case a scene.
    ///
    /// # Errors
    /// What planning, the generator or the device says.
    pub fn new(gpu: &Gpu, scene: &Scene, job: &PlanJob) -> Result<Self, BenchError> {
        let table = cssm_codegen::generate(&job.case)?.table;
        let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default())?;
        let casters = SceneBuffers::new(gpu, scene)?.add_to(&mut service, scene)?;
        Ok(Self { name: job.name.clone(), service, casters, plan: job.run()? })
    }

    /// Builds the commands and returns what they draw.
    ///
    /// # Errors
    /// What the service says.
    pub fn run(&self) -> Result<FrameStatistics, ServiceError> {
        Ok(self.service.commands(&self.plan, &self.casters)?.1)
    }
}

/// Commands of some of the plans for a scene.
///
/// # Errors
/// As [`CommandJob::new`].
pub fn command_jobs(gpu: &Gpu, scene: &Scene) -> Result<Vec<CommandJob>, BenchError> {
    let jobs = plan_jobs(scene)?;
    let culled = jobs.iter().filter(|job| CULLED.contains(&job.case.name.as_str()));
    culled.map(|job| CommandJob::new(gpu, scene, job)).collect()
}

/// Runs all jobs in turns and times each against the first one of the same turn; the fastest of several calls counts, so
/// that what else the machine does is left out.
///
/// # Errors
/// What a job says.
pub fn time_in_turns<J, R, E: Into<BenchError>>(
    heading: String,
    jobs: &[J],
    name: impl Fn(&J) -> &str,
    run: impl Fn(&J) -> Result<R, E>,
    (warm_up_runs, runs): (usize, usize),
) -> Result<CpuTimes, BenchError> {
    let mut times = vec![Vec::with_capacity(runs); jobs.len()];
    for turn in 0..warm_up_runs + runs {
        for (job, times) in jobs.iter().zip(&mut times) {
            let mut microseconds = f64::INFINITY;
            for _ in 0..CALLS_PER_TURN {
                let start = Instant::now();
                black_box(run(job).map_err(Into::into)?);
                microseconds = microseconds.min(start.elapsed().as_secs_f64() * 1e6);
            }
            if turn >= warm_up_runs {
                times.push(microseconds);
            }
        }
    }
    let first = times.first().cloned().unwrap_or_default();
    let jobs = jobs.iter().zip(times).map(|(job, times)| {
        let ratios = times.iter().zip(&first).map(|(ours, first)| ours / first).collect();
        (name(job).to_owned(), Interval::of(times), Interval::of(ratios))
    });
    Ok(CpuTimes { heading, jobs: jobs.collect() })
}

fn shipped_case(text: &str) -> Result<LightCase, BenchError> {
    Ok(pick_case(Path::new("a shipped declaration"), text, None)?)
}
