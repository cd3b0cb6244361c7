//! What the engine's own functions place is captured as the service captures it: texel for texel where both start from
//! the same numbers, and elsewhere where it is displaced.

use cssm_codegen::{CasterEntry, dsl, generate};
use cssm_core::case::LightCase;
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::plan::DepthOrder;
use cssm_core::table::{CasterTable, caster_rows};
use cssm_core::{SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{
    AlphaMask, CasterInstance, CasterPipelineDescription, CasterPipelines, Command, EngineFacet,
    MeshDescription, MeshHandle, Options, PreparedFrame, ServiceError, ShadowService, wgpu,
};
use cssm_tests::gpu::casters::{Geometry, GeometryBuffers, buffer};
use cssm_tests::gpu::yard::{suns, views};
use cssm_tests::gpu::{TestDevice, Yard, exclusive, images};

/// Four joints to a vertex, and leaves with holes.
const SOURCE: &str = "
struct Vertex { @location(0) position: vec3<f32> }
struct Leaf { @location(0) position: vec3<f32>, @location(4) uv: vec2<f32> }
@group(1) @binding(0) var<uniform> palette: array<mat4x4<f32>, 2>;
@group(1) @binding(2) var leaves: texture_2d<f32>;
@group(1) @binding(3) var leaves_sampler: sampler;

fn skinned(vertex: Vertex) -> vec3<f32> {
    let matrix = 0.5 * palette[0] + 0.5 * palette[1];
    return (matrix * vec4<f32>(vertex.position, 1.0)).xyz;
}

fn leaf(vertex: Leaf) -> vec3<f32> {
    return vertex.position;
}

fn leaf_alpha(uv: vec2<f32>) -> f32 {
    return textureSample(leaves, leaves_sampler, uv).a;
}
";

fn case(body: &str) -> LightCase {
    let text = format!("case Engine {{ map: {{ size: 512 x 512 }}, {body} }}");
    dsl::parse_file("case", &text).unwrap().remove(0)
}

/// Cases with every capture shader that takes entries.
fn cases() -> [LightCase; 4] {
    [
        case(""),
        case("configurations: [four_plane]"),
        case("configurations: [one_plane], distribution: perspective, stretch: vertex"),
        case("technique: standard, shadow_distance: 60 m"),
    ]
}

/// Column-major translations for the two joints.
fn palette(shifts: [[f32; 3]; 2]) -> Vec<u8> {
    let matrix =
        |[x, y, z]: [f32; 3]| [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, x, y, z, 1.0_f32];
    shifts.iter().flat_map(|shift| matrix(*shift)).flat_map(f32::to_le_bytes).collect()
}

/// The engine: its bindings, its pipelines, its buffers.
struct Engine {
    group: wgpu::BindGroup,
    pipelines: CasterPipelines,
}

impl Engine {
    fn new(
        gpu: &TestDevice,
        service: &ShadowService,
        casters: &CasterTable,
        buffers: &[Option<wgpu::VertexBufferLayout>],
        entries: &[(wgpu::ShaderStages, wgpu::BindingType, u32, wgpu::BindingResource)],
    ) -> Self {
        let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &entries
                .iter()
                .map(|(visibility, ty, binding, _)| wgpu::BindGroupLayoutEntry {
                    binding: *binding,
                    visibility: *visibility,
                    ty: *ty,
                    count: None,
                })
                .collect::<Vec<_>>(),
        });
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &entries
                .iter()
                .map(|(_, _, binding, resource)| wgpu::BindGroupEntry {
                    binding: *binding,
                    resource: resource.clone(),
                })
                .collect::<Vec<_>>(),
        });
        let pipelines = service
            .caster_pipelines(&CasterPipelineDescription {
                casters,
                bind_group_layouts: &[None, Some(&layout)],
                buffers,
                topology: wgpu::PrimitiveTopology::TriangleList,
                strip_index_format: None,
            })
            .unwrap();
        Self { group, pipelines }
    }
}

const UNIFORM: wgpu::BindingType = wgpu::BindingType::Buffer {
    ty: wgpu::BufferBindingType::Uniform,
    has_dynamic_offset: false,
    min_binding_size: None,
};

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

