//! Casters that move, a camera that moves, and no memory taken once the lists have had their room.

use allocation_counter::measure;
use cssm_core::case::Stretch;
use cssm_core::glam::{DAffine3, DMat3, DVec3};
use cssm_core::schema::Word;
use cssm_core::{BoundingBox, Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{
    CasterInstance, CasterScene, Cluster, Command, CommandScratch, Drawing, FrameCommands, FrameStatistics,
    MeshFacts, MeshHandle, PipelineHandle,
};

const FRAMES: usize = 24;
/// Frames in which lists find their room.
const WARM: usize = 2;
const FANS: PipelineHandle = PipelineHandle(2);

/// Bands of straight rows, and bent rows.
fn cases() -> [LightCase; 2] {
    let bands = LightCase::builder("Sun").map_size_texels(1024, 1024).bands(4, 200.0);
    let bent = LightCase::builder("SunLog").map_size_texels(1024, 1024);
    let bent = bent.configurations(&["face_columns"]).distribution(Word::plain("logarithmic"));
    [bands, bent.stretch(Stretch::Exact { bound_texels: 0.25 })].map(|case| case.build().unwrap())
}

/// Plans of a camera that walks through the casters.
fn plans(case: &LightCase) -> Vec<ShadowPlan> {
    let light = Light::directional_travelling(DVec3::new(0.4, -1.0, 0.3)).unwrap();
    let step = |frame: usize| {
        let eye = DVec3::new(1e5 + 1.5 * frame as f64, 2.0, 4.0);
        let target = eye + DVec3::new(8.0, -1.0, 0.1 * frame as f64);
        let view = View::perspective(eye, target, DVec3::Y, 1.0, 0.1, 1e3, (1280, 720)).unwrap();
        let bounds = BoundingBox { min: eye - 150.0, max: eye + 150.0 };
        plan(case, &view, &light, &SceneBounds::of(Some(bounds))).unwrap()
    };
    (0..FRAMES).map(step).collect()
}

/// Casters of three meshes in a frame; every ninth moves.
fn casters(frame: usize, casters: &mut Vec<CasterInstance>) {
    casters.clear();
    casters.extend((0..3000).map(|number: u32| {
        let along = |prime: u32| f64::from(number * prime % 997) * 0.2 - 99.0;
        let shift = if number.is_multiple_of(9) { 0.05 * frame as f64 } else { 0.0 };
        CasterInstance {
            mesh: MeshHandle::new(number % 3, 0),
            world_from_object: DAffine3 {
                matrix3: DMat3::from_rotation_y(f64::from(number)),
                translation: DVec3::new(1e5 + along(31) + shift, 0.5, along(173)),
            },
        }
    }));
}

/// A row of clusters along x, worth drawing apart.
fn clusters() -> Vec<Cluster> {
    let cluster = |at: u32| Cluster {
        first: 1500 * at,
        count: 1500,
        bounds_object: BoundingBox {
            min: DVec3::new(f64::from(at) - 4.0, -0.5, -0.5),
            max: DVec3::new(f64::from(at) - 3.0, 0.5, 0.5),
        },
    };
    (0..8).map(cluster).collect()
}

fn facts(mesh: MeshHandle, clusters: &[Cluster]) -> Option<MeshFacts<'_>> {
    let in_parts = mesh != MeshHandle::new(0, 0);
    let fans = Drawing::Both { fans: FANS, bound_texels: 0.25 };
    Some(MeshFacts {
        pipeline: PipelineHandle(u32::from(in_parts)),
        corners: 12_000,
        indexed: mesh != MeshHandle::new(2, 0),
        first_index: 0,
        bounds_object: BoundingBox { min: DVec3::new(-4.0, -0.5, -0.5), max: DVec3::new(4.0, 0.5, 0.5) },
        clusters: if in_parts { clusters } else { &[] },
        drawing: if mesh == MeshHandle::new(2, 0) { fans } else { Drawing::Plain },
    })
}

#[test]
fn lists_are_rebuilt_without_allocating() {
    let [straight, bent] = cases().map(|case| walk(&plans(&case)));
    assert_eq!(straight, 0, "straight rows need no fans");
    assert!(bent > 100, "only {bent} draws of fans");
}

/// Rebuilds the list of every plan, asserts that from the third on nothing is allocated, and counts draws of fans.
fn walk(plans: &[ShadowPlan]) -> usize {
    let (clusters, mut fans) = (clusters(), 0);
    let facts = |mesh| facts(mesh, &clusters);
    let mut instances = Vec::with_capacity(3000);
    let mut scene = CasterScene::new();
    let mut scratch = CommandScratch::default();
    let (mut frame, mut statistics) = (FrameCommands::default(), FrameStatistics::default());
    let (mut cold, mut draws, mut parts) = (0, 0, 0);
    for (number, plan) in plans.iter().enumerate() {
        casters(number, &mut instances);
        let taken = measure(|| {
            scene.update(&instances, facts).unwrap();
            let facets = 0..plan.facets.len();
            frame.rebuild(plan, facets, &scene, facts, &mut scratch, &mut statistics).unwrap();
            for facet in &statistics.facets {
                let position = plan.facets.iter().position(|other| other.first_cell() == facet.facet);
                let content = FrameCommands::content(plan, position.unwrap(), &scene, &mut scratch);
                assert_eq!(content, facet.content);
            }
        });
        if number < WARM {
            cold += taken.count_total;
        } else {
            assert_eq!(taken.count_total, 0, "{} bytes in frame {number}", taken.bytes_total);
        }
        draws += statistics.draws;
        parts += statistics.facets.iter().map(|facet| u64::from(facet.draws)).sum::<u64>();

        // What is rebuilt is what would be built from nothing.
        let (_, fresh) = FrameCommands::build(plan, &instances, facts).unwrap();
        let counts = |of: &FrameStatistics| (of.casters, of.instances, of.triangles);
        assert_eq!(counts(&statistics), counts(&fresh));
        fans += frame.commands.iter().filter(|command| **command == Command::Pipeline(FANS)).count();
        assert!(statistics.instances > 100);
    }
    assert!(cold > 0, "the counter counts");
    assert_eq!(u64::from(draws), parts);
    assert!(draws as usize > 20 * FRAMES, "{draws} draws are no test");
    fans
}

#[test]
fn building_from_nothing_allocates() {
    let [case, _] = cases();
    let (plans, clusters) = (plans(&case), clusters());
    let mut instances = Vec::new();
    casters(0, &mut instances);
    let build = || FrameCommands::build(&plans[0], &instances, |mesh| facts(mesh, &clusters)).unwrap();
    build();
    let taken = measure(|| drop(build()));
    assert!(taken.count_total > 10, "{taken:?}");
}
