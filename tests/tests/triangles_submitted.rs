//! Facets draw hardly more triangles than touch them.

use std::path::Path;

use cssm_core::facet::Facet;
use cssm_core::glam::{DVec3, DVec4};
use cssm_core::{BoundingBox, SceneBounds, plan};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_lab::scene::Scene;
use cssm_runtime::{
    CLUSTER_TRIANGLES, CasterInstance, ClusteredTriangles, Drawing, FrameCommands, MeshFacts, MeshHandle,
    PipelineHandle, cluster_triangles,
};
use cssm_tests::touch::{box_corners, touches};
use shaders_gen::shipped;

const SIZE: (u32, u32) = (1280, 720);
const CASES: [(&str, &str); 2] = [("Sun", shipped::SUN), ("Pssm4Log", shipped::PSSM4_LOG)];
/// Multiple of the triangles that touch a facet that it may draw, besides a cluster for each boundary.
const FACTOR: f64 = 1.3;

/// A scene's meshes in clusters.
fn clustered(scene: &Scene) -> Vec<ClusteredTriangles> {
    let meshes = scene.meshes.iter().map(|mesh| {
        let position = |index: u32| Some(DVec3::from_array(mesh.positions[index as usize].map(f64::from)));
        cluster_triangles(position, &mesh.indices).unwrap()
    });
    meshes.collect()
}

fn box_of(scene: &Scene, mesh: usize) -> BoundingBox {
    let (min, max) = scene.meshes[mesh].bounds().unwrap();
    BoundingBox { min: DVec3::from_array(min), max: DVec3::from_array(max) }
}

/// Triangles that touch a facet, and boundaries of the facet that cut through the box of any instance of which one does.
fn needed(scene: &Scene, facet: &Facet, eye_world: DVec3) -> (u64, u64) {
    let (mut triangles, mut boundaries) = (0, vec![false; facet.casters.len()]);
    for instance in &scene.instances {
        let mut eye_from_object = instance.world_from_object;
        eye_from_object.translation -= eye_world;
        let corners = box_corners(&box_of(scene, instance.mesh), &eye_from_object);
        let counts = facet
            .casters
            .iter()
            .map(|plane| corners.iter().filter(|corner| plane.dot(corner.extend(1.0)) >= 0.0).count());
        let counts: Vec<usize> = counts.collect();
        if counts.contains(&0) {
            continue;
        }
        let cutting: Vec<DVec4> = (facet.casters.iter().zip(&counts))
            .filter_map(|(plane, count)| (*count < 8).then_some(*plane))
            .collect();
        let mesh = &scene.meshes[instance.mesh];
        let position = |index: &u32| {
            let position = DVec3::from_array(mesh.positions[*index as usize].map(f64::from));
            eye_from_object.transform_point3(position)
        };
        let touching = mesh.indices.chunks_exact(3).filter(|corners| {
            cutting.is_empty() || touches(&[0, 1, 2].map(|corner| position(&corners[corner])), &cutting)
        });
        let touching = touching.count() as u64;
        triangles += touching;
        if touching > 0 {
            boundaries.iter_mut().zip(&counts).for_each(|(cuts, count)| *cuts |= *count < 8);
        }
    }
    (triangles, boundaries.iter().filter(|cuts| **cuts).count() as u64)
}

#[test]
fn facets_draw_little_that_does_not_touch_them() {
    for scene in [Scene::city(), Scene::palm(), Scene::pavilion()] {
        let clustered = clustered(&scene);
        let facts = |mesh: MeshHandle| {
            let number = (0..scene.meshes.len()).find(|at| MeshHandle::new(*at as u32, 0) == mesh)?;
            Some(MeshFacts {
                pipeline: PipelineHandle(0),
                corners: clustered[number].indices.len() as u32,
                indexed: true,
                first_index: 0,
                bounds_object: box_of(&scene, number),
                clusters: &clustered[number].clusters,
                drawing: Drawing::Plain,
            })
        };
        let casters = scene.instances.iter().map(|instance| CasterInstance {
            mesh: MeshHandle::new(instance.mesh as u32, 0),
            world_from_object: instance.world_from_object,
        });
        let casters: Vec<_> = casters.collect();
        for (name, text) in CASES {
            let case = pick_case(Path::new("case.cssm"), text, Some(name)).unwrap();
            let case = with_map_size(case, (2048, 2048)).unwrap();
            for (number, spot) in scene.views.iter().enumerate() {
                let (view, light) = spot.pictured(SIZE).unwrap();
                let plan = plan(&case, &view, &light, &SceneBounds::of(scene.bounds_world())).unwrap();
                let (_, statistics) = FrameCommands::build(&plan, &casters, facts).unwrap();
                let needs = plan.facets.iter().map(|facet| needed(&scene, facet, plan.eye_world));
                let (least, boundaries) = needs.fold((0, 0), |all, facet| (all.0 + facet.0, all.1 + facet.1));
                let allowance = boundaries * CLUSTER_TRIANGLES as u64;
                println!(
                    "{:<9} {name:<9} view {number}, {:2} facets: {:7} submitted, {least:7} touch ({:.3}), {boundaries:4} boundaries, {:.3} without a cluster each",
                    scene.name,
                    plan.facets.len(),
                    statistics.triangles,
                    statistics.triangles as f64 / least as f64,
                    statistics.triangles.saturating_sub(allowance) as f64 / least as f64,
                );
                assert!(statistics.triangles >= least, "something is missing");
                let most = FACTOR * least as f64 + allowance as f64;
                assert!(statistics.triangles as f64 <= most, "{} {name} view {number}", scene.name);
            }
        }
    }
}
