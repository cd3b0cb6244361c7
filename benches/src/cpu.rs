//! The work of a frame that needs no device: planning, and building the commands of the capture pass.

use std::path::Path;

use cssm_core::{Light, LightCase, PlanError, SceneBounds, ShadowPlan, View, plan};
use cssm_lab::case_file::pick_case;
use cssm_lab::gpu::{Gpu, SceneBuffers};
use cssm_lab::scene::Scene;
use cssm_runtime::{CasterInstance, FrameStatistics, Options, ServiceError, ShadowService};
use shaders_gen::shipped;

use crate::error::BenchError;
use crate::situation::situations;

/// Image of the views that are planned for.
const IMAGE_PIXELS: (u32, u32) = (1920, 1080);

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

/// The declarations that ship, each with a light that it is made for; `Standard` comes first.
///
/// # Errors
/// When the scene lacks views or lamps.
pub fn plan_jobs(scene: &Scene) -> Result<Vec<PlanJob>, BenchError> {
    let [general, dueling] = situations(scene, IMAGE_PIXELS)?;
    let bounds = general.bounds;
    let mut jobs = Vec::new();
    for (situation, texts, suffix) in [(general, &GENERAL[..], "sun outside"), (dueling, &DUELING[..], "sun in image")] {
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
    /// Scene, case and position of the light.
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
        Ok(Self { name: format!("{}, {}", scene.name, job.name), service, casters, plan: job.run()? })
    }

    /// Builds the commands and returns what they draw.
    ///
    /// # Errors
    /// What the service says.
    pub fn run(&self) -> Result<FrameStatistics, ServiceError> {
        Ok(self.service.commands(&self.plan, &self.casters)?.1)
    }
}

fn shipped_case(text: &str) -> Result<LightCase, BenchError> {
    Ok(pick_case(Path::new("a shipped declaration"), text, None)?)
}
