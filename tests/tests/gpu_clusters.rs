//! Clusters: far fewer triangles in every facet, the same in every texel that a receiver can read; a box too small is
//! seen.

use std::path::Path;
use std::time::Instant;

use cssm_codegen::generate;
use cssm_core::case::Casters;
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::{LightCase, SceneBounds, ShadowPlan, View, plan};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_lab::gpu::{CaseRunner, Gpu, ResolveMethod, SceneBuffers, Surface};
use cssm_lab::scene::Scene;
use cssm_lab::truth::{Frame, Tracer};
use cssm_runtime::{
    CasterInstance, Cluster, MeshDescription, MeshError, Options, ServiceError, ShadowService,
    cluster_triangles,
};
use cssm_tests::gpu::{Geometry, TestDevice, exclusive};
use shaders_gen::shipped;

#[path = "support/reading.rs"]
mod reading;

use reading::{fused, lost};

const SIZE: (u32, u32) = (640, 360);

/// Face columns of eight bands, four logarithmic splits.
const CASES: [(&str, &str); 2] = [("Sun", shipped::SUN), ("Pssm4Log", shipped::PSSM4_LOG)];

fn case((name, text): (&str, &str), scene: &Scene) -> LightCase {
    let case = pick_case(Path::new("case.cssm"), text, Some(name)).unwrap();
    let mut case = with_map_size(case, (1024, 1024)).unwrap();
    if scene.has_masks() {
        case.casters = Casters::AlphaTested;
    }
    case
}

fn planned(case: &LightCase, scene: &Scene, view: usize) -> (View, ShadowPlan) {
    let (view, light) = scene.views[view].pictured(SIZE).unwrap();
    let bounds = SceneBounds::of(scene.bounds_world());
    (view, plan(case, &view, &light, &bounds).unwrap())
}

/// A service and a scene's casters.
struct Loaded {
    service: ShadowService,
    casters: Vec<CasterInstance>,
}

impl Loaded {
    /// The scene with its clusters, and with every mesh whole.
    fn both(gpu: &Gpu, scene: &Scene, case: &LightCase) -> [Self; 2] {
        let table = generate(case).unwrap().table;
        let load = |buffers: &SceneBuffers| {
            let service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default());
            let mut service = service.unwrap();
            let casters = buffers.add_to(&mut service, scene).unwrap();
            Self { service, casters }
        };
        let buffers = SceneBuffers::new(gpu, scene).unwrap();
        [load(&buffers), load(&buffers.without_clusters())]
    }

    /// The map of a plan and how many triangles went into it.
    fn map(&mut self, gpu: &Gpu, plan: &ShadowPlan, view: &View) -> (Vec<f32>, u64) {
        let frame = self.service.prepare(plan, view, &self.casters).unwrap();
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        self.service.capture(&mut encoder, &frame, None).unwrap();
        gpu.queue.submit([encoder.finish()]);
        (self.service.read_map().unwrap(), frame.statistics().triangles)
    }

    /// Median time of building commands, in microseconds.
    fn microseconds(&self, plan: &ShadowPlan) -> f64 {
        let time = |_| {
            let start = Instant::now();
            std::hint::black_box(self.service.commands(plan, &self.casters).unwrap());
            start.elapsed().as_secs_f64() * 1e6
        };
        let mut times: Vec<f64> = (0..9).map(time).collect();
        times.sort_by(f64::total_cmp);
        times[4]
    }
}

#[test]
fn maps_with_and_without_clusters_read_the_same() {
    let scenes = [Scene::palm(), Scene::pavilion(), Scene::city()];
    let scenes = [fused(&scenes[0]), fused(&scenes[1])].into_iter().chain(scenes);
    for scene in scenes {
        for declared in CASES {
            let case = case(declared, &scene);
            let gpu = Gpu::open(&[&case], SIZE).unwrap();
            let [mut clustered, mut whole] = Loaded::both(&gpu, &scene, &case);
            for number in 0..scene.views.len() {
                let (view, plan) = planned(&case, &scene, number);
                let ((map, fewer), (expected, more)) =
                    (clustered.map(&gpu, &plan, &view), whole.map(&gpu, &plan, &view));
                assert!(fewer <= more, "{} view {number}", scene.name);
                let covered = expected.iter().filter(|depth| **depth != plan.depth_order.cleared() as f32);
                assert!(covered.count() > expected.len() / 20, "{} view {number} is no test", scene.name);
                let lost = lost(&plan, &map, &expected);
                assert_eq!(lost, 0, "{} view {number} {}", scene.name, case.name);
            }
        }
    }
}

