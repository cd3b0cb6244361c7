//! The shadow service for a whole scene: a sun, a spot light and two lamps share one map; a ball of light moves, a crate
//! moves, and only what they touch is drawn again. The last frame is drawn with the facets of one lamp over it, and the map's
//! tiles beside it.
//!
//! Run with `cargo run -p cssm-examples --example many_lights`.

use std::error::Error;

use cssm::core::case::MaskDepth;
use cssm::core::glam::{DAffine3, DVec3};
use cssm::runtime::lights::{CaseHandle, LightDescription, LightFrame, LightOptions, ViewId};
use cssm::runtime::{
    CasterInstance, LightService, MaskInputs, MeshDescription, MeshHandle, Overlay, OverlayLook, OverlayTile,
    PreparedLights, wgpu,
};
use cssm::{BoundingBox, Light, View};
use cssm_examples::{Gpu, write_picture};

cssm::light_case! {
    /// The sun.
    case Sun {
        technique: camera_space,
        map: { size: 2048 x 2048 },
        resolve: [mask { depth: linear }],
        prefix: sun,
    }
    /// A lamp that shines to all sides.
    case Lamp {
        light: omni,
        technique: camera_space,
        map: { size: 2048 x 2048 },
        resolve: [mask { depth: linear }],
        prefix: lamp,
    }
    /// A spot light.
    case Spot {
        light: spot,
        technique: camera_space,
        map: { size: 2048 x 2048 },
        resolve: [mask { depth: linear }],
        prefix: spot,
    }
}

const SIZE: (u32, u32) = (640, 360);
const PIXELS: usize = (SIZE.0 * SIZE.1) as usize;
/// The picture with the map beside it.
const SHOWN: (u32, u32) = (SIZE.0 + SIZE.1, SIZE.1);
const SHOWN_USAGE: wgpu::TextureUsages = wgpu::TextureUsages::RENDER_ATTACHMENT
    .union(wgpu::TextureUsages::COPY_SRC)
    .union(wgpu::TextureUsages::COPY_DST);
const GROUND_METRES: f64 = 60.0;

/// A box of the yard: its middle and half its sides, metres.
#[derive(Clone, Copy)]
struct Crate(DVec3, DVec3);

impl Crate {
    /// Where a ray enters the box, as a parameter along it.
    fn entered(&self, origin: DVec3, ray: DVec3) -> Option<f64> {
        let (one, two) = ((self.0 - self.1 - origin) / ray, (self.0 + self.1 - origin) / ray);
        let (enter, leave) = (one.min(two).max_element(), one.max(two).min_element());
        (enter <= leave && leave > 1e-9).then_some(enter)
    }

    fn instance(&self, mesh: MeshHandle) -> CasterInstance {
        let (_, no_turn, _) = DAffine3::IDENTITY.to_scale_rotation_translation();
        CasterInstance {
            mesh,
            world_from_object: DAffine3::from_scale_rotation_translation(self.1, no_turn, self.0),
        }
    }
}

/// The engine's depth in metres, ray cast; 0 in the sky.
fn depths(view: &View, crates: &[Crate]) -> Vec<f32> {
    let pixels = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y)));
    let depth = |(x, y): (u32, u32)| {
        let ray = view.ray_world(f64::from(x) + 0.5, f64::from(y) + 0.5);
        let hits = crates.iter().filter_map(|one| one.entered(view.eye_world, ray));
        hits.filter(|hit| *hit > 0.0).fold(f64::INFINITY, f64::min)
    };
    pixels.map(depth).map(|depth| if depth.is_finite() { depth as f32 } else { 0.0 }).collect()
}

/// Whether anything stands between a point and a light.
fn is_lit(point: DVec3, light: &Light, crates: &[Crate]) -> bool {
    let toward = light.toward_world(point);
    let reach = light.distance_metres(point);
    let start = point + toward * 1e-4;
    light.reaches(point)
        && !crates.iter().any(|one| one.entered(start, toward).is_some_and(|hit| hit < reach && hit > -1e-3))
}

