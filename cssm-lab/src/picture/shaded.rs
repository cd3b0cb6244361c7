//! The scene with its shadows, as an engine would show it.

use cssm_core::Light;

use super::{Picture, srgb_byte};
use crate::scene::Scene;
use crate::score::statistics::quantile;
use crate::truth::Frame;

const SKY_ZENITH: [f64; 3] = [0.22, 0.42, 0.75];
const SKY_HORIZON: [f64; 3] = [0.66, 0.77, 0.88];
const SUNLIGHT: [f64; 3] = [1.25, 1.18, 1.02];
const SKYLIGHT: [f64; 3] = [0.24, 0.28, 0.36];
const LAMPLIGHT: [f64; 3] = [1.6, 1.35, 0.95];
/// Light from the sky by night, as a share of that by day.
const NIGHT: f64 = 0.22;
/// Lamplight falls to a half over this share of the median distance from the lamp.
const HALF_SHARE: f64 = 1.5;
/// Distance over which air hides all but a share of 1/e of what lies behind it.
const HAZE_METRES: f64 = 2500.0;

/// Lambert's law with the map's visibility, light from the sky, and haze in the distance; by night under a lamp.
pub fn shaded_picture(scene: &Scene, frame: &Frame, visibility: &[f32], light: &Light) -> Picture {
    let lamp = light.kind().is_local();
    let (colours, day) = if lamp { (LAMPLIGHT, NIGHT) } else { (SUNLIGHT, 1.0) };
    let half_metres = HALF_SHARE * median_distance(frame);
    let pixels = frame
        .pixels
        .iter()
        .enumerate()
        .map(|(index, pixel)| {
            let Some(pixel) = pixel else {
                let height = (index / frame.width) as f64 / frame.height as f64;
                return [0, 1, 2]
                    .map(|c| srgb_byte(day * (SKY_ZENITH[c] + (SKY_HORIZON[c] - SKY_ZENITH[c]) * height)));
            };
            let colour =
                scene.instances.get(pixel.instance as usize).map_or([0.5; 3], |instance| instance.colour);
            let lit = if pixel.reached { f64::from(visibility[index]) } else { 0.0 };
            let fall = if lamp { half_metres / (half_metres + pixel.light_metres) } else { 1.0 };
            let direct = pixel.cosine.max(0.0) * lit * fall;
            let sky = 0.75 + 0.25 * pixel.normal.y;
            let clear = libm::exp(-pixel.position.length() / HAZE_METRES);
            [0, 1, 2].map(|c| {
                let surface = f64::from(colour[c]) * (colours[c] * direct + day * SKYLIGHT[c] * sky);
                srgb_byte(day * SKY_HORIZON[c] + (surface - day * SKY_HORIZON[c]) * clear)
            })
        })
        .collect();
    Picture { width: frame.width, height: frame.height, pixels }
}

/// Median distance of the visible points from a lamp.
fn median_distance(frame: &Frame) -> f64 {
    let mut distances: Vec<f64> = frame.visible().map(|(_, pixel)| pixel.light_metres).collect();
    distances.sort_by(f64::total_cmp);
    quantile(&distances, 0.5).max(f64::MIN_POSITIVE)
}
