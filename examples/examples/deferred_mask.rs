//! A deferred renderer gives its depth buffer and gets a visibility mask.
//!
//! The engine's geometry pass writes reversed-z depth and what the sun and the sky would give each pixel. The service's
//! mask pass turns the depth into visibility; normals are reconstructed from it. Lighting is then ambient + mask * sun. Every
//! pixel's visibility is checked by a ray from the point that its depth says.
//!
//! Run with `cargo run -p cssm-examples --example deferred_mask`.

use std::error::Error;

use cssm::core::glam::{DAffine3, DVec3};
use cssm::runtime::{CasterInstance, MaskInputs, Options, ShadowService, wgpu};
use cssm::{Light, SceneBounds, View, plan};
use cssm_examples::{BoxScene, Gpu, camera_numbers, write_picture};

cssm::light_case! {
    /// A low sun over a court; the engine is deferred.
    case Court {
        technique: camera_space,
        map: { size: 2048 x 2048 },
        resolve: [mask { depth: reversed_z, normal: reconstructed }],
        prefix: court,
    }
}

/// Size of the picture.
const SIZE: (u32, u32) = (640, 360);
/// Where the scene lies.
const ORIGIN: DVec3 = DVec3::new(1.1e6, 12.0, 3.4e6);
/// Where the light's rays travel.
const TRAVEL: DVec3 = DVec3::new(0.8, -0.55, -0.35);

/// The engine's geometry pass: light of the sky into one target, light of the sun into another.
const GEOMETRY_PASS: &str = "
struct Camera { clip_from_camera: mat4x4<f32>, camera_from_object: mat4x4<f32>, toward_light: vec4<f32> }
@group(0) @binding(0) var<uniform> camera: Camera;
struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) normal: vec3<f32>,
    @location(1) colour: vec3<f32>,
    @location(2) upwards: f32,
}
struct Surface { @location(0) sky: vec4<f32>, @location(1) sun: vec4<f32> }

@vertex
fn geometry_vertex(@location(0) position: vec3<f32>, @location(1) normal: vec3<f32>) -> Varying {
    let seen = camera.camera_from_object * vec4<f32>(position, 1.0);
    let colour = select(vec3<f32>(0.78, 0.68, 0.55), vec3<f32>(0.62, 0.6, 0.56), position.y <= 0.0);
    let turned = (camera.camera_from_object * vec4<f32>(normal, 0.0)).xyz;
    return Varying(camera.clip_from_camera * seen, turned, colour, normal.y);
}

@fragment
fn geometry_fragment(surface: Varying) -> Surface {
    let sun = max(dot(surface.normal, camera.toward_light.xyz), 0.0) * vec3<f32>(1.0, 0.86, 0.66);
    let sky = (0.75 + 0.25 * surface.upwards) * vec3<f32>(0.22, 0.27, 0.36);
    return Surface(vec4<f32>(surface.colour * sky, 1.0), vec4<f32>(surface.colour * sun, 1.0));
}
";

/// Boxes of the court, from corner to corner: the ground first, then walls, an arch and blocks.
fn boxes() -> Vec<[[f32; 3]; 2]> {
    let mut boxes = vec![[[-30.0, -1.0, -50.0], [30.0, 0.0, 15.0]]];
    boxes.push([[-12.0, 0.0, -26.0], [-11.0, 5.0, 4.0]]);
    boxes.push([[-4.0, 0.0, -18.0], [-3.0, 4.0, -17.0]]);
    boxes.push([[3.0, 0.0, -18.0], [4.0, 4.0, -17.0]]);
    boxes.push([[-4.5, 4.0, -18.2], [4.5, 4.8, -16.8]]);
    for block in 0..7_u8 {
        let (x, z) = (f32::from(block % 3) * 4.0 - 5.0, f32::from(block / 3) * -4.0 - 3.0);
        let height = 0.8 + f32::from(block * 5 % 7) * 0.35;
        boxes.push([[x, 0.0, z], [x + 1.1, height, z + 1.1]]);
    }
    boxes
}

