//! `city`: blocks of buildings over a square kilometre. Every shape is a closed solid with outward faces; windows
//! stand out of the walls as small boxes, so shadow edges are everywhere and at every scale.

use cssm_core::glam::DVec3;

use super::lamp::{self, Places};
use super::place::{shaded, upright, viewpoint};
use super::random::Random;
use super::solid::MeshBuilder;
use super::{Instance, Mesh, Scene};

const BLOCKS_PER_SIDE: i32 = 13;
const BLOCK_METRES: f64 = 80.0;
const PAVEMENT_METRES: f64 = 66.0;
const KERB_METRES: f64 = 0.15;
/// How far solids reach into what they stand on, so that no two faces coincide.
const FOOTING_METRES: f64 = 0.5;
const LAMPS_PER_EDGE: i32 = 3;

const ASPHALT: [f32; 3] = [0.20, 0.20, 0.22];
const PAVEMENT: [f32; 3] = [0.42, 0.41, 0.40];
const GRASS: [f32; 3] = [0.22, 0.34, 0.14];
const POLE: [f32; 3] = [0.12, 0.13, 0.15];
const TREE: [f32; 3] = [0.15, 0.31, 0.12];
const PLASTER: [[f32; 3]; 5] =
    [[0.62, 0.52, 0.42], [0.55, 0.38, 0.31], [0.58, 0.58, 0.55], [0.66, 0.60, 0.48], [0.43, 0.47, 0.52]];

/// (width, depth) in bays and height in storeys.
const BUILDINGS: [(u32, u32, u32); 6] = [(5, 3, 5), (4, 4, 7), (6, 3, 3), (3, 3, 11), (5, 3, 6), (3, 2, 4)];
const BAY_METRES: f64 = 3.6;
const STOREY_METRES: f64 = 3.2;

/// Indices of the meshes.
const ROAD: usize = 0;
const SLAB: usize = 1;
const LAMP: usize = 2;
const CONIFER: usize = 3;
const BROADLEAF: usize = 4;
const CAR: usize = 5;
const FIRST_BUILDING: usize = 6;

pub(super) fn scene() -> Scene {
    let mut random = Random::new(0xc17e);
    let mut meshes = vec![
        slab("road", BLOCK_METRES, 0.0),
        slab("pavement", PAVEMENT_METRES, KERB_METRES),
        lamp(),
        conifer(),
        broadleaf(),
        car(),
    ];
    meshes.extend(BUILDINGS.iter().map(|size| building(*size)));

    let mut instances = Vec::new();
    for block in 0..BLOCKS_PER_SIDE * BLOCKS_PER_SIDE {
        let along = |index: i32| f64::from(index - BLOCKS_PER_SIDE / 2) * BLOCK_METRES;
        let centre = DVec3::new(along(block % BLOCKS_PER_SIDE), 0.0, along(block / BLOCKS_PER_SIDE));
        put(&mut instances, ROAD, centre, 0.0, ASPHALT);
        let park = random.below(5) == 0;
        put(&mut instances, SLAB, centre, 0.0, if park { GRASS } else { PAVEMENT });
        furnish_streets(&mut instances, centre, &mut random);
        if park {
            plant_park(&mut instances, centre, &mut random);
        } else {
            build_block(&mut instances, centre, &mut random);
        }
    }

    let views = vec![
        viewpoint([42.0, 9.0, 128.0], [36.0, 5.5, 40.0], [-0.55, -0.6, -0.35]),
        viewpoint([-41.0, 1.9, 118.0], [-40.0, 2.5, 0.0], [0.7, -0.6, -0.15]),
        viewpoint([122.0, 22.0, 168.0], [60.0, 2.0, 90.0], [-0.5, -0.6, -0.35]),
    ];
    let places = Places {
        in_view: [-1.7, 5.0, 22.0],
        behind: [1.1, 2.6, -8.0],
        beside: [0.8, 18.0, 22.1],
        outside: [-3.1, 28.0, 13.1],
        at_eye: [0.4, 0.5, 0.1],
        wall_world: [-25.068, 4.984, 101.741],
        ahead: [[2.0, 1.5, -1.0], [0.0, 0.0, 30.0]],
        aside: [[0.0, 14.0, 10.0], [0.0, 0.0, 45.0]],
        dueling: [[1.5, 5.8, 58.0], [-0.2, -2.0, 18.0]],
    };
    let lamps = lamp::around(views[1], &places);
    Scene { name: "city".to_owned(), meshes, instances, views, lamps }
}

