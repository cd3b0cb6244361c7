//! Many lights on the device: one service, one map, and the visibility of traced pixels under each light.

use cssm_core::table::CaseTable;
use cssm_core::{LightCase, ShadowPlan, View};
use cssm_runtime::lights::{LightCommands, LightFrame, LightHandle, LightOptions, LightReport, ViewId};
use cssm_runtime::{LightService, PreparedLights, read_back};

use super::function::{FunctionPipeline, VISIBILITY_FORMAT};
use super::surface::Surface;
use super::{Gpu, GpuError, whole};

/// A service of many lights and what reads its shadows.
#[derive(Debug)]
pub struct LightRunner<'g> {
    gpu: &'g Gpu,
    /// The service.
    pub service: LightService,
    functions: Vec<FunctionPipeline>,
    prepared: PreparedLights,
}

impl<'g> LightRunner<'g> {
    /// A service of some cases, which declare a function.
    ///
    /// # Errors
    /// When a case lacks the function or the device refuses.
    pub fn new(
        gpu: &'g Gpu,
        cases: &[(&LightCase, &CaseTable)],
        options: &LightOptions,
    ) -> Result<Self, GpuError> {
        let service = LightService::new(&gpu.device, &gpu.queue, cases, options)?;
        let mut functions = Vec::with_capacity(cases.len());
        for (index, (case, table)) in cases.iter().enumerate() {
            let not_declared = || GpuError::NotDeclared { case: case.name.clone(), method: "function" };
            let handle = cssm_runtime::lights::CaseHandle(index as u32);
            let executor = service.executor(handle).ok_or_else(not_declared)?;
            functions.push(FunctionPipeline::new(gpu, case, table, executor)?);
        }
        Ok(Self { gpu, service, functions, prepared: PreparedLights::new() })
    }

    /// Prepares a frame.
    ///
    /// # Errors
    /// What the service says.
    pub fn prepare(&mut self, frame: &LightFrame) -> Result<&LightReport, GpuError> {
        self.service.prepare(frame, &mut self.prepared)?;
        Ok(self.prepared.report())
    }

    /// Captures and submits the frame that was prepared last.
    ///
    /// # Errors
    /// What the service says.
    pub fn draw(&mut self) -> Result<(), GpuError> {
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.service.capture(&mut encoder, &self.prepared, None)?;
        self.gpu.checked("a frame of many lights", || self.gpu.queue.submit([encoder.finish()]))?;
        Ok(())
    }

    /// What the last frame cost.
    pub fn report(&self) -> &LightReport {
        self.prepared.report()
    }

    /// The visibility that the last frame gives to the pixels of a surface under one light; 1 where lit and in the sky.
    ///
    /// # Errors
    /// What the service or the device says.
    pub fn visibility(&self, light: LightHandle, surface: &Surface) -> Result<Vec<f32>, GpuError> {
        let case = self.service.light(light).map_or(0, |description| description.case.0 as usize);
        let (Some(function), Some(shadow)) =
            (self.functions.get(case), self.prepared.shadow_bind_group(light))
        else {
            return Ok(vec![1.0; surface.size.0 as usize * surface.size.1 as usize]);
        };
        let gpu = self.gpu;
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let target = gpu.texture(surface.size, VISIBILITY_FORMAT, usage)?;
        let mut encoder = gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let pixels = function.bind(gpu, surface)?;
        function.record(&mut encoder, &pixels, Some(shadow), &whole(&target), None);
        gpu.checked("the shadows of a light", || gpu.queue.submit([encoder.finish()]))?;
        let bytes = read_back::texture_bytes(&gpu.device, &gpu.queue, &target)?;
        Ok(bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
    }

    /// The plan of a light relative to a view's eye, if the last frame has one.
    pub fn plan(&self, light: LightHandle, view: &View) -> Option<ShadowPlan> {
        self.service.plan(light, ViewId::default()).map(|plan| plan.rebased(view))
    }

    /// What the tiles of every light draw in the last frame. Blocks.
    ///
    /// # Errors
    /// What the service says.
    pub fn commands(&self) -> Result<Vec<LightCommands>, GpuError> {
        Ok(self.service.read_commands(&self.prepared)?)
    }

    /// Stored depths of the shared map. Blocks.
    ///
    /// # Errors
    /// A lost device.
    pub fn map(&self) -> Result<Vec<f32>, GpuError> {
        let bytes = read_back::texture_bytes(&self.gpu.device, &self.gpu.queue, self.service.map())?;
        Ok(bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect())
    }
}
