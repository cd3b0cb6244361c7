//! A case that is ready to run in a situation, and the frame without any light that all are compared with.

use std::path::Path;

use cssm_core::{LightCase, ShadowPlan, plan};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_lab::gpu::{Gpu, RecordPass, SceneBuffers, Stopwatch};
use cssm_lab::scene::Scene;
use cssm_runtime::{FrameStatistics, MaskInputs, Options, PreparedFrame, ShadowService};

use crate::error::BenchError;
use crate::situation::Situation;
use crate::view_passes::{LIT_FORMAT, ViewPasses};

/// The declarations that are timed.
const CASES: &str = include_str!("../speed.cssm");

/// Ends the name of a contender whose depth comes from a fragment shader, even where the device can do without one.
pub const IN_FRAGMENTS: &str = "InFragments";

/// Passes of a frame with a light: see, capture, resolve, shade.
pub const PASSES: u32 = 4;

/// The case of a contender, with a square map.
///
/// # Errors
/// When there is none of that name, or the size is out of range.
pub fn case(name: &str, map_side_texels: u32) -> Result<LightCase, BenchError> {
    let name = name.strip_suffix(IN_FRAGMENTS).unwrap_or(name);
    let case = pick_case(Path::new("speed.cssm"), CASES, Some(name))?;
    Ok(with_map_size(case, (map_side_texels, map_side_texels))?)
}

/// A case with its plan, its shaders and its casters on the device.
#[derive(Debug)]
pub struct Contender {
    /// The case's name, and how its depth is written.
    pub name: &'static str,
    /// The plan of the situation.
    pub plan: ShadowPlan,
    service: ShadowService,
    prepared: PreparedFrame,
}

/// Times of one frame in milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FrameTimes {
    /// Rendering casters into the map.
    pub capture: f64,
    /// From the map to visibility.
    pub resolve: f64,
    /// The view's own passes.
    pub view: f64,
    /// From the first pass's beginning to the last one's end.
    pub frame: f64,
}

impl FrameTimes {
    /// What the light adds.
    pub fn shadows(&self) -> f64 {
        self.capture + self.resolve
    }
}

impl Contender {
    /// Plans, generates and prepares a case.
    ///
    /// # Errors
    /// Whatever planning, the generator or the device says.
    pub fn new(
        gpu: &Gpu,
        scene: &Scene,
        buffers: &SceneBuffers,
        situation: &Situation,
        name: &'static str,
        map_side_texels: u32,
    ) -> Result<Self, BenchError> {
        let case = case(name, map_side_texels)?;
        let plan = plan(&case, &situation.view, &situation.light, &situation.bounds)?;
        let table = cssm_codegen::generate(&case)?.table;
        let options = Options {
            mask_format: LIT_FORMAT,
            clamp_in_fragments: name.ends_with(IN_FRAGMENTS),
            ..Options::default()
        };
        let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &options)?;
        let casters = buffers.add_to(&mut service, scene)?;
        let prepared = service.prepare(&plan, &situation.view, &casters)?;
        Ok(Self { name, plan, service, prepared })
    }

    /// Draws and triangles.
    pub fn statistics(&self) -> &FrameStatistics {
        self.prepared.statistics()
    }

    /// Runs a frame once, timed.
    ///
    /// # Errors
    /// What the service or the device says.
    pub fn time(
        &self,
        gpu: &Gpu,
        passes: &ViewPasses,
        stopwatch: &Stopwatch,
    ) -> Result<FrameTimes, BenchError> {
        let see: &mut RecordPass<'_> = &mut |encoder, timestamps| {
            passes.see(encoder, timestamps);
            Ok(())
        };
        let capture: &mut RecordPass<'_> =
            &mut |encoder, timestamps| Ok(self.service.capture(encoder, &self.prepared, timestamps)?);
        let inputs = MaskInputs { depth: &passes.depth, normal: None };
        let resolve: &mut RecordPass<'_> = &mut |encoder, timestamps| {
            Ok(self.service.mask(encoder, &self.prepared, &inputs, &passes.lit, timestamps)?)
        };
        let shade: &mut RecordPass<'_> = &mut |encoder, timestamps| {
            passes.shade(encoder, timestamps);
            Ok(())
        };
        let times = stopwatch.time_sequence(gpu, &mut [see, capture, resolve, shade])?;
        let pass = |index: usize| times.passes_milliseconds.get(index).copied().unwrap_or_default();
        Ok(FrameTimes {
            capture: pass(1),
            resolve: pass(2),
            view: pass(0) + pass(3),
            frame: times.whole_milliseconds,
        })
    }
}

/// Runs a frame without any shadow once, timed.
///
/// # Errors
/// What the device says.
pub fn time_without_light(
    gpu: &Gpu,
    passes: &ViewPasses,
    stopwatch: &Stopwatch,
) -> Result<FrameTimes, BenchError> {
    let see: &mut RecordPass<'_> = &mut |encoder, timestamps| {
        passes.see(encoder, timestamps);
        Ok(())
    };
    let shade: &mut RecordPass<'_> = &mut |encoder, timestamps| {
        passes.shade(encoder, timestamps);
        Ok(())
    };
    let times = stopwatch.time_sequence(gpu, &mut [see, shade])?;
    let view = times.passes_milliseconds.iter().sum();
    Ok(FrameTimes { view, frame: times.whole_milliseconds, ..FrameTimes::default() })
}
