//! A case on the device with the yard's casters: the map, and visibility through every interface that it declares.

use cssm_codegen::generate;
use cssm_core::case::{Axes, LightCase, MaskDepth, Resolve};
use cssm_core::table::CaseTable;
use cssm_core::twin::DepthMap;
use cssm_core::{ShadowPlan, View};
use cssm_runtime::{CasterInstance, MaskInputs, Options, PreparedFrame, ShadowService, wgpu};

use super::device::TestDevice;
use super::images;
use super::resolve::{Material, Visible};
use super::yard::Yard;

/// Everything drawn frame after frame with one case.
#[derive(Debug)]
pub struct Stage<'a> {
    gpu: &'a TestDevice,
    /// The service.
    pub service: ShadowService,
    interfaces: &'a [Resolve],
    axes: Axes,
    material: Option<Material>,
    casters: Vec<CasterInstance>,
}

/// One frame.
#[derive(Debug)]
pub struct Drawn {
    /// The plan it was drawn with.
    pub plan: ShadowPlan,
    /// The map as the device stored it.
    pub map: DepthMap,
    /// The mask, if the case declares one.
    pub mask: Option<Vec<u8>>,
    /// What the engine's material got from the generated function, if the case declares one.
    pub material: Option<Vec<u8>>,
}

impl<'a> Stage<'a> {
    /// Generates the case and uploads the yard.
    ///
    /// # Panics
    /// When generator or service refuse.
    pub fn new(gpu: &'a TestDevice, yard: &Yard, case: &'a LightCase, options: &Options) -> Self {
        let table = generate(case).expect("a checked case generates").table;
        Self::of_table(gpu, yard, case, &table, options)
    }

    /// The same with a table that is not quite what the case generates.
    ///
    /// # Panics
    /// When the service refuses.
    pub fn of_table(
        gpu: &'a TestDevice,
        yard: &Yard,
        case: &'a LightCase,
        table: &CaseTable,
        options: &Options,
    ) -> Self {
        let mut service = ShadowService::new(&gpu.device, &gpu.queue, table, options)
            .expect("the device serves every test case");
        let buffers = yard.upload(gpu);
        let casters = yard.add_to(&mut service, &buffers).expect("the yard's meshes are sound");
        let function = case.resolve.iter().any(|interface| matches!(interface, Resolve::Function { .. }));
        let arguments = if case.bias.reads_normal() { "position.xyz, normal" } else { "position.xyz" };
        let material = function.then(|| Material::new(gpu, table, &service, arguments));
        Self { gpu, service, interfaces: &case.resolve, axes: case.axes, material, casters }
    }

    /// The map that the device captures for a plan.
    ///
    /// # Panics
    /// When the plan belongs to another case.
    pub fn capture(&mut self, plan: &ShadowPlan, view: &View) -> DepthMap {
        let (frame, encoder) = self.begin(plan, view);
        self.gpu.queue.submit([encoder.finish()]);
        drop(frame);
        self.map()
    }

    /// The map that the device captures of one place of the yard.
    ///
    /// # Panics
    /// When the plan belongs to another case or there is no such place.
    pub fn capture_place(&mut self, plan: &ShadowPlan, view: &View, place: usize) -> DepthMap {
        let all = std::mem::take(&mut self.casters);
        self.casters = vec![all[place]];
        let map = self.capture(plan, view);
        self.casters = all;
        map
    }

    /// Captures and resolves in one submission.
    ///
    /// # Panics
    /// When the plan belongs to another case.
    pub fn draw(&mut self, plan: ShadowPlan, view: &View, visible: &Visible) -> Drawn {
        let (frame, mut encoder) = self.begin(&plan, view);
        let gpu = self.gpu;
        let target = || images::target(gpu, visible.size, wgpu::TextureFormat::R8Unorm);
        let normals = images::vector_texture(gpu, visible.size, &visible.normals(self.axes));
        let normals = normals.create_view(&Default::default());
        let mask = self.record_mask(&mut encoder, &frame, view, visible);

        // The engine's own material.
        let material = self.material.as_ref().map(|material| {
            let positions = images::vector_texture(gpu, visible.size, &visible.positions(self.axes));
            let positions = positions.create_view(&Default::default());
            let lit = target();
            let target = lit.create_view(&Default::default());
            material.draw(gpu, &mut encoder, &frame, &positions, &normals, &target);
            lit
        });
        gpu.queue.submit([encoder.finish()]);

        let red = |image: wgpu::Texture| images::red(gpu, &image);
        Drawn { plan, map: self.map(), mask: mask.map(red), material: material.map(red) }
    }

    /// Masks of several plans for one view, all prepared before any is recorded, in one submission.
    ///
    /// # Panics
    /// When a plan belongs to another case, or the case declares no mask.
    pub fn masks_together(&mut self, plans: &[&ShadowPlan], view: &View, visible: &Visible) -> Vec<Vec<u8>> {
        let prepare = |plan: &&ShadowPlan| self.service.prepare(plan, view, &self.casters);
        let frames: Vec<_> =
            plans.iter().map(prepare).collect::<Result<_, _>>().expect("the plans belong to the case");
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        let record = |frame: &PreparedFrame| {
            self.service.capture(&mut encoder, frame, None).expect("the frame is fresh");
            self.record_mask(&mut encoder, frame, view, visible).expect("the case declares a mask")
        };
        let masks: Vec<_> = frames.iter().map(record).collect();
        self.gpu.queue.submit([encoder.finish()]);
        masks.iter().map(|mask| images::red(self.gpu, mask)).collect()
    }

    /// Records the mask pass over the engine's depth and normals, if the case declares one.
    fn record_mask(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedFrame,
        view: &View,
        visible: &Visible,
    ) -> Option<wgpu::Texture> {
        let (gpu, size) = (self.gpu, visible.size);
        let declared = self.interfaces.iter().find_map(|interface| match interface {
            Resolve::Mask { depth, .. } => Some(*depth),
            Resolve::Function { .. } => None,
        });
        let depth = match declared? {
            MaskDepth::ReversedZ => images::depth_texture(gpu, size, &visible.reversed_depths(view)),
            MaskDepth::Linear => images::float_texture(gpu, size, &visible.linear_depths()),
        };
        let depth = depth.create_view(&Default::default());
        let normals = images::vector_texture(gpu, size, &visible.normals(self.axes));
        let normals = normals.create_view(&Default::default());
        let inputs = MaskInputs { depth: &depth, normal: Some(&normals) };
        let target = images::target(gpu, size, wgpu::TextureFormat::R8Unorm);
        let target_view = target.create_view(&Default::default());
        self.service
            .mask(encoder, frame, &inputs, &target_view, None)
            .expect("the inputs are what the case declares");
        Some(target)
    }

    /// A frame with its capture recorded.
    fn begin(&mut self, plan: &ShadowPlan, view: &View) -> (PreparedFrame, wgpu::CommandEncoder) {
        let frame = self.service.prepare(plan, view, &self.casters).expect("the plan belongs to the case");
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.service.capture(&mut encoder, &frame, None).expect("the frame is fresh");
        (frame, encoder)
    }

    fn map(&self) -> DepthMap {
        let size = self.service.map().size();
        let depths = self.service.read_map().expect("the device is alive");
        let depths = depths.into_iter().map(f64::from).collect();
        DepthMap { width: size.width, height: size.height, depths }
    }
}
