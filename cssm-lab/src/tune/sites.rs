//! Where variants are judged: the stations of the view paths, traced once.

use cssm_core::case::LightKind;
use cssm_core::glam::DVec3;

use super::error::TuneError;
use crate::error::LabError;
use crate::measure::paths::ViewPath;
use crate::progress::Progress;
use crate::scene::Scene;
use crate::sight::{Sight, StageOptions};
use crate::truth::{Frame, Tracer};
use crate::twin::TwinCasters;

/// A view with fewer light-facing pixels than this part of its image is judged as if it had so many: a share of few pixels
/// is chance.
const LEAST_PART_OF_IMAGE: u64 = 10;
/// Pixels of each kind that a prediction looks at in each frame.
const SAMPLES: usize = 256;

/// Everything that is measured on.
pub struct Sites<'a> {
    /// The paths, in order.
    pub paths: Vec<Path>,
    /// Every station of every path.
    pub sites: Vec<Site<'a>>,
    /// Casters relative to each eye.
    eyes: Vec<(DVec3, TwinCasters<'a>)>,
    /// Whether any caster has holes.
    pub has_masks: bool,
}

/// A path and what its stations have together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Path {
    /// Its name.
    pub name: String,
    /// Number of its stations.
    pub stations: usize,
    /// Light-facing pixels of all its stations.
    pub facing_pixels: u64,
}

/// One traced station.
pub struct Site<'a> {
    /// Index of its path.
    pub path: usize,
    /// View, light and truth.
    pub sight: Sight<'a>,
    /// Light-facing pixels.
    pub facing_pixels: u64,
    /// Light-facing pixels on true shadow edges.
    pub edge_pixels: usize,
    /// Some of them.
    pub edges: Vec<usize>,
    /// Some of the visible pixels.
    pub visible: Vec<usize>,
    eye: usize,
}

impl<'a> Sites<'a> {
    /// Traces the stations of paths.
    ///
    /// # Errors
    /// When a view is too large, or when no pixel of a path faces the light.
    pub fn trace(
        scene: &'a Scene,
        tracer: &Tracer,
        paths: &[ViewPath],
        progress: Progress,
    ) -> Result<Self, LabError> {
        let mut all =
            Self { paths: Vec::new(), sites: Vec::new(), eyes: Vec::new(), has_masks: scene.has_masks() };
        let count: usize = paths.iter().map(|path| path.stations.len()).sum();
        let bar = progress.bar(count as u64, "tracing stations");
        for (index, path) in paths.iter().enumerate() {
            let mut facing_pixels = 0;
            for station in &path.stations {
                let options = StageOptions { supersample: false, progress: Progress::Hidden };
                let sight = Sight::trace(scene, tracer, station.view, station.light, options)?;
                let eye = all.eye(scene, station.view.eye_world);
                let site = Site::new(index, sight, eye);
                facing_pixels += site.facing_pixels;
                all.sites.push(site);
                bar.inc(1);
            }
            if facing_pixels == 0 {
                return Err(TuneError::NothingFaces { path: path.name.clone() }.into());
            }
            let stations = path.stations.len();
            all.paths.push(Path { name: path.name.clone(), stations, facing_pixels });
        }
        bar.finish_and_clear();
        Ok(all)
    }

    /// The kind of light that all stations have.
    ///
    /// # Errors
    /// [`TuneError::SeveralLights`] when they differ.
    pub fn light(&self) -> Result<LightKind, TuneError> {
        let mut kinds: Vec<LightKind> = Vec::new();
        for site in &self.sites {
            if !kinds.contains(&site.sight.light.kind()) {
                kinds.push(site.sight.light.kind());
            }
        }
        match kinds[..] {
            [kind] => Ok(kind),
            _ => Err(TuneError::SeveralLights { kinds: kinds.into_iter().map(LightKind::name).collect() }),
        }
    }

    /// Whether every view has a finite far plane.
    pub fn are_finite(&self) -> bool {
        self.sites.iter().all(|site| site.sight.view.far_metres.is_finite())
    }

    /// Casters relative to a site's eye.
    pub fn casters(&self, site: &Site<'a>) -> &TwinCasters<'a> {
        &self.eyes[site.eye].1
    }

    /// Index of an eye, whose casters are made if it is new.
    fn eye(&mut self, scene: &'a Scene, eye_world: DVec3) -> usize {
        let known = self.eyes.iter().position(|(known, _)| *known == eye_world);
        known.unwrap_or_else(|| {
            self.eyes.push((eye_world, TwinCasters::new(scene, eye_world)));
            self.eyes.len() - 1
        })
    }
}

impl<'a> Site<'a> {
    fn new(path: usize, sight: Sight<'a>, eye: usize) -> Self {
        let edges: Vec<usize> = edge_pixels(&sight.frame).collect();
        let visible: Vec<usize> = sight.frame.visible().map(|(index, _)| index).collect();
        Self {
            path,
            facing_pixels: facing(&sight.frame).count() as u64,
            edge_pixels: edges.len(),
            edges: spread(&edges),
            visible: spread(&visible),
            sight,
            eye,
        }
    }

    /// Pixels that errors of the view are shares of.
    pub fn judged_pixels(&self) -> u64 {
        self.facing_pixels.max(self.sight.frame.pixels.len() as u64 / LEAST_PART_OF_IMAGE).max(1)
    }
}

/// Light-facing pixels with their index.
pub fn facing(frame: &Frame) -> impl Iterator<Item = (usize, &crate::truth::Visible)> {
    frame.visible().filter(|(_, pixel)| pixel.faces_light())
}

/// Light-facing pixels whose right or lower neighbour, on a light-facing surface too, is lit otherwise.
fn edge_pixels(frame: &Frame) -> impl Iterator<Item = usize> {
    facing(frame).filter_map(|(index, pixel)| {
        let (x, y) = (index % frame.width, index / frame.width);
        let differs = |x: usize, y: usize| {
            let inside = x < frame.width && y < frame.height;
            let other = if inside { frame.at(x, y) } else { None };
            other.is_some_and(|other| other.faces_light() && other.lit != pixel.lit)
        };
        (differs(x + 1, y) || differs(x, y + 1)).then_some(index)
    })
}

/// At most [`SAMPLES`] of a list, evenly spread.
fn spread(all: &[usize]) -> Vec<usize> {
    let count = all.len().min(SAMPLES);
    (0..count).map(|index| all[index * all.len() / count]).collect()
}
