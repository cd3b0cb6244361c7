//! The engine's own vertex functions place the casters: a skinned stem, and leaves that are instanced, displaced by wind
//! and cut out by a function.
//!
//! `build.rs` composed capture shaders around `shaders/plants.wgsl`. The engine makes pipelines of them, and the service
//! hands it the capture pass facet by facet. The engine's camera pass places vertices with the same functions. What the
//! shadows on the ground must be is found by casting rays at the plants, placed once more in f64.
//!
//! Run with `cargo run -p cssm-examples --example engine_casters`.

use std::error::Error;

use cssm::core::glam::{DAffine3, DMat3, DMat4, DVec2, DVec3, DVec4};
use cssm::core::table::caster_rows;
use cssm::runtime::{
    CasterPipelineDescription, CasterPipelines, EngineFacet, Options, PreparedFrame, ShadowService, wgpu,
};
use cssm::{BoundingBox, Light, SceneBounds, ShadowPlan, View, plan};
use cssm_examples::{Gpu, camera_numbers, write_picture};

include!(concat!(env!("OUT_DIR"), "/meadow.rs"));
include!(concat!(env!("OUT_DIR"), "/meadow_stem.rs"));
include!(concat!(env!("OUT_DIR"), "/meadow_leaf.rs"));

/// Size of the picture.
const SIZE: (u32, u32) = (640, 400);
/// Where the meadow lies.
const ORIGIN: DVec3 = DVec3::new(2.3e6, 55.0, -6.1e5);
/// Where the light's rays travel.
const TRAVEL: DVec3 = DVec3::new(0.15, -1.0, 0.75);
/// Number of leaves.
const LEAVES: usize = 40;
/// Half the side of a leaf's square, as in the shader.
const LEAF_SIZE: f64 = 0.7;
/// Height of the stem at rest.
const STEM_HEIGHT: f64 = 8.0;

/// The engine's camera pass; placing vertices comes from `plants.wgsl`, `meadow_visibility` from the generated module.
const CAMERA_PASS: &str = "
struct Camera { clip_from_camera: mat4x4<f32>, camera_from_origin: mat4x4<f32>, toward_light: vec4<f32> }
@group(0) @binding(0) var<uniform> camera: Camera;

struct Varying {
    @builtin(position) clip: vec4<f32>,
    @location(0) position: vec3<f32>,
    @location(1) uv: vec2<f32>,
}

fn seen(position: vec3<f32>, uv: vec2<f32>) -> Varying {
    let camera_position = camera.camera_from_origin * vec4<f32>(position, 1.0);
    return Varying(camera.clip_from_camera * camera_position, camera_position.xyz, uv);
}

@vertex fn ground_vertex(@builtin(vertex_index) corner: u32) -> Varying {
    let square = vec2<f32>(f32(corner & 1u), f32(corner >> 1u)) * 2.0 - 1.0;
    return seen(40.0 * vec3<f32>(square.x, 0.0, square.y), square);
}
@vertex fn stem_vertex(vertex: StemVertex) -> Varying {
    return seen(stem_position(vertex), vec2<f32>(0.0));
}
@vertex fn leaf_vertex(vertex: LeafVertex) -> Varying {
    let caster = leaf(vertex);
    return seen(caster.position, caster.uv);
}

struct Pixel { @location(0) colour: vec4<f32>, @location(1) ground: f32 }

fn shaded(surface: Varying, normal: vec3<f32>, colour: vec3<f32>, both_sides: f32) -> vec4<f32> {
    let facing = dot(normal, camera.toward_light.xyz);
    let sun = max(facing, -both_sides * facing) * meadow_visibility(surface.position, normal);
    return vec4<f32>(colour * (vec3<f32>(0.2, 0.25, 0.33) + sun * vec3<f32>(1.0, 0.93, 0.76)), 1.0);
}
fn facet_normal(position: vec3<f32>) -> vec3<f32> {
    let normal = normalize(cross(dpdx(position), dpdy(position)));
    return normal * -sign(dot(normal, position));
}

