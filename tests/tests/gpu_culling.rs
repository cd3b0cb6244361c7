//! Culling on the device: it draws what the CPU draws, and no more than f32 cannot tell.

use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

use cssm_codegen::generate;
use cssm_core::case::Casters;
use cssm_core::glam::{DVec3, DVec4};
use cssm_core::table::CaseTable;
use cssm_core::{BoundingBox, Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_lab::scene::Scene;
use cssm_runtime::{
    CasterInstance, Cluster, Command, Culling, FrameCommands, MeshDescription, MeshHandle, Options,
    PreparedFrame, ShadowService, cluster_triangles,
};
use cssm_tests::gpu::device::culling_device;
use cssm_tests::gpu::{Geometry, TestDevice, Yard, exclusive, yard};
use cssm_tests::touch::{box_corners, touches};
use shaders_gen::shipped;

#[path = "support/reading.rs"]
mod reading;

use reading::{fused, lost};

const SIZE: (u32, u32) = (640, 360);
const CASES: [(&str, &str); 2] = [("Sun", shipped::SUN), ("Pssm4Log", shipped::PSSM4_LOG)];
/// Share of the size of all numbers in a test by which a box that the device draws may lie outside: rounding of boxes and
/// the stated margin of 2^-19.
const MARGIN: f64 = 4e-6;

fn case((name, text): (&str, &str)) -> LightCase {
    let case = pick_case(Path::new("case.cssm"), text, Some(name)).unwrap();
    let case = with_map_size(case, (1024, 1024)).unwrap();
    // Cutouts are drawn as if they were whole.
    LightCase { casters: Casters::Opaque, ..case }
}

fn table(case: &LightCase) -> CaseTable {
    generate(case).unwrap().table
}

fn planned(case: &LightCase, scene: &Scene, view: usize) -> (View, ShadowPlan) {
    let (view, light) = scene.views[view].pictured(SIZE).unwrap();
    let bounds = SceneBounds::of(scene.bounds_world());
    (view, plan(case, &view, &light, &bounds).unwrap())
}

/// A mesh in clusters.
struct Shape {
    geometry: Geometry,
    clusters: Vec<Cluster>,
}

/// Shapes and their instances, some shapes without indices.
struct Content {
    shapes: Vec<Shape>,
    instances: Vec<(usize, CasterInstance)>,
}

/// Which shapes are drawn without indices.
const fn is_unindexed(shape: usize) -> bool {
    shape % 3 == 1
}

impl Content {
    fn new(scene: &Scene) -> Self {
        let shapes = scene.meshes.iter().enumerate().map(|(number, mesh)| {
            let at = |index: u32| DVec3::from_array(mesh.positions[index as usize].map(f64::from));
            let clustered = cluster_triangles(|index| Some(at(index)), &mesh.indices).unwrap();
            let (positions, indices) = match is_unindexed(number) {
                false => (mesh.positions.clone(), clustered.indices),
                true => {
                    let corners = clustered.indices.iter();
                    (corners.map(|index| mesh.positions[*index as usize]).collect(), vec![0])
                }
            };
            Shape { geometry: Geometry { positions, indices }, clusters: clustered.clusters }
        });
        let instances = scene.instances.iter().map(|instance| {
            let mesh = MeshHandle::new(instance.mesh as u32, 0);
            (instance.mesh, CasterInstance { mesh, world_from_object: instance.world_from_object })
        });
        Self { shapes: shapes.collect(), instances: instances.collect() }
    }

    /// A service with the shapes; their handles are their numbers.
    fn load(&self, gpu: &TestDevice, table: &CaseTable, culling: Culling) -> ShadowService {
        let options = Options { culling, ..Options::default() };
        let mut service = ShadowService::new(&gpu.device, &gpu.queue, table, &options).unwrap();
        for (number, shape) in self.shapes.iter().enumerate() {
            let buffers = shape.geometry.upload(gpu);
            let whole = buffers.description();
            let indices = whole.indices.clone().filter(|_| !is_unindexed(number));
            let description = MeshDescription { indices, clusters: &shape.clusters, ..whole };
            assert_eq!(service.add_mesh(&description).unwrap(), MeshHandle::new(number as u32, 0));
        }
        service
    }

    fn casters(&self) -> Vec<CasterInstance> {
        self.instances.iter().map(|(_, instance)| *instance).collect()
    }

    fn bounds(&self, shape: usize) -> BoundingBox {
        self.shapes[shape].geometry.bounds()
    }
}

/// Corners of an instance's box relative to a plan's eye.
fn corners(plan: &ShadowPlan, bounds: &BoundingBox, instance: &CasterInstance) -> [DVec3; 8] {
    let mut eye_from_object = instance.world_from_object;
    eye_from_object.translation -= plan.eye_world;
    box_corners(bounds, &eye_from_object)
}

/// Whether the surface of a box reaches into all half-spaces of a facet by more than rounding.
fn is_touched(plan: &ShadowPlan, facet: usize, bounds: &BoundingBox, instance: &CasterInstance) -> bool {
    let corners = corners(plan, bounds, instance);
    let size = corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
    let planes = plan.facets[facet]
        .casters
        .iter()
        .map(|plane| *plane - DVec4::W * (MARGIN * (plane.truncate().length() * size + plane.w.abs())));
    let planes: Vec<DVec4> = planes.collect();
    let sides = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]];
    sides.iter().any(|side| touches(&side.map(|corner: usize| corners[corner]), &planes))
}