fn put(instances: &mut Vec<Instance>, mesh: usize, place: DVec3, turn_radians: f64, colour: [f32; 3]) {
    instances.push(upright(mesh, place, turn_radians, 1.0, colour));
}

/// Lamps along the kerb of all four sides, cars on two of the streets.
fn furnish_streets(instances: &mut Vec<Instance>, centre: DVec3, random: &mut Random) {
    let kerb = 0.5 * PAVEMENT_METRES - 0.8;
    for side in 0..4 {
        let turn = f64::from(side) * std::f64::consts::FRAC_PI_2;
        let (sin, cos) = libm::sincos(turn);
        let outward = DVec3::new(cos, 0.0, -sin);
        let along = DVec3::new(-outward.z, 0.0, outward.x);
        for lamp in 0..LAMPS_PER_EDGE {
            let step = (f64::from(lamp) + 0.5) / f64::from(LAMPS_PER_EDGE) - 0.5;
            let foot = centre + outward * kerb + along * (step * PAVEMENT_METRES) + DVec3::Y * KERB_METRES;
            put(instances, LAMP, foot, turn, POLE);
        }
        if side < 2 {
            let place = centre + outward * 36.0 + along * random.between(-30.0, 30.0);
            let tint = PLASTER[random.below(PLASTER.len())].map(|channel| channel * 0.8);
            put(instances, CAR, place, turn + std::f64::consts::FRAC_PI_2, tint);
        }
    }
}

fn plant_park(instances: &mut Vec<Instance>, centre: DVec3, random: &mut Random) {
    for _ in 0..14 {
        let reach = 0.5 * PAVEMENT_METRES - 6.0;
        let offset = DVec3::new(random.between(-reach, reach), KERB_METRES, random.between(-reach, reach));
        plant(instances, centre + offset, random);
    }
}

fn plant(instances: &mut Vec<Instance>, foot: DVec3, random: &mut Random) {
    let mesh = if random.below(2) == 0 { CONIFER } else { BROADLEAF };
    let colour = shaded(TREE, random.between(0.8, 1.25));
    let turn = random.between(0.0, std::f64::consts::TAU);
    instances.push(upright(mesh, foot, turn, random.between(0.7, 1.3), colour));
}

/// One building in each quarter of the block, and trees between them.
fn build_block(instances: &mut Vec<Instance>, centre: DVec3, random: &mut Random) {
    for quarter in 0..4 {
        let (x, z) = (f64::from(quarter % 2) * 2.0 - 1.0, f64::from(quarter / 2) * 2.0 - 1.0);
        let middle = centre + DVec3::new(x * 16.5, KERB_METRES, z * 16.5);
        if random.below(8) == 0 {
            plant(instances, middle, random);
            continue;
        }
        let kind = random.below(BUILDINGS.len());
        let turn = random.below(4) as f64 * std::f64::consts::FRAC_PI_2 + random.between(-0.02, 0.02);
        let shift = DVec3::new(random.between(-0.8, 0.8), 0.0, random.between(-0.8, 0.8));
        put(instances, FIRST_BUILDING + kind, middle + shift, turn, PLASTER[random.below(PLASTER.len())]);
    }
    for _ in 0..2 {
        let offset = DVec3::new(random.between(-2.0, 2.0), KERB_METRES, random.between(-28.0, 28.0));
        plant(instances, centre + offset, random);
    }
}

fn slab(name: &str, side: f64, top: f64) -> Mesh {
    let half = 0.5 * side;
    let mut builder = MeshBuilder::new();
    builder.cuboid(DVec3::new(-half, -FOOTING_METRES, -half), DVec3::new(half, top, half));
    builder.build(name)
}

/// A pole of 12 cm with an arm over the street (along x) and a lamp under it.
fn lamp() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.frustum(DVec3::Y * -FOOTING_METRES, 6.0 + FOOTING_METRES, 0.06, 0.045, 8);
    builder.cuboid(DVec3::new(-0.03, 5.94, -0.03), DVec3::new(1.5, 6.02, 0.03));
    builder.cuboid(DVec3::new(1.05, 5.84, -0.1), DVec3::new(1.6, 5.95, 0.1));
    builder.build("lamp")
}

