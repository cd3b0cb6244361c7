//! The pavilion itself.

use std::f64::consts::{FRAC_PI_4, FRAC_PI_8};

use cssm_core::glam::DVec3;

use super::{FOOTING_METRES, Parts};
use crate::scene::Mesh;
use crate::scene::place::upright;
use crate::scene::solid::MeshBuilder;

const SIDES: u32 = 8;
const STEP_METRES: f64 = 0.16;
/// Radii of the plinth's octagons to their corners, from below.
const STEPS: [f64; 3] = [6.3, 5.9, 5.5];
const FLOOR: f64 = STEP_METRES * STEPS.len() as f64;
/// Distance of the columns from the axis.
const COLUMNS: f64 = 4.7;
const BEAM: f64 = 3.5;
const EAVES: f64 = 3.75;
const EAVES_RADIUS: f64 = 5.7;
const LANTERN: f64 = 6.0;
const LANTERN_RADIUS: f64 = 0.8;
const COURSES: u32 = 11;

const STONE: [f32; 3] = [0.50, 0.47, 0.42];
const PAINT: [f32; 3] = [0.78, 0.75, 0.68];
const TIMBER: [f32; 3] = [0.38, 0.25, 0.15];
const TILE: [f32; 3] = [0.42, 0.17, 0.11];
const COPPER: [f32; 3] = [0.22, 0.42, 0.36];

/// Builds the plinth, then each side with its column, railing, frieze and roof, then the lantern.
pub(super) fn build(parts: &mut Parts) {
    let mut put_once = |mesh: Mesh, turn: f64, colour| {
        let mesh = parts.add(mesh);
        parts.instances.push(upright(mesh, DVec3::ZERO, turn, 1.0, colour));
    };
    for (index, radius) in STEPS.iter().enumerate() {
        put_once(step(index, *radius), FRAC_PI_8, STONE);
    }
    put_once(lantern(), FRAC_PI_8, PAINT);
    put_once(lantern_roof(), FRAC_PI_8, COPPER);

    let column = parts.add(column());
    let railing = parts.add(railing());
    let frieze = parts.add(frieze());
    let rafters = parts.add(rafters());
    let roof = parts.add(roof_side());
    let hip = parts.add(hip());
    for side in 0..SIDES {
        let turn = f64::from(side) * FRAC_PI_4;
        let mut put =
            |mesh, turn, colour| parts.instances.push(upright(mesh, DVec3::ZERO, turn, 1.0, colour));
        put(column, turn + FRAC_PI_8, PAINT);
        put(frieze, turn, PAINT);
        put(rafters, turn, TIMBER);
        put(roof, turn, TILE);
        put(hip, turn + FRAC_PI_8, COPPER);
        // The entrance has no railing.
        if side > 0 {
            put(railing, turn, PAINT);
        }
    }
}

fn step(index: usize, radius: f64) -> Mesh {
    let foot = STEP_METRES * index as f64;
    let mut builder = MeshBuilder::new();
    builder.frustum(DVec3::Y * (foot - FOOTING_METRES), STEP_METRES + FOOTING_METRES, radius, radius, SIDES);
    builder.build("step")
}

/// A base, a shaft that swells, rings and a capital; it stands on the corner that x points at.
fn column() -> Mesh {
    let mut builder = MeshBuilder::new();
    let centre = DVec3::X * COLUMNS;
    let (min, max) = (DVec3::new(-0.24, FLOOR - 0.1, -0.24), DVec3::new(0.24, FLOOR + 0.12, 0.24));
    builder.cuboid(centre + min, centre + max);
    let rings: [(f64, f64, f64, f64); 8] = [
        (0.10, 0.10, 0.21, 0.20),
        (0.18, 0.06, 0.18, 0.18),
        (0.22, 0.90, 0.150, 0.158),
        (1.10, 0.90, 0.158, 0.150),
        (1.98, 0.74, 0.150, 0.130),
        (2.62, 0.05, 0.155, 0.155),
        (2.66, 0.14, 0.135, 0.21),
        (2.30, 0.04, 0.150, 0.150),
    ];
    for (foot, height, low, high) in rings {
        builder.frustum(centre + DVec3::Y * (FLOOR + foot), height, low, high, 24);
    }
    let (min, max) = (DVec3::new(-0.25, FLOOR + 2.78, -0.25), DVec3::new(0.25, BEAM + 0.02, 0.25));
    builder.cuboid(centre + min, centre + max);
    builder.build("column")
}

