//! View paths from a file.
//!
//! ```json
//! { "paths": [ { "name": "gate", "stations": [
//!   { "eye": [8, 1.7, 9], "target": [0, 1, 0], "near": 0.1, "far": "infinite", "light": "directional:-1,-1,0" },
//!   { "eye": [8, 1.7, 9], "yaw_degrees": 30, "pitch_degrees": -5, "fov_degrees": 75, "far": 2000,
//!     "light": "spot:0,5,0:0,-1,0:30" } ] } ] }
//! ```
//!
//! Yaw 0 looks along -z and grows to the right; pitch grows upwards. Lights are written as on the command line.

use std::path::{Path, PathBuf};

use cssm_core::View;
use cssm_core::glam::DVec3;
use serde::Deserialize;

use super::{Station, ViewPath};
use crate::arguments::parse_light;

/// What a file of paths may have wrong.
#[derive(Debug, thiserror::Error)]
pub enum PathFileError {
    /// It cannot be read.
    #[error("cannot read the view paths in {}: {source}; check the path, or give --views builtin", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// It is not JSON of the expected form.
    #[error("{} holds no view paths: {source}; write {{ \"paths\": [ {{ \"name\": .., \"stations\": [ .. ] }} ] }}", path.display())]
    Form {
        /// The file.
        path: PathBuf,
        /// What the parser said, with line and column.
        source: serde_json::Error,
    },
    /// It has no station.
    #[error("{} holds no station; give every path at least one", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// Two paths have one name.
    #[error("{} names two paths `{name}`; give each a name of its own", path.display())]
    SameName {
        /// The file.
        path: PathBuf,
        /// The name.
        name: String,
    },
    /// A station makes no sense.
    #[error("{}: station {index} of path `{name}`: {reason}", path.display())]
    Station {
        /// The file.
        path: PathBuf,
        /// The path's name.
        name: String,
        /// The station, from 0.
        index: usize,
        /// What is wrong and what to write instead.
        reason: String,
    },
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PathFile {
    paths: Vec<PathEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PathEntry {
    name: String,
    #[serde(default)]
    summary: String,
    stations: Vec<StationEntry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StationEntry {
    eye: [f64; 3],
    target: Option<[f64; 3]>,
    yaw_degrees: Option<f64>,
    pitch_degrees: Option<f64>,
    #[serde(default = "up")]
    up: [f64; 3],
    #[serde(default = "fov_degrees")]
    fov_degrees: f64,
    #[serde(default = "near")]
    near: f64,
    #[serde(default)]
    far: Far,
    light: String,
}

#[derive(Deserialize, Default)]
#[serde(untagged)]
enum Far {
    Metres(f64),
    Word(FarWord),
    #[default]
    Absent,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum FarWord {
    Infinite,
}

const fn up() -> [f64; 3] {
    [0.0, 1.0, 0.0]
}

const fn fov_degrees() -> f64 {
    60.0
}

const fn near() -> f64 {
    0.2
}

/// The paths of a file.
///
/// # Errors
/// A [`PathFileError`] that names the entry at fault and what to write instead.
pub fn from_file(path: &Path, size_pixels: (u32, u32)) -> Result<Vec<ViewPath>, PathFileError> {
    let text = std::fs::read_to_string(path)
        .map_err(|source| PathFileError::Read { path: path.to_owned(), source })?;
    let file: PathFile = serde_json::from_str(&text)
        .map_err(|source| PathFileError::Form { path: path.to_owned(), source })?;
    let mut paths: Vec<ViewPath> = Vec::with_capacity(file.paths.len());
    for entry in file.paths {
        if paths.iter().any(|known| known.name == entry.name) {
            return Err(PathFileError::SameName { path: path.to_owned(), name: entry.name });
        }
        if entry.stations.is_empty() {
            return Err(PathFileError::Empty { path: path.to_owned() });
        }
        let fault = |index: usize, reason: String| PathFileError::Station {
            path: path.to_owned(),
            name: entry.name.clone(),
            index,
            reason,
        };
        let stations = entry
            .stations
            .iter()
            .enumerate()
            .map(|(index, station)| station.station(size_pixels).map_err(|reason| fault(index, reason)));
        let stations = stations.collect::<Result<_, _>>()?;
        paths.push(ViewPath { name: entry.name.clone(), summary: entry.summary, stations });
    }
    if paths.is_empty() {
        return Err(PathFileError::Empty { path: path.to_owned() });
    }
    Ok(paths)
}

impl StationEntry {
    fn station(&self, size_pixels: (u32, u32)) -> Result<Station, String> {
        let eye = DVec3::from(self.eye);
        let target = match (self.target, self.yaw_degrees, self.pitch_degrees) {
            (Some(target), None, None) => DVec3::from(target),
            (None, Some(yaw), pitch) => {
                let (sin_yaw, cos_yaw) = libm::sincos(yaw.to_radians());
                let (sin_pitch, cos_pitch) = libm::sincos(pitch.unwrap_or(0.0).to_radians());
                eye + DVec3::new(sin_yaw * cos_pitch, sin_pitch, -cos_yaw * cos_pitch)
            }
            _ => {
                return Err("say where it looks: give `target`, or `yaw_degrees` with or without \
                            `pitch_degrees`"
                    .to_owned());
            }
        };
        let far = match self.far {
            Far::Metres(metres) => metres,
            Far::Word(FarWord::Infinite) | Far::Absent => f64::INFINITY,
        };
        let (up, fov) = (DVec3::from(self.up), self.fov_degrees.to_radians());
        let view = View::perspective(eye, target, up, fov, self.near, far, size_pixels)
            .map_err(|error| error.to_string())?;
        Ok(Station { view, light: parse_light(&self.light)? })
    }
}
