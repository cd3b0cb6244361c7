//! Is a light as good in company as alone? The same pixels under the same light, through its square of the shared map and
//! through a map of its own with as many texels.

use cssm_core::plan::PlanRequest;
use cssm_core::{Light, LightCase};
use cssm_runtime::lights::LightHandle;
use serde::Serialize;

use crate::error::LabError;
use crate::gpu::{CaseRunner, Gpu, LightRunner, ResolveMethod, SceneBuffers, Surface};
use crate::scene::Scene;
use crate::score::Score;
use crate::sight::Sight;
use crate::truth::{Frame, Tracer};

/// What one light's shadows are worth.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Judgement {
    /// The light.
    pub name: String,
    /// Side of its square in texels; 0 without one.
    pub side_texels: u32,
    /// Configuration of its plan; empty without one.
    pub configuration: &'static str,
    /// Pixels that face the light within its reach.
    pub judged_pixels: u64,
    /// Of these, wrong ones in the shared map.
    pub wrong_in_company: u64,
    /// Wrong ones in a map of its own with as many texels.
    pub wrong_alone: u64,
    /// Wrong ones away from edges and creases, in the shared map.
    pub interior_in_company: u64,
    /// The same in a map of its own.
    pub interior_alone: u64,
}

impl Judgement {
    /// Share of the judged pixels that the shared map gets wrong beyond what a map of its own does.
    pub fn excess(&self) -> f64 {
        let more = self.wrong_in_company as f64 - self.wrong_alone as f64;
        if self.judged_pixels == 0 { 0.0 } else { more / self.judged_pixels as f64 }
    }
}

/// What all lights are judged on: one scene, one view, its surfaces.
pub struct Bench<'a> {
    /// The device.
    pub gpu: &'a Gpu,
    /// The scene as it stands.
    pub scene: &'a Scene,
    /// Its rays.
    pub tracer: &'a Tracer,
    /// Its meshes on the device.
    pub buffers: &'a SceneBuffers,
    /// What the view sees, under any light.
    pub frame: &'a Frame,
    /// The view.
    pub view: cssm_core::View,
    /// The same on the device.
    pub surface: &'a Surface,
}

impl Bench<'_> {
    /// Judges a light of a runner whose last frame shows this very view.
    ///
    /// # Errors
    /// What the service or the device says.
    pub fn judge(
        &self,
        runner: &LightRunner,
        handle: LightHandle,
        name: &str,
        case: &LightCase,
        light: Light,
    ) -> Result<Judgement, LabError> {
        let frame = self.frame.under(self.tracer, &self.view, &light);
        let sight = Sight::of_frame(self.scene, self.view, light, frame);
        let Some(plan) = runner.plan(handle, &self.view) else {
            // A light without shadows is judged as lit.
            let pixels = sight.frame.pixels.iter().flatten().filter(|pixel| pixel.faces_light());
            let (judged, wrong) =
                pixels.fold((0, 0), |(all, wrong), pixel| (all + 1, wrong + u64::from(!pixel.lit)));
            return Ok(Judgement {
                name: name.to_owned(),
                side_texels: 0,
                configuration: "",
                judged_pixels: judged,
                wrong_in_company: wrong,
                wrong_alone: wrong,
                interior_in_company: 0,
                interior_alone: 0,
            });
        };
        let visibility = runner.visibility(handle, self.surface)?;
        let company = sight.judge(&plan, case.filter, visibility).score;

        // Give it a map of its own with as many texels.
        let mut own = case.clone();
        (own.map.width, own.map.height) = (plan.region.width, plan.region.height);
        let generated = cssm_codegen::generate(&own)?;
        let method = ResolveMethod::Function;
        let mut alone = CaseRunner::new(self.gpu, &own, &generated.table, self.scene, self.buffers, method)?;
        let own_plan = PlanRequest::new(&own, &self.view, &light, sight.bounds).plan()?;
        let prepared = alone.prepare(&own_plan, &self.view)?;
        let visibility = alone.visibility(self.gpu, &prepared, self.surface)?;
        let alone = sight.judge(&own_plan, own.filter, visibility).score;
        let wrong = |score: &Score| (score.mismatch * score.facing_pixels as f64).round() as u64;
        Ok(Judgement {
            name: name.to_owned(),
            side_texels: plan.region.width,
            configuration: plan.configuration,
            judged_pixels: company.facing_pixels,
            wrong_in_company: wrong(&company),
            wrong_alone: wrong(&alone),
            interior_in_company: company.interior_wrong_pixels,
            interior_alone: alone.interior_wrong_pixels,
        })
    }
}