fn main() -> Result<(), Box<dyn Error>> {
    // The service draws the engine's vertex buffer into the map.
    let gpu = Gpu::for_table(&court::TABLE)?;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &court::TABLE, &Options::default())?;
    let scene = BoxScene::new(&gpu, &boxes());
    let mesh = service.add_mesh(&scene.mesh())?;
    let eye = ORIGIN + DVec3::new(6.0, 4.2, 9.0);
    let view = View::perspective(
        eye,
        ORIGIN + DVec3::new(-3.0, 0.8, -9.0),
        DVec3::Y,
        0.9,
        0.1,
        f64::INFINITY,
        SIZE,
    )?;
    let light = Light::directional_travelling(TRAVEL)?;
    let plan = plan(&court::case(), &view, &light, &SceneBounds::default())?;
    let world_from_object = DAffine3::from_translation(ORIGIN);
    let frame = service.prepare(&plan, &view, &[CasterInstance { mesh, world_from_object }])?;

    // Capture, draw the engine's geometry pass, then ask for the mask.
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    let colour = || gpu.texture(SIZE, wgpu::TextureFormat::Rgba8Unorm, usage);
    let (sky, sun) = (colour(), colour());
    let mask = gpu.texture(SIZE, wgpu::TextureFormat::R8Unorm, usage);
    let depth =
        gpu.texture(SIZE, wgpu::TextureFormat::Depth32Float, usage | wgpu::TextureUsages::TEXTURE_BINDING);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None)?;
    draw_geometry(&gpu, &mut encoder, &view, [&sky, &sun, &depth], &scene);
    let inputs = MaskInputs { depth: &depth.create_view(&Default::default()), normal: None };
    service.mask(&mut encoder, &frame, &inputs, &mask.create_view(&Default::default()), None)?;
    gpu.queue.submit([encoder.finish()]);

    // Light the picture.
    let (sky, sun, mask, depth) = (gpu.read(&sky)?, gpu.read(&sun)?, gpu.read(&mask)?, gpu.read(&depth)?);
    let light = |(index, (sky, sun)): (usize, (&u8, &u8))| {
        let lit = f64::from(*sky) + f64::from(*sun) * f64::from(mask[index / 4]) / 255.0;
        if index % 4 == 3 { 255 } else { (255.0 * (lit / 255.0).min(1.0).powf(1.0 / 2.2)) as u8 }
    };
    let picture: Vec<u8> = sky.iter().zip(&sun).enumerate().map(light).collect();

    // Cast a ray from every pixel's point towards the light.
    let depths: Vec<f32> = bytemuck::pod_collect_to_vec(&depth);
    let (mut judged, mut shaded, mut wrong) = (0_usize, 0_usize, 0_usize);
    for (pixel, stored) in depths.iter().enumerate().filter(|(_, stored)| **stored > 0.0) {
        let (x, y) = (pixel as u32 % SIZE.0, pixel as u32 / SIZE.0);
        let faces_sun = sun[4 * pixel..4 * pixel + 3].iter().any(|channel| *channel > 8);
        let Some(truth) = truth(&view, (x, y), f64::from(*stored)).filter(|_| faces_sun) else { continue };
        judged += 1;
        shaded += usize::from(!truth);
        wrong += usize::from((mask[pixel] > 127) != truth);
    }
    println!("{wrong} of {judged} pixels that face the sun differ from ray casting; {shaded} are in shadow");
    assert!(shaded * 10 > judged, "the court throws shadows");
    assert!(wrong * 200 < judged, "the mask is what rays say");
    write_picture("deferred_mask", SIZE, &picture)
}

/// Whether the point of a pixel is lit; `None` near the edges of shadows.
fn truth(view: &View, (x, y): (u32, u32), stored: f64) -> Option<bool> {
    /// Distance from an edge below which filtering may show.
    const EDGE_METRES: f64 = 0.05;
    /// How far a ray starts from its surface.
    const START_METRES: f64 = 0.02;
    let (across, down) = ((f64::from(x) + 0.5) / f64::from(SIZE.0), (f64::from(y) + 0.5) / f64::from(SIZE.1));
    let ray = DVec3::new(
        view.left + across * (view.right - view.left),
        view.top + down * (view.bottom - view.top),
        -1.0,
    );
    let depth = view.near_metres / stored;
    let point = view.eye_world - ORIGIN + view.camera_from_world.transpose() * ray * depth;
    let lit = |offset: DVec3| {
        let start = point + offset * EDGE_METRES - TRAVEL * START_METRES;
        !boxes().iter().any(|[min, max]| meets(start, -TRAVEL, *min, *max))
    };
    let near = [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::NEG_Z].map(lit);
    let truth = lit(DVec3::ZERO);
    near.iter().all(|near| *near == truth).then_some(truth)
}

/// Whether a ray meets a box.
fn meets(start: DVec3, along: DVec3, min: [f32; 3], max: [f32; 3]) -> bool {
    let corner = |corner: [f32; 3]| (DVec3::from_array(corner.map(f64::from)) - start) / along;
    let (one, other) = (corner(min), corner(max));
    let (enter, leave) = (one.min(other).max_element(), one.max(other).min_element());
    leave > enter.max(0.0)
}

/// Records the engine's geometry pass.
fn draw_geometry(
    gpu: &Gpu,
    encoder: &mut wgpu::CommandEncoder,
    view: &View,
    [sky, sun, depth]: [&wgpu::Texture; 3],
    scene: &BoxScene,
) {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("geometry"),
        source: wgpu::ShaderSource::Wgsl(GEOMETRY_PASS.into()),
    });
    let camera = camera_numbers(view, ORIGIN, -TRAVEL.normalize());
    let (layout, group) = gpu.uniform_group(&[&gpu.buffer(&camera, wgpu::BufferUsages::UNIFORM)]);
    let pipeline = gpu.pipeline(
        &module,
        ["geometry_vertex", "geometry_fragment"],
        &[Some(&layout)],
        &[Some(BoxScene::layout())],
        wgpu::PrimitiveTopology::TriangleList,
        &[wgpu::TextureFormat::Rgba8Unorm; 2],
    );
    let clear = wgpu::Color { r: 0.12, g: 0.3, b: 0.6, a: 1.0 };
    let mut pass = gpu.pass(encoder, &[(sky, clear), (sun, wgpu::Color::BLACK)], depth);
    scene.draw(&mut pass, &pipeline, &group);
}