fn conifer() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.frustum(DVec3::Y * -FOOTING_METRES, 2.2, 0.18, 0.14, 7);
    for (foot, height, radius) in [(1.2, 2.6, 1.9), (2.6, 2.4, 1.5), (4.0, 2.6, 1.05)] {
        builder.frustum(DVec3::Y * foot, height, radius, 0.0, 11);
    }
    builder.build("conifer")
}

fn broadleaf() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.frustum(DVec3::Y * -FOOTING_METRES, 3.2, 0.2, 0.13, 7);
    for (x, y, z, radius) in [(0.0, 2.3, 0.0, 1.7), (0.7, 3.2, 0.4, 1.3), (-0.6, 3.4, -0.5, 1.2)] {
        let centre = DVec3::new(x, y, z);
        builder.frustum(centre, radius, 0.45 * radius, radius, 9);
        builder.frustum(centre + DVec3::Y * radius, 0.9 * radius, radius, 0.0, 9);
    }
    builder.build("broadleaf")
}

fn car() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.cuboid(DVec3::new(-2.1, 0.28, -0.88), DVec3::new(2.1, 0.85, 0.88));
    builder.cuboid(DVec3::new(-1.3, 0.8, -0.76), DVec3::new(1.0, 1.42, 0.76));
    for (x, z) in [(-1.35, -0.82), (-1.35, 0.82), (1.35, -0.82), (1.35, 0.82)] {
        builder.cuboid(DVec3::new(x - 0.31, -0.05, z - 0.1), DVec3::new(x + 0.31, 0.5, z + 0.1));
    }
    builder.build("car")
}

/// A body, a parapet and roof boxes, and a frame around every window.
fn building((bays_x, bays_z, storeys): (u32, u32, u32)) -> Mesh {
    let (half_x, half_z) = (0.5 * BAY_METRES * f64::from(bays_x), 0.5 * BAY_METRES * f64::from(bays_z));
    let height = STOREY_METRES * f64::from(storeys) + 0.6;
    let mut builder = MeshBuilder::new();
    builder.cuboid(DVec3::new(-half_x, -FOOTING_METRES, -half_z), DVec3::new(half_x, height, half_z));

    // Put a cornice around the head and boxes on the roof.
    let cornice = DVec3::new(half_x + 0.35, 0.0, half_z + 0.35);
    builder.cuboid(-cornice + DVec3::Y * (height - 0.35), cornice + DVec3::Y * (height + 0.25));
    for (x, z, size, rise) in [(-0.4, 0.3, 1.4, 1.8), (0.35, -0.2, 0.9, 1.2), (0.1, 0.45, 0.6, 2.4)] {
        let (centre, reach) = (DVec3::new(x * half_x, height, z * half_z), DVec3::new(size, 0.0, size));
        builder.cuboid(centre - reach, centre + reach + DVec3::Y * (0.25 + rise));
    }

    // Set a frame that stands out of the wall at each bay of each storey.
    for storey in 0..storeys {
        let base = STOREY_METRES * f64::from(storey);
        for bay in 0..bays_x {
            let across = BAY_METRES * (f64::from(bay) + 0.5) - half_x;
            for face in [-half_z, half_z] {
                window(&mut builder, DVec3::new(across, base, face), DVec3::X, DVec3::Z);
            }
        }
        for bay in 0..bays_z {
            let across = BAY_METRES * (f64::from(bay) + 0.5) - half_z;
            for face in [-half_x, half_x] {
                window(&mut builder, DVec3::new(face, base, across), DVec3::Z, DVec3::X);
            }
        }
    }
    builder.build("building")
}

fn window(builder: &mut MeshBuilder, place: DVec3, along: DVec3, outward: DVec3) {
    let reach = along * 0.75 + outward * 0.22;
    builder.cuboid(place - reach + DVec3::Y * 0.9, place + reach + DVec3::Y * 2.6);
}

#[cfg(test)]
mod tests {
    #[test]
    fn city_is_large_and_its_objects_are_small() {
        let scene = super::scene();
        let triangles = scene.triangles();
        assert!((300_000..3_000_000).contains(&triangles), "{triangles} triangles");
        let bounds = scene.bounds_world().unwrap();
        let extent = bounds.max - bounds.min;
        assert!(extent.x >= 1000.0 && extent.z >= 1000.0, "{extent}");
        assert!(scene.instances.len() > 2000);
        let largest = scene.meshes.iter().map(super::Mesh::triangles).max().unwrap();
        assert!(largest < 10_000, "{largest} triangles in one mesh");
    }
}
