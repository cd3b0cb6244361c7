//! Casters in an engine's own vertex format: positions quantised to 16 bits, in chunks whose origin is f64 and 5,000 km
//! from the world's.
//!
//! The service reads the engine's vertex buffers as they are. What decodes a position (a scale and an origin) belongs
//! to the instance's transform, which is f64; the eye is subtracted and the axes turned to the camera's before anything is
//! rounded to f32.
//!
//! Run with `cargo run -p cssm-examples --example quantised_vertices`.

use std::error::Error;

use cssm::core::glam::{DAffine3, DVec3};
use cssm::runtime::{CasterInstance, IndexDescription, MeshDescription, Options, ShadowService, wgpu};
use cssm::{BoundingBox, Light, SceneBounds, View, plan};
use cssm_examples::{Gpu, write_picture};

cssm::light_case! {
    /// Sun over a planet.
    case Planet {
        technique: camera_space,
        map: { size: 1024 x 1024 },
        resolve: [function { group: 1 }],
        prefix: planet,
    }
}

/// Where the chunk lies: no multiple of anything, far beyond what f32 resolves to a metre.
const ORIGIN: DVec3 = DVec3::new(5.0e6 + 0.123, 420.5, -3.1e6 - 0.707);
/// Edge of the chunk in metres; a quantisation step is 2 mm.
const CHUNK_METRES: f64 = 128.0;

/// A vertex as this engine stores it: 16-bit position with the material in the fourth component, then a packed normal.
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
struct Vertex {
    position: [i16; 3],
    material: i16,
    normal: [i8; 4],
}

impl Vertex {
    const fn new(position: [i16; 3]) -> Self {
        Self { position, material: 7, normal: [0, 127, 0, 0] }
    }
}

/// A mesh of the engine in quantised units.
struct Chunk {
    vertices: Vec<Vertex>,
    indices: Vec<u16>,
}

impl Chunk {
    /// A box between two corners in metres.
    fn add_box(&mut self, min: DVec3, max: DVec3) {
        let first = self.vertices.len() as u16;
        let quantised = |metres: f64| (metres / CHUNK_METRES * f64::from(i16::MAX)).round() as i16;
        self.vertices.extend((0..8).map(|corner| {
            let pick = |axis: usize| if corner >> axis & 1 == 0 { min[axis] } else { max[axis] };
            Vertex::new([quantised(pick(0)), quantised(pick(1)), quantised(pick(2))])
        }));
        let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
        self.indices.extend(faces.iter().flat_map(|[a, b, c, d]| [a, b, c, a, c, d].map(|k| first + k)));
    }

    /// Triangles relative to the eye, decoded by the engine itself in f64.
    fn triangles_from_eye(&self, eye: DVec3) -> Vec<[DVec3; 3]> {
        let corner = |index: u16| {
            let [x, y, z] =
                self.vertices[usize::from(index)].position.map(|value| f64::from(value) / 32767.0);
            DVec3::new(x, y, z) * CHUNK_METRES + (ORIGIN - eye)
        };
        self.indices
            .chunks_exact(3)
            .map(|corners| [corner(corners[0]), corner(corners[1]), corner(corners[2])])
            .collect()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    // The engine's geometry: a street of houses.
    let mut chunk = Chunk { vertices: Vec::new(), indices: Vec::new() };
    for house in 0..14 {
        let (side, along) = (f64::from(house % 2) * 26.0 - 18.0, f64::from(house / 2) * 14.0 - 50.0);
        let height = 4.0 + f64::from(house * 7 % 5) * 1.7;
        chunk.add_box(DVec3::new(side, 0.0, along), DVec3::new(side + 10.0, height, along + 9.0));
    }

    // Register its buffers as they are.
    let gpu = Gpu::for_table(&planet::TABLE)?;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &planet::TABLE, &Options::default())?;
    let vertices = gpu.buffer(&chunk.vertices, wgpu::BufferUsages::VERTEX);
    let indices = gpu.buffer(&chunk.indices, wgpu::BufferUsages::INDEX);
    let mesh = service.add_mesh(&MeshDescription {
        vertices: &vertices,
        vertices_offset_bytes: 0,
        vertex_count: chunk.vertices.len() as u32,
        stride_bytes: size_of::<Vertex>() as u32,
        position_offset_bytes: 0,
        position_format: wgpu::VertexFormat::Snorm16x4,
        indices: Some(IndexDescription {
            buffer: &indices,
            offset_bytes: 0,
            count: chunk.indices.len() as u32,
            format: wgpu::IndexFormat::Uint16,
        }),
        // What the vertex fetch yields: normalised integers.
        bounds_object: BoundingBox { min: DVec3::splat(-1.0), max: DVec3::splat(1.0) },
        clusters: &[],
        mask: None,
    })?;

    // Decode in the transform, in f64.
    let (_, no_turn, _) = DAffine3::IDENTITY.to_scale_rotation_translation();
    let world_from_object =
        DAffine3::from_scale_rotation_translation(DVec3::splat(CHUNK_METRES), no_turn, ORIGIN);

    // Capture a view from the street.
    let eye = ORIGIN + DVec3::new(3.0, 1.7, 55.0);
    let view = View::perspective(eye, eye - DVec3::Z, DVec3::Y, 1.1, 0.1, f64::INFINITY, (1280, 720))?;
    let light = Light::directional_travelling(DVec3::new(0.6, -0.8, -0.35))?;
    let plan = plan(&planet::case(), &view, &light, &SceneBounds::default())?;
    let frame = service.prepare(&plan, &view, &[CasterInstance { mesh, world_from_object }])?;
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None)?;
    gpu.queue.submit([encoder.finish()]);
    let map = service.read_map()?;
    println!("{} triangles in {} draws", frame.statistics().triangles, frame.statistics().draws);

    // Compare with the same geometry decoded and drawn in f64: a metre of error would move whole houses.
    let truth = cssm::core::twin::capture(&plan, &chunk.triangles_from_eye(eye));
    let differs = |(stored, exact): &(&f32, &f64)| (f64::from(**stored) - **exact).abs() > 1e-3;
    let wrong = map.iter().zip(&truth.depths).filter(differs).count();
    let cleared = plan.depth_order.cleared();
    let covered = truth.depths.iter().filter(|depth| **depth != cleared).count();
    println!("{wrong} of {covered} covered texels differ from the f64 twin: texels on edges");
    assert!(covered > 10_000, "the houses are in the map");
    assert!(wrong * 200 < covered, "only edges may differ");

    let grey: Vec<u8> = map.iter().map(|depth| (depth * 255.0) as u8).collect();
    write_picture("quantised_vertices", (planet::TABLE.map_width, planet::TABLE.map_height), &grey)
}