/// By how much a box lies outside a facet, as a share of the size of all numbers that tell; below zero where it reaches.
fn outside(plan: &ShadowPlan, facet: usize, bounds: &BoundingBox, instance: &CasterInstance) -> f64 {
    let corners = corners(plan, bounds, instance);
    // The device tests in the axes of the capture, where numbers have another size.
    let turn = plan.capture_from_world();
    let turn_back = turn.inverse().transpose();
    let reach = plan.facets[facet].casters.iter().map(|plane| {
        let nearest = corners.iter().map(|corner| plane.dot(corner.extend(1.0))).fold(f64::MIN, f64::max);
        let normal = (turn_back * plane.truncate()).abs();
        let matrix = turn * instance.world_from_object.matrix3;
        let shift = (turn * (instance.world_from_object.translation - plan.eye_world)).abs();
        let size = (matrix.abs() * bounds.min.abs().max(bounds.max.abs())) * 2.0 + shift;
        -nearest / (normal.dot(size) + plane.w.abs())
    });
    reach.fold(f64::MIN, f64::max)
}

/// What each facet draws of each instance, which is known by its rows: ranges of corners.
type Drawn = BTreeMap<(u32, u32, [u32; 12]), Vec<Range<u32>>>;

fn drawn(commands: &FrameCommands) -> Drawn {
    let (mut facet_here, mut mesh_here) = (0, 0);
    let mut drawn = Drawn::new();
    for command in &commands.commands {
        match command {
            Command::Facet { facet, .. } => facet_here = facet.0,
            Command::Mesh(mesh) => {
                mesh_here = (0..1000).find(|number| MeshHandle::new(*number, 0) == *mesh).unwrap();
            }
            Command::Draw { first, count, instances, .. } => {
                for row in instances.clone() {
                    let rows = commands.rows[row as usize].0;
                    let bits = std::array::from_fn(|at| rows[at / 4][at % 4].to_bits());
                    drawn.entry((facet_here, mesh_here, bits)).or_default().push(*first..first + count);
                }
            }
            Command::Pipeline(_) => {}
            other => panic!("{other:?} was not read back"),
        }
    }
    drawn
}

/// The frame's map, and what was drawn into it.
fn captured(gpu: &TestDevice, service: &ShadowService, frame: &PreparedFrame) -> (Vec<f32>, FrameCommands) {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, frame, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    (service.read_map().unwrap(), service.read_commands(frame).unwrap())
}

