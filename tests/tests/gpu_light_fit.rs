//! Lights whose plans follow what is seen: the service measures the engine's depth by itself, plans by it as if it had been
//! handed in, and does without where it is missing.

use cssm_core::case::{Fit, MaskDepth, MaskNormal, Resolve};
use cssm_core::fit::DepthHistogram;
use cssm_core::glam::DVec3;
use cssm_core::plan::PlanRequest;
use cssm_core::table::CaseTable;
use cssm_core::{BoundingBox, Light, LightCase, SceneBounds, ShadowPlan, View};
use cssm_runtime::lights::{CaseHandle, LightDescription, LightFrame, LightHandle, LightOptions, ViewId};
use cssm_runtime::{
    LightService, PreparedLights, ServiceError, depth_reduction_requirements, features_and_limits, wgpu,
};
use cssm_tests::gpu::{TestDevice, new_device};

const SIZE: (u32, u32) = (200, 100);
const SIDE: u32 = 512;

fn declared(fit: Fit) -> (LightCase, CaseTable) {
    let mask = Resolve::Mask { depth: MaskDepth::Linear, normal: MaskNormal::Reconstructed };
    let case = LightCase::builder("Sun").map_size_texels(SIDE, SIDE).fit(fit).resolve(&[mask]);
    let case = case.build().unwrap();
    let table = cssm_codegen::generate(&case).unwrap().table;
    (case, table)
}

/// A device that measures depth, or one that cannot.
fn device(table: &CaseTable, measures: bool) -> TestDevice {
    let TestDevice { adapter, .. } = new_device(wgpu::Features::empty());
    let needed = features_and_limits(&adapter, table).unwrap();
    let depth = depth_reduction_requirements(&adapter).expect("the adapter measures depth");
    let limits = match measures {
        true => needed.limits.or_better_values_from(&depth.limits),
        false => needed.limits,
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        required_features: needed.features,
        required_limits: limits,
        ..Default::default()
    }))
    .expect("the adapter refused what it offers");
    TestDevice { adapter, device, queue }
}

fn view(x: f64) -> View {
    let eye = DVec3::new(x, 6.0, 0.0);
    View::perspective(eye, eye + DVec3::new(0.0, -0.4, -10.0), DVec3::Y, 1.0, 0.25, 400.0, SIZE).unwrap()
}

fn sun() -> Light {
    Light::directional_travelling(DVec3::new(0.4, -1.0, -0.2)).unwrap()
}

fn bounds() -> SceneBounds {
    let ground = BoundingBox { min: DVec3::new(-400.0, 0.0, -400.0), max: DVec3::new(400.0, 12.0, 400.0) };
    SceneBounds::of(Some(ground))
}

/// Sky above, a wall at some metres below.
fn metres(wall: f32) -> Vec<f32> {
    let pixel = |index: u32| if index / SIZE.0 < 20 { 0.0 } else { wall + 0.01 * (index % SIZE.0) as f32 };
    (0..SIZE.0 * SIZE.1).map(pixel).collect()
}

/// A service with one sun, and the engine's depth.
struct Stage {
    case: LightCase,
    gpu: TestDevice,
    service: LightService,
    light: LightHandle,
    depth: wgpu::Texture,
    prepared: PreparedLights,
}

impl Stage {
    fn new(fit: Fit, measures: bool) -> Self {
        let (case, table) = declared(fit);
        let gpu = device(&table, measures);
        let options = LightOptions::default();
        let mut service = LightService::new(&gpu.device, &gpu.queue, &[(&case, &table)], &options).unwrap();
        let light = service.add_light(&LightDescription::new(CaseHandle(0), sun())).unwrap();
        let depth = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: SIZE.0, height: SIZE.1, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::R32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        Self { case, gpu, service, light, depth, prepared: PreparedLights::new() }
    }

    fn prepare(&mut self, id: ViewId, view: &View, depth: Option<&DepthHistogram>) {
        let frame = LightFrame { view_id: id, bounds: bounds(), depth, ..LightFrame::new(view, &[], &[]) };
        self.service.prepare(&frame, &mut self.prepared).unwrap();
    }

    /// A whole frame; with a wall its depth is observed. Says whether it is measured.
    fn frame(&mut self, id: ViewId, view: &View, wall: Option<f32>) -> bool {
        self.prepare(id, view, None);
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.service.capture(&mut encoder, &self.prepared, None).unwrap();
        let measured = wall.is_some_and(|wall| self.observe(&mut encoder, id, view, wall).unwrap());
        self.gpu.queue.submit([encoder.finish()]);
        measured
    }

    fn observe(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        id: ViewId,
        view: &View,
        wall: f32,
    ) -> Result<bool, ServiceError> {
        let bytes: Vec<u8> = metres(wall).iter().flat_map(|texel| texel.to_le_bytes()).collect();
        let layout =
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIZE.0), rows_per_image: None };
        self.gpu.queue.write_texture(self.depth.as_image_copy(), &bytes, layout, self.depth.size());
        self.service.observe_depth(encoder, id, view, &self.depth.create_view(&Default::default()))
    }

    fn wait(&self) {
        self.gpu.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
    }

    /// A plan in the place of another, by some depth.
    fn planned(&self, place: &ShadowPlan, view: &View, depth: Option<&DepthHistogram>) -> ShadowPlan {
        let (case, sun) = (&self.case, sun());
        let request = PlanRequest::new(case, view, &sun, bounds());
        PlanRequest { region: Some(place.region), depth, ..request }.plan().unwrap()
    }

    fn plan(&self, id: ViewId) -> ShadowPlan {
        self.service.plan(self.light, id).unwrap().clone()
    }
}

