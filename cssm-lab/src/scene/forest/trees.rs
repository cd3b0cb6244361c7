//! What grows in the forest: broad-leaved trees, birches, conifers, bushes, grass.

use std::f64::consts::TAU;

use cssm_core::glam::DVec3;

use crate::scene::Mesh;
use crate::scene::foliage::{Cards, Drawing};
use crate::scene::random::Random;
use crate::scene::solid::MeshBuilder;

/// A kind of tree.
pub(super) struct Kind {
    /// Mesh of its trunk.
    pub(super) trunk: usize,
    /// Mesh of its leaves.
    pub(super) crown: usize,
    /// Colour of its bark.
    pub(super) bark: [f32; 3],
    /// Colour of its leaves.
    pub(super) leaf: [f32; 3],
}

/// Shapes of each family.
const SHAPES: u32 = 3;
const GOLDEN_ANGLE: f64 = 2.399_963;

/// Adds the meshes of all kinds: as many broad-leaved trees as birches as conifers, in that order.
pub(super) fn kinds(meshes: &mut Vec<Mesh>, random: &mut Random) -> Vec<Kind> {
    let mut kinds = Vec::new();
    let mut add = |trunk: Mesh, crown: Mesh, bark, leaf| {
        kinds.push(Kind { trunk: meshes.len(), crown: meshes.len() + 1, bark, leaf });
        meshes.extend([trunk, crown]);
    };
    for _ in 0..SHAPES {
        let height = random.between(7.5, 9.5);
        let crown = DVec3::new(random.between(3.0, 3.7), random.between(2.5, 3.1), random.between(3.0, 3.7));
        let bark = [0.24, 0.18, 0.13];
        add(
            trunk(height, 0.34, crown.x, random),
            leaves(height, crown, 46, 1.15, random),
            bark,
            [0.15, 0.29, 0.07],
        );
    }
    for _ in 0..SHAPES {
        let height = random.between(8.5, 10.5);
        let crown = DVec3::new(random.between(1.7, 2.1), random.between(3.6, 4.2), random.between(1.7, 2.1));
        let bark = [0.66, 0.64, 0.60];
        add(
            trunk(height, 0.17, crown.x, random),
            leaves(height, crown, 46, 0.9, random),
            bark,
            [0.27, 0.36, 0.09],
        );
    }
    for _ in 0..SHAPES {
        let height = random.between(12.0, 15.0);
        add(mast(height), boughs(height, random), [0.22, 0.15, 0.11], [0.06, 0.17, 0.08]);
    }
    kinds
}

/// A bent trunk with branches into the crown, whose middle lies at a height.
fn trunk(height: f64, radius: f64, spread: f64, random: &mut Random) -> Mesh {
    let lean = DVec3::new(random.between(-0.05, 0.05), 0.0, random.between(-0.05, 0.05));
    let at = |share: f64| DVec3::Y * (height * share - 0.4) + lean * (height * share * share);
    let mut builder = MeshBuilder::new();
    let centres = [(0.0, 1.35), (0.12, 1.0), (0.55, 0.75), (1.15, 0.2)]
        .map(|(share, girth)| (at(share), radius * girth));
    builder.tube(&centres, 7);
    for branch in 0..4 {
        let (sin, cos) = libm::sincos(f64::from(branch) * GOLDEN_ANGLE + random.between(-0.3, 0.3));
        let root = at(0.5 + 0.11 * f64::from(branch));
        let tip = root + DVec3::new(cos * spread * 0.7, height * 0.2, sin * spread * 0.7);
        let bend = root.lerp(tip, 0.5) + DVec3::Y * 0.15;
        builder.tube(&[(root, radius * 0.42), (bend, radius * 0.28), (tip, radius * 0.08)], 4);
    }
    builder.build("trunk")
}

/// Cards over and within an ellipsoid, turned every way.
fn leaves(height: f64, reach: DVec3, cards: u32, half_card: f64, random: &mut Random) -> Mesh {
    let middle = DVec3::Y * height;
    let mut builder = Cards::new();
    for index in 0..cards {
        // Spread directions evenly over the sphere.
        let up = 1.0 - 2.0 * (f64::from(index) + 0.5) / f64::from(cards);
        let (sin, cos) = libm::sincos(f64::from(index) * GOLDEN_ANGLE);
        let flat = libm::sqrt(1.0 - up * up);
        let outward = DVec3::new(flat * cos, up, flat * sin);
        let place = middle + outward * reach * random.between(0.4, 0.95);
        let tilt =
            DVec3::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let facing = (outward + tilt * 0.8).normalize_or(DVec3::Y);
        let across = facing.any_orthonormal_vector();
        let (sin, cos) = libm::sincos(random.between(0.0, TAU));
        let along = across * cos + facing.cross(across) * sin;
        let half = half_card * random.between(0.8, 1.15);
        builder.card(place, along * half, facing.cross(along) * half);
    }
    builder.build("leaves", Drawing::Leaves, random)
}

/// The straight trunk of a conifer.
fn mast(height: f64) -> Mesh {
    let mut builder = MeshBuilder::new();
    let centres = [(-0.4, 0.27), (1.0, 0.2), (0.6 * height, 0.11), (0.99 * height, 0.02)]
        .map(|(rise, radius)| (DVec3::Y * rise, radius));
    builder.tube(&centres, 7);
    builder.build("mast")
}

/// Drooping boughs in whorls that grow shorter upwards, and a crossed pair of cards at the top.
fn boughs(height: f64, random: &mut Random) -> Mesh {
    let whorls = 12;
    let mut builder = Cards::new();
    for whorl in 0..whorls {
        let share = 0.10 + 0.84 * f64::from(whorl) / f64::from(whorls);
        let reach = 0.55 + 2.9 * (1.0 - share);
        for bough in 0..5 {
            let turn = TAU * f64::from(bough) / 5.0 + f64::from(whorl) * 0.9 + random.between(-0.2, 0.2);
            let (sin, cos) = libm::sincos(turn);
            let droop = random.between(0.3, 0.6);
            let out = DVec3::new(cos, -droop, sin) * (0.5 * reach);
            let across = DVec3::new(-sin, random.between(-0.25, 0.25), cos) * (0.5 * reach + 0.1);
            let root = DVec3::Y * (height * share + random.between(-0.25, 0.25));
            builder.card(root + out, out, across);
        }
    }
    for turn in [0.3, 0.3 + 0.25 * TAU] {
        let (sin, cos) = libm::sincos(turn);
        builder.card(DVec3::Y * (0.93 * height), DVec3::Y * (0.09 * height), DVec3::new(cos, 0.0, sin) * 0.7);
    }
    builder.build("boughs", Drawing::Needles, random)
}

/// A bush: leaves alone, down to the ground.
pub(super) fn bush(random: &mut Random) -> Mesh {
    leaves(0.55, DVec3::new(0.7, 0.45, 0.7), 10, 0.5, random)
}

/// A tuft of grass: three crossed cards.
pub(super) fn tuft(random: &mut Random) -> Mesh {
    let mut builder = Cards::new();
    for blade in 0..3 {
        let (sin, cos) = libm::sincos(TAU * f64::from(blade) / 6.0 + 0.2);
        let lean = DVec3::new(-sin, 0.0, cos) * random.between(-0.06, 0.06);
        builder.card(DVec3::Y * 0.2, DVec3::new(cos, 0.0, sin) * 0.34, DVec3::Y * 0.24 + lean);
    }
    builder.build("tuft", Drawing::Blades, random)
}