#[test]
fn every_pixel_sees_the_same_shadow_with_and_without_clusters() {
    const PIXELS: (u32, u32) = (320, 180);
    for scene in [fused(&Scene::palm()), Scene::pavilion(), Scene::city()] {
        let tracer = Tracer::new(&scene);
        for declared in CASES {
            let case = case(declared, &scene);
            let gpu = Gpu::open(&[&case], PIXELS).unwrap();
            let table = generate(&case).unwrap().table;
            for spot in &scene.views {
                let (view, light) = spot.pictured(PIXELS).unwrap();
                let bounds = SceneBounds::of(scene.bounds_world());
                let plan = plan(&case, &view, &light, &bounds).unwrap();
                let frame = Frame::trace(&tracer, &view, &light, &|_| {});
                let surface = Surface::new(&gpu, &view, &frame).unwrap();
                let seen = |buffers: &SceneBuffers| {
                    let method = ResolveMethod::Function;
                    let runner = CaseRunner::new(&gpu, &case, &table, &scene, buffers, method);
                    let mut runner = runner.unwrap();
                    let prepared = runner.prepare(&plan, &view).unwrap();
                    runner.visibility(&gpu, &prepared, &surface).unwrap()
                };
                let buffers = SceneBuffers::new(&gpu, &scene).unwrap();
                let clustered = seen(&buffers);
                let whole = seen(&buffers.without_clusters());
                let dark = whole.iter().filter(|visible| **visible < 0.5).count();
                assert!(dark > whole.len() / 50, "{} {}: only {dark} dark pixels", scene.name, case.name);
                let differing = clustered.iter().zip(&whole).filter(|(one, other)| one != other).count();
                assert_eq!(differing, 0, "{} {}", scene.name, case.name);
            }
        }
    }
}

#[test]
fn facets_draw_few_triangles_of_large_meshes() {
    // Largest share of triangles over the scene's views, and most draws of a frame: face columns, then splits.
    let (palm, pavilion, city) = (Scene::palm(), Scene::pavilion(), Scene::city());
    let scenes = [
        (fused(&palm), [(0.11, 50), (0.4, 12)]),
        (fused(&pavilion), [(0.09, 400), (0.3, 60)]),
        (fused(&city), [(0.03, 270), (0.12, 70)]),
        (palm, [(1.0, 57), (1.0, 18)]),
        (pavilion, [(0.87, 270), (0.97, 50)]),
        (city, [(0.98, 170), (1.0, 45)]),
        (Scene::forest(), [(1.0, 555), (1.0, 190)]),
    ];
    for (scene, limits) in &scenes {
        for (declared, (share_limit, draw_limit)) in CASES.into_iter().zip(limits) {
            let case = case(declared, scene);
            let gpu = Gpu::open(&[&case], SIZE).unwrap();
            let [clustered, whole] = Loaded::both(&gpu, scene, &case);
            for number in 0..scene.views.len() {
                let (_, plan) = planned(&case, scene, number);
                let counts = |loaded: &Loaded| loaded.service.commands(&plan, &loaded.casters).unwrap().1;
                let (few, all) = (counts(&clustered), counts(&whole));
                let share = few.triangles as f64 / all.triangles as f64;
                println!(
                    "{:<20} {:<8} view {number}, {:2} facets: {:8} of {:8} triangles ({share:.3}), {:3} draws instead of {:3}, built in {:.0} us instead of {:.0}",
                    scene.name,
                    case.name,
                    plan.facets.len(),
                    few.triangles,
                    all.triangles,
                    few.draws,
                    all.draws,
                    clustered.microseconds(&plan),
                    whole.microseconds(&plan)
                );
                assert!(share <= *share_limit, "{} {}: {share}", scene.name, case.name);
                assert!(few.draws <= *draw_limit, "{} {}: {} draws", scene.name, case.name, few.draws);
                // No facet draws more than it did.
                assert!(few.facets.iter().zip(&all.facets).all(|(few, all)| few.triangles <= all.triangles));
            }
        }
    }
}

