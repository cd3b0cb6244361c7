//! The bench: view paths traced once, on which any number of cases are judged.

use cssm_core::case::Stretch;
use std::collections::{BTreeMap, BTreeSet};

use cssm_core::glam::DVec3;
use cssm_core::{BoundingBox, LightCase, SceneBounds};
use indicatif::ProgressBar;

use super::paths::{Station, ViewPath};
use crate::creep::{Creep, carried};
use crate::error::LabError;
use crate::gpu::{Gpu, SceneBuffers, Surface};
use crate::progress::Progress;
use crate::scene::Scene;
use crate::sight::{Sight, StageOptions};
use crate::truth::Tracer;

/// What draws the maps that are judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum JudgeKind {
    /// The device where there is one; the twin where there is none, and for exact pixel stretching on an adapter that is a
    /// program, which would take minutes to compile each case.
    Auto,
    /// The device, through the generated shaders and the runtime, as an engine does.
    Gpu,
    /// The f64 twin: needs no device, counts no draws.
    Twin,
}

/// What plans are told of the receivers beside the scene's bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub enum Receivers {
    /// Nothing.
    None,
    /// World boxes of the instances that are visible, as an engine knows them from its own culling.
    Boxes,
    /// World boxes around blocks of visible pixels, as an engine knows them that reads its depth back.
    Points,
}

impl JudgeKind {
    /// Whether a device draws a case's maps.
    pub fn draws(self, case: &LightCase, gpu: Option<&Gpu>) -> bool {
        let bent = matches!(case.stretch, Stretch::Exact { .. });
        match self {
            Self::Auto => gpu.is_some_and(|gpu| !(bent && gpu.is_software())),
            Self::Gpu => gpu.is_some(),
            Self::Twin => false,
        }
    }
}

/// A scene with traced view paths.
pub struct Bench<'a> {
    /// The scene.
    pub scene: &'a Scene,
    /// What planning is told of the scene.
    pub bounds: SceneBounds,
    /// The paths.
    pub paths: Vec<TracedPath<'a>>,
    device: Option<Device<'a>>,
    judge: JudgeKind,
    pub(super) boxes: TriangleBoxes,
}

/// A device that holds the scene.
pub(super) struct Device<'a> {
    pub(super) gpu: &'a Gpu,
    pub(super) buffers: SceneBuffers,
}

/// A path whose stations are traced.
pub struct TracedPath<'a> {
    /// Name in reports.
    pub name: String,
    /// What is special about it.
    pub summary: String,
    /// Its frames.
    pub stations: Vec<TracedStation<'a>>,
}

/// A traced frame, with the next frames of a slow camera.
pub struct TracedStation<'a> {
    /// View and light.
    pub station: Station,
    /// The truth.
    pub sight: Sight<'a>,
    pub(super) surface: Option<Surface>,
    pub(super) next: Vec<NextFrame<'a>>,
}

/// The pixels of a frame as the next frame's map must shadow them: the same points, relative to the moved eye. Truth at
/// the same point does not change, so whatever flips is the map's doing.
pub(super) struct NextFrame<'a> {
    pub(super) sight: Sight<'a>,
    pub(super) surface: Option<Surface>,
}

/// World boxes of triangles, grouped by instance.
pub(super) struct TriangleBoxes {
    pub(super) groups: Vec<(BoundingBox, Vec<BoundingBox>)>,
    /// The whole of each instance, by its index.
    instances: BTreeMap<u32, BoundingBox>,
}

/// How the bench is set up.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BenchOptions {
    /// Traces true edges with four times four samples a pixel, for surfaces thinner than a pixel.
    pub supersample: bool,
    /// What draws the maps.
    pub judge: JudgeKind,
    /// What plans are told of the receivers.
    pub receivers: Receivers,
    /// Whether the first station of each path is judged for flicker.
    pub flicker: bool,
    /// Whether progress is shown.
    pub progress: Progress,
}

impl<'a> Bench<'a> {
    /// Traces the paths, and uploads what they see if a device is given.
    ///
    /// # Errors
    /// When the device refuses, or the images are too large for finer edges.
    pub fn new(
        scene: &'a Scene,
        tracer: &Tracer,
        paths: &[ViewPath],
        gpu: Option<&'a Gpu>,
        options: BenchOptions,
    ) -> Result<Self, LabError> {
        let device =
            gpu.map(|gpu| Ok::<_, LabError>(Device { gpu, buffers: SceneBuffers::new(gpu, scene)? }));
        let mut bench = Self {
            scene,
            bounds: SceneBounds::of(scene.bounds_world()),
            paths: Vec::with_capacity(paths.len()),
            device: device.transpose()?,
            judge: options.judge,
            boxes: TriangleBoxes::of(scene),
        };
        let stations: usize = paths.iter().map(|path| path.stations.len()).sum();
        let bar = options.progress.bar(stations as u64, "tracing stations");
        for path in paths {
            let traced = bench.trace(tracer, path, options, &bar)?;
            bench.paths.push(traced);
        }
        bar.finish_and_clear();
        Ok(bench)
    }

