//! The engine's own material calls the generated visibility function.
//!
//! The engine concatenates `FUNCTION_WGSL` with its own shader, binds the service's shadow group at the number that
//! the case declares, and calls `noon_visibility(position, normal)` with a position relative to the eye and the
//! geometric normal, both in camera axes (x right, y up, looking along -z). It keeps its groups, vertex formats and
//! passes.
//!
//! Run with `cargo run -p cssm-examples --example material_function`.

use std::error::Error;

use cssm::core::glam::{DAffine3, DMat4, DVec3, DVec4};
use cssm::core::table::{GroupContent, ShaderKind};
use cssm::runtime::{CasterInstance, MeshDescription, Options, PreparedFrame, ShadowService, wgpu};
use cssm::{BoundingBox, Light, SceneBounds, View, plan};
use cssm_examples::{Gpu, write_picture};

cssm::light_case! {
    /// A sun whose shadows the engine's material asks for.
    case Noon {
        technique: camera_space,
        map: { size: 2048 x 2048 },
        resolve: [function { group: 1 }],
        prefix: noon,
    }
}

/// Size of the picture.
const SIZE: (u32, u32) = (640, 360);
/// Where the scene lies.
const ORIGIN: DVec3 = DVec3::new(-7.7e5, 88.0, 1.9e6);

/// The engine's shader; `noon_visibility` comes from the generated module in front of it.
const MATERIAL: &str = "
struct EngineCamera { clip_from_camera: mat4x4<f32>, camera_from_object: mat4x4<f32>, toward_light: vec4<f32> }
@group(0) @binding(0) var<uniform> camera: EngineCamera;

struct EngineVarying {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) upwards: f32,
}

@vertex
fn engine_vertex(@location(0) position: vec3<f32>, @location(1) normal: vec3<f32>) -> EngineVarying {
    let seen = camera.camera_from_object * vec4<f32>(position, 1.0);
    let turned = (camera.camera_from_object * vec4<f32>(normal, 0.0)).xyz;
    return EngineVarying(camera.clip_from_camera * seen, seen.xyz, turned, normal.y);
}

@fragment
fn engine_fragment(surface: EngineVarying) -> @location(0) vec4<f32> {
    let cosine = max(dot(surface.normal, camera.toward_light.xyz), 0.0);
    let sun = cosine * noon_visibility(surface.position, surface.normal);
    let sky = vec3<f32>(0.16, 0.2, 0.27) * (0.7 + 0.3 * surface.upwards);
    return vec4<f32>(sky + sun * vec3<f32>(0.8, 0.75, 0.62), 1.0);
}
";

/// A vertex of this engine.
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
struct Vertex {
    position: [f32; 3],
    normal: [f32; 3],
}

/// A box between two corners, as triangles with flat normals.
fn add_box(vertices: &mut Vec<Vertex>, min: [f32; 3], max: [f32; 3]) {
    for (axis, end) in [(0, min), (0, max), (1, min), (1, max), (2, min), (2, max)] {
        let (across, along) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut normal = [0.0; 3];
        normal[axis] = if end == max { 1.0 } else { -1.0 };
        for (u, v) in [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)] {
            let mut position = end;
            position[across] = if u == 0 { min[across] } else { max[across] };
            position[along] = if v == 0 { min[along] } else { max[along] };
            vertices.push(Vertex { position, normal });
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    // A terrace with columns.
    let mut vertices = Vec::new();
    add_box(&mut vertices, [-40.0, -1.0, -90.0], [40.0, 0.0, 20.0]);
    for column in 0..16_u8 {
        let (x, z) = (f32::from(column % 2) * 9.0 - 5.0, f32::from(column / 2) * -7.0 - 4.0);
        add_box(&mut vertices, [x - 0.5, 0.0, z - 0.5], [x + 0.5, 6.0, z + 0.5]);
    }
    add_box(&mut vertices, [-6.0, 6.0, -54.0], [5.0, 6.6, -3.0]);

    // The service and the engine share the vertex buffer.
    let gpu = Gpu::for_table(&noon::TABLE)?;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &noon::TABLE, &Options::default())?;
    let vertex_buffer = gpu.buffer(&vertices, wgpu::BufferUsages::VERTEX);
    let mesh = service.add_mesh(&MeshDescription {
        vertices: &vertex_buffer,
        vertices_offset_bytes: 0,
        vertex_count: vertices.len() as u32,
        stride_bytes: size_of::<Vertex>() as u32,
        position_offset_bytes: 0,
        position_format: wgpu::VertexFormat::Float32x3,
        indices: None,
        bounds_object: BoundingBox { min: DVec3::new(-40.0, -1.0, -90.0), max: DVec3::new(40.0, 6.6, 20.0) },
        clusters: &[],
        mask: None,
    })?;

    // Plan and prepare the frame.
    let eye = ORIGIN + DVec3::new(10.0, 3.2, 8.0);
    let target = ORIGIN + DVec3::new(-6.0, 1.5, -30.0);
    let view = View::perspective(eye, target, DVec3::Y, 0.9, 0.1, f64::INFINITY, SIZE)?;
    let light = Light::directional_travelling(DVec3::new(-0.7, -1.0, 0.35))?;
    let plan = plan(&noon::case(), &view, &light, &SceneBounds::default())?;
    let world_from_object = DAffine3::from_translation(ORIGIN);
    let frame = service.prepare(&plan, &view, &[CasterInstance { mesh, world_from_object }])?;

    // Capture, then draw with the engine's material; once more without casters to know what would be lit.
    let engine = Engine::new(&gpu, &service, &view, plan.light)?;
    let unshadowed = service.prepare(&plan, &view, &[])?;
    let (mut pictures, mut encoder) = (Vec::new(), gpu.device.create_command_encoder(&Default::default()));
    for frame in [&frame, &unshadowed] {
        service.capture(&mut encoder, frame, None)?;
        pictures.push(engine.draw(&gpu, &mut encoder, frame, &vertex_buffer, vertices.len() as u32));
    }
    gpu.queue.submit([encoder.finish()]);

    // Some of what faces the sun is in shadow, most is not, and nothing is brighter with casters than without.
    let (shaded, lit) = (gpu.read(&pictures[0])?, gpu.read(&pictures[1])?);
    let darker =
        shaded.chunks_exact(4).zip(lit.chunks_exact(4)).filter(|(one, other)| one[0] + 8 < other[0]).count();
    let share = darker as f64 / f64::from(SIZE.0 * SIZE.1);
    println!("{:.1} % of the picture is in shadow", 100.0 * share);
    assert!((0.05..0.5).contains(&share), "the colonnade throws shadows");
    assert!(shaded.iter().zip(&lit).all(|(one, other)| one <= other), "shadows only darken");
    write_picture("material_function", SIZE, &shaded)
}

