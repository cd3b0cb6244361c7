//! A lattice of views: the nearest of them stands for all views around it.

use glam::{DMat3, DQuat, DVec3};

use super::View;

/// Largest angle between a view and the nearest of a lattice, in pitches: half a pitch of azimuth, of elevation and of roll,
/// and what their sines add where pitches are coarse.
const FARTHEST_TURN: f64 = 0.875;

/// Eyes on a cubic lattice and axes at whole steps of azimuth, elevation and roll, in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ViewLattice {
    /// Distance of neighbouring eyes along the world's axes, metres; 0: eyes stay where they are.
    pub pitch_metres: f64,
    /// Step of each angle, radians, at most an eighth of a turn; 0: axes stay as they are.
    pub pitch_radians: f64,
}

impl ViewLattice {
    /// The nearest view of the lattice; image and depths stay as they are.
    #[must_use]
    pub fn nearest(&self, view: &View) -> View {
        View {
            eye_world: rounded_eye(view.eye_world, self.pitch_metres),
            camera_from_world: rounded_axes(view.camera_from_world, self.pitch_radians),
            ..*view
        }
    }

    /// Largest distance between a view's eye and the nearest one's, metres.
    pub fn farthest_move_metres(&self) -> f64 {
        0.5 * libm::sqrt(3.0) * self.pitch_metres
    }

    /// Largest angle between a view's axes and the nearest one's, about any axis, radians.
    pub fn farthest_turn_radians(&self) -> f64 {
        FARTHEST_TURN * self.pitch_radians
    }
}

fn rounded_eye(eye_world: DVec3, pitch: f64) -> DVec3 {
    if pitch > 0.0 { (eye_world / pitch).round() * pitch } else { eye_world }
}

/// A rotation, or reflection, whose view direction and whose roll about it are whole steps.
fn rounded_axes(camera_from_world: DMat3, pitch: f64) -> DMat3 {
    if pitch <= 0.0 {
        return camera_from_world;
    }
    let rounded = |angle: f64| libm::round(angle / pitch) * pitch;
    let axes = camera_from_world.transpose();
    let handed = camera_from_world.determinant().signum();
    let (right, forward) = (axes.x_axis * handed, -axes.z_axis);

    // Round the view direction; azimuth about the world's y.
    let azimuth = rounded(libm::atan2(forward.x, -forward.z));
    let quarter = std::f64::consts::FRAC_PI_2;
    let elevation = rounded(libm::asin(forward.y.clamp(-1.0, 1.0))).clamp(-quarter, quarter);
    let level = DVec3::new(libm::sin(azimuth), 0.0, -libm::cos(azimuth));
    let ahead = level * libm::cos(elevation) + DVec3::Y * libm::sin(elevation);

    // Swing the axes along and round how they are rolled beside level ones.
    let swung = DQuat::from_rotation_arc(forward, ahead) * right;
    let level_right = DVec3::new(libm::cos(azimuth), 0.0, libm::sin(azimuth));
    let level_up = level_right.cross(ahead);
    let roll = rounded(libm::atan2(swung.dot(level_up), swung.dot(level_right)));
    let right = level_right * libm::cos(roll) + level_up * libm::sin(roll);
    let up = right.cross(ahead);
    DMat3::from_cols(right * handed, up, -ahead).transpose()
}
