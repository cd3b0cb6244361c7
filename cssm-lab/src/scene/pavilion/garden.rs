//! The garden around the pavilion: lawn, a paved path, hedges, clipped trees, benches.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

use cssm_core::glam::DVec3;

use super::{FOOTING_METRES, Parts};
use crate::scene::Mesh;
use crate::scene::place::{shaded, upright};
use crate::scene::solid::MeshBuilder;

const LAWN_TILES_PER_SIDE: i32 = 16;
const LAWN_TILE_METRES: f64 = 8.0;
/// Distance of the ring path's middle from the pavilion's axis.
const RING_METRES: f64 = 8.6;
const HEDGE_METRES: f64 = 11.6;
const CYPRESS_METRES: f64 = 38.0;

const LAWN: [f32; 3] = [0.19, 0.33, 0.09];
const PAVING: [f32; 3] = [0.56, 0.50, 0.41];
const HEDGE: [f32; 3] = [0.09, 0.21, 0.06];
const CYPRESS: [f32; 3] = [0.07, 0.17, 0.08];
const BENCH: [f32; 3] = [0.44, 0.28, 0.15];
const POT: [f32; 3] = [0.46, 0.22, 0.13];

/// Lays the lawn and puts everything on it.
pub(super) fn lay_out(parts: &mut Parts) {
    lay_lawn(parts);
    pave(parts);
    plant_hedges(parts);
    plant_cypresses(parts);
    furnish(parts);
}

/// A point at an angle and a distance from the pavilion's axis.
fn around(turn: f64, distance: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(turn);
    DVec3::new(cos, 0.0, -sin) * distance
}

fn lay_lawn(parts: &mut Parts) {
    let mut builder = MeshBuilder::new();
    builder.cuboid(DVec3::Y * -FOOTING_METRES, DVec3::new(LAWN_TILE_METRES, 0.0, LAWN_TILE_METRES));
    let tile = parts.add(builder.build("lawn"));
    for index in 0..LAWN_TILES_PER_SIDE * LAWN_TILES_PER_SIDE {
        let along = |step: i32| f64::from(step - LAWN_TILES_PER_SIDE / 2) * LAWN_TILE_METRES;
        let corner = DVec3::new(along(index % LAWN_TILES_PER_SIDE), 0.0, along(index / LAWN_TILES_PER_SIDE));
        // Show which way each stripe was mown.
        let shade = if index % 2 == 0 { 0.93 } else { 1.07 };
        parts.instances.push(upright(tile, corner, 0.0, 1.0, shaded(LAWN, shade)));
    }
}

/// Flags around the pavilion, and away from its entrance.
fn pave(parts: &mut Parts) {
    let mut builder = MeshBuilder::new();
    builder.cuboid(DVec3::new(-0.62, -FOOTING_METRES, -0.62), DVec3::new(0.62, 0.035, 0.62));
    let flag = parts.add(builder.build("flag"));
    let mut put = |place: DVec3, turn: f64| {
        let turn = turn + parts.random.between(-0.06, 0.06);
        let colour = shaded(PAVING, parts.random.between(0.85, 1.12));
        parts.instances.push(upright(flag, place, turn, 1.0, colour));
    };
    for (row, distance) in [RING_METRES - 0.67, RING_METRES + 0.67].into_iter().enumerate() {
        let flags = (TAU * distance / 1.38) as u32;
        for index in 0..flags {
            let turn = TAU * (f64::from(index) + 0.5 * row as f64) / f64::from(flags);
            put(around(turn, distance), turn);
        }
    }
    for step in 0..22 {
        for column in [-0.5, 0.5] {
            let place = DVec3::new(RING_METRES + 2.05 + 1.34 * f64::from(step), 0.0, 1.34 * column);
            put(place, 0.0);
        }
    }
}

/// Waves of a few centimetres that make clipped shapes look grown.
fn waves(point: DVec3, metres: f64) -> f64 {
    let wave = |direction: DVec3| libm::sin(point.dot(direction));
    metres
        * (wave(DVec3::new(4.1, 2.3, 1.7))
            + wave(DVec3::new(-2.9, 5.3, 3.1))
            + wave(DVec3::new(1.3, -4.7, 6.1)))
}