    /// The device, for cases whose maps it draws.
    pub(super) fn device_for(&self, case: &LightCase) -> Option<&Device<'a>> {
        self.device.as_ref().filter(|device| self.judge.draws(case, Some(device.gpu)))
    }

    /// The path of a name.
    pub fn path(&self, name: &str) -> Option<&TracedPath<'a>> {
        self.paths.iter().find(|path| path.name == name)
    }

    fn trace(
        &self,
        tracer: &Tracer,
        path: &ViewPath,
        options: BenchOptions,
        bar: &ProgressBar,
    ) -> Result<TracedPath<'a>, LabError> {
        let instances = &self.boxes.instances;
        let hidden = StageOptions { supersample: options.supersample, progress: Progress::Hidden };
        let mut stations = Vec::with_capacity(path.stations.len());
        for (index, station) in path.stations.iter().enumerate() {
            let mut sight = Sight::trace(self.scene, tracer, station.view, station.light, hidden)?;
            sight.visible_world = visible(&sight, instances, options.receivers);
            let creeps: &[Creep] = if options.flicker && index == 0 { &Creep::ALL } else { &[] };
            let next = creeps.iter().map(|creep| {
                let sight = self.next_sight(station, &sight, *creep);
                Ok::<_, LabError>(NextFrame { surface: self.upload(&sight)?, sight })
            });
            let next = next.collect::<Result<_, _>>()?;
            stations.push(TracedStation { station: *station, surface: self.upload(&sight)?, sight, next });
            bar.inc(1);
        }
        Ok(TracedPath { name: path.name.clone(), summary: path.summary.clone(), stations })
    }

    fn upload(&self, sight: &Sight<'_>) -> Result<Option<Surface>, LabError> {
        let surface = |device: &Device<'_>| Surface::new(device.gpu, &sight.view, &sight.frame);
        Ok(self.device.as_ref().map(surface).transpose()?)
    }

    fn next_sight(&self, station: &Station, sight: &Sight<'_>, creep: Creep) -> Sight<'a> {
        let view = creep.moved(&station.view, 1);
        let frame = carried(&sight.frame, &station.view, &view);
        let visible_world = sight.visible_world.clone();
        Sight { visible_world, ..Sight::of_frame(self.scene, view, station.light, frame) }
    }
}

/// World boxes that hold everything visible.
fn visible(
    sight: &Sight<'_>,
    instances: &BTreeMap<u32, BoundingBox>,
    receivers: Receivers,
) -> Vec<BoundingBox> {
    match receivers {
        Receivers::None => Vec::new(),
        Receivers::Points => sight.visible_world.clone(),
        Receivers::Boxes => {
            let seen: BTreeSet<u32> = sight.frame.visible().map(|(_, pixel)| pixel.instance).collect();
            seen.iter().filter_map(|instance| instances.get(instance).copied()).collect()
        }
    }
}

fn union(one: BoundingBox, two: &BoundingBox) -> BoundingBox {
    BoundingBox { min: one.min.min(two.min), max: one.max.max(two.max) }
}

impl TriangleBoxes {
    fn of(scene: &Scene) -> Self {
        let mut instances = BTreeMap::new();
        let groups = scene.instances.iter().enumerate().filter_map(|(index, instance)| {
            let mesh = &scene.meshes[instance.mesh];
            let corner = |index: u32| {
                let object = DVec3::from_array(mesh.positions[index as usize].map(f64::from));
                instance.world_from_object.transform_point3(object)
            };
            let boxes: Vec<BoundingBox> = mesh
                .indices
                .chunks_exact(3)
                .map(|corners| {
                    let [one, two, three] = [corners[0], corners[1], corners[2]].map(corner);
                    BoundingBox { min: one.min(two).min(three), max: one.max(two).max(three) }
                })
                .collect();
            let around = boxes.iter().skip(1).fold(*boxes.first()?, union);
            instances.insert(index as u32, around);
            Some((around, boxes))
        });
        let groups = groups.collect();
        Self { groups, instances }
    }
}