/// Instances and clusters that the device draws although the CPU would refuse them, after it has been found to draw
/// everything that the CPU does not refuse.
fn compare(content: &Content, plan: &ShadowPlan, cpu: &Drawn, gpu: &Drawn) -> (usize, usize, usize) {
    for key in cpu.keys() {
        assert!(gpu.contains_key(key), "facet {} lacks an instance of mesh {}", key.0, key.1);
    }
    let rows = |number: usize| {
        let probe = ShadowPlan { facets: Vec::new(), ..plan.clone() };
        let eye = content.instances[number].1.world_from_object;
        let turn = probe.capture_from_world();
        let (matrix, shift) = (turn * eye.matrix3, turn * (eye.translation - plan.eye_world));
        std::array::from_fn::<u32, 12, _>(|at| {
            let value = if at % 4 == 3 { shift[at / 4] } else { matrix.col(at % 4)[at / 4] };
            (value as f32).to_bits()
        })
    };
    let (mut clusters, mut extra_instances, mut extra_clusters) = (0, 0, 0);
    for (number, (shape, instance)) in content.instances.iter().enumerate() {
        let rows = rows(number);
        for facet in 0..plan.facets.len() {
            let key = (facet as u32, *shape as u32, rows);
            let far = outside(plan, facet, &content.bounds(*shape), instance);
            let Some(ranges) = gpu.get(&key) else {
                // The CPU finds no cluster that reaches where the box does.
                let own = &content.shapes[*shape].clusters;
                let reached = own.iter().any(|one| is_touched(plan, facet, &one.bounds_object, instance));
                let touched = is_touched(plan, facet, &content.bounds(*shape), instance);
                assert!(!touched || !reached, "facet {facet} lacks instance {number}");
                continue;
            };
            assert!(far < MARGIN, "facet {facet} draws instance {number}, which is {far} outside");
            extra_instances += usize::from(far > 0.0);

            // Ranges are those of clusters, each once, or all corners.
            let corners: u32 = ranges.iter().map(|range| range.end - range.start).sum();
            let own = &content.shapes[*shape].clusters;
            let all: u32 = own.iter().map(|cluster| cluster.count).sum();
            assert!(corners <= all);
            for cluster in own {
                let holds = |range: &Range<u32>| range.contains(&cluster.first);
                let is_drawn = ranges.iter().any(holds);
                let far = outside(plan, facet, &cluster.bounds_object, instance);
                let touched = is_touched(plan, facet, &cluster.bounds_object, instance);
                assert!(is_drawn || !touched, "facet {facet} lacks a cluster of instance {number}");
                clusters += usize::from(is_drawn && corners < all);
                if is_drawn && corners < all {
                    assert!(far < MARGIN, "facet {facet} draws a cluster that is {far} outside");
                    extra_clusters += usize::from(far > 0.0);
                }
            }
        }
    }
    (clusters, extra_instances, extra_clusters)
}

#[test]
fn the_device_draws_what_the_cpu_draws() {
    let scenes = [fused(&Scene::palm()), Scene::pavilion(), Scene::city(), Scene::forest()];
    let mut clusters = 0;
    for scene in &scenes {
        let content = Content::new(scene);
        let casters = content.casters();
        for declared in CASES {
            let case = case(declared);
            let table = table(&case);
            let gpu = culling_device(&table);
            let mut on_cpu = content.load(&gpu, &table, Culling::Cpu);
            let mut on_gpu = content.load(&gpu, &table, Culling::Gpu);
            assert_eq!((on_cpu.culling(), on_gpu.culling()), (Culling::Cpu, Culling::Gpu));
            for number in 0..scene.views.len() {
                let (view, plan) = planned(&case, scene, number);
                let frame = on_cpu.prepare(&plan, &view, &casters).unwrap();
                let (expected, commands) = captured(&gpu, &on_cpu, &frame);
                let cpu = drawn(&commands);
                let frame = on_gpu.prepare(&plan, &view, &casters).unwrap();
                assert_eq!(frame.culling(), Culling::Gpu);
                let (map, left) = captured(&gpu, &on_gpu, &frame);
                let (of_mesh, instances, of_clusters) = compare(&content, &plan, &cpu, &drawn(&left));
                clusters += of_mesh;

                // What no receiver reads may differ where the CPU draws gaps between clusters along.
                let differing = map.iter().zip(&expected).filter(|(one, other)| one != other).count();
                let lost = lost(&plan, &map, &expected);
                println!(
                    "{:<22} {:<9} view {number}: {:4} instances, {of_mesh:5} clusters; {instances} and {of_clusters} in the margin; {differing} texels differ, {lost} that are read",
                    scene.name,
                    case.name,
                    cpu.len(),
                );
                assert_eq!(lost, 0, "{} view {number} {}", scene.name, case.name);

                // Once more, from the same frame.
                let (again, _) = captured(&gpu, &on_gpu, &frame);
                assert_eq!(again, map);
            }
        }
    }
    assert!(clusters > 1000, "only {clusters} clusters were told apart");
}

