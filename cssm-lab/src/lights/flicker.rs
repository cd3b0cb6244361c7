//! Flicker under the sun: the same points of still surfaces, asked again in every frame of a camera that creeps. Truth does
//! not change, so whatever flips is the map's doing.

use cssm_core::View;
use cssm_core::glam::{DMat3, DVec3};
use cssm_runtime::lights::LightOptions;
use serde::Serialize;

use super::{Host, Town};
use crate::error::LabError;
use crate::gpu::{Gpu, SceneBuffers, Surface};
use crate::score::LIT_VISIBILITY;
use crate::truth::Frame;

/// Frames of a motion.
const FRAMES: u32 = 12;
const STEP_METRES: f64 = 0.01;
const TURN_DEGREES: f64 = 0.05;

/// How the camera creeps.
const MOTIONS: [&str; 2] = ["1 cm a frame", "0.05 degrees a frame"];

/// Share of points that flip from one frame to the next.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Flicker {
    /// How the service is set.
    pub mode: &'static str,
    /// How the camera moves.
    pub motion: &'static str,
    /// Mean share of the light-facing points that flip in a frame.
    pub flipped: f64,
    /// Frames, of all, in which the sun's tiles were drawn.
    pub drawn_frames: u32,
}

/// Flicker with plans held and not.
///
/// # Errors
/// What the service or the device says.
pub(super) fn flicker(
    gpu: &Gpu,
    town: &Town,
    buffers: &SceneBuffers,
    frame: &Frame,
) -> Result<Vec<Flicker>, LabError> {
    let mut found = Vec::new();
    for (mode, hold) in [("plans held", true), ("planned every frame", false)] {
        for (motion, name) in MOTIONS.into_iter().enumerate() {
            let options = LightOptions { hold, ..LightOptions::default() };
            let mut host = Host::new(gpu, town, buffers, &options)?;
            let (mut flips, mut asked, mut drawn_frames) = (0_u64, 0_u64, 0);
            let mut before: Option<Vec<f32>> = None;
            for number in 0..=FRAMES {
                let view = moved(&town.view, motion, number);
                host.frame(&view, 0)?;
                let sun = host.runner.report().lights.first().map_or(0, |light| light.redrawn_texels);
                drawn_frames += u32::from(number > 0 && sun > 0);
                let surface = Surface::new(gpu, &view, &carried(frame, &town.view, &view))?;
                let now = host.runner.visibility(host.handles[0], &surface)?;
                if let Some(before) = &before {
                    for (index, _) in frame.visible().filter(|(_, seen)| seen.faces_light()) {
                        asked += 1;
                        let lit = |visibility: &[f32]| visibility[index] >= LIT_VISIBILITY;
                        flips += u64::from(lit(before) != lit(&now));
                    }
                }
                before = Some(now);
            }
            let flipped = flips as f64 / asked.max(1) as f64;
            found.push(Flicker { mode, motion: name, flipped, drawn_frames });
        }
    }
    Ok(found)
}

/// The view after so many frames.
fn moved(start: &View, motion: usize, frames: u32) -> View {
    let frames = f64::from(frames);
    let mut view = *start;
    if motion == 0 {
        view.eye_world += view.camera_from_world.transpose() * DVec3::X * (STEP_METRES * frames);
    } else {
        view.camera_from_world =
            DMat3::from_rotation_y((TURN_DEGREES * frames).to_radians()) * view.camera_from_world;
    }
    view
}

/// The same points relative to another eye.
fn carried(frame: &Frame, from: &View, to: &View) -> Frame {
    let shift = from.eye_world - to.eye_world;
    let pixels = frame.pixels.iter().map(|pixel| {
        let mut pixel = (*pixel)?;
        pixel.position += shift;
        pixel.depth = -(to.camera_from_world * pixel.position).z;
        Some(pixel)
    });
    Frame { width: frame.width, height: frame.height, pixels: pixels.collect() }
}