@fragment fn ground_fragment(surface: Varying) -> Pixel {
    let up = normalize((camera.camera_from_origin * vec4<f32>(0.0, 1.0, 0.0, 0.0)).xyz);
    let squares = 0.06 * sign(sin(63.0 * surface.uv.x) * sin(63.0 * surface.uv.y));
    let visibility = meadow_visibility(surface.position, up);
    return Pixel(shaded(surface, up, vec3<f32>(0.34, 0.5, 0.24) + squares, 0.0), 0.5 + 0.5 * visibility);
}
@fragment fn stem_fragment(surface: Varying) -> Pixel {
    return Pixel(shaded(surface, facet_normal(surface.position), vec3<f32>(0.5, 0.42, 0.2), 0.0), 0.0);
}
@fragment fn leaf_fragment(surface: Varying) -> Pixel {
    let normal = facet_normal(surface.position);
    if leaf_hole(surface.uv) {
        discard;
    }
    return Pixel(shaded(surface, normal, vec3<f32>(0.75, 0.35, 0.2), 0.6), 0.0);
}
";

/// A vertex of the stem at rest.
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
struct StemVertex {
    position: [f32; 3],
    bend: f32,
}

/// The plants as the engine animates them, in f64.
struct Plants {
    joints: [DMat4; 2],
    leaves: Vec<DVec4>,
    wind: DVec4,
}

impl Plants {
    /// One moment: `turn` is how far the second joint is turned, in radians.
    fn new(turn: f64) -> Self {
        let pivot = DVec3::new(0.0, 2.2, 0.0);
        let turned = DMat4::from_translation(pivot)
            * DMat4::from_axis_angle(DVec3::new(0.3, 0.0, 1.0).normalize(), turn)
            * DMat4::from_translation(-pivot);
        // Leaves stand on a spiral around the stem.
        let leaf = |number: usize| {
            let angle = number as f64 * 2.4;
            let radius = 3.6 + number as f64 * 0.12;
            let height = 1.2 + (number * 7 % 11) as f64 * 0.32;
            DVec4::new(radius * angle.cos(), height, radius * angle.sin(), angle * 1.7)
        };
        let leaves = (0..LEAVES).map(leaf).collect();
        Self { joints: [DMat4::IDENTITY, turned], leaves, wind: DVec4::new(0.5, 0.1, -0.3, 0.8) }
    }

    /// What the shaders read.
    fn uniform(&self) -> Vec<f32> {
        let joints = self.joints.iter().flat_map(|joint| joint.as_mat4().to_cols_array());
        let leaves = self.leaves.iter().chain([&self.wind]).flat_map(|leaf| leaf.as_vec4().to_array());
        joints.chain(leaves).collect()
    }

    /// Places a vertex of the stem.
    fn stem(&self, vertex: &StemVertex) -> DVec3 {
        let rest = DVec3::from_array(vertex.position.map(f64::from));
        let [one, two] = self.joints.map(|joint| joint.transform_point3(rest));
        one.lerp(two, f64::from(vertex.bend))
    }

    /// Centre, axes across and along of a leaf.
    fn leaf(&self, place: &DVec4) -> (DVec3, DVec3, DVec3) {
        let across = DVec3::new(place.w.cos(), 0.0, place.w.sin());
        let along = DVec3::new(0.6 * across.z, 0.8, -0.6 * across.x);
        let centre = place.truncate() + self.wind.truncate() * (self.wind.w + place.x).sin();
        (centre, across * LEAF_SIZE, along * LEAF_SIZE)
    }

    /// Whether a point of the ground sees the light.
    fn is_lit(&self, point: DVec3, stem: &Stem) -> bool {
        let toward = -TRAVEL;
        let corner = |index: &u16| self.stem(&stem.vertices[usize::from(*index)]);
        let by_stem = stem.indices.chunks_exact(3).any(|triangle| {
            let [a, b, c] = [0, 1, 2].map(|k| corner(&triangle[k]));
            meets(point, toward, a, b - a, c - a)
                .is_some_and(|uv| uv.min_element() >= 0.0 && uv.x + uv.y <= 1.0)
        });
        let by_leaf = self.leaves.iter().any(|place| {
            let (centre, across, along) = self.leaf(place);
            let is_leaf = |uv: DVec2| uv.length() <= 1.0 && (uv - DVec2::new(0.35, 0.25)).length() >= 0.4;
            meets(point, toward, centre, across, along).is_some_and(is_leaf)
        });
        !by_stem && !by_leaf
    }
}

