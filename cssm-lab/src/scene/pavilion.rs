//! `pavilion`: an octagonal garden pavilion on a stepped plinth, with columns, railings of thin bars, lattice
//! friezes and a roof of overlapping courses, in a garden of hedges. Every shape is a closed solid with outward
//! faces. The pavilion's axis is y; one side faces x and is its entrance.

mod garden;
mod structure;

use super::lamp::{self, Places};
use super::place::viewpoint;
use super::random::Random;
use super::{Instance, Mesh, Scene};

/// How far solids reach into what they stand on, so that no two faces coincide.
const FOOTING_METRES: f64 = 0.3;

pub(super) fn scene() -> Scene {
    let mut parts = Parts { meshes: Vec::new(), instances: Vec::new(), random: Random::new(0x9a71) };
    structure::build(&mut parts);
    garden::lay_out(&mut parts);
    let views = vec![
        viewpoint([13.6, 3.6, 3.0], [0.0, 2.3, -1.2], [0.15, -0.46, -0.85]),
        viewpoint([2.9, 2.1, 1.4], [-4.0, 1.3, -2.4], [0.75, -0.22, 0.45]),
        viewpoint([10.5, 6.5, -8.0], [0.5, 0.6, 0.5], [-0.72, -0.42, 0.35]),
    ];
    let places = Places {
        in_view: [-0.5, 1.0, 4.7],
        behind: [0.4, 0.7, -1.8],
        beside: [-0.8, 1.5, 2.2],
        outside: [2.7, 1.2, 1.0],
        at_eye: [0.4, 0.5, 0.1],
        wall_world: [-4.237, 1.354, 1.004],
        ahead: [[0.8, 0.6, -0.4], [0.0, 0.0, 6.0]],
        aside: [[2.5, 1.4, 3.0], [-2.0, -1.2, 4.5]],
        dueling: [[-0.2, 2.2, 10.5], [0.3, -1.2, 3.6]],
    };
    let lamps = lamp::around(views[1], &places);
    Scene { name: "pavilion".to_owned(), meshes: parts.meshes, instances: parts.instances, views, lamps }
}

/// What the scene is being put together from.
struct Parts {
    meshes: Vec<Mesh>,
    instances: Vec<Instance>,
    random: Random,
}

impl Parts {
    /// Adds a mesh and returns its index.
    fn add(&mut self, mesh: Mesh) -> usize {
        self.meshes.push(mesh);
        self.meshes.len() - 1
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn pavilion_has_its_exact_count() {
        let scene = super::scene();
        assert_eq!(scene.triangles(), 58_354);
        let largest = scene.meshes.iter().map(super::Mesh::triangles).max();
        assert!(largest.is_some_and(|triangles| triangles < 2500), "{largest:?} triangles in one mesh");
    }

    #[test]
    fn pavilion_is_the_same_every_time() {
        let (one, two) = (format!("{:?}", super::scene()), format!("{:?}", super::scene()));
        assert!(one == two, "two builds of the scene differ");
    }
}
