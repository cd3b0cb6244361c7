//! Wind: leaves sway a little from frame to frame, trunks and ground stand still.

use cssm_core::glam::{DAffine3, DMat3, DVec3};

use crate::scene::Scene;

/// Largest lean of a crown, metres for each metre above its foot.
const LEAN: f64 = 0.02;
/// Turns of the sway in each frame: a crown sways once in two and a half seconds at sixty frames.
const TURNS_PER_FRAME: f64 = 1.0 / 150.0;
/// Metres over which the wind's phase runs once around.
const GUST_METRES: f64 = 35.0;

/// Whether an instance sways: leaves do.
pub fn sways(scene: &Scene, instance: usize) -> bool {
    scene.instances.get(instance).is_some_and(|instance| scene.meshes[instance.mesh].mask.is_some())
}

/// The scene in a frame.
pub fn blown(scene: &Scene, frame: u32) -> Scene {
    let mut blown = scene.clone();
    for index in 0..blown.instances.len() {
        if sways(scene, index) {
            let instance = &mut blown.instances[index];
            let foot = instance.world_from_object.translation;
            instance.world_from_object = lean(foot, frame) * instance.world_from_object;
        }
    }
    blown
}

/// A shear about a foot.
fn lean(foot: DVec3, frame: u32) -> DAffine3 {
    let phase = (foot.x + 0.6 * foot.z) / GUST_METRES + f64::from(frame) * TURNS_PER_FRAME;
    let (sine, cosine) = libm::sincos(std::f64::consts::TAU * phase);
    let shear = DMat3::from_cols(DVec3::X, DVec3::new(LEAN * sine, 1.0, 0.6 * LEAN * cosine), DVec3::Z);
    DAffine3 { matrix3: shear, translation: foot - shear * foot }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feet_stay_and_tops_move_a_little() {
        let foot = DVec3::new(3.0, 2.0, -7.0);
        let top = foot + DVec3::Y * 10.0;
        let moved = |frame: u32| {
            (lean(foot, frame + 1).transform_point3(top) - lean(foot, frame).transform_point3(top)).length()
        };
        for frame in 0..150 {
            assert!(lean(foot, frame).transform_point3(foot).distance(foot) < 1e-12);
            assert!((1e-4..0.02).contains(&moved(frame)), "{}", moved(frame));
        }
    }
}
