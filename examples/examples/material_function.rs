//! The engine's own material calls the generated visibility function.
//!
//! The engine concatenates `FUNCTION_WGSL` with its own shader and calls `noon_visibility(position, normal)` with a
//! position relative to the eye and the geometric normal, both in camera axes (x right, y up, looking along -z). It keeps
//! its groups, vertex formats and passes: the shadow's bindings take the numbers 4 and up in the one bind group that this
//! engine has.
//!
//! Run with `cargo run -p cssm-examples --example material_function`.

use std::error::Error;

use cssm::core::glam::{DAffine3, DVec3, DVec4};
use cssm::runtime::{CasterInstance, Options, PreparedFrame, ShadowService, wgpu};
use cssm::{Light, SceneBounds, View, plan};
use cssm_examples::{BoxScene, Gpu, camera_numbers, write_picture};

cssm::light_case! {
    /// A sun whose shadows the engine's material asks for.
    case Noon {
        technique: camera_space,
        map: { size: 2048 x 2048 },
        resolve: [function { group: 0, first_binding: 4 }],
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

fn main() -> Result<(), Box<dyn Error>> {
    // A terrace with columns.
    let mut boxes = vec![[[-40.0, -1.0, -90.0], [40.0, 0.0, 20.0]]];
    boxes.extend((0..16_u8).map(|column| {
        let (x, z) = (f32::from(column % 2) * 9.0 - 5.0, f32::from(column / 2) * -7.0 - 4.0);
        [[x - 0.5, 0.0, z - 0.5], [x + 0.5, 6.0, z + 0.5]]
    }));
    boxes.push([[-6.0, 6.0, -54.0], [5.0, 6.6, -3.0]]);

    // The service and the engine share the vertex buffer.
    let gpu = Gpu::for_table(&noon::TABLE)?;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &noon::TABLE, &Options::default())?;
    let scene = BoxScene::new(&gpu, &boxes);
    let mesh = service.add_mesh(&scene.mesh())?;

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
        pictures.push(engine.draw(&gpu, &mut encoder, &service, frame, &scene)?);
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
    camera: wgpu::Buffer,
    layout: wgpu::BindGroupLayout,
}

impl Engine {
    fn new(gpu: &Gpu, service: &ShadowService, view: &View, light: DVec4) -> Result<Self, Box<dyn Error>> {
        // Put the generated function in front of the engine's own shader.
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("material"),
            source: wgpu::ShaderSource::Wgsl(format!("{}{MATERIAL}", noon::FUNCTION_WGSL).into()),
        });

        // One layout for the engine's bindings and the shadow's, whose numbers the declaration has chosen.
        let camera_entry = wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let mut entries = service.shadow_layout_entries(wgpu::ShaderStages::FRAGMENT);
        entries.push(camera_entry);
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries });
        let pipeline = gpu.pipeline(
            &module,
            ["engine_vertex", "engine_fragment"],
            &[Some(&layout)],
            &[Some(BoxScene::layout())],
            wgpu::PrimitiveTopology::TriangleList,
            &[wgpu::TextureFormat::Rgba8UnormSrgb],
        );

        let camera = camera_numbers(view, ORIGIN, light.truncate());
        Ok(Self { pipeline, camera: gpu.buffer(&camera, wgpu::BufferUsages::UNIFORM), layout })
    }

    /// Records the engine's pass and returns its picture.
    fn draw(
        &self,
        gpu: &Gpu,
        encoder: &mut wgpu::CommandEncoder,
        service: &ShadowService,
        frame: &PreparedFrame,
        scene: &BoxScene,
    ) -> Result<wgpu::Texture, Box<dyn Error>> {
        // The engine's camera and this frame's shadow side by side.
        let mut entries = service.shadow_entries(frame)?;
        entries.push(wgpu::BindGroupEntry { binding: 0, resource: self.camera.as_entire_binding() });
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.layout,
            entries: &entries,
        });
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let picture =
            gpu.texture(SIZE, wgpu::TextureFormat::Rgba8UnormSrgb, usage | wgpu::TextureUsages::COPY_SRC);
        let depth = gpu.texture(SIZE, wgpu::TextureFormat::Depth32Float, usage);
        let sky = wgpu::Color { r: 0.3, g: 0.5, b: 0.8, a: 1.0 };
        let mut pass = gpu.pass(encoder, &[(&picture, sky)], &depth);
        scene.draw(&mut pass, &self.pipeline, &group);
        drop(pass);
        Ok(picture)
    }
}