/// Where a ray meets a plane, in multiples of the plane's two axes; `None` behind the ray's start and beside it.
fn meets(start: DVec3, along: DVec3, corner: DVec3, one: DVec3, two: DVec3) -> Option<DVec2> {
    let axes = DMat3::from_cols(one, two, -along);
    let found = axes.inverse() * (start - corner);
    (found.is_finite() && found.z > 1e-9).then_some(found.truncate())
}

/// The stem at rest: rings around a straight line.
struct Stem {
    vertices: Vec<StemVertex>,
    indices: Vec<u16>,
}

impl Stem {
    fn new() -> Self {
        const SIDES: u16 = 10;
        const RINGS: u16 = 20;
        let mut stem = Self { vertices: Vec::new(), indices: Vec::new() };
        for ring in 0..=RINGS {
            let share = f32::from(ring) / f32::from(RINGS);
            for side in 0..SIDES {
                let angle = f32::from(side) / f32::from(SIDES) * std::f32::consts::TAU;
                let radius = 0.9 - 0.6 * share;
                let position = [radius * angle.cos(), share * STEM_HEIGHT as f32, radius * angle.sin()];
                stem.vertices.push(StemVertex { position, bend: share * share * (3.0 - 2.0 * share) });
            }
        }
        for (ring, side) in (0..RINGS).flat_map(|ring| (0..SIDES).map(move |side| (ring, side))) {
            let at = |ring: u16, side: u16| ring * SIDES + side % SIDES;
            let [a, b, c, d] =
                [at(ring, side), at(ring, side + 1), at(ring + 1, side + 1), at(ring + 1, side)];
            stem.indices.extend([a, b, c, a, c, d]);
        }
        stem
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let gpu = Gpu::for_table(&meadow::TABLE)?;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &meadow::TABLE, &Options::default())?;

    // Plan a frame. The service holds no mesh: every caster is the engine's.
    let eye = ORIGIN + DVec3::new(-3.0, 9.0, 20.0);
    let view =
        View::perspective(eye, ORIGIN + DVec3::new(-2.0, 1.2, 0.0), DVec3::Y, 0.9, 0.1, f64::INFINITY, SIZE)?;
    let light = Light::directional_travelling(TRAVEL)?;
    let plan = plan(&meadow::case(), &view, &light, &SceneBounds::default())?;
    let frame = service.prepare(&plan, &view, &[])?;

    // Draw one moment, and the same shadows once more with a stem that nobody has bent.
    let (bent, straight) = (Plants::new(0.85), Plants::new(0.0));
    let engine = Engine::new(&gpu, &service, &view, &plan, &bent)?;
    let (picture, ground) = engine.draw(&gpu, &service, &frame, &plan, &bent)?;
    let (_, unbent) = engine.draw(&gpu, &service, &frame, &plan, &straight)?;

    // The shadows are where rays say that they are, and nowhere near with the stem at rest.
    let (wrong, shaded, judged) = compare(&view, &bent, &ground);
    let (wrong_unbent, ..) = compare(&view, &bent, &unbent);
    println!("{wrong} of {judged} points of the ground differ from ray casting; {shaded} are in shadow");
    println!("{wrong_unbent} would differ if the capture did not bend the stem");
    write_picture("engine_casters", SIZE, &picture)?;
    assert!(shaded * 40 > judged, "the plants throw shadows");
    assert!(wrong * 500 < judged, "shadows are where rays say");
    assert!(wrong_unbent > 10 * wrong.max(10), "the capture follows the skinning");
    Ok(())
}

/// Compares visibility of the ground with rays, away from the edges of shadows: points that differ, points in shadow,
/// points judged.
fn compare(view: &View, plants: &Plants, ground: &[u8]) -> (usize, usize, usize) {
    /// Distance from an edge below which filtering may show.
    const EDGE_METRES: f64 = 0.06;
    let stem = Stem::new();
    let (mut wrong, mut shaded, mut judged) = (0, 0, 0);
    for (x, y) in (0..SIZE.1).step_by(2).flat_map(|y| (0..SIZE.0).step_by(2).map(move |x| (x, y))) {
        let stored = ground[(y * SIZE.0 + x) as usize];
        if stored < 100 {
            continue;
        }
        // Find the point of the ground under the pixel.
        let across = (f64::from(x) + 0.5) / f64::from(SIZE.0);
        let down = (f64::from(y) + 0.5) / f64::from(SIZE.1);
        let ray = DVec3::new(
            view.left + across * (view.right - view.left),
            view.top + down * (view.bottom - view.top),
            -1.0,
        );
        let ray = view.camera_from_world.transpose() * ray;
        let eye = view.eye_world - ORIGIN;
        let point = eye + ray * (-eye.y / ray.y);
        let lit = |x: f64, z: f64| plants.is_lit(point + DVec3::new(x, 0.0, z) * EDGE_METRES, &stem);
        let truth = lit(0.0, 0.0);
        if [lit(1.0, 0.0), lit(-1.0, 0.0), lit(0.0, 1.0), lit(0.0, -1.0)].iter().any(|near| *near != truth) {
            continue;
        }
        judged += 1;
        shaded += usize::from(!truth);
        wrong += usize::from((stored > 191) != truth);
    }
    (wrong, shaded, judged)
}

