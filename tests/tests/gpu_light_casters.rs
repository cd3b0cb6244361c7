//! Casters that the engine draws into the map of many lights: texel for texel what the service draws of the same casters,
//! drawn anew where they changed and nowhere else.

use cssm_codegen::{CasterEntry, generate};
use cssm_core::glam::{DAffine3, DQuat, DVec3};
use cssm_core::table::{CaseTable, CasterTable, caster_rows};
use cssm_core::{BoundingBox, Light, LightCase, View};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_runtime::lights::{
    CaseHandle, CasterLayer, EngineCaster, LightDescription, LightFacet, LightFrame, LightHandle,
    LightOptions,
};
use cssm_runtime::{
    CasterInstance, CasterPipelineDescription, CasterPipelines, LightService, MeshHandle, PreparedLights,
    ServiceError, read_back, wgpu,
};
use cssm_tests::gpu::casters::{Geometry, GeometryBuffers, buffer};
use cssm_tests::gpu::{TestDevice, exclusive};
use shaders_gen::shipped;

const SIDE: u32 = 512;
const SOURCE: &str = "fn placed(@location(0) position: vec3<f32>) -> vec3<f32> { return position; }";
const POSITIONS: wgpu::VertexBufferLayout = wgpu::VertexBufferLayout {
    array_stride: 12,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &wgpu::vertex_attr_array![0 => Float32x3],
};
const ROWS: wgpu::VertexBufferLayout = wgpu::VertexBufferLayout {
    array_stride: 48,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &wgpu::vertex_attr_array![1 => Float32x4, 2 => Float32x4, 3 => Float32x4],
};

/// A case, its table and the capture shaders around the engine's function.
struct Declared {
    case: LightCase,
    table: CaseTable,
    casters: CasterTable,
}

fn cases() -> Vec<Declared> {
    let declared = |(name, text)| {
        let case = pick_case(std::path::Path::new("case.cssm"), text, Some(name)).unwrap();
        let case = with_map_size(case, (SIDE, SIDE)).unwrap();
        let table = generate(&case).unwrap().table;
        let entry = CasterEntry::new("placed", "placed").source("engine.wgsl", SOURCE);
        Declared { casters: entry.compose(&case).unwrap(), table, case }
    };
    [("Sun", shipped::SUN), ("Lamp", shipped::LAMP)].map(declared).into()
}

/// Boxes on a ground; the first stay, the last one moves.
fn still() -> Vec<DAffine3> {
    let stand = |x: f64, z: f64, size: DVec3| {
        DAffine3::from_scale_rotation_translation(size, DQuat::from_rotation_y(x), DVec3::new(x, size.y, z))
    };
    vec![
        DAffine3::from_scale_rotation_translation(
            DVec3::new(30.0, 0.5, 30.0),
            DQuat::IDENTITY,
            DVec3::NEG_Y * 0.5,
        ),
        stand(-3.0, -2.0, DVec3::new(0.5, 1.5, 0.5)),
        stand(2.0, -4.0, DVec3::new(0.7, 0.6, 1.0)),
        stand(4.0, -9.0, DVec3::new(1.0, 2.5, 1.0)),
    ]
}

fn moving(place: f64) -> DAffine3 {
    DAffine3::from_scale_rotation_translation(
        DVec3::splat(0.4),
        DQuat::from_rotation_y(0.3),
        DVec3::new(place, 0.4, 1.0),
    )
}

/// Who draws what.
#[derive(Clone, Copy, PartialEq)]
enum Drawer {
    Service,
    Engine,
}

/// A service with a sun and two lamps, and an engine beside it.
struct Stage<'g> {
    gpu: &'g TestDevice,
    service: LightService,
    lights: Vec<LightHandle>,
    mesh: MeshHandle,
    buffers: GeometryBuffers,
    pipelines: Vec<CasterPipelines>,
    prepared: PreparedLights,
    static_drawer: Drawer,
    dynamic_drawer: Drawer,
    /// Casters that the engine forgets to draw.
    left_out: usize,
    calls: usize,
}

