//! A hundred lights for a town: the sun, and lamps under the arms of its lamp posts.

use cssm_core::glam::DVec3;
use cssm_core::{Light, View};

use crate::error::LabError;
use crate::scene::{Instance, Scene};

/// Local lights in a scene.
pub(super) const LOCAL_LIGHTS: usize = 99;
/// Every so many lamps one is a spot light: 20 of 99.
const SPOT_STEP: usize = 5;
/// Name of the meshes that carry lamps.
const LAMP_MESH: &str = "lamp";
/// Name of the meshes that drive.
const CAR_MESH: &str = "car";
/// The light in the space of a lamp post, metres: under the box at the end of its arm.
const LAMP_PLACE: DVec3 = DVec3::new(1.32, 5.6, 0.0);
/// Distance from a lamp beyond which nothing is lit.
const LAMP_RANGE_METRES: f64 = 18.0;
const SPOT_RANGE_METRES: f64 = 24.0;
const SPOT_HALF_ANGLE_RADIANS: f64 = 0.9;
/// How far ahead of the eye the middle of the lamps lies.
const AHEAD_METRES: f64 = 40.0;
/// Number of cars that drive.
const CARS: usize = 12;
/// Distance that a car drives in a frame: 8 m/s at 60 frames a second.
const CAR_STEP_METRES: f64 = 8.0 / 60.0;

/// A light of the town.
#[derive(Debug, Clone, PartialEq)]
pub struct PlantedLight {
    /// Name for reports.
    pub name: String,
    /// The light.
    pub light: Light,
}

/// The sun of a viewpoint and the lamps nearest to what it sees.
///
/// # Errors
/// [`LabError::NoLamps`] where the scene has too few lamp posts.
pub fn lights(scene: &Scene, view: &View, sun: Light) -> Result<Vec<PlantedLight>, LabError> {
    let middle = view.eye_world - view.camera_from_world.transpose().z_axis * AHEAD_METRES;
    let posts = nearest(scene, LAMP_MESH, middle);
    if posts.len() < LOCAL_LIGHTS {
        return Err(LabError::NoLamps { found: posts.len(), needed: LOCAL_LIGHTS });
    }
    let mut lights = vec![PlantedLight { name: "sun".to_owned(), light: sun }];
    let (mut spots, mut omnis) = (0, 0);
    for (number, post) in posts.into_iter().take(LOCAL_LIGHTS).enumerate() {
        let place = scene.instances[post].world_from_object;
        let position_world = place.transform_point3(LAMP_PLACE);
        lights.push(if number % SPOT_STEP == 0 {
            spots += 1;
            let direction = place.transform_vector3(DVec3::new(0.35, -1.0, 0.2));
            let light = Light::spot(position_world, direction, SPOT_HALF_ANGLE_RADIANS, SPOT_RANGE_METRES)?;
            PlantedLight { name: format!("spot {spots}"), light }
        } else {
            omnis += 1;
            let light = Light::omni(position_world, LAMP_RANGE_METRES)?;
            PlantedLight { name: format!("omni {omnis}"), light }
        });
    }
    Ok(lights)
}

/// Instances that drive: the cars nearest to what is seen.
pub fn cars(scene: &Scene, view: &View) -> Vec<usize> {
    let middle = view.eye_world - view.camera_from_world.transpose().z_axis * AHEAD_METRES;
    let mut cars = nearest(scene, CAR_MESH, middle);
    cars.truncate(CARS);
    cars.sort_unstable();
    cars
}

/// Where a car stands after so many frames.
pub fn driven(car: &Instance, frames: u32) -> Instance {
    let mut car = *car;
    let ahead = car.world_from_object.matrix3.x_axis.normalize_or(DVec3::X);
    car.world_from_object.translation += ahead * (CAR_STEP_METRES * f64::from(frames));
    car
}

/// The scene after the cars have driven for so many frames.
pub fn scene_at(scene: &Scene, cars: &[usize], frames: u32) -> Scene {
    let mut scene = scene.clone();
    for car in cars {
        scene.instances[*car] = driven(&scene.instances[*car], frames);
    }
    scene
}

/// Instances of meshes of a name, nearest to a point first.
fn nearest(scene: &Scene, mesh: &str, point: DVec3) -> Vec<usize> {
    let is_named = |instance: &Instance| scene.meshes[instance.mesh].name == mesh;
    let mut found: Vec<usize> =
        (0..scene.instances.len()).filter(|index| is_named(&scene.instances[*index])).collect();
    let distance =
        |index: &usize| scene.instances[*index].world_from_object.translation.distance_squared(point);
    found.sort_by(|one, two| distance(one).total_cmp(&distance(two)));
    found
}