/// Hedges around the ring path with a gap at each path, and clipped balls on pots in the gaps.
fn plant_hedges(parts: &mut Parts) {
    let mut builder = MeshBuilder::new();
    builder.lump(7, |point| {
        // Round the edges of a box a little: between a cube and the ball within it.
        let rounded = point * 0.86 + point.normalize() * 0.16;
        let grown = rounded * DVec3::new(0.42, 0.62, 1.5) + DVec3::Y * 0.42;
        grown + point.normalize() * waves(grown * 1.6, 0.016)
    });
    let hedge = parts.add(builder.build("hedge"));
    let ball = parts.add(ball());
    let pot = parts.add(pot());
    for quarter in 0..4 {
        let entrance = f64::from(quarter) * FRAC_PI_2;
        for index in -2..=2 {
            let turn = entrance + FRAC_PI_4 + f64::from(index) * 0.236;
            let colour = shaded(HEDGE, parts.random.between(0.9, 1.15));
            parts.instances.push(upright(hedge, around(turn, HEDGE_METRES), turn, 1.0, colour));
        }
        for side in [-1.0, 1.0] {
            let place = around(entrance + side * 0.155, HEDGE_METRES - 0.1);
            let turn = parts.random.between(0.0, TAU);
            let colour = shaded(HEDGE, parts.random.between(1.1, 1.3));
            parts.instances.push(upright(pot, place, turn, 1.0, POT));
            parts.instances.push(upright(ball, place, turn, 1.0, colour));
        }
    }
}

fn ball() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.lump(6, |point| {
        let round = point.normalize();
        round * (0.52 + waves(round * 3.0, 0.010)) + DVec3::Y * 0.98
    });
    builder.build("ball")
}

fn pot() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.frustum(DVec3::Y * -FOOTING_METRES, FOOTING_METRES + 0.5, 0.22, 0.36, 16);
    builder.frustum(DVec3::Y * 0.46, 0.1, 0.4, 0.4, 16);
    builder.build("pot")
}

/// Cypresses in a wide ring, behind everything.
fn plant_cypresses(parts: &mut Parts) {
    let mut builder = MeshBuilder::new();
    builder.lump(5, |point| {
        let round = point.normalize();
        // Pointed above, broad below.
        let girth = 1.15 * (1.0 - 0.45 * round.y) * (1.0 + waves(round * 2.4, 0.03));
        DVec3::new(round.x * girth, 4.6 + 5.0 * round.y, round.z * girth)
    });
    let cypress = parts.add(builder.build("cypress"));
    let count = 44;
    for index in 0..count {
        let turn = TAU * f64::from(index) / f64::from(count) + parts.random.between(-0.06, 0.06);
        let place = around(turn, CYPRESS_METRES + parts.random.between(-5.0, 5.0));
        let (size, colour) =
            (parts.random.between(0.6, 1.25), shaded(CYPRESS, parts.random.between(0.85, 1.2)));
        parts.instances.push(upright(cypress, place, parts.random.between(0.0, TAU), size, colour));
    }
}

/// Benches of slats between the path and the hedges, facing the pavilion.
fn furnish(parts: &mut Parts) {
    let bench = parts.add(bench());
    for turn in [-0.75, 0.75, 2.2, 3.9] {
        parts.instances.push(upright(bench, around(turn, RING_METRES + 1.75), turn, 1.0, BENCH));
    }
}

/// A bench along z whose back is towards x.
fn bench() -> Mesh {
    let mut builder = MeshBuilder::new();
    for z in [-0.75, 0.75] {
        builder.cuboid(DVec3::new(-0.24, -FOOTING_METRES, z - 0.03), DVec3::new(-0.18, 0.44, z + 0.03));
        builder.beam(DVec3::new(0.20, -FOOTING_METRES, z), DVec3::new(0.20, 0.44, z), 0.06, 0.06);
        builder.beam(DVec3::new(0.20, 0.40, z), DVec3::new(0.34, 0.98, z), 0.05, 0.05);
        builder.cuboid(DVec3::new(-0.26, 0.36, z - 0.025), DVec3::new(0.24, 0.42, z + 0.025));
    }
    for slat in 0..5 {
        let x = -0.24 + 0.105 * f64::from(slat);
        builder.cuboid(DVec3::new(x - 0.04, 0.425, -0.9), DVec3::new(x + 0.04, 0.455, 0.9));
    }
    for slat in 0..4 {
        let rise = 0.12 * f64::from(slat);
        let (x, y) = (0.235 + rise * 0.24, 0.56 + rise);
        builder.beam(DVec3::new(x, y, -0.9), DVec3::new(x, y, 0.9), 0.025, 0.08);
    }
    builder.build("bench")
}
