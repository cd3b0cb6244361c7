//! `palm`: four palms on bare ground, 10,624 triangles; leaflets are thin open sheets.

use cssm_core::glam::{DAffine3, DMat3, DVec3};

use super::lamp::{self, Places};
use super::place::{turn_about_y, viewpoint};
use super::random::Random;
use super::solid::MeshBuilder;
use super::{Instance, Mesh, Scene};

const PALMS: [(f64, f64, f64); 4] =
    [(0.0, 0.0, 1.0), (6.5, -7.0, 1.25), (-8.0, -12.0, 1.1), (-3.5, 9.0, 0.8)];
const FRONDS_PER_PALM: usize = 16;
const FROND_SHAPES: usize = 4;
const FROND_SEGMENTS: usize = 8;
const LEAFLETS_PER_SIDE: usize = 26;
const TRUNK_SEGMENTS: usize = 12;
const TRUNK_SIDES: u32 = 8;
const TRUNK_HEIGHT_METRES: f64 = 7.0;
const GROUND_TILES_PER_SIDE: i32 = 8;
const GROUND_TILE_METRES: f64 = 15.0;

const SAND: [f32; 3] = [0.55, 0.48, 0.34];
const BARK: [f32; 3] = [0.34, 0.24, 0.16];
const LEAF: [f32; 3] = [0.13, 0.30, 0.09];

pub(super) fn scene() -> Scene {
    let mut random = Random::new(0x70a1);
    let mut meshes = vec![ground(), trunk()];
    meshes.extend((0..FROND_SHAPES).map(|shape| frond(shape, &mut random)));

    // Lay the ground in tiles.
    let mut instances = Vec::new();
    for tile in 0..GROUND_TILES_PER_SIDE * GROUND_TILES_PER_SIDE {
        let along = |index: i32| f64::from(index - GROUND_TILES_PER_SIDE / 2) * GROUND_TILE_METRES;
        let corner =
            DVec3::new(along(tile % GROUND_TILES_PER_SIDE), 0.0, along(tile / GROUND_TILES_PER_SIDE));
        instances.push(Instance {
            mesh: 0,
            world_from_object: DAffine3::from_translation(corner),
            colour: SAND,
        });
    }

    // Plant the palms: a turned trunk, and fronds around its head.
    for (x, z, size) in PALMS {
        let turn = random.between(0.0, std::f64::consts::TAU);
        let trunk = DAffine3::from_translation(DVec3::new(x, 0.0, z))
            * DAffine3::from_mat3(turn_about_y(turn) * DMat3::from_diagonal(DVec3::splat(size)));
        instances.push(Instance { mesh: 1, world_from_object: trunk, colour: BARK });
        for index in 0..FRONDS_PER_PALM {
            let turn = (index as f64 + random.between(-0.3, 0.3)) * 2.399_963; // golden angle
            let tilt = 0.9 - 1.2 * index as f64 / FRONDS_PER_PALM as f64 + random.between(-0.1, 0.1);
            let size = random.between(0.85, 1.1);
            let place = turn_about_y(turn) * turn_about_z(tilt) * DMat3::from_diagonal(DVec3::splat(size));
            let head = DAffine3::from_translation(trunk_centre(1.0));
            let world_from_object = trunk * head * DAffine3::from_mat3(place);
            let shade = random.between(0.85, 1.2) as f32;
            let colour = LEAF.map(|channel| channel * shade);
            instances.push(Instance { mesh: 2 + index % FROND_SHAPES, world_from_object, colour });
        }
    }

    let views = vec![
        viewpoint([8.5, 3.6, 9.5], [-2.5, 1.6, -3.0], [-0.45, -0.5, 0.35]),
        viewpoint([-16.0, 9.0, 6.0], [0.0, 1.0, -3.0], [0.3, -0.8, 0.6]),
        viewpoint([2.0, 1.7, 24.0], [-1.0, 2.5, 0.0], [0.35, -0.5, 0.8]),
    ];
    let places = Places {
        in_view: [1.6, 7.5, 17.7],
        behind: [3.0, 2.5, -6.0],
        beside: [-1.1, 15.4, 17.8],
        outside: [0.0, 19.3, 11.6],
        at_eye: [0.4, 0.5, 0.1],
        wall_world: [0.120, 1.607, -0.152],
        ahead: [[2.0, 1.5, -1.0], [0.0, 0.0, 20.0]],
        aside: [[10.0, 9.0, 20.0], [-1.0, -2.0, 18.0]],
        dueling: [[-4.7, 14.8, 29.0], [-0.3, -3.6, 14.3]],
    };
    let lamps = lamp::around(views[1], &places);
    Scene { name: "palm".to_owned(), meshes, instances, views, lamps }
}