/// The draws of a frame's facet: mesh and instances.
fn draws(frame: &PreparedFrame, position: usize) -> Vec<(MeshHandle, std::ops::Range<u32>)> {
    let (mut facet, mut bound, mut found) = (None, None, Vec::new());
    for command in &frame.commands().commands {
        match command {
            Command::Facet { facet: next, .. } => facet = Some(next.0 as usize),
            Command::Mesh(mesh) => bound = Some(*mesh),
            Command::Draw { instances, .. } if facet == Some(position) => {
                found.push((bound.unwrap(), instances.clone()));
            }
            _ => {}
        }
    }
    found
}

fn read(service: &ShadowService, gpu: &TestDevice, encoder: wgpu::CommandEncoder) -> Vec<f32> {
    gpu.queue.submit([encoder.finish()]);
    service.read_map().unwrap()
}

fn differing(one: &[f32], other: &[f32]) -> usize {
    one.iter().zip(other).filter(|(one, other)| one != other).count()
}

/// A yard on the device, and what the service captures of it.
struct Standard {
    meshes: Vec<MeshHandle>,
    buffers: Vec<GeometryBuffers>,
    frame: PreparedFrame,
    /// The same plan without casters of the service's own.
    empty: PreparedFrame,
    map: Vec<f32>,
}

impl Standard {
    fn new(
        gpu: &TestDevice,
        service: &mut ShadowService,
        yard: &Yard,
        plan: &ShadowPlan,
        view: &View,
    ) -> Self {
        let buffers: Vec<_> = yard.geometries.iter().map(|geometry| geometry.upload(gpu)).collect();
        let meshes: Vec<_> =
            buffers.iter().map(|buffers| service.add_mesh(&buffers.description()).unwrap()).collect();
        let places = yard.places.iter();
        let instances: Vec<_> = places
            .map(|(shape, world_from_object)| CasterInstance {
                mesh: meshes[*shape],
                world_from_object: *world_from_object,
            })
            .collect();
        let frame = service.prepare(plan, view, &instances).unwrap();
        let empty = service.prepare(plan, view, &[]).unwrap();
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        service.capture(&mut encoder, &frame, None).unwrap();
        let map = read(service, gpu, encoder);
        Self { meshes, buffers, frame, empty, map }
    }
}

#[test]
fn an_entry_draws_what_the_service_draws() {
    let gpu = exclusive();
    let yard = Yard::new();
    for case in cases() {
        let table = generate(&case).unwrap().table;
        let entry = CasterEntry::new("skinned", "skinned").source("engine.wgsl", SOURCE);
        let casters = entry.compose(&case).unwrap();
        for clamp_in_fragments in [false, true] {
            let options = Options { clamp_in_fragments, ..Options::default() };
            let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &options).unwrap();
            let (mut orders, mut changed) = (Vec::new(), 0);
            for (view, sun) in views((160, 90)).iter().zip(suns()) {
                let Ok(plan) = plan(&case, view, &sun, &SceneBounds::default()) else { continue };
                orders.push(plan.depth_order);
                let standard = Standard::new(&gpu, &mut service, &yard, &plan, view);
                let rows = bytes(&standard.frame);
                let rows = buffer(&gpu, &rows, wgpu::BufferUsages::VERTEX);
                let capture = |shifts| {
                    let palette = buffer(&gpu, &palette(shifts), wgpu::BufferUsages::UNIFORM);
                    let binding = (wgpu::ShaderStages::VERTEX, UNIFORM, 0, palette.as_entire_binding());
                    let layouts = [Some(POSITIONS), Some(ROWS)];
                    let engine = Engine::new(&gpu, &service, &casters, &layouts, &[binding]);
                    let mut encoder = gpu.device.create_command_encoder(&Default::default());
                    let draw = |pass: &mut wgpu::RenderPass, facet: EngineFacet| {
                        pass.set_pipeline(engine.pipelines.of(facet.depth_order));
                        pass.set_bind_group(1, &engine.group, &[]);
                        pass.set_vertex_buffer(1, rows.slice(..));
                        for (mesh, instances) in draws(&standard.frame, facet.position) {
                            let shape = standard.meshes.iter().position(|known| *known == mesh).unwrap();
                            let buffers = &standard.buffers[shape];
                            pass.set_vertex_buffer(0, buffers.vertices.slice(..));
                            pass.set_index_buffer(buffers.indices.slice(..), wgpu::IndexFormat::Uint32);
                            pass.draw_indexed(0..(buffers.indices.size() / 4) as u32, 0, instances);
                        }
                    };
                    service.capture_with(&mut encoder, &standard.empty, &plan, None, draw).unwrap();
                    read(&service, &gpu, encoder)
                };
                // Joints whose blend is no movement, and one that moves everything.
                let still = capture([[0.25, -2.0, 8.0], [-0.25, 2.0, -8.0]]);
                let moved = capture([[0.0, 0.0, 0.0], [0.0, 1.5, 0.0]]);
                let what = format!("{:?}, clamped {clamp_in_fragments}", case.technique.name);
                assert_eq!(differing(&still, &standard.map), 0, "{what}");
                changed += differing(&moved, &standard.map);
            }
            assert!(changed > 500, "{changed} texels show that everything moved");
            assert!(!orders.is_empty());
            if case.may_reverse_depth() {
                assert!(orders.contains(&DepthOrder::Reversed) || orders.contains(&DepthOrder::Standard));
            }
        }
    }
}

