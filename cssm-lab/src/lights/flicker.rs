//! Flicker under the sun: the same points of still surfaces, asked again in every frame of a camera that creeps. Truth does
//! not change, so whatever flips is the map's doing.

use cssm_runtime::lights::LightOptions;
use serde::Serialize;

use super::{Host, Town};
use crate::creep::{Creep, Flips, carried};
use crate::error::LabError;
use crate::gpu::{Gpu, SceneBuffers, Surface};
use crate::truth::Frame;

/// Frames of a motion.
const FRAMES: u32 = 12;

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
        for creep in Creep::ALL {
            let options = LightOptions { hold, ..LightOptions::default() };
            let mut host = Host::new(gpu, town, buffers, &options)?;
            let (mut flips, mut drawn_frames) = (Flips::default(), 0);
            let mut before: Option<(Frame, Vec<f32>)> = None;
            for number in 0..=FRAMES {
                let view = creep.moved(&town.view, number);
                host.frame(&view, 0)?;
                let sun = host.runner.report().lights.first().map_or(0, |light| light.redrawn_texels);
                drawn_frames += u32::from(number > 0 && sun > 0);
                let points = carried(frame, &town.view, &view);
                let surface = Surface::new(gpu, &view, &points)?;
                let now = host.runner.visibility(host.handles[0], &surface)?;
                if let Some((earlier, shown)) = &before {
                    flips.add((earlier, shown), (&points, &now));
                }
                before = Some((points, now));
            }
            let flipped = flips.share();
            found.push(Flicker { mode, motion: creep.name(), flipped, drawn_frames });
        }
    }
    Ok(found)
}