fn ground() -> Mesh {
    let mut builder = MeshBuilder::new();
    let [near, far] = [0.0, GROUND_TILE_METRES];
    builder.quad([(near, near), (near, far), (far, far), (far, near)].map(|(x, z)| DVec3::new(x, 0.0, z)));
    builder.build("ground")
}

/// Centre of the trunk at a share of its height; it leans and straightens up.
fn trunk_centre(share: f64) -> DVec3 {
    DVec3::new(1.4 * share * share * (1.5 - 0.5 * share), TRUNK_HEIGHT_METRES * share, 0.0)
}

fn trunk() -> Mesh {
    let centres: Vec<_> = (0..=TRUNK_SEGMENTS)
        .map(|index| {
            let share = index as f64 / TRUNK_SEGMENTS as f64;
            (trunk_centre(share), 0.24 - 0.12 * share)
        })
        .collect();
    let mut builder = MeshBuilder::new();
    builder.tube(&centres, TRUNK_SIDES);
    builder.build("trunk")
}

/// A frond along x that droops: a three-sided stalk and two rows of narrow leaflets.
fn frond(shape: usize, random: &mut Random) -> Mesh {
    let (length, droop) = (random.between(2.6, 3.4), random.between(0.9, 1.6));
    let stalk = |share: f64| DVec3::new(length * share * (1.0 - 0.12 * share), -droop * share * share, 0.0);
    let centres: Vec<_> = (0..=FROND_SEGMENTS)
        .map(|index| {
            let share = index as f64 / FROND_SEGMENTS as f64;
            (stalk(share), 0.03 - 0.025 * share)
        })
        .collect();
    let mut builder = MeshBuilder::new();
    builder.tube(&centres, 3);
    for side in [-1.0, 1.0] {
        for leaflet in 0..LEAFLETS_PER_SIDE {
            let share = 0.12 + 0.87 * (leaflet as f64 + random.between(0.0, 0.6)) / LEAFLETS_PER_SIDE as f64;
            let reach = 0.75 * libm::sin(std::f64::consts::PI * (0.12 + 0.83 * share)) + 0.08;
            let root = stalk(share);
            let width = DVec3::new(0.022, -0.004, 0.0);
            let middle = root + DVec3::new(0.3 * reach, -0.05 * reach, side * 0.6 * reach);
            let tip = root + DVec3::new(0.5 * reach, random.between(-0.45, -0.25) * reach, side * reach);
            builder.triangle([root - width, middle - width * 1.5, middle + width * 1.5]);
            builder.triangle([middle - width * 1.5, tip, middle + width * 1.5]);
        }
    }
    builder.build(format!("frond {shape}"))
}

fn turn_about_z(radians: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(radians);
    DMat3::from_cols(DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z)
}

#[cfg(test)]
mod tests {
    #[test]
    fn palm_has_its_exact_count() {
        assert_eq!(super::scene().triangles(), 10_624);
    }

    #[test]
    fn palm_is_the_same_every_time() {
        assert_eq!(format!("{:?}", super::scene()), format!("{:?}", super::scene()));
    }
}
