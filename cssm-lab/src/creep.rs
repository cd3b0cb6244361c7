//! A camera that creeps by less than a texel a frame, and the same points of still surfaces seen from there: whatever flips
//! is the map's doing.

use cssm_core::View;
use cssm_core::glam::{DMat3, DVec3};

use crate::score::LIT_VISIBILITY;
use crate::truth::Frame;

/// How the camera creeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Creep {
    /// One centimetre a frame, ahead and to the right.
    Step,
    /// A twentieth of a degree a frame to the right, about the camera's own up axis.
    Turn,
}

/// One centimetre a frame, in camera axes.
const STEP_CAMERA_METRES: DVec3 = DVec3::new(0.006, 0.0, -0.008);
const TURN_DEGREES: f64 = 0.05;

impl Creep {
    /// All motions.
    pub const ALL: [Self; 2] = [Self::Step, Self::Turn];

    /// Name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Step => "1 cm a frame",
            Self::Turn => "0.05 degrees a frame",
        }
    }

    /// The view after so many frames.
    pub fn moved(self, view: &View, frames: u32) -> View {
        let frames = f64::from(frames);
        let mut view = *view;
        match self {
            Self::Step => {
                view.eye_world += view.camera_from_world.transpose() * STEP_CAMERA_METRES * frames;
            }
            Self::Turn => {
                let turn = DMat3::from_rotation_y((TURN_DEGREES * frames).to_radians());
                view.camera_from_world = turn * view.camera_from_world;
            }
        }
        view
    }
}

/// A frame's points relative to another eye; those that the other view does not see are left out.
pub fn carried(frame: &Frame, from: &View, to: &View) -> Frame {
    let shift = from.eye_world - to.eye_world;
    let pixels = frame.pixels.iter().map(|pixel| {
        let mut pixel = (*pixel)?;
        pixel.position += shift;
        pixel.depth = to.depth_metres(pixel.position);
        sees(to, pixel.position).then_some(pixel)
    });
    Frame { width: frame.width, height: frame.height, pixels: pixels.collect() }
}

/// Light-facing points that both of two frames see, and how many of them flip.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Flips {
    /// Points that flip.
    pub flipped: u64,
    /// All points.
    pub asked: u64,
}

impl Flips {
    /// Adds what happens between two frames of the same points, each with its visibility.
    pub fn add(&mut self, before: (&Frame, &[f32]), now: (&Frame, &[f32])) {
        let facing = now.0.visible().filter(|(_, seen)| seen.faces_light());
        for (index, _) in facing.filter(|(index, _)| before.0.pixels[*index].is_some()) {
            self.asked += 1;
            let lit = |visibility: &[f32]| visibility[index] >= LIT_VISIBILITY;
            self.flipped += u64::from(lit(before.1) != lit(now.1));
        }
    }

    /// Share of the points that flip.
    pub fn share(&self) -> f64 {
        self.flipped as f64 / self.asked.max(1) as f64
    }
}

/// Whether a point relative to the eye lies within a view.
fn sees(view: &View, point: DVec3) -> bool {
    let camera = view.camera_from_world * point;
    let depth = -camera.z;
    (view.near_metres..=view.far_metres).contains(&depth)
        && (view.left * depth..=view.right * depth).contains(&camera.x)
        && (view.bottom * depth..=view.top * depth).contains(&camera.y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    #[test]
    fn a_creeping_camera_moves_a_centimetre_or_turns_a_twentieth_of_a_degree() {
        let (view, _) = Scene::palm().views[0].pictured((64, 36)).unwrap();
        let step = Creep::Step.moved(&view, 3);
        assert!((step.eye_world.distance(view.eye_world) - 0.03).abs() < 1e-12);
        assert_eq!(step.camera_from_world, view.camera_from_world);
        let turn = Creep::Turn.moved(&view, 1);
        assert_eq!(turn.eye_world, view.eye_world);
        let cosine = turn.camera_from_world.row(2).dot(view.camera_from_world.row(2));
        assert!((libm::acos(cosine).to_degrees() - 0.05).abs() < 1e-6);
        // The camera turns to the right: what was ahead is now to the left.
        assert!((turn.camera_from_world * -view.camera_from_world.row(2)).x < 0.0);
    }
}
