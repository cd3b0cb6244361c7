//! View paths: where a scene is looked at from, and under which light, when techniques are compared.
//!
//! A path is a handful of stations. Errors are judged at the stations; flicker is judged between a station and the next
//! frame of a slow camera ([`crate::creep::Creep`]). [`builtin`] derives paths from a scene's own views and its ground;
//! [`unseen`] walks the same paths at other stations, for promises that must hold where nothing was tuned;
//! [`from_file`] reads paths of the user's own.

mod courses;
mod file;
mod land;
mod orbit;

pub use file::{PathFileError, from_file};

use cssm_core::{Light, View};

use crate::error::LabError;
use crate::scene::Scene;
use crate::truth::Tracer;
use land::Land;

/// Stations that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct ViewPath {
    /// Name on the command line and in reports.
    pub name: String,
    /// One sentence: what is special about it.
    pub summary: String,
    /// Its frames.
    pub stations: Vec<Station>,
}

/// One frame: a view and a light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Station {
    /// The view.
    pub view: View,
    /// The light.
    pub light: Light,
}

/// Which stations of a path are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stations {
    /// Those that everything is measured at.
    Seen,
    /// Those halfway between.
    Unseen,
}

impl ViewPath {
    /// The path with at most so many stations, evenly chosen.
    pub fn thinned(mut self, most: usize) -> Self {
        let count = self.stations.len();
        if most > 0 && most < count {
            // Take the middle of each of so many equal parts.
            let middle = |part: usize| (2 * part + 1) * count / (2 * most);
            self.stations = (0..most).map(|part| self.stations[middle(part)]).collect();
        }
        self
    }
}

/// The built-in paths on a scene: walk, drive, flight, dueling, interior, the light's orbit and its borders, a kilometre
/// and an infinite far plane. A path that the scene has no place for is left out.
///
/// # Errors
/// [`LabError::NoView`] when the scene suggests no view, which scenes from files may not.
pub fn builtin(scene: &Scene, tracer: &Tracer, size_pixels: (u32, u32)) -> Result<Vec<ViewPath>, LabError> {
    all(scene, tracer, size_pixels, Stations::Seen)
}

/// The same paths at other stations, which nothing was tuned on.
///
/// # Errors
/// As [`builtin`].
pub fn unseen(scene: &Scene, tracer: &Tracer, size_pixels: (u32, u32)) -> Result<Vec<ViewPath>, LabError> {
    all(scene, tracer, size_pixels, Stations::Unseen)
}

fn all(
    scene: &Scene,
    tracer: &Tracer,
    size_pixels: (u32, u32),
    stations: Stations,
) -> Result<Vec<ViewPath>, LabError> {
    let land = Land::of(scene, tracer, size_pixels)?;
    let mut paths = courses::paths(scene, &land, stations)?;
    paths.extend(orbit::paths(scene, size_pixels, stations)?);
    paths.retain(|path| !path.stations.is_empty());
    Ok(paths)
}

#[cfg(test)]
mod tests;
