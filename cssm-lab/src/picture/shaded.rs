//! The scene with its shadows, as an engine would show it.

use super::{Picture, srgb_byte};
use crate::scene::Scene;
use crate::truth::Frame;

const SKY_ZENITH: [f64; 3] = [0.22, 0.42, 0.75];
const SKY_HORIZON: [f64; 3] = [0.66, 0.77, 0.88];
const SUNLIGHT: [f64; 3] = [1.25, 1.18, 1.02];
const SKYLIGHT: [f64; 3] = [0.24, 0.28, 0.36];
/// Distance over which air hides all but a share of 1/e of what lies behind it.
const HAZE_METRES: f64 = 2500.0;

/// Lambert's law with the map's visibility, light from the sky, and haze in the distance.
pub fn shaded_picture(scene: &Scene, frame: &Frame, visibility: &[f32]) -> Picture {
    let pixels = frame
        .pixels
        .iter()
        .enumerate()
        .map(|(index, pixel)| {
            let Some(pixel) = pixel else {
                let height = (index / frame.width) as f64 / frame.height as f64;
                return [0, 1, 2]
                    .map(|c| srgb_byte(SKY_ZENITH[c] + (SKY_HORIZON[c] - SKY_ZENITH[c]) * height));
            };
            let colour =
                scene.instances.get(pixel.instance as usize).map_or([0.5; 3], |instance| instance.colour);
            let sun = pixel.cosine.max(0.0) * f64::from(visibility[index]);
            let sky = 0.75 + 0.25 * pixel.normal.y;
            let clear = libm::exp(-pixel.position.length() / HAZE_METRES);
            [0, 1, 2].map(|c| {
                let surface = f64::from(colour[c]) * (SUNLIGHT[c] * sun + SKYLIGHT[c] * sky);
                srgb_byte(SKY_HORIZON[c] + (surface - SKY_HORIZON[c]) * clear)
            })
        })
        .collect();
    Picture { width: frame.width, height: frame.height, pixels }
}