/// The engine's renderer.
struct Engine {
    pipeline: wgpu::RenderPipeline,
    camera: wgpu::BindGroup,
    shadow_group: u32,
}

impl Engine {
    fn new(gpu: &Gpu, service: &ShadowService, view: &View, light: DVec4) -> Result<Self, Box<dyn Error>> {
        // Put the generated function in front of the engine's own shader.
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("material"),
            source: wgpu::ShaderSource::Wgsl([noon::FUNCTION_WGSL, MATERIAL].concat().into()),
        });

        // Reserve the declared group for the service.
        let shadow = service.table().group(ShaderKind::Function, GroupContent::Shadow);
        let shadow_group = shadow.ok_or("the case declares a function")?.group;
        let camera_layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: None,
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Uniform,
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
                count: None,
            }],
        });
        let mut groups = vec![None; 1 + shadow_group as usize];
        groups[0] = Some(&camera_layout);
        groups[shadow_group as usize] = service.shadow_bind_group_layout();
        let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: &groups,
            immediate_size: 0,
        });
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("material"),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("engine_vertex"),
                compilation_options: Default::default(),
                buffers: &[Some(wgpu::VertexBufferLayout {
                    array_stride: size_of::<Vertex>() as u64,
                    step_mode: wgpu::VertexStepMode::Vertex,
                    attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3],
                })],
            },
            primitive: Default::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: wgpu::TextureFormat::Depth32Float,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("engine_fragment"),
                compilation_options: Default::default(),
                targets: &[Some(wgpu::TextureFormat::Rgba8UnormSrgb.into())],
            }),
            multiview_mask: None,
            cache: None,
        });

        // An infinite reversed-z projection, and the object's place before the camera: composed in f64, rounded once.
        let (x, y) = (1.0 / view.right, 1.0 / view.top);
        let clip_from_camera = DMat4::from_cols(
            DVec4::new(x, 0.0, 0.0, 0.0),
            DVec4::new(0.0, y, 0.0, 0.0),
            DVec4::new(0.0, 0.0, 0.0, -1.0),
            DVec4::new(0.0, 0.0, view.near_metres, 0.0),
        );
        let origin = view.camera_from_world * (ORIGIN - view.eye_world);
        let camera_from_object = DMat4::from_mat3_translation(view.camera_from_world, origin);
        let toward_light = (view.camera_from_world * light.truncate()).extend(0.0);
        let mut camera = clip_from_camera.as_mat4().to_cols_array().to_vec();
        camera.extend(camera_from_object.as_mat4().to_cols_array());
        camera.extend(toward_light.as_vec4().to_array());
        let camera = gpu.buffer(&camera, wgpu::BufferUsages::UNIFORM);
        let camera = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &camera_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: camera.as_entire_binding() }],
        });
        Ok(Self { pipeline, camera, shadow_group })
    }

    /// Records the engine's pass and returns its picture.
    fn draw(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedFrame,
        vertices: &wgpu::Buffer,
        count: u32,
    ) -> wgpu::Texture {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let picture =
            gpu.texture(SIZE, wgpu::TextureFormat::Rgba8UnormSrgb, usage | wgpu::TextureUsages::COPY_SRC);
        let depth = gpu.texture(SIZE, wgpu::TextureFormat::Depth32Float, usage);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("material"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &picture.create_view(&Default::default()),
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color { r: 0.3, g: 0.5, b: 0.8, a: 1.0 }),
                    store: wgpu::StoreOp::Store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth.create_view(&Default::default()),
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.camera, &[]);
        pass.set_bind_group(self.shadow_group, frame.shadow_bind_group(), &[]);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.draw(0..count, 0..1);
        drop(pass);
        picture
    }
}