#[test]
fn the_device_draws_what_the_cpu_draws_for_lamps() {
    let case = case(("Lamp", shipped::LAMP));
    let table = table(&case);
    let gpu = culling_device(&table);
    let (mut clusters, mut configurations) = (0, BTreeMap::new());
    for scene in [Scene::pavilion(), Scene::city()] {
        let content = Content::new(&scene);
        let casters = content.casters();
        let mut on_cpu = content.load(&gpu, &table, Culling::Cpu);
        let mut on_gpu = content.load(&gpu, &table, Culling::Gpu);
        for (number, place) in [[2.0, 1.5, -9.0], [-4.0, 3.0, 5.0], [0.5, 0.2, -3.0]].into_iter().enumerate()
        {
            let (view, _) = scene.views[number % scene.views.len()].pictured(SIZE).unwrap();
            let place = view.eye_world + view.camera_from_world.transpose() * DVec3::from_array(place);
            let lamp = Light::omni(place, 30.0).unwrap();
            let plan = plan(&case, &view, &lamp, &SceneBounds::of(scene.bounds_world())).unwrap();
            let frame = on_cpu.prepare(&plan, &view, &casters).unwrap();
            let (expected, commands) = captured(&gpu, &on_cpu, &frame);
            let frame = on_gpu.prepare(&plan, &view, &casters).unwrap();
            let (map, left) = captured(&gpu, &on_gpu, &frame);
            let (of_mesh, ..) = compare(&content, &plan, &drawn(&commands), &drawn(&left));
            assert_eq!(lost(&plan, &map, &expected), 0, "{} lamp {number}", scene.name);
            clusters += of_mesh;
            *configurations.entry(plan.configuration).or_insert(0) += 1;
        }
    }
    assert!(clusters > 100 && configurations.len() > 1, "{clusters} clusters, {configurations:?}");
}

#[test]
fn nothing_is_lost_far_from_the_origin() {
    let case = case(CASES[0]);
    let table = table(&case);
    let gpu = culling_device(&table);
    let yard = Yard::new();
    let map = |culling: Culling, view: &View, plan: &ShadowPlan| {
        let options = Options { culling, ..Options::default() };
        let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &options).unwrap();
        let buffers = yard.upload(&gpu);
        let casters = yard.add_to(&mut service, &buffers).unwrap();
        let frame = service.prepare(plan, view, &casters).unwrap();
        assert_eq!(frame.culling(), culling);
        captured(&gpu, &service, &frame)
    };
    for view in yard::views(SIZE) {
        for light in yard::suns() {
            let plan = plan(&case, &view, &light, &SceneBounds::of(Some(yard.bounds()))).unwrap();
            let (expected, cpu) = map(Culling::Cpu, &view, &plan);
            let (found, left) = map(Culling::Gpu, &view, &plan);
            assert_eq!(found, expected);
            let (cpu, gpu) = (drawn(&cpu), drawn(&left));
            assert_eq!(cpu.keys().collect::<Vec<_>>(), gpu.keys().collect::<Vec<_>>());
        }
    }
}

