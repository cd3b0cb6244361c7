//! Scenes that move.

use cssm_core::glam::DAffine3;

use super::*;
use crate::commands::Drawing;

const MESH: MeshHandle = MeshHandle { index: 0, generation: 0 };

fn facts(mesh: MeshHandle) -> Option<MeshFacts<'static>> {
    let half = DVec3::splat(1.0 + f64::from(mesh.index));
    let facts = MeshFacts {
        pipeline: PipelineHandle(1 - mesh.index.min(1)),
        corners: 3,
        indexed: false,
        first_index: 0,
        bounds_object: BoundingBox { min: -half, max: half },
        clusters: &[],
        drawing: Drawing::Plain,
    };
    (mesh.index < 2).then_some(facts)
}

fn at(mesh: u32, place: DVec3) -> CasterInstance {
    CasterInstance {
        mesh: MeshHandle { index: mesh, generation: 0 },
        world_from_object: DAffine3::from_translation(place),
    }
}

/// A plain of casters with two meshes, a metre of space between them.
fn plain(count: u32) -> Vec<CasterInstance> {
    let number = |at: u32, prime: u32| f64::from(at * prime % 97) * 3.0;
    (0..count).map(|index| at(index % 2, DVec3::new(number(index, 31), 0.0, number(index, 7)))).collect()
}

/// Checks that blocks and groups hold what they say.
fn check(scene: &CasterScene, instances: &[CasterInstance]) {
    assert_eq!(scene.instances(), instances);
    let contains = |outer: &CentredBox, inner: &CentredBox| {
        ((outer.centre - inner.centre).abs() + inner.half).cmple(outer.half + 1e-9).all()
    };
    let mut seen = vec![0; instances.len()];
    for group in scene.groups() {
        let mut count = 0;
        for block in scene.blocks(group) {
            assert!(contains(&group.bounds, &block.bounds));
            assert!((1..=BLOCK_CASTERS).contains(&scene.members(block).len()));
            for caster in scene.members(block) {
                let instance = &instances[caster.number as usize];
                assert_eq!(instance.mesh, group.mesh);
                assert_eq!(caster.bounds.centre, instance.world_from_object.translation);
                assert!(contains(&block.bounds, &caster.bounds));
                assert_eq!(caster.content, content::hash(instance));
                seen[caster.number as usize] += 1;
                count += 1;
            }
        }
        assert_eq!(count, group.count);
    }
    assert!(seen.iter().all(|times| *times == 1));
}

#[test]
fn only_what_moved_is_touched() {
    let mut instances = plain(500);
    let mut scene = CasterScene::new();
    assert!(scene.update(&instances, facts).unwrap());
    check(&scene, &instances);
    let order: Vec<u32> = scene.sorted.iter().map(|caster| caster.number).collect();
    assert!(!scene.update(&instances, facts).unwrap());
    assert_eq!(scene.revision(), 1);

    instances[77].world_from_object.translation.y += 2.0;
    assert!(scene.update(&instances, facts).unwrap());
    check(&scene, &instances);
    assert_eq!(scene.sorted.iter().map(|caster| caster.number).collect::<Vec<_>>(), order);

    // A shorter and a longer list, and another mesh in place of one.
    instances.truncate(300);
    assert!(scene.update(&instances, facts).unwrap());
    check(&scene, &instances);
    instances.extend(plain(40));
    assert!(scene.update(&instances, facts).unwrap());
    check(&scene, &instances);
    instances[3] = at(0, DVec3::Y);
    assert!(scene.update(&instances, facts).unwrap());
    check(&scene, &instances);
    assert_eq!(scene.revision(), 5);

    assert!(scene.update(&[], facts).unwrap());
    check(&scene, &[]);
    assert_eq!(scene.bounds_world(), None);
}

#[test]
fn blocks_are_made_anew_when_casters_have_scattered() {
    let mut instances = plain(500);
    let mut scene = CasterScene::new();
    scene.update(&instances, facts).unwrap();
    let made = scene.extent();
    let places: Vec<_> = instances.iter().rev().map(|instance| instance.world_from_object).collect();
    for (instance, place) in instances.iter_mut().zip(places) {
        // The same mesh somewhere else.
        instance.world_from_object = place;
    }
    scene.update(&instances, facts).unwrap();
    check(&scene, &instances);
    assert!(scene.extent() <= made * GROWTH_LIMIT, "{} of {made}", scene.extent());

    let bounds = scene.bounds_world().unwrap();
    assert_eq!((bounds.min.x, bounds.max.x), (-2.0, 96.0 * 3.0 + 2.0));
}

#[test]
fn a_refused_list_changes_nothing() {
    let instances = plain(40);
    let mut scene = CasterScene::new();
    scene.update(&instances, facts).unwrap();
    let mut refuse = |number: usize, instance: CasterInstance| {
        let mut faulty = instances.clone();
        faulty[5].world_from_object.translation.z += 1.0;
        faulty[number] = instance;
        let refused = scene.update(&faulty, facts).unwrap_err();
        check(&scene, &instances);
        assert_eq!(scene.revision(), 1);
        refused
    };
    let nowhere = at(1, DVec3::new(0.0, f64::NAN, 0.0));
    assert!(matches!(refuse(7, nowhere), ServiceError::Transform { instance: 7 }));
    assert!(matches!(refuse(9, at(1, DVec3::splat(1e300))), ServiceError::Transform { instance: 9 }));
    assert!(matches!(refuse(6, at(2, DVec3::ZERO)), ServiceError::UnknownMesh { instance: 6 }));

    // A mesh that has gone is found even when nothing moved.
    let gone = |mesh: MeshHandle| facts(mesh).filter(|_| mesh != MESH);
    assert!(matches!(scene.update(&instances, gone), Err(ServiceError::UnknownMesh { instance: 0 })));
    check(&scene, &instances);
}