fn bytes(frame: &PreparedFrame) -> Vec<u8> {
    let rows = frame.commands().rows.iter();
    rows.flat_map(|rows| rows.0).flatten().flat_map(f32::to_le_bytes).collect()
}

#[test]
fn positions_in_world_axes_and_in_the_capture_axes_land_in_the_same_places() {
    let gpu = exclusive();
    let case = case("configurations: [four_plane]");
    let table = generate(&case).unwrap().table;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let (view, sun) = (&views((160, 90))[0], &suns()[0]);
    let plan = plan(&case, view, sun, &SceneBounds::default()).unwrap();
    // The yard's ground alone: one object, placed in the world by the rows of a translation.
    let yard = Yard::new();
    let (shape, world_from_object) = yard.places[0];
    let yard = Yard { places: vec![(shape, world_from_object)], ..yard };
    let standard = Standard::new(&gpu, &mut service, &yard, &plan, view);
    let geometry = &standard.buffers[shape];
    let origin = view.eye_world.floor();
    for world in [true, false] {
        let transform = match world {
            // What the engine knows: its object relative to an origin near the eye; what it asks for: the origin's rows.
            true => DAffine3::from_translation(world_from_object.translation - origin),
            false => {
                let rows = caster_rows(&plan, &world_from_object).unwrap();
                let column = |k: usize| DVec3::new(rows[0][k].into(), rows[1][k].into(), rows[2][k].into());
                DAffine3::from_cols(column(0), column(1), column(2), column(3))
            }
        };
        let source = "
            struct Placed { x: vec4<f32>, y: vec4<f32>, z: vec4<f32> }
            @group(1) @binding(1) var<uniform> object: Placed;
            fn placed(@location(0) position: vec3<f32>) -> vec3<f32> {
                let point = vec4<f32>(position, 1.0);
                return vec3<f32>(dot(object.x, point), dot(object.y, point), dot(object.z, point));
            }";
        let entry = CasterEntry::new("placed", "placed").source("placed.wgsl", source);
        let entry = if world { entry.world(1, 0) } else { entry.capture_axes() };
        let casters = entry.compose(&case).unwrap();
        let rows = |rows: [[f32; 4]; 3]| -> Vec<u8> {
            rows.as_flattened().iter().flat_map(|value| value.to_le_bytes()).collect()
        };
        let of_affine = |affine: &DAffine3| {
            let row = |k: usize| affine.matrix3.row(k).extend(affine.translation[k]).as_vec4().to_array();
            [row(0), row(1), row(2)]
        };
        let object = buffer(&gpu, &rows(of_affine(&transform)), wgpu::BufferUsages::UNIFORM);
        let axes = caster_rows(&plan, &DAffine3::from_translation(origin)).unwrap();
        let axes = buffer(&gpu, &rows(axes), wgpu::BufferUsages::UNIFORM);
        let stage = wgpu::ShaderStages::VERTEX;
        let mut entries = vec![(stage, UNIFORM, 1, object.as_entire_binding())];
        if world {
            entries.push((stage, UNIFORM, 0, axes.as_entire_binding()));
        }
        assert_eq!(casters.bindings.len(), entries.len());
        let engine = Engine::new(&gpu, &service, &casters, &[Some(POSITIONS)], &entries);
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let draw = |pass: &mut wgpu::RenderPass, facet: EngineFacet| {
            if draws(&standard.frame, facet.position).is_empty() {
                return;
            }
            pass.set_pipeline(engine.pipelines.of(facet.depth_order));
            pass.set_bind_group(1, &engine.group, &[]);
            pass.set_vertex_buffer(0, geometry.vertices.slice(..));
            pass.set_index_buffer(geometry.indices.slice(..), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..(geometry.indices.size() / 4) as u32, 0, 0..1);
        };
        service.capture_with(&mut encoder, &standard.empty, &plan, None, draw).unwrap();
        let map = read(&service, &gpu, encoder);
        let cleared = plan.depth_order.cleared() as f32;
        let covered = standard.map.iter().filter(|depth| **depth != cleared).count();
        let far = map.iter().zip(&standard.map).filter(|(one, other)| (*one - *other).abs() > 1e-4).count();
        assert!(covered > 20_000 && far * 500 < covered, "world {world}: {far} of {covered}");
    }
}