#[test]
fn half_spaces_too_narrow_lose_texels() {
    let (scene, case) = (fused(&Scene::palm()), case(CASES[0]));
    let content = Content::new(&scene);
    let table = table(&case);
    let gpu = culling_device(&table);
    let mut service = content.load(&gpu, &table, Culling::Gpu);
    let (view, plan) = planned(&case, &scene, 0);
    let mut map = |plan: &ShadowPlan| {
        let frame = service.prepare(plan, &view, &content.casters()).unwrap();
        captured(&gpu, &service, &frame)
    };
    let (expected, all) = map(&plan);
    let mut narrow = plan.clone();
    for plane in narrow.facets.iter_mut().flat_map(|facet| &mut facet.casters) {
        plane.w -= 2.0 * plane.truncate().length();
    }
    let (found, fewer) = map(&narrow);
    let lost = lost(&plan, &found, &expected);
    assert!(lost > 100, "only {lost} texels tell");
    assert!(fewer.commands.len() < all.commands.len());
}

#[test]
fn frames_of_one_submission_do_not_share_draws() {
    let (scene, case) = (Scene::city(), case(CASES[1]));
    let content = Content::new(&scene);
    let table = table(&case);
    let gpu = culling_device(&table);
    let mut service = content.load(&gpu, &table, Culling::Gpu);
    let casters = content.casters();
    let planned = [0, 1].map(|number| planned(&case, &scene, number));
    let alone = planned.each_ref().map(|(view, plan)| {
        let frame = service.prepare(plan, view, &casters).unwrap();
        captured(&gpu, &service, &frame)
    });

    // Both prepared before either is recorded, and read after both.
    let frames = planned.each_ref().map(|(view, plan)| service.prepare(plan, view, &casters).unwrap());
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    for frame in frames.iter().rev() {
        service.capture(&mut encoder, frame, None).unwrap();
    }
    gpu.queue.submit([encoder.finish()]);
    assert_eq!(service.read_map().unwrap(), alone[0].0);
    for (frame, (_, expected)) in frames.iter().zip(&alone) {
        assert_eq!(drawn(&service.read_commands(frame).unwrap()), drawn(expected));
    }
}

#[test]
fn devices_that_cannot_cull_leave_it_to_the_cpu() {
    let gpu = exclusive();
    let case = case(CASES[0]);
    let content = Content::new(&Scene::palm());
    let mut service = content.load(&gpu, &table(&case), Culling::Gpu);
    assert_eq!(service.culling(), Culling::Cpu);
    let (view, plan) = planned(&case, &Scene::palm(), 0);
    let frame = service.prepare(&plan, &view, &content.casters()).unwrap();
    assert_eq!(frame.culling(), Culling::Cpu);
    assert_eq!(service.read_commands(&frame).unwrap(), *frame.commands());
}

#[test]
fn casters_that_shaders_fetch_are_culled_by_the_cpu() {
    let case = case(("SunLog", shipped::SUN_LOG));
    let table = table(&case);
    let gpu = culling_device(&table);
    let content = Content::new(&Scene::palm());
    let mut on_gpu = content.load(&gpu, &table, Culling::Gpu);
    let (view, plan) = planned(&case, &Scene::palm(), 0);
    let casters = content.casters();
    let frame = on_gpu.prepare(&plan, &view, &casters).unwrap();
    assert_eq!((on_gpu.culling(), frame.culling()), (Culling::Gpu, Culling::Cpu));
    let expected = FrameCommands::clone(&on_gpu.commands(&plan, &casters).unwrap().0);
    assert_eq!(*frame.commands(), expected);
    let (map, _) = captured(&gpu, &on_gpu, &frame);
    let mut on_cpu = content.load(&gpu, &table, Culling::Cpu);
    let frame = on_cpu.prepare(&plan, &view, &casters).unwrap();
    assert_eq!(captured(&gpu, &on_cpu, &frame).0, map);
}
