//! Cameras that stand still, creep and drive, and what lights cost under each.

use cssm_core::View;
use cssm_core::glam::{DMat3, DVec3};
use serde::Serialize;

/// How the camera moves from frame to frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Motion {
    /// Name for reports.
    pub name: &'static str,
    /// Distance ahead in a frame, metres.
    pub step_metres: f64,
    /// Turn to the left in a frame, degrees.
    pub turn_degrees: f64,
    /// Whether cars drive.
    pub cars_drive: bool,
}

/// Still, slow and fast; the first two also with cars that drive.
pub const MOTIONS: [Motion; 5] = [
    Motion { name: "still", step_metres: 0.0, turn_degrees: 0.0, cars_drive: false },
    Motion { name: "still, cars drive", step_metres: 0.0, turn_degrees: 0.0, cars_drive: true },
    Motion { name: "slow", step_metres: 0.01, turn_degrees: 0.02, cars_drive: false },
    Motion { name: "slow, cars drive", step_metres: 0.01, turn_degrees: 0.02, cars_drive: true },
    Motion { name: "fast", step_metres: 0.25, turn_degrees: 0.5, cars_drive: true },
];

impl Motion {
    /// The view after so many frames.
    pub fn view(&self, start: &View, frames: u32) -> View {
        let turned = self.turn_degrees.to_radians() * f64::from(frames);
        let ahead = -start.camera_from_world.transpose().z_axis;
        let level = DVec3::new(ahead.x, 0.0, ahead.z).normalize_or(DVec3::NEG_Z);
        View {
            eye_world: start.eye_world + level * (self.step_metres * f64::from(frames)),
            camera_from_world: start.camera_from_world * DMat3::from_rotation_y(-turned),
            ..*start
        }
    }
}