const FIRST: ViewId = ViewId(0);
const SECOND: ViewId = ViewId(1);

#[test]
fn plans_follow_observed_depth_as_if_it_had_been_handed_in() {
    for fit in [Fit::DepthMinMax, Fit::Histogram] {
        let (view, other) = (view(0.0), view(30.0));
        let mut stage = Stage::new(fit, true);
        assert!(stage.frame(FIRST, &view, Some(40.0)));
        stage.frame(SECOND, &other, None);
        let before = stage.plan(FIRST);
        stage.wait();
        assert!(stage.frame(FIRST, &view, Some(40.0)));
        stage.frame(SECOND, &other, None);
        let after = stage.plan(FIRST);
        assert!(before != after, "{}: what is seen at 40 m draws texels there", fit.name());
        let expected = DepthHistogram { latency_frames: 1, ..DepthHistogram::measure(&view, metres(40.0)) };
        assert_eq!(stage.service.observed_depth(FIRST), Some(&expected));

        // The same, handed in.
        let mut handed = Stage::new(fit, true);
        handed.prepare(FIRST, &view, None);
        assert!(handed.plan(FIRST) == before);
        handed.prepare(SECOND, &other, None);
        handed.prepare(FIRST, &view, Some(&expected));
        assert!(handed.plan(FIRST) == after, "{}", fit.name());

        // Both are what the case plans by that depth; a view that was never observed is planned without.
        assert!(after == stage.planned(&after, &view, Some(&expected)));
        assert!(after != stage.planned(&after, &view, None));
        assert_eq!(stage.service.observed_depth(SECOND), None);
        let blind = stage.plan(SECOND);
        assert!(blind == stage.planned(&blind, &other, None));

        // While nothing changes nothing is planned anew; a wall that comes near is followed.
        stage.wait();
        stage.frame(FIRST, &view, Some(5.0));
        assert_eq!((stage.prepared.report().planned, stage.plan(FIRST) == after), (0, true));
        stage.wait();
        stage.frame(FIRST, &view, Some(5.0));
        assert_eq!(stage.prepared.report().planned, 1);
        assert!(stage.plan(FIRST) != after);
    }
}

#[test]
fn depth_that_is_missing_or_old_is_done_without() {
    let view = view(0.0);
    let mut stage = Stage::new(Fit::Histogram, true);
    stage.frame(FIRST, &view, Some(40.0));
    let without = stage.plan(FIRST);

    // Nobody waits: measured depth grows older, and is forgotten in the end.
    stage.wait();
    for latency in 1..=30 {
        stage.frame(FIRST, &view, None);
        assert_eq!(stage.service.observed_depth(FIRST).unwrap().latency_frames, latency);
    }
    stage.frame(FIRST, &view, None);
    assert_eq!(stage.service.observed_depth(FIRST), None);
    stage.service.remove_light(stage.light);
    stage.light = stage.service.add_light(&LightDescription::new(CaseHandle(0), sun())).unwrap();
    stage.frame(FIRST, &view, None);
    let again = stage.plan(FIRST);
    assert_eq!(
        (again.p95_pixels(&view), again.facets.len()),
        (without.p95_pixels(&view), without.facets.len())
    );

    // Encoders that are dropped take their measurement along, however many.
    for _ in 0..10 {
        stage.prepare(FIRST, &view, None);
        let mut encoder = stage.gpu.device.create_command_encoder(&Default::default());
        assert!(stage.observe(&mut encoder, FIRST, &view, 40.0).unwrap());
    }
    stage.wait();
    stage.prepare(FIRST, &view, None);
    assert_eq!(stage.service.observed_depth(FIRST), None);

    // Measurements that have not come do not hold the next frames up.
    assert!(stage.frame(FIRST, &view, Some(40.0)));
    stage.wait();
    stage.prepare(FIRST, &view, None);
    assert_eq!(stage.service.observed_depth(FIRST).unwrap().latency_frames, 1);
}

#[test]
fn what_no_case_asks_for_and_no_device_can_do_is_not_measured() {
    for (fit, measures) in [(Fit::None, true), (Fit::Bounds, true), (Fit::Histogram, false)] {
        let view = view(0.0);
        let mut stage = Stage::new(fit, measures);
        assert!(!stage.frame(FIRST, &view, Some(40.0)));
        let before = stage.plan(FIRST);
        stage.wait();
        assert!(!stage.frame(FIRST, &view, Some(40.0)));
        assert!(stage.plan(FIRST) == before);
        assert_eq!(stage.service.observed_depth(FIRST), None);
    }

    // A texture of another kind is refused, and nothing breaks.
    let view = view(0.0);
    let mut stage = Stage::new(Fit::Histogram, true);
    let wrong = stage.gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: stage.depth.size(),
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba8Uint,
        usage: wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    let wrong = wrong.create_view(&Default::default());
    let mut encoder = stage.gpu.device.create_command_encoder(&Default::default());
    assert!(stage.service.observe_depth(&mut encoder, FIRST, &view, &wrong).is_err());
    assert!(stage.frame(FIRST, &view, Some(40.0)));
}