/// The engine's renderer.
struct Engine {
    stem: Mesh,
    leaf: Mesh,
    plants_group: wgpu::BindGroup,
    plants: wgpu::Buffer,
    rows: wgpu::Buffer,
    camera_group: wgpu::BindGroup,
    capture: Drawn<CasterPipelines>,
    camera: Drawn<wgpu::RenderPipeline>,
    ground: wgpu::RenderPipeline,
}

/// One thing for each kind of plant.
struct Drawn<T> {
    stem: T,
    leaf: T,
}

struct Mesh {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    count: u32,
    instances: u32,
}

impl Mesh {
    fn draw(&self, pass: &mut wgpu::RenderPass) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint16);
        pass.draw_indexed(0..self.count, 0, 0..self.instances);
    }
}

impl Engine {
    fn new(
        gpu: &Gpu,
        service: &ShadowService,
        view: &View,
        plan: &ShadowPlan,
        plants: &Plants,
    ) -> Result<Self, Box<dyn Error>> {
        // The engine's buffers.
        let stem = Stem::new();
        let (vertex, index) = (wgpu::BufferUsages::VERTEX, wgpu::BufferUsages::INDEX);
        let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0_f32]];
        let stem_mesh = Mesh {
            vertices: gpu.buffer(&stem.vertices, vertex),
            indices: gpu.buffer(&stem.indices, index),
            count: stem.indices.len() as u32,
            instances: 1,
        };
        let leaf_mesh = Mesh {
            vertices: gpu.buffer(&corners, vertex),
            indices: gpu.buffer(&[0_u16, 1, 2, 0, 2, 3], index),
            count: 6,
            instances: LEAVES as u32,
        };

        // Where casters stand, in the axes of this plan's capture: the stem by instance rows, the leaves by their origin's.
        let rows =
            caster_rows(plan, &DAffine3::from_translation(ORIGIN)).ok_or("the meadow is out of reach")?;
        let rows = gpu.buffer(rows.as_flattened(), vertex | wgpu::BufferUsages::UNIFORM);
        let plants = gpu.buffer(&plants.uniform(), wgpu::BufferUsages::UNIFORM);
        let (camera_layout, camera_group) = {
            let camera =
                gpu.buffer(&camera_numbers(view, ORIGIN, plan.light.truncate()), wgpu::BufferUsages::UNIFORM);
            gpu.uniform_group(&[&camera])
        };
        let (plants_layout, plants_group) = gpu.uniform_group(&[&plants, &rows]);

        // Pipelines of the capture: composed shaders, the engine's vertex formats and bind groups.
        let stem_layout = wgpu::VertexBufferLayout {
            array_stride: size_of::<StemVertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32],
        };
        let rows_layout = wgpu::VertexBufferLayout {
            array_stride: 48,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &wgpu::vertex_attr_array![2 => Float32x4, 3 => Float32x4, 4 => Float32x4],
        };
        let leaf_layout = wgpu::VertexBufferLayout {
            array_stride: 8,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x2],
        };
        let capture = |casters, buffers: &[Option<wgpu::VertexBufferLayout>]| {
            service.caster_pipelines(&CasterPipelineDescription {
                casters,
                bind_group_layouts: &[None, Some(&plants_layout)],
                buffers,
                topology: wgpu::PrimitiveTopology::TriangleList,
                strip_index_format: None,
            })
        };
        let capture = Drawn {
            stem: capture(&meadow_stem::CASTERS, &[Some(stem_layout.clone()), Some(rows_layout)])?,
            leaf: capture(&meadow_leaf::CASTERS, &[Some(leaf_layout.clone())])?,
        };

        // Pipelines of the camera pass, with the same functions.
        let source = [meadow::FUNCTION_WGSL, include_str!("../shaders/plants.wgsl"), CAMERA_PASS].concat();
        let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("camera"),
            source: wgpu::ShaderSource::Wgsl(source.into()),
        });
        let groups = [Some(&camera_layout), Some(&plants_layout), service.shadow_bind_group_layout()];
        let pipeline = |vertex, fragment, topology, buffers: &[Option<wgpu::VertexBufferLayout>]| {
            let formats = [wgpu::TextureFormat::Rgba8UnormSrgb, wgpu::TextureFormat::R8Unorm];
            gpu.pipeline(&module, [vertex, fragment], &groups, buffers, topology, &formats)
        };
        let (list, strip) = (wgpu::PrimitiveTopology::TriangleList, wgpu::PrimitiveTopology::TriangleStrip);
        let camera = Drawn {
            stem: pipeline("stem_vertex", "stem_fragment", list, &[Some(stem_layout)]),
            leaf: pipeline("leaf_vertex", "leaf_fragment", list, &[Some(leaf_layout)]),
        };
        let ground = pipeline("ground_vertex", "ground_fragment", strip, &[]);
        Ok(Self {
            stem: stem_mesh,
            leaf: leaf_mesh,
            plants_group,
            plants,
            rows,
            camera_group,
            capture,
            camera,
            ground,
        })
    }

    /// Captures the plants and draws the meadow: its picture and the visibility of its ground.
    fn draw(
        &self,
        gpu: &Gpu,
        service: &ShadowService,
        frame: &PreparedFrame,
        plan: &ShadowPlan,
        plants: &Plants,
    ) -> Result<(Vec<u8>, Vec<u8>), Box<dyn Error>> {
        // Cull by boxes that hold whatever the animation does.
        let bounds = |half: DVec3, centre: DVec3| {
            let centre = ORIGIN - plan.eye_world + centre;
            BoundingBox { min: centre - half, max: centre + half }
        };
        let stem = bounds(DVec3::splat(STEM_HEIGHT + 2.0), DVec3::Y * 2.0);
        let leaves = bounds(DVec3::new(11.0, 4.0, 11.0), DVec3::Y * 3.0);
        gpu.queue.write_buffer(&self.plants, 0, bytemuck::cast_slice(&plants.uniform()));
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        service.capture_with(
            &mut encoder,
            frame,
            plan,
            None,
            |pass, EngineFacet { facet, depth_order, .. }| {
                pass.set_bind_group(1, &self.plants_group, &[]);
                if facet.reached_by(&stem) {
                    pass.set_pipeline(self.capture.stem.of(depth_order));
                    pass.set_vertex_buffer(1, self.rows.slice(..));
                    self.stem.draw(pass);
                }
                if facet.reached_by(&leaves) {
                    pass.set_pipeline(self.capture.leaf.of(depth_order));
                    self.leaf.draw(pass);
                }
            },
        )?;

        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let read = usage | wgpu::TextureUsages::COPY_SRC;
        let picture = gpu.texture(SIZE, wgpu::TextureFormat::Rgba8UnormSrgb, read);
        let ground = gpu.texture(SIZE, wgpu::TextureFormat::R8Unorm, read);
        let depth = gpu.texture(SIZE, wgpu::TextureFormat::Depth32Float, usage);
        let sky = wgpu::Color { r: 0.35, g: 0.55, b: 0.85, a: 1.0 };
        let mut pass = gpu.pass(&mut encoder, &[(&picture, sky), (&ground, wgpu::Color::BLACK)], &depth);
        pass.set_bind_group(0, &self.camera_group, &[]);
        pass.set_bind_group(1, &self.plants_group, &[]);
        pass.set_bind_group(2, frame.shadow_bind_group(), &[]);
        pass.set_pipeline(&self.ground);
        pass.draw(0..4, 0..1);
        pass.set_pipeline(&self.camera.stem);
        self.stem.draw(&mut pass);
        pass.set_pipeline(&self.camera.leaf);
        self.leaf.draw(&mut pass);
        drop(pass);
        gpu.queue.submit([encoder.finish()]);
        Ok((gpu.read(&picture)?, gpu.read(&ground)?))
    }
}