#[test]
fn holes_of_the_engine_are_those_of_the_service() {
    let gpu = exclusive();
    let alpha: Vec<u8> = (0..64).map(|texel| if (texel + texel / 8) % 2 == 0 { 230 } else { 20 }).collect();
    let texture = images::alpha_texture(&gpu, (8, 8), &alpha).create_view(&Default::default());
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor::default());
    let quad = Geometry::quad([-4.0, 0.5, -9.0], [8.0, 0.0, 1.0], [0.0, 6.0, -2.0]).upload(&gpu);
    let uvs: Vec<u8> =
        [0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0_f32].iter().flat_map(|v| v.to_le_bytes()).collect();
    let uvs = buffer(&gpu, &uvs, wgpu::BufferUsages::VERTEX);
    for configuration in ["face_columns", "four_plane"] {
        let case = case(&format!("configurations: [{configuration}], casters: alpha_tested"));
        let table = generate(&case).unwrap().table;
        let entry = CasterEntry::new("leaf", "leaf").alpha("leaf_alpha", 0.5).rows_at(1);
        let casters = entry.source("engine.wgsl", SOURCE).compose(&case).unwrap();
        for clamp_in_fragments in [false, true] {
            let options = Options { clamp_in_fragments, ..Options::default() };
            let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &options).unwrap();
            let (view, sun) = (&views((160, 90))[0], &suns()[0]);
            let plan = plan(&case, view, sun, &SceneBounds::default()).unwrap();
            let mask = AlphaMask {
                uvs: &uvs,
                offset_bytes: 0,
                stride_bytes: 8,
                format: wgpu::VertexFormat::Float32x2,
                texture: &texture,
                sampler: &sampler,
                cutoff: 0.5,
            };
            let description = MeshDescription { mask: Some(mask), ..quad.description() };
            let mesh = service.add_mesh(&description).unwrap();
            let whole = service.add_mesh(&quad.description()).unwrap();
            let place = DAffine3::from_translation(Yard::new().places[0].1.translation);
            let instance = |mesh| [CasterInstance { mesh, world_from_object: place }];
            let frame = service.prepare(&plan, view, &instance(mesh)).unwrap();
            let unmasked = service.prepare(&plan, view, &instance(whole)).unwrap();
            let empty = service.prepare(&plan, view, &[]).unwrap();
            let captured = |frame: &PreparedFrame| {
                let mut encoder = gpu.device.create_command_encoder(&Default::default());
                service.capture(&mut encoder, frame, None).unwrap();
                read(&service, &gpu, encoder)
            };
            let (own, whole) = (captured(&frame), captured(&unmasked));

            let float = wgpu::TextureSampleType::Float { filterable: true };
            let texture_type = wgpu::BindingType::Texture {
                sample_type: float,
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            };
            let sampler_type = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
            let stage = wgpu::ShaderStages::FRAGMENT;
            let entries = [
                (stage, texture_type, 2, wgpu::BindingResource::TextureView(&texture)),
                (stage, sampler_type, 3, wgpu::BindingResource::Sampler(&sampler)),
            ];
            let attributes = wgpu::vertex_attr_array![4 => Float32x2];
            let uv_layout = wgpu::VertexBufferLayout {
                array_stride: 8,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: &attributes,
            };
            let layouts = [Some(POSITIONS), Some(ROWS), Some(uv_layout)];
            let engine = Engine::new(&gpu, &service, &casters, &layouts, &entries);
            let rows = caster_rows(&plan, &place).unwrap();
            assert_eq!(rows, frame.commands().rows[0].0);
            let rows: Vec<u8> = rows.as_flattened().iter().flat_map(|value| value.to_le_bytes()).collect();
            let rows = buffer(&gpu, &rows, wgpu::BufferUsages::VERTEX);
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            let draw = |pass: &mut wgpu::RenderPass, facet: EngineFacet| {
                if draws(&frame, facet.position).is_empty() {
                    return;
                }
                pass.set_pipeline(engine.pipelines.of(facet.depth_order));
                pass.set_bind_group(1, &engine.group, &[]);
                pass.set_vertex_buffer(0, quad.vertices.slice(..));
                pass.set_vertex_buffer(1, rows.slice(..));
                pass.set_vertex_buffer(2, uvs.slice(..));
                pass.set_index_buffer(quad.indices.slice(..), wgpu::IndexFormat::Uint32);
                pass.draw_indexed(0..6, 0, 0..1);
            };
            service.capture_with(&mut encoder, &empty, &plan, None, draw).unwrap();
            let map = read(&service, &gpu, encoder);
            let what = format!("{configuration}, clamped {clamp_in_fragments}");
            assert_eq!(differing(&map, &own), 0, "{what}");
            assert!(differing(&whole, &own) > 100, "{what}: without its holes the quad covers more");
        }
    }
}

