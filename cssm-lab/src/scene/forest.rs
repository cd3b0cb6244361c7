//! `forest`: a square kilometre of gentle hills under thousands of trees, with meadows and a track. Trunks are
//! tubes; leaves are cards cut out by alpha masks.

mod terrain;
mod trees;

use std::f64::consts::TAU;

use cssm_core::glam::DVec3;

use super::lamp::{self, Places};
use super::place::{shaded, upright, viewpoint};
use super::random::Random;
use super::{Instance, Mesh, Scene};
use trees::Kind;

/// Trees stand on a jittered grid of this step.
const SPACING_METRES: f64 = 14.5;
/// Undergrowth stands this much more densely.
const UNDERGROWTH: usize = 4200;
/// Undergrowth reaches this far from the middle, where the views are.
const UNDERGROWTH_METRES: f64 = 190.0;

const GROUND: [f32; 3] = [0.22, 0.29, 0.10];
const BUSH: [f32; 3] = [0.12, 0.24, 0.07];
const GRASS: [f32; 3] = [0.20, 0.29, 0.09];

pub(super) fn scene() -> Scene {
    let mut random = Random::new(0xf03e57);
    let mut meshes = Vec::new();
    let mut instances = Vec::new();
    terrain::lay(&mut meshes, &mut instances, GROUND);
    plant_trees(&mut meshes, &mut instances, &mut random);
    plant_undergrowth(&mut meshes, &mut instances, &mut random);
    let over_ground = |x: f64, up: f64, z: f64| [x, terrain::height(x, z) + up, z];
    let views = vec![
        viewpoint(over_ground(-24.0, 2.8, 17.0), over_ground(-56.0, 4.0, -8.0), [0.8, -0.45, -0.62]),
        viewpoint(over_ground(3.0, 1.9, 120.0), over_ground(-2.0, 3.0, 60.0), [0.9, -0.3, -0.1]),
        viewpoint(over_ground(-13.0, 11.0, -118.0), over_ground(-6.0, 1.0, -70.0), [0.3, -0.4, 0.85]),
    ];
    let places = Places {
        in_view: [1.0, 1.6, 14.0],
        behind: [0.4, 1.2, -6.0],
        beside: [2.0, 12.0, 16.0],
        outside: [-6.0, 14.0, 8.0],
        at_eye: [0.4, 0.5, 0.1],
        wall_world: [-65.628, 7.372, 16.577],
        ahead: [[2.0, 1.5, -1.0], [0.0, -0.5, 18.0]],
        aside: [[14.0, 7.0, 20.0], [-4.0, 0.0, 26.0]],
        dueling: [[3.0, 7.0, 46.0], [0.0, -1.0, 14.0]],
    };
    let lamps = lamp::around(views[0], &places);
    Scene { name: "forest".to_owned(), meshes, instances, views, lamps }
}

/// How far a place lies from where trees may stand, in metres; negative among them.
fn openness(x: f64, z: f64) -> f64 {
    // A meadow in the middle with a wavy border, a track through it, and glades.
    let turn = libm::atan2(z, x);
    let border = 46.0 + 9.0 * libm::sin(3.0 * turn + 0.7) + 4.0 * libm::sin(7.0 * turn);
    let meadow = border - libm::sqrt(x * x + z * z);
    let track = 5.5 - (x - 14.0 * libm::sin(z / 70.0)).abs();
    let glade = 30.0 * (libm::sin(x / 47.0 + 1.0) * libm::sin(z / 53.0 + 2.0) - 0.72);
    meadow.max(track).max(glade)
}

fn plant_trees(meshes: &mut Vec<Mesh>, instances: &mut Vec<Instance>, random: &mut Random) {
    let kinds: Vec<Kind> = trees::kinds(meshes, random);
    let reach = 0.5 * terrain::SIDE_METRES - 4.0;
    let steps = (2.0 * reach / SPACING_METRES) as i32;
    for index in 0..steps * steps {
        let along = |step: i32, jitter: f64| (f64::from(step) + 0.5 + jitter) * SPACING_METRES - reach;
        let x = along(index % steps, random.between(-0.42, 0.42));
        let z = along(index / steps, random.between(-0.42, 0.42));
        let (turn, size) = (random.between(0.0, TAU), random.between(0.75, 1.3));
        let (shade, chance) = (random.between(0.8, 1.2), random.between(0.0, 1.0));
        let pick = random.below(kinds.len() / 3);
        if openness(x, z) > 0.0 {
            continue;
        }
        // Broad-leaved trees and conifers keep to regions of their own, birches to the borders.
        let region =
            libm::sin(x / 90.0) + libm::sin(z / 75.0 + 0.6 * libm::sin(x / 60.0)) + 1.2 * (chance - 0.5);
        let family = if openness(x, z) > -9.0 && chance < 0.45 {
            1
        } else if region > 0.25 {
            2
        } else {
            0
        };
        let kind = &kinds[family * (kinds.len() / 3) + pick];
        let foot = DVec3::new(x, terrain::height(x, z), z);
        instances.push(upright(kind.trunk, foot, turn, size, kind.bark));
        instances.push(upright(kind.crown, foot, turn, size, shaded(kind.leaf, shade)));
    }
}

/// Bushes at the trees' feet and tufts of grass in the open, around the middle.
fn plant_undergrowth(meshes: &mut Vec<Mesh>, instances: &mut Vec<Instance>, random: &mut Random) {
    let bush = meshes.len();
    meshes.push(trees::bush(random));
    meshes.push(trees::tuft(random));
    for _ in 0..UNDERGROWTH {
        let distance = UNDERGROWTH_METRES * libm::sqrt(random.between(0.0, 1.0));
        let (sin, cos) = libm::sincos(random.between(0.0, TAU));
        let (x, z) = (cos * distance, sin * distance);
        let (turn, size, shade) =
            (random.between(0.0, TAU), random.between(0.6, 1.25), random.between(0.85, 1.2));
        let open = openness(x, z);
        let (mesh, colour) = if open > 0.0 { (bush + 1, GRASS) } else { (bush, BUSH) };
        let foot = DVec3::new(x, terrain::height(x, z), z);
        // Only every fourth place under the trees carries a bush.
        if open > 0.0 || shade < 0.9375 {
            instances.push(upright(mesh, foot, turn, size, shaded(colour, shade)));
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn forest_has_its_exact_count() {
        let scene = super::scene();
        assert_eq!(scene.triangles(), 958_738);
        let bounds = scene.bounds_world().unwrap();
        let extent = bounds.max - bounds.min;
        assert!(extent.x >= 1000.0 && extent.z >= 1000.0, "{extent}");
        let largest = scene.meshes.iter().map(super::Mesh::triangles).max();
        assert!(largest.is_some_and(|triangles| triangles <= 200), "{largest:?} triangles in one mesh");
    }

    #[test]
    fn leaves_are_most_of_the_trees() {
        let scene = super::scene();
        let of = |masked: bool| {
            let instances = scene
                .instances
                .iter()
                .filter(|instance| scene.meshes[instance.mesh].mask.is_some() == masked);
            instances.count()
        };
        assert!(of(true) > 4000 && of(false) > 4000, "{} masked, {} not", of(true), of(false));
    }

    #[test]
    fn forest_is_the_same_every_time() {
        let (one, two) = (format!("{:?}", super::scene()), format!("{:?}", super::scene()));
        assert!(one == two, "two builds of the scene differ");
    }
}