/// Half the distance between two columns' axes, and the distance of its middle from the pavilion's axis.
fn bay() -> (f64, f64) {
    (COLUMNS * libm::sin(FRAC_PI_8), COLUMNS * libm::cos(FRAC_PI_8))
}

/// A rail, a curb and turned bars of three centimetres between them; it closes the side that x points at.
fn railing() -> Mesh {
    let (half, middle) = bay();
    let mut builder = MeshBuilder::new();
    let across = |low: f64, high: f64, reach: f64, builder: &mut MeshBuilder| {
        builder.cuboid(
            DVec3::new(middle - reach, FLOOR + low, -half),
            DVec3::new(middle + reach, FLOOR + high, half),
        );
    };
    across(0.10, 0.15, 0.035, &mut builder);
    across(0.86, 0.93, 0.055, &mut builder);
    let bars = 21;
    for bar in 0..bars {
        let z = (half - 0.2) * (2.0 * f64::from(bar) / f64::from(bars - 1) - 1.0);
        let foot = DVec3::new(middle, FLOOR + 0.14, z);
        for (rise, height, low, high) in
            [(0.0, 0.16, 0.016, 0.013), (0.15, 0.22, 0.013, 0.028), (0.36, 0.38, 0.026, 0.012)]
        {
            builder.frustum(foot + DVec3::Y * rise, height, low, high, 8);
        }
    }
    builder.build("railing")
}

/// The beam over the side that x points at, and a lattice of laths below it.
fn frieze() -> Mesh {
    let (half, middle) = bay();
    let mut builder = MeshBuilder::new();
    let wide = half + 0.1;
    builder.cuboid(DVec3::new(middle - 0.13, BEAM, -wide), DVec3::new(middle + 0.13, BEAM + 0.26, wide));
    let (low, high) = (BEAM - 0.46, BEAM - 0.05);
    for rise in [low, high] {
        builder.cuboid(
            DVec3::new(middle - 0.025, rise - 0.02, -half),
            DVec3::new(middle + 0.025, rise + 0.02, half),
        );
    }
    let fields = 7;
    let at = |field: i32| (half - 0.15) * (2.0 * f64::from(field) / f64::from(fields) - 1.0);
    for field in 0..fields {
        // Crossing laths lie behind each other.
        for (from, to, depth) in [(field, field + 1, -0.008), (field + 1, field, 0.008)] {
            let lath = |z, y| DVec3::new(middle + depth, y, z);
            builder.beam(lath(at(from), low), lath(at(to), high), 0.014, 0.024);
        }
    }
    for field in 0..=fields {
        builder.beam(
            DVec3::new(middle, low, at(field)),
            DVec3::new(middle, BEAM + 0.02, at(field)),
            0.022,
            0.022,
        );
    }
    builder.build("frieze")
}

/// A point of the roof's slope over the side that x points at: share of the way up, metres across, metres off it.
fn on_roof(share: f64, across: f64, off: f64) -> DVec3 {
    let flat = libm::cos(FRAC_PI_8);
    let (foot, head) =
        (DVec3::new(EAVES_RADIUS * flat, EAVES, 0.0), DVec3::new(LANTERN_RADIUS * flat, LANTERN, 0.0));
    let slope = head - foot;
    let outward = DVec3::new(slope.y, -slope.x, 0.0).normalize();
    foot + slope * share + outward * off + DVec3::Z * across
}