impl<'g> Stage<'g> {
    fn new(gpu: &'g TestDevice, cases: &[Declared], drawers: [Drawer; 2]) -> Self {
        let tables: Vec<_> = cases.iter().map(|one| (&one.case, &one.table)).collect();
        let options = LightOptions::default();
        let mut service = LightService::new(&gpu.device, &gpu.queue, &tables, &options).unwrap();
        let buffers = Geometry::cuboid([-1.0; 3], [1.0; 3]).upload(gpu);
        let mesh = service.add_mesh(&buffers.description()).unwrap();
        let pipelines = (0..)
            .zip(cases)
            .map(|(case, declared)| {
                let executor = service.executor(CaseHandle(case)).unwrap();
                let description = CasterPipelineDescription {
                    casters: &declared.casters,
                    bind_group_layouts: &[],
                    buffers: &[Some(POSITIONS), Some(ROWS)],
                    topology: wgpu::PrimitiveTopology::TriangleList,
                    strip_index_format: None,
                };
                executor.caster_pipelines(&description).unwrap()
            })
            .collect();
        let sun = Light::directional_travelling(DVec3::new(0.3, -1.0, -0.2)).unwrap();
        let lamp = |x: f64| Light::omni(DVec3::new(x, 3.0, -2.0), 12.0).unwrap();
        let lights = [(0, sun), (1, lamp(-1.0)), (1, lamp(3.0))];
        let lights = lights.map(|(case, light)| {
            let description = LightDescription::new(CaseHandle(case), light);
            service.add_light(&LightDescription { max_side_texels: 256, ..description }).unwrap()
        });
        let [static_drawer, dynamic_drawer] = drawers;
        Self {
            gpu,
            service,
            lights: lights.into(),
            mesh,
            buffers,
            pipelines,
            prepared: PreparedLights::new(),
            static_drawer,
            dynamic_drawer,
            left_out: 0,
            calls: 0,
        }
    }

    /// Draws a frame; `revision` is what the engine says of the moving box. Returns the map.
    fn frame(&mut self, place: f64, revision: u64) -> Vec<u8> {
        let mesh = self.mesh;
        let instance = |world_from_object| CasterInstance { mesh, world_from_object };
        let (still, moving) = (still(), [moving(place)]);
        let instances = [&still[..], &moving[..]].map(|list| list.iter().copied().map(instance));
        let [static_casters, dynamic_casters] = instances.map(|list| list.collect::<Vec<_>>());
        let engine = |list: &[DAffine3], first: u64| -> Vec<EngineCaster> {
            (first..)
                .zip(list)
                .map(|(revision, place)| EngineCaster::new(surrounded(place), revision))
                .collect()
        };
        let (of_static, of_dynamic) = (engine(&still, 1), engine(&moving, revision));
        let view = view();
        let mut frame = LightFrame::new(&view, &[], &[]);
        match self.static_drawer {
            Drawer::Service => frame.static_casters = &static_casters,
            Drawer::Engine => frame.static_engine_casters = &of_static,
        }
        match self.dynamic_drawer {
            Drawer::Service => frame.dynamic_casters = &dynamic_casters,
            Drawer::Engine => frame.dynamic_engine_casters = &of_dynamic,
        }
        self.service.prepare(&frame, &mut self.prepared).unwrap();

        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.calls = 0;
        let Self { service, gpu, buffers, pipelines, prepared, left_out, calls, lights, .. } = self;
        let draw = |pass: &mut wgpu::RenderPass, facet: LightFacet| {
            *calls += 1;
            assert!(lights.contains(&facet.light) && facet.plan.facets.len() > facet.facet.position);
            let list = match facet.layer {
                CasterLayer::Static => &still[*left_out..],
                CasterLayer::Dynamic => &moving[..],
            };
            // What no box reaches need not be drawn.
            let list = list.iter().filter(|place| facet.reached_by(&surrounded(place)));
            let rows: Vec<u8> = list
                .flat_map(|place| caster_rows(facet.plan, place).unwrap())
                .flatten()
                .flat_map(f32::to_le_bytes)
                .collect();
            if rows.is_empty() {
                return;
            }
            let rows = buffer(gpu, &rows, wgpu::BufferUsages::VERTEX);
            pass.set_pipeline(pipelines[facet.case.0 as usize].of(facet.facet.depth_order));
            pass.set_vertex_buffer(0, buffers.vertices.slice(..));
            pass.set_vertex_buffer(1, rows.slice(..));
            pass.set_index_buffer(buffers.indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..(buffers.indices.size() / 4) as u32, 0, 0..(rows.size() / 48) as u32);
        };
        service.capture_with(&mut encoder, prepared, None, draw).unwrap();
        gpu.queue.submit([encoder.finish()]);
        read_back::texture_bytes(&gpu.device, &gpu.queue, service.map()).unwrap()
    }
}

/// The box around a box.
fn surrounded(place: &DAffine3) -> BoundingBox {
    let half = (0..3).fold(DVec3::ZERO, |sum, axis| sum + place.matrix3.col(axis).abs());
    BoundingBox { min: place.translation - half, max: place.translation + half }
}

fn view() -> View {
    let eye = DVec3::new(0.0, 2.0, 8.0);
    View::perspective(eye, DVec3::ZERO, DVec3::Y, 1.0, 0.1, 100.0, (64, 64)).unwrap()
}