fn main() -> Result<(), Box<dyn Error>> {
    let cases = [sun::case(), lamp::case(), spot::case()];
    let tables = [&sun::TABLE, &lamp::TABLE, &spot::TABLE];
    let gpu = Gpu::for_table(&lamp::TABLE)?;
    let declared: Vec<_> = cases.iter().zip(tables).collect();
    let mut service = LightService::new(&gpu.device, &gpu.queue, &declared, &LightOptions::default())?;

    // The engine's lights, each of a declared case.
    let directional = Light::directional_travelling(DVec3::new(0.5, -0.8, -0.4))?;
    let down = DVec3::new(0.2, -1.0, -0.1);
    let lamp_at = |x: f64| Light::omni(DVec3::new(x, 3.2, -3.0), 14.0);
    let mut lights = vec![
        (CaseHandle(0), directional),
        (CaseHandle(1), lamp_at(-4.0)?),
        (CaseHandle(1), lamp_at(5.0)?),
        (CaseHandle(2), Light::spot(DVec3::new(0.0, 6.0, 1.0), down, 0.6, 20.0)?),
    ];
    let mut handles = Vec::new();
    for (case, light) in &lights {
        let usual = LightDescription::new(*case, *light);
        handles.push(service.add_light(&LightDescription { max_side_texels: 1024, ..usual })?);
    }

    // The engine's geometry: one cube, drawn in many places.
    let corners: Vec<[f32; 3]> = cube();
    let vertices = gpu.buffer(&corners, wgpu::BufferUsages::VERTEX);
    let mesh = service.add_mesh(&MeshDescription {
        vertices: &vertices,
        vertices_offset_bytes: 0,
        vertex_count: corners.len() as u32,
        stride_bytes: 12,
        position_offset_bytes: 0,
        position_format: wgpu::VertexFormat::Float32x3,
        indices: None,
        bounds_object: BoundingBox { min: DVec3::NEG_ONE, max: DVec3::ONE },
        clusters: &[],
        mask: None,
    })?;
    let ground = DVec3::new(GROUND_METRES, 0.5, GROUND_METRES);
    let mut still = vec![Crate(DVec3::NEG_Y * 0.5, ground)];
    still.extend((0..9).map(|index| {
        let (column, row) = (f64::from(index % 3) - 1.0, f64::from(index / 3));
        let height = 0.4 + 0.25 * f64::from(index * 5 % 4);
        Crate(DVec3::new(3.2 * column, height, -2.0 - 3.0 * row), DVec3::new(0.5, height, 0.6))
    }));
    let static_casters: Vec<_> = still.iter().map(|one| one.instance(mesh)).collect();

    let eye = DVec3::new(0.5, 3.5, 8.0);
    let view = View::perspective(eye, DVec3::new(0.0, 0.5, -3.0), DVec3::Y, 1.0, 0.1, 200.0, SIZE)?;
    let masks: Vec<_> = lights
        .iter()
        .map(|_| {
            let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
            gpu.texture(SIZE, wgpu::TextureFormat::R8Unorm, usage)
        })
        .collect();
    let depth_usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let depth_texture = gpu.texture(SIZE, wgpu::TextureFormat::R32Float, depth_usage);
    let mut prepared = PreparedLights::new();

    for number in 0..4 {
        // A crate slides; in the last frame a lamp moves too.
        let moving = Crate(DVec3::new(-2.5 + f64::from(number) * 0.6, 0.5, 1.0), DVec3::splat(0.5));
        if number == 3 {
            lights[1].1 = lamp_at(-3.0)?;
            let usual = LightDescription::new(lights[1].0, lights[1].1);
            service.update_light(handles[1], &LightDescription { max_side_texels: 1024, ..usual })?;
        }
        let all: Vec<_> = still.iter().copied().chain([moving]).collect();
        let depths = depths(&view, &all);
        gpu.queue.write_texture(
            depth_texture.as_image_copy(),
            bytemuck::cast_slice(&depths),
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIZE.0), rows_per_image: None },
            depth_texture.size(),
        );

        // Prepare, capture, resolve: one encoder of the engine's own.
        let dynamic_casters = [moving.instance(mesh)];
        service.prepare(&LightFrame::new(&view, &static_casters, &dynamic_casters), &mut prepared)?;
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        service.capture(&mut encoder, &prepared, None)?;
        let depth = depth_texture.create_view(&Default::default());
        let inputs = MaskInputs { depth: &depth, normal: None };
        for (handle, mask) in handles.iter().zip(&masks) {
            let target = mask.create_view(&Default::default());
            service.mask(&mut encoder, &prepared, *handle, &inputs, &target, None)?;
        }
        gpu.queue.submit([encoder.finish()]);

        // Judge every light by ray casting, and draw what the yard looks like.
        let report = prepared.report();
        println!(
            "frame {number}: {} lights planned, {:.1} % of their texels redrawn, {} triangles",
            report.planned,
            100.0 * report.redrawn_texels as f64 / report.owned_texels as f64,
            report.triangles
        );
        let mut picture = vec![0.06_f64; PIXELS];
        for ((_, light), mask) in lights.iter().zip(&masks) {
            let visibility = gpu.read(mask)?;
            let (mut judged, mut wrong) = (0, 0);
            for (index, depth) in depths.iter().enumerate().filter(|(_, depth)| **depth > 0.0) {
                let (x, y) = (index as u32 % SIZE.0, index as u32 / SIZE.0);
                let ray = view.ray_world(f64::from(x) + 0.5, f64::from(y) + 0.5);
                let point = view.eye_world + ray * f64::from(*depth);
                if !light.reaches(point) {
                    continue;
                }
                judged += 1;
                wrong += usize::from((visibility[index] >= 128) != is_lit(point, light, &all));
                let distance = light.distance_metres(point);
                let fall = if distance.is_finite() { 2.0 / (2.0 + distance) } else { 0.45 };
                picture[index] += fall * f64::from(visibility[index]) / 255.0;
            }
            assert!(judged > 10_000, "the light reaches the view");
            assert!(
                wrong * 50 < judged,
                "{wrong} of {judged} pixels are wrong: more than edges and faces that look away"
            );
        }
        assert!(number == 0 || report.redrawn_texels < report.owned_texels, "some tiles are kept");
        if number == 3 {
            let grey: Vec<u8> = picture.iter().map(|light| (light.min(1.0).sqrt() * 255.0) as u8).collect();
            write_picture("many_lights", SIZE, &grey)?;

            // Look inside: the facets of the lamp that moved, and the tiles of all lights; bright ones are of this frame.
            let shown = gpu.texture(SHOWN, wgpu::TextureFormat::Rgba8Unorm, SHOWN_USAGE);
            let overlay = Overlay::new(&gpu.device, &gpu.queue, MaskDepth::Linear, shown.format())?;
            let plan = service.plan(handles[1], ViewId::default()).ok_or("the lamp has no shadow")?;
            let look = OverlayLook { opacity: 0.4, checker_texels: 16 };
            let facets = gpu.texture(SIZE, shown.format(), SHOWN_USAGE);
            write_left(&gpu, &facets, &grey);
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            overlay.draw_facets(
                &mut encoder,
                plan,
                &view,
                &depth,
                &facets.create_view(&Default::default()),
                &look,
            )?;
            encoder.copy_texture_to_texture(
                facets.as_image_copy(),
                shown.as_image_copy(),
                wgpu::Extent3d { width: SIZE.0, height: SIZE.1, depth_or_array_layers: 1 },
            );
            let tiles = OverlayTile::of_report(prepared.report());
            let place = [SIZE.0, 0, SIZE.1, SIZE.1];
            let target = shown.create_view(&Default::default());
            overlay.draw_tiles(&mut encoder, service.map(), &tiles, &target, place)?;
            gpu.queue.submit([encoder.finish()]);
            write_picture("many_lights_overlay", SHOWN, &gpu.read(&shown)?)?;
        }
    }
    Ok(())
}

/// Writes a grey picture into the left part of a texture.
fn write_left(gpu: &Gpu, texture: &wgpu::Texture, grey: &[u8]) {
    let pixels: Vec<u8> = grey.iter().flat_map(|level| [*level, *level, *level, 255]).collect();
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIZE.0), rows_per_image: None };
    let size = wgpu::Extent3d { width: SIZE.0, height: SIZE.1, depth_or_array_layers: 1 };
    gpu.queue.write_texture(texture.as_image_copy(), &pixels, layout, size);
}

/// Corners of the triangles of a cube from -1 to 1.
fn cube() -> Vec<[f32; 3]> {
    let corner = |index: usize| [0, 1, 2].map(|axis| if index >> axis & 1 == 0 { -1.0 } else { 1.0 });
    let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    faces.iter().flat_map(|[a, b, c, d]| [a, b, c, a, c, d].map(|index| corner(*index))).collect()
}