/// Half the width of the roof's side at a share of the way up.
fn roof_half_width(share: f64) -> f64 {
    (EAVES_RADIUS + (LANTERN_RADIUS - EAVES_RADIUS) * share) * libm::sin(FRAC_PI_8)
}

/// Courses of boards that overlap upwards, each thicker at its lower edge.
fn roof_side() -> Mesh {
    let mut builder = MeshBuilder::new();
    for course in 0..COURSES {
        let low = f64::from(course) / f64::from(COURSES);
        let high = f64::from(course + 1) / f64::from(COURSES) + 0.012;
        let corner = |share: f64, side: f64, off: f64| {
            // Reach a little past the hip, which covers it.
            on_roof(share, side * (roof_half_width(share) + 0.015), off)
        };
        // Across the roof, off it and down it are right-handed.
        builder.hexahedron([
            corner(high, -1.0, 0.0),
            corner(high, 1.0, 0.0),
            corner(high, -1.0, 0.055),
            corner(high, 1.0, 0.055),
            corner(low, -1.0, 0.02),
            corner(low, 1.0, 0.02),
            corner(low, -1.0, 0.11),
            corner(low, 1.0, 0.11),
        ]);
    }
    builder.build("roof")
}

/// Rafters under the roof and a board along its eaves.
fn rafters() -> Mesh {
    let mut builder = MeshBuilder::new();
    for rafter in -3..=3 {
        let across = 0.55 * f64::from(rafter);
        // Rafters end where the side grows narrower than they lie apart.
        let top = (0..=20)
            .map(|step| f64::from(step) / 20.0)
            .filter(|share| roof_half_width(*share) > across.abs() + 0.05);
        let top = top.fold(0.0, f64::max).min(0.98);
        builder.beam(on_roof(0.005, across, -0.045), on_roof(top, across, -0.045), 0.06, 0.10);
    }
    let half = roof_half_width(0.0);
    builder.beam(on_roof(-0.004, -half, -0.03), on_roof(-0.004, half, -0.03), 0.03, 0.16);
    builder.build("rafters")
}

/// The cap over the edge between two sides of the roof; it lies over the corner that x points at.
fn hip() -> Mesh {
    let mut builder = MeshBuilder::new();
    let (foot, head) =
        (DVec3::new(EAVES_RADIUS + 0.06, EAVES + 0.05, 0.0), DVec3::new(LANTERN_RADIUS, LANTERN + 0.09, 0.0));
    builder.beam(foot, head, 0.12, 0.13);
    builder.build("hip")
}

/// A drum with posts between the roof and its little roof.
fn lantern() -> Mesh {
    let mut builder = MeshBuilder::new();
    builder.frustum(DVec3::Y * (LANTERN - 0.25), 0.45, 0.95, 0.85, SIDES);
    for post in 0..SIDES {
        let (sin, cos) = libm::sincos(f64::from(post) * FRAC_PI_4);
        let foot = DVec3::new(0.68 * cos, LANTERN + 0.15, -0.68 * sin);
        builder.frustum(foot, 0.75, 0.045, 0.045, 10);
    }
    builder.build("lantern")
}

fn lantern_roof() -> Mesh {
    let mut builder = MeshBuilder::new();
    let foot = LANTERN + 0.85;
    builder.frustum(DVec3::Y * foot, 0.08, 1.0, 1.02, SIDES);
    builder.frustum(DVec3::Y * (foot + 0.06), 0.75, 0.96, 0.10, SIDES);
    builder.frustum(DVec3::Y * (foot + 0.75), 0.55, 0.07, 0.03, 12);
    builder.lump(4, |point| point.normalize() * 0.13 + DVec3::Y * (foot + 1.0));
    builder.frustum(DVec3::Y * (foot + 1.25), 0.5, 0.035, 0.0, 10);
    builder.build("lantern roof")
}