/// Captures a mesh with some clusters.
fn captured(gpu: &TestDevice, scene: &Scene, clusters: &[Cluster], geometry: &Geometry) -> Vec<f32> {
    let case = case(CASES[0], scene);
    let table = generate(&case).unwrap().table;
    let (view, plan) = planned(&case, scene, 0);
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let buffers = geometry.upload(gpu);
    let mesh = service.add_mesh(&MeshDescription { clusters, ..buffers.description() }).unwrap();
    let casters = [CasterInstance { mesh, world_from_object: DAffine3::IDENTITY }];
    let frame = service.prepare(&plan, &view, &casters).unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    service.read_map().unwrap()
}

/// A fused scene in clusters.
fn palm_in_clusters() -> (Scene, Geometry, Vec<Cluster>) {
    let scene = fused(&Scene::palm());
    let positions = scene.meshes[0].positions.clone();
    let position = |index: u32| Some(DVec3::from_array(positions.get(index as usize)?.map(f64::from)));
    let clustered = cluster_triangles(position, &scene.meshes[0].indices).unwrap();
    let geometry = Geometry { positions, indices: clustered.indices };
    (scene, geometry, clustered.clusters)
}

#[test]
fn boxes_too_small_lose_texels() {
    let gpu = exclusive();
    let (scene, geometry, clusters) = palm_in_clusters();
    let expected = captured(&gpu, &scene, &[], &geometry);
    let (_, plan) = planned(&case(CASES[0], &scene), &scene, 0);
    let lost = |shrink: f64| {
        let shrunk = |cluster: &Cluster| {
            let (min, max) = (cluster.bounds_object.min, cluster.bounds_object.max);
            let (centre, half) = ((min + max) * 0.5, (max - min) * 0.5 * shrink);
            let mut cluster = *cluster;
            cluster.bounds_object.min = centre - half;
            cluster.bounds_object.max = centre + half;
            cluster
        };
        let clusters: Vec<_> = clusters.iter().map(shrunk).collect();
        let map = captured(&gpu, &scene, &clusters, &geometry);
        lost(&plan, &map, &expected)
    };
    assert_eq!(lost(1.0), 0);
    let lost = lost(0.3);
    assert!(lost > 100, "only {lost} texels tell");
}

#[test]
fn clusters_that_make_no_sense() {
    let gpu = exclusive();
    let (scene, geometry, clusters) = palm_in_clusters();
    let table = generate(&case(CASES[0], &scene)).unwrap().table;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let buffers = geometry.upload(&gpu);
    let corners = geometry.indices.len() as u32;
    let last = clusters.len() - 1;
    let mut refused = |change: &dyn Fn(&mut Vec<Cluster>)| {
        let mut clusters = clusters.clone();
        change(&mut clusters);
        match service.add_mesh(&MeshDescription { clusters: &clusters, ..buffers.description() }) {
            Err(ServiceError::Mesh(error)) => error,
            other => panic!("{other:?}"),
        }
    };

    let error = refused(&|clusters| clusters[2].count += 1);
    assert!(matches!(error, MeshError::ClusterCount { cluster: 2, .. }), "{error}");
    let error = refused(&|clusters| clusters[last].count += 3);
    assert!(matches!(error, MeshError::ClusterOutOfRange { cluster, .. } if cluster == last), "{error}");
    let error = refused(&|clusters| clusters[1].first -= 3);
    assert!(matches!(error, MeshError::ClusterOrder { cluster: 1, .. }), "{error}");
    let error = refused(&|clusters| {
        clusters.remove(5);
    });
    assert!(matches!(error, MeshError::ClusterOrder { cluster: 5, .. }), "{error}");
    let error = refused(&|clusters| clusters.truncate(last));
    assert_eq!(error, MeshError::ClustersEnd { covered: clusters[last].first, corners });
    let error = refused(&|clusters| clusters[3].bounds_object.max.z = f64::NAN);
    assert_eq!(error, MeshError::ClusterBounds { cluster: 3 });

    service.add_mesh(&MeshDescription { clusters: &clusters, ..buffers.description() }).unwrap();
}