fn differing(one: &[u8], other: &[u8]) -> usize {
    one.chunks(4).zip(other.chunks(4)).filter(|(one, other)| one != other).count()
}

const WHO: [[Drawer; 2]; 3] =
    [[Drawer::Engine, Drawer::Engine], [Drawer::Service, Drawer::Engine], [Drawer::Engine, Drawer::Service]];

#[test]
fn the_engine_draws_what_the_service_draws() {
    let gpu = exclusive();
    let cases = cases();
    let frames = [(-1.5, 100), (-1.5, 100), (-0.5, 101), (0.5, 102), (0.5, 102)];
    let mut ours = Stage::new(&gpu, &cases, [Drawer::Service; 2]);
    let maps: Vec<_> = frames.iter().map(|(place, revision)| ours.frame(*place, *revision)).collect();
    assert!(differing(&maps[1], &maps[2]) > 50, "a box that moves is seen");
    for who in WHO {
        let mut stage = Stage::new(&gpu, &cases, who);
        let (mut calls, mut redrawn) = (Vec::new(), Vec::new());
        for ((place, revision), map) in frames.iter().zip(&maps) {
            let found = stage.frame(*place, *revision);
            assert_eq!(differing(&found, map), 0, "at {place}");
            assert_eq!(stage.calls, stage.prepared.report().engine_facets as usize);
            calls.push(stage.calls);
            redrawn.push(stage.prepared.report().redrawn_texels);
        }
        // Still frames ask for nothing; frames in which the box moves ask for the tiles that it reaches.
        assert!(calls[0] > 0 && calls[1] == 0 && calls[4] == 0, "{calls:?}");
        assert!(redrawn[3] > 0 && redrawn[3] < redrawn[0], "{redrawn:?}");
        if who == [Drawer::Service, Drawer::Engine] {
            let facets: usize = stage.prepared.report().lights.iter().map(|light| light.tiles.len()).sum();
            assert!(calls[2] > 0 && calls[3] > 0 && calls[3] < facets, "{calls:?} of {facets}");
        }
    }
}

#[test]
fn what_the_engine_keeps_to_itself_is_not_drawn() {
    let gpu = exclusive();
    let cases = cases();
    let mut ours = Stage::new(&gpu, &cases, [Drawer::Service; 2]);
    let mut silent = Stage::new(&gpu, &cases, [Drawer::Engine; 2]);
    ours.frame(-1.5, 100);
    silent.frame(-1.5, 100);

    // A box that moves without another number is another box, which is told by its own box alone.
    let moved = silent.frame(1.5, 100);
    assert_eq!(differing(&moved, &ours.frame(1.5, 100)), 0);

    // One that bends within its box and does not say so stays as it was; said, it is drawn.
    silent.left_out = 2;
    assert_eq!(differing(&silent.frame(1.5, 100), &moved), 0);
    assert_eq!(silent.calls, 0);
    let mut fresh = Stage::new(&gpu, &cases, [Drawer::Engine; 2]);
    fresh.left_out = 2;
    assert!(differing(&fresh.frame(1.5, 100), &moved) > 50, "a box that is left out is missed");
}

#[test]
fn frames_that_only_the_engine_can_draw_are_refused_without_it() {
    let gpu = exclusive();
    let cases = cases();
    let mut stage = Stage::new(&gpu, &cases, [Drawer::Engine; 2]);
    let view = view();
    let anywhere = EngineCaster { light: Some(stage.lights[1]), bounds_world: None, revision: 1 };
    let frame = LightFrame { dynamic_engine_casters: &[anywhere], ..LightFrame::new(&view, &[], &[]) };
    stage.service.prepare(&frame, &mut stage.prepared).unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let refused = stage.service.capture(&mut encoder, &stage.prepared, None);
    assert!(matches!(refused, Err(ServiceError::EngineCasters)), "{refused:?}");

    // A caster of one light is drawn for that light and no other.
    let mut asked = Vec::new();
    let draw = |_: &mut wgpu::RenderPass, facet: LightFacet| asked.push((facet.light, facet.layer));
    stage.service.capture_with(&mut encoder, &stage.prepared, None, draw).unwrap();
    assert!(!asked.is_empty());
    assert!(asked.iter().all(|one| *one == (stage.lights[1], CasterLayer::Dynamic)), "{asked:?}");

    // Boxes that hold nothing are named.
    let wrong = EngineCaster::new(BoundingBox { min: DVec3::ONE, max: DVec3::NAN }, 2);
    let frame = LightFrame { static_engine_casters: &[anywhere, wrong], ..LightFrame::new(&view, &[], &[]) };
    let error = stage.service.prepare(&frame, &mut stage.prepared).unwrap_err();
    assert!(matches!(error, ServiceError::EngineBounds { list: "static", caster: 1 }), "{error}");
}