#[test]
fn both_kinds_of_casters_share_a_map_and_foreign_ones_are_refused() {
    let gpu = exclusive();
    let (case, other) = (case(""), case("distribution: bands(3)"));
    let table = generate(&case).unwrap().table;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let (view, sun) = (&views((160, 90))[0], &suns()[0]);
    let plan_here = plan(&case, view, sun, &SceneBounds::default()).unwrap();
    let standard = Standard::new(&gpu, &mut service, &Yard::new(), &plan_here, view);

    // An engine that draws nothing leaves the service's own casters.
    let mut facets = Vec::new();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let draw = |_: &mut wgpu::RenderPass, facet: EngineFacet| facets.push(facet.position);
    service.capture_with(&mut encoder, &standard.frame, &plan_here, None, draw).unwrap();
    assert_eq!(differing(&read(&service, &gpu, encoder), &standard.map), 0);
    assert_eq!(facets, (0..plan_here.facets.len()).collect::<Vec<_>>());

    // Nothing is recorded for another plan; shaders of another case make no pipelines.
    let elsewhere = plan(&other, view, sun, &SceneBounds::default()).unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let refused = service.capture_with(&mut encoder, &standard.frame, &elsewhere, None, |_, _| panic!());
    assert!(matches!(refused, Err(ServiceError::StaleFrame { .. })), "{refused:?}");
    let entry = CasterEntry::new("skinned", "skinned").source("engine.wgsl", SOURCE);
    let casters = entry.compose(&other).unwrap();
    let refused = service.caster_shader(&casters);
    assert!(matches!(refused, Err(ServiceError::ForeignCasters { .. })));
}
