//! A view around every view nearby.

use glam::DVec3;

use super::{View, ViewError};

/// Largest tangent of a widened view's edges: beyond, its field of view is as good as 180 degrees.
const WIDEST_TANGENT: f64 = 1e3;

impl View {
    /// A view with the same axes that sees everything that any view sees whose eye is at most `move_metres` away and
    /// whose axes are turned by at most `turn_radians`, about whatever axis. Its eye stands behind this one, as far as
    /// its sides must clear the moved eyes. Screen pixels span the same tangents, up to whole pixels of the image, so
    /// that footprints compare.
    ///
    /// # Errors
    /// [`ViewError::FieldOfView`] when it would have to reach 180 degrees, [`ViewError::NotFinite`] for a turn or a move
    /// that is negative or not finite.
    pub fn widened(&self, turn_radians: f64, move_metres: f64) -> Result<Self, ViewError> {
        let usable = |value: f64| value >= 0.0 && value.is_finite();
        if !usable(turn_radians) || !usable(move_metres) {
            return Err(ViewError::NotFinite { what: "the margin's turn or move, or its sign," });
        }
        if turn_radians == 0.0 && move_metres == 0.0 {
            return Ok(*self);
        }

        // Turn every visible direction by the angle, whichever way.
        let (left, right) = turned((self.left, self.right), (self.bottom, self.top), turn_radians)?;
        let (bottom, top) = turned((self.bottom, self.top), (self.left, self.right), turn_radians)?;

        // Draw the eye back until all four sides clear the moved eyes.
        let back_x = move_metres * (libm::hypot(1.0, right) + libm::hypot(1.0, left)) / (right - left);
        let back_y = move_metres * (libm::hypot(1.0, top) + libm::hypot(1.0, bottom)) / (top - bottom);
        let back = back_x.max(back_y);
        let beside = |low: f64, high: f64| {
            let least = move_metres * libm::hypot(1.0, high) - high * back;
            let most = -low * back - move_metres * libm::hypot(1.0, low);
            0.5 * (least + most)
        };
        let eye = DVec3::new(beside(left, right), beside(bottom, top), back);

        // Turning brings corners nearer to the image plane of the eye, and farther from it, at most onto the axis.
        let tangents = self.corner_tangents().map(|(x, y)| libm::hypot(x, y));
        let tangent = tangents.into_iter().fold(0.0, f64::max);
        let (sine, cosine) = (libm::sin(turn_radians), libm::cos(turn_radians));
        let nearest = self.near_metres * (cosine - tangent * sine);
        if nearest <= 0.0 {
            return Err(ViewError::FieldOfView);
        }
        let farthest = if tangent * cosine < sine {
            self.far_metres * libm::hypot(1.0, tangent)
        } else {
            self.far_metres * (cosine + tangent * sine)
        };

        let pixels = |old: u32, grown: f64| {
            let pixels = libm::round(f64::from(old) * grown);
            pixels.clamp(1.0, f64::from(u32::MAX)) as u32
        };
        Self {
            eye_world: self.eye_world + self.camera_from_world.transpose() * eye,
            left,
            right,
            bottom,
            top,
            near_metres: nearest + back - move_metres,
            far_metres: farthest + back + move_metres,
            size_pixels: (
                pixels(self.size_pixels.0, (right - left) / (self.right - self.left)),
                pixels(self.size_pixels.1, (top - bottom) / (self.top - self.bottom)),
            ),
            ..*self
        }
        .checked()
    }
}

/// Tangents of the edges of a range of directions along one axis of the image after a turn, for directions that range over
/// tangents `beside` along the other.
fn turned(along: (f64, f64), beside: (f64, f64), turn_radians: f64) -> Result<(f64, f64), ViewError> {
    // A cap of directions around one that is raised by the tangent t over the other axis spans the azimuths
    // asin(sin(turn) / cos(raise)) to either side; the raise is greatest in the middle.
    let raised = beside.0.abs().max(beside.1.abs());
    let middle = if along.0 <= 0.0 && along.1 >= 0.0 { 0.0 } else { along.0.abs().min(along.1.abs()) };
    let sine = libm::sin(turn_radians.min(std::f64::consts::FRAC_PI_2));
    let azimuth = sine * libm::hypot(1.0, raised / libm::hypot(1.0, middle));
    if azimuth >= 1.0 {
        return Err(ViewError::FieldOfView);
    }
    let (low, high) = (libm::atan(along.0) - libm::asin(azimuth), libm::atan(along.1) + libm::asin(azimuth));
    let widest = libm::atan(WIDEST_TANGENT);
    if low <= -widest || high >= widest {
        return Err(ViewError::FieldOfView);
    }
    Ok((libm::tan(low), libm::tan(high)))
}
