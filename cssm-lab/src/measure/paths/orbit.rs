//! The light's orbit about a fixed view: the sun over the sky, and on either side of every border between the cases that
//! a technique may tell apart.

use cssm_core::light::LightPosition;
use cssm_core::{Light, View};

use super::courses::{heading, toward_light};
use super::{Station, Stations, ViewPath};
use crate::error::LabError;
use crate::scene::Scene;

/// Elevations and azimuths of the sun; azimuth 0 is ahead, 180 behind.
const ELEVATIONS_DEGREES: [f64; 8] = [5.0, 15.0, 25.0, 35.0, 45.0, 60.0, 75.0, 90.0];
const AZIMUTHS_DEGREES: [f64; 5] = [0.0, 45.0, 90.0, 135.0, 180.0];
/// What unseen suns are shifted by.
const UNSEEN_SHIFT_DEGREES: (f64, f64) = (-3.0, 21.0);
/// Elevations along which borders are looked for.
const BORDER_ELEVATIONS_DEGREES: [f64; 2] = [8.0, 25.0];
/// How far on either side of a border the sun stands; unseen: twice as far.
const BESIDE_DEGREES: f64 = 1.0;
/// Halvings of a degree that find a border.
const HALVINGS: usize = 20;

/// The orbit, and the borders.
pub(super) fn paths(
    scene: &Scene,
    size_pixels: (u32, u32),
    stations: Stations,
) -> Result<Vec<ViewPath>, LabError> {
    let from = scene.views.first().ok_or(LabError::NoView)?;
    let (view, _) = from.pictured(size_pixels)?;
    let ahead = heading(from);
    let station = |elevation: f64, azimuth: f64| -> Result<Station, LabError> {
        let light = Light::directional_travelling(-toward_light(ahead, elevation, azimuth))?;
        Ok(Station { view, light })
    };

    // Let the sun stand all over the sky.
    let (lower, further) = if stations == Stations::Unseen { UNSEEN_SHIFT_DEGREES } else { (0.0, 0.0) };
    let mut orbit = Vec::new();
    for elevation in ELEVATIONS_DEGREES {
        for azimuth in AZIMUTHS_DEGREES {
            orbit.push(station(elevation + lower, azimuth + further)?);
        }
    }

    // Find where the case changes as the sun goes round, and stand on either side.
    let beside = if stations == Stations::Unseen { 2.0 * BESIDE_DEGREES } else { BESIDE_DEGREES };
    let mut borders = Vec::new();
    for elevation in BORDER_ELEVATIONS_DEGREES {
        let position = |azimuth: f64| position(&view, ahead, elevation, azimuth);
        for degree in 0..180 {
            let (mut low, mut high) = (f64::from(degree), f64::from(degree + 1));
            let before = position(low);
            if before == position(high) {
                continue;
            }
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                if position(middle) == before { low = middle } else { high = middle }
            }
            borders.push(station(elevation, low - beside)?);
            borders.push(station(elevation, high + beside)?);
        }
    }
    let path = |name: &str, summary: &str, stations| ViewPath {
        name: name.to_owned(),
        summary: summary.to_owned(),
        stations,
    };
    Ok(vec![
        path("orbit", "the sun all over the sky above a fixed view", orbit),
        path("borders", "the sun a degree on either side of every border between cases", borders),
    ])
}

fn position(
    view: &View,
    ahead: cssm_core::glam::DVec3,
    elevation_degrees: f64,
    azimuth_degrees: f64,
) -> LightPosition {
    let toward = toward_light(ahead, elevation_degrees, azimuth_degrees);
    LightPosition::of(view, (view.camera_from_world * toward).extend(0.0))
}
