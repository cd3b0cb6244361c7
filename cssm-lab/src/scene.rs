//! Scenes: meshes, and the places where they stand.
//!
//! Positions of a mesh are f32 in its own space, as an engine uploads them; instances place it in the world in
//! f64. Procedural scenes are pure functions of a seed. Every mesh is small, so that culling whole instances per
//! facet works.

mod city;
mod foliage;
mod forest;
mod gltf_file;
mod gltf_mask;
mod gltf_read;
mod lamp;
mod mask;
mod palm;
mod pavilion;
mod place;
pub(crate) mod random;
mod solid;

pub use gltf_file::SceneFileError;
pub use lamp::Lamp;
pub use mask::AlphaMask;

use std::path::Path;

use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::{BoundingBox, Light, View};

use crate::error::LabError;

/// A scene.
#[derive(Debug, Clone)]
pub struct Scene {
    /// Name for reports and picture labels.
    pub name: String,
    /// Shapes, each in its own space.
    pub meshes: Vec<Mesh>,
    /// Places where they stand.
    pub instances: Vec<Instance>,
    /// Views worth looking at; the first is the one a demo shows.
    pub views: Vec<Viewpoint>,
    /// Local lights worth looking at; none in scenes from files.
    pub lamps: Vec<Lamp>,
}

/// A triangle mesh.
#[derive(Debug, Clone)]
pub struct Mesh {
    /// Name for messages.
    pub name: String,
    /// Vertex positions in object space, metres.
    pub positions: Vec<[f32; 3]>,
    /// Three per triangle, counter-clockwise seen from outside.
    pub indices: Vec<u32>,
    /// Holes; `None` for a mesh without any.
    pub mask: Option<AlphaMask>,
}

/// A mesh placed in the world.
#[derive(Debug, Clone, Copy)]
pub struct Instance {
    /// Index in [`Scene::meshes`].
    pub mesh: usize,
    /// Object to world.
    pub world_from_object: DAffine3,
    /// Linear colour for pictures.
    pub colour: [f32; 3],
}

/// A camera position worth looking from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Viewpoint {
    /// Eye in world space, metres.
    pub eye_world: DVec3,
    /// Point looked at.
    pub target_world: DVec3,
    /// Direction in which the light travels.
    pub light_travels: DVec3,
}

impl Viewpoint {
    /// What is seen from here to infinity with the customary camera of the lab's pictures, and the light.
    ///
    /// # Errors
    /// When the eye, the target or the light make no sense.
    pub fn pictured(&self, size_pixels: (u32, u32)) -> Result<(View, Light), LabError> {
        let fov_y_radians = FOV_Y_DEGREES.to_radians();
        let (eye, target, far) = (self.eye_world, self.target_world, f64::INFINITY);
        let view = View::perspective(eye, target, DVec3::Y, fov_y_radians, NEAR_METRES, far, size_pixels)?;
        Ok((view, Light::directional_travelling(self.light_travels)?))
    }
}

/// Camera of the lab's pictures.
const FOV_Y_DEGREES: f64 = 60.0;
const NEAR_METRES: f64 = 0.2;

/// Names of the scenes that are built in.
pub const BUILT_IN: [&str; 4] = ["palm", "city", "pavilion", "forest"];

impl Scene {
    /// The scene of a name in [`BUILT_IN`], or of a glTF 2.0 file (`.gltf`, `.glb`).
    ///
    /// # Errors
    /// [`SceneFileError`] when the file cannot be read as a scene.
    pub fn load(name_or_path: &str) -> Result<Self, SceneFileError> {
        match name_or_path {
            "palm" => Ok(palm::scene()),
            "city" => Ok(city::scene()),
            "pavilion" => Ok(pavilion::scene()),
            "forest" => Ok(forest::scene()),
            path => gltf_file::load(Path::new(path)),
        }
    }

    /// A few palms with thin fronds on bare ground: 10,624 triangles.
    pub fn palm() -> Self {
        palm::scene()
    }

    /// A town of a kilometre with window reliefs, trees and thin lamp posts: more than 300,000 triangles.
    pub fn city() -> Self {
        city::scene()
    }

    /// A garden pavilion with railings of thin bars, among hedges.
    pub fn pavilion() -> Self {
        pavilion::scene()
    }

    /// A square kilometre of hills under thousands of trees, whose leaves are cut out by alpha masks.
    pub fn forest() -> Self {
        forest::scene()
    }

    /// The lamp of a name.
    ///
    /// # Errors
    /// [`LabError::NoSuchLamp`] with the names that there are.
    pub fn lamp(&self, name: &str) -> Result<&Lamp, LabError> {
        let no_such = || LabError::NoSuchLamp {
            scene: self.name.clone(),
            name: name.to_owned(),
            known: self.lamps.iter().map(|lamp| lamp.name).collect(),
        };
        self.lamps.iter().find(|lamp| lamp.name == name).ok_or_else(no_such)
    }

    /// Whether any of its instances has holes.
    pub fn has_masks(&self) -> bool {
        self.instances.iter().any(|instance| self.meshes[instance.mesh].mask.is_some())
    }

    /// Number of triangles, instances counted.
    pub fn triangles(&self) -> usize {
        self.instances.iter().map(|instance| self.meshes[instance.mesh].triangles()).sum()
    }

    /// World box around everything; `None` for a scene without triangles.
    pub fn bounds_world(&self) -> Option<BoundingBox> {
        let local: Vec<_> = self.meshes.iter().map(Mesh::bounds).collect();
        let mut bounds: Option<BoundingBox> = None;
        for instance in &self.instances {
            let Some((min, max)) = local[instance.mesh] else {
                continue;
            };
            for corner in 0..8_u32 {
                let pick = |bit: u32, axis: usize| {
                    if corner >> bit & 1 == 0 { min[axis] } else { max[axis] }
                };
                let point = instance.world_from_object.transform_point3(DVec3::new(
                    pick(0, 0),
                    pick(1, 1),
                    pick(2, 2),
                ));
                bounds = Some(bounds.map_or(BoundingBox { min: point, max: point }, |b| BoundingBox {
                    min: b.min.min(point),
                    max: b.max.max(point),
                }));
            }
        }
        bounds
    }
}

impl Mesh {
    /// Number of triangles.
    pub fn triangles(&self) -> usize {
        self.indices.len() / 3
    }

    /// Object-space box; `None` for a mesh without vertices.
    pub fn bounds(&self) -> Option<([f64; 3], [f64; 3])> {
        let first = self.positions.first()?.map(f64::from);
        Some(self.positions.iter().fold((first, first), |(mut min, mut max), position| {
            for axis in 0..3 {
                min[axis] = min[axis].min(f64::from(position[axis]));
                max[axis] = max[axis].max(f64::from(position[axis]));
            }
            (min, max)
        }))
    }
}
