//! One case on the device: capture, then visibility of traced pixels.

use cssm_core::case::{Axes, LightCase, MaskDepth, Resolve};
use cssm_core::table::CaseTable;
use cssm_core::{ShadowPlan, View};
use cssm_runtime::{CasterInstance, MaskInputs, Options, PreparedFrame, ShadowService, read_back};

use super::function::{FunctionPipeline, VISIBILITY_FORMAT, offers_function};
use super::geometry::SceneBuffers;
use super::stopwatch::{PassTimes, Stopwatch};
use super::surface::Surface;
use super::{Gpu, GpuError, whole};
use crate::scene::Scene;

/// Which interface of a case resolves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum ResolveMethod {
    /// The generated function, called from a material with exact positions and normals.
    Function,
    /// The mask pass, from depth.
    Mask,
}

impl ResolveMethod {
    /// The function where the case declares one, else the mask.
    pub fn of(case: &LightCase) -> Self {
        if offers_function(case) { Self::Function } else { Self::Mask }
    }
}

/// A service with a scene's casters and the pipeline that resolves.
#[derive(Debug)]
pub struct CaseRunner {
    service: ShadowService,
    casters: Vec<CasterInstance>,
    resolver: Resolver,
}

#[derive(Debug)]
enum Resolver {
    Function(FunctionPipeline),
    Mask(MaskDepth, Axes),
}

impl CaseRunner {
    /// Creates the service of a generated table and gives it a scene.
    ///
    /// # Errors
    /// When the case lacks the interface or the device refuses.
    pub fn new(
        gpu: &Gpu,
        case: &LightCase,
        table: &CaseTable,
        scene: &Scene,
        buffers: &SceneBuffers,
        method: ResolveMethod,
    ) -> Result<Self, GpuError> {
        let options = Options { mask_format: VISIBILITY_FORMAT, ..Options::default() };
        let mut service = ShadowService::new(&gpu.device, &gpu.queue, table, &options)?;
        let casters = buffers.add_to(&mut service, scene)?;
        let resolver = match method {
            ResolveMethod::Function => Resolver::Function(FunctionPipeline::new(gpu, case, table, &service)?),
            ResolveMethod::Mask => {
                let depth = case.resolve.iter().find_map(|resolve| match resolve {
                    Resolve::Mask { depth, .. } => Some(*depth),
                    Resolve::Function { .. } => None,
                });
                let not_declared = || GpuError::NotDeclared { case: case.name.clone(), method: "mask" };
                Resolver::Mask(depth.ok_or_else(not_declared)?, case.axes)
            }
        };
        Ok(Self { service, casters, resolver })
    }

    /// Culls and uploads a frame.
    ///
    /// # Errors
    /// What the service says.
    pub fn prepare(&mut self, plan: &ShadowPlan, view: &View) -> Result<PreparedFrame, GpuError> {
        Ok(self.service.prepare(plan, view, &self.casters)?)
    }

    /// Captures a frame and returns the visibility of each pixel of a surface, 1 where lit and in the sky.
    ///
    /// # Errors
    /// What the service or the device says.
    pub fn visibility(
        &self,
        gpu: &Gpu,
        frame: &PreparedFrame,
        surface: &Surface,
    ) -> Result<Vec<f32>, GpuError> {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let target = gpu.texture(surface.size, VISIBILITY_FORMAT, usage)?;
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.service.capture(&mut encoder, frame, None)?;
        self.resolve(gpu, &mut encoder, frame, surface, &whole(&target), None)?;
        gpu.checked("a frame", || gpu.queue.submit([encoder.finish()]))?;
        let bytes = read_back::texture_bytes(&gpu.device, &gpu.queue, &target)?;
        Ok(bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
    }

    /// Captures and resolves a frame once, timed.
    ///
    /// # Errors
    /// What the service or the device says.
    pub fn time(
        &self,
        gpu: &Gpu,
        frame: &PreparedFrame,
        surface: &Surface,
        stopwatch: &Stopwatch,
    ) -> Result<PassTimes, GpuError> {
        let target = gpu.texture(surface.size, VISIBILITY_FORMAT, wgpu::TextureUsages::RENDER_ATTACHMENT)?;
        let target = whole(&target);
        stopwatch.time(
            gpu,
            &mut |encoder, timestamps| Ok(self.service.capture(encoder, frame, timestamps)?),
            &mut |encoder, timestamps| self.resolve(gpu, encoder, frame, surface, &target, timestamps),
        )
    }

    /// Depths of the map after the last capture.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn map(&self) -> Result<Vec<f32>, GpuError> {
        Ok(self.service.read_map()?)
    }

    fn resolve(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedFrame,
        surface: &Surface,
        target: &wgpu::TextureView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) -> Result<(), GpuError> {
        match &self.resolver {
            Resolver::Function(function) => {
                let pixels = function.bind(gpu, surface)?;
                function.record(encoder, &pixels, frame.shadow_bind_group(), target, timestamps);
            }
            Resolver::Mask(depth, axes) => {
                let depth = match depth {
                    MaskDepth::ReversedZ => &surface.reversed_z,
                    MaskDepth::Linear => &surface.linear_depths,
                };
                let inputs = MaskInputs { depth, normal: Some(&surface.vectors(*axes).normals) };
                self.service.mask(encoder, frame, &inputs, target, timestamps)?;
            }
        }
        Ok(())
    }
}
