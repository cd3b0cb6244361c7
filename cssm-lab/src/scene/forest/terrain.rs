//! Gentle hills, in tiles that meet without gaps.

use cssm_core::glam::DVec3;

use crate::scene::place::upright;
use crate::scene::solid::MeshBuilder;
use crate::scene::{Instance, Mesh};

const TILES_PER_SIDE: i32 = 17;
/// A power of two, so that neighbouring tiles put their common corners in exactly the same place.
const TILE_METRES: f64 = 64.0;
const CELLS_PER_SIDE: i32 = 8;

/// Side of the whole terrain.
pub(super) const SIDE_METRES: f64 = TILES_PER_SIDE as f64 * TILE_METRES;

/// Height of the ground. Hills are so wide that neighbouring triangles differ by less than a degree.
pub(super) fn height(x: f64, z: f64) -> f64 {
    let wave =
        |metres: f64, across: f64, along: f64, phase: f64| metres * libm::sin(x * across + z * along + phase);
    wave(7.0, 0.0098, 0.0062, 0.4) + wave(3.0, -0.0105, 0.0126, 1.9) + wave(1.2, 0.004, -0.022, 0.0)
}

/// Lays all tiles.
pub(super) fn lay(meshes: &mut Vec<Mesh>, instances: &mut Vec<Instance>, colour: [f32; 3]) {
    for tile in 0..TILES_PER_SIDE * TILES_PER_SIDE {
        let along = |step: i32| f64::from(step) * TILE_METRES - 0.5 * SIDE_METRES;
        let corner = DVec3::new(along(tile % TILES_PER_SIDE), 0.0, along(tile / TILES_PER_SIDE));
        instances.push(upright(meshes.len(), corner, 0.0, 1.0, colour));
        meshes.push(tile_at(corner));
    }
}

fn tile_at(corner: DVec3) -> Mesh {
    let step = TILE_METRES / f64::from(CELLS_PER_SIDE);
    let mut builder = MeshBuilder::new();
    for cell in 0..CELLS_PER_SIDE * CELLS_PER_SIDE {
        let (column, row) = (cell % CELLS_PER_SIDE, cell / CELLS_PER_SIDE);
        let point = |x: i32, z: i32| {
            let (x, z) = (f64::from(column + x) * step, f64::from(row + z) * step);
            DVec3::new(x, height(corner.x + x, corner.z + z), z)
        };
        builder.quad([point(0, 0), point(0, 1), point(1, 1), point(1, 0)]);
    }
    builder.build("ground")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_are_gentle_and_face_up() {
        let (mut meshes, mut instances) = (Vec::new(), Vec::new());
        lay(&mut meshes, &mut instances, [0.5; 3]);
        for mesh in &meshes {
            for corners in mesh.indices.chunks_exact(3) {
                let at = |corner: u32| DVec3::from(mesh.positions[corner as usize].map(f64::from));
                let (one, two) = (at(corners[1]) - at(corners[0]), at(corners[2]) - at(corners[0]));
                assert!(one.cross(two).normalize().y > 0.98);
            }
        }
    }

    #[test]
    fn tiles_meet_without_gaps() {
        let corner = DVec3::new(64.0, 0.0, -128.0);
        let last =
            |mesh: &Mesh| mesh.positions.iter().filter(|p| p[0] == 64.0).map(|p| p[1]).collect::<Vec<_>>();
        let first =
            |mesh: &Mesh| mesh.positions.iter().filter(|p| p[0] == 0.0).map(|p| p[1]).collect::<Vec<_>>();
        let sorted = |mut heights: Vec<f32>| {
            heights.sort_by(f32::total_cmp);
            heights.dedup();
            heights
        };
        let (one, two) = (tile_at(corner), tile_at(corner + DVec3::X * TILE_METRES));
        assert_eq!(sorted(last(&one)), sorted(first(&two)));
    }
}
