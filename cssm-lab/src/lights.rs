//! `cssm-lab lights`: a hundred lights in a town through one map: what frames cost, and whether each light is as good as
//! alone.

mod flicker;
mod judge;
mod motion;
mod overlay;
mod plant;
mod table;

use std::path::PathBuf;
use std::time::Instant;

use cssm_core::{LightCase, SceneBounds, View};
use cssm_runtime::CasterInstance;
use cssm_runtime::lights::{CaseHandle, LightDescription, LightFrame, LightHandle, LightOptions};
use serde::Serialize;
use shaders_gen::shipped;

pub use flicker::Flicker;
pub use judge::{Bench, Judgement};
pub use motion::{MOTIONS, Motion};
pub use plant::{PlantedLight, cars, driven, lights, scene_at};

use crate::arguments::parse_image_size;
use crate::case_file::{pick_case, with_map_size};
use crate::error::LabError;
use crate::gpu::{Gpu, LightRunner, SceneBuffers, Surface};
use crate::progress::Progress;
use crate::report::{create_folder, write_json};
use crate::scene::Scene;
use crate::truth::{Frame, Tracer};

/// The declarations that serve the lights, by kind.
const CASES: [(&str, &str, &str); 3] = [
    ("sun.cssm", "Sun", shipped::SUN),
    ("spot.cssm", "Spot", shipped::SPOT),
    ("lamp.cssm", "Lamp", shipped::LAMP),
];
/// Weight of the sun's errors: it lights more pixels than any lamp.
const SUN_PRIORITY: f64 = 4.0;
/// Largest square of a lamp.
const LAMP_SIDE_TEXELS: u32 = 1024;
/// Frames of a motion that are not counted.
pub const WARM_UP_FRAMES: u32 = 4;
/// Which of the scene's viewpoints is used: a street.
const VIEWPOINT: usize = 1;

/// A hundred lights in one map.
#[derive(Debug, clap::Args)]
pub struct LightsArguments {
    /// Folder for the tables and pictures
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Size of the image in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "1280x720")]
    size: (u32, u32),
    /// Side of the map in texels
    #[arg(long, value_name = "TEXELS", default_value_t = 4096)]
    map: u32,
    /// How many of the lights are judged, evenly picked
    #[arg(long, default_value_t = 100)]
    judged: usize,
    /// Frames of each motion
    #[arg(long, default_value_t = 24)]
    frames: u32,
}

/// Everything that was found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LightsReport {
    /// The scene.
    pub scene: String,
    /// Width of the image in pixels.
    pub width: u32,
    /// Height of the image in pixels.
    pub height: u32,
    /// Side of the map in texels.
    pub map_side: u32,
    /// Texels that belong to some light.
    pub owned_texels: u64,
    /// The adapter.
    pub adapter: String,
    /// One entry for each motion.
    pub costs: Vec<MotionCosts>,
    /// One entry for each mode and motion.
    pub flicker: Vec<Flicker>,
    /// One entry for each judged light.
    pub judgements: Vec<Judgement>,
}

/// Means over the frames of a motion.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct MotionCosts {
    /// The motion.
    pub name: &'static str,
    /// Texels drawn or restored in the shared map.
    pub redrawn_texels: f64,
    /// Texels drawn in the map of static casters.
    pub static_texels: f64,
    /// Triangles submitted.
    pub triangles: f64,
    /// Draw calls.
    pub draws: f64,
    /// Lights that were planned.
    pub planned: f64,
    /// Lights whose changes waited.
    pub waiting: f64,
    /// Time of preparing on the CPU.
    pub prepare_milliseconds: f64,
}

/// Runs the command; returns the tables as Markdown.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &LightsArguments, progress: Progress) -> Result<String, LabError> {
    create_folder(&arguments.out)?;
    let scene = Scene::city();
    let town = Town::new(&scene, arguments.size, arguments.map)?;
    let gpu = Gpu::open(&town.cases.iter().collect::<Vec<_>>(), arguments.size)?;
    let spinner = progress.spinner("building the town");
    let tracer = Tracer::new(&scene);
    let buffers = SceneBuffers::new(&gpu, &scene)?;
    spinner.finish_and_clear();

    // Judge the first frame, then move.
    let mut host = Host::new(&gpu, &town, &buffers, &LightOptions::default())?;
    let view = town.view;
    host.frame(&view, 0)?;
    let frame = Frame::trace(&tracer, &view, &town.lights[0].light, &|_| ());
    let surface = Surface::new(&gpu, &view, &frame)?;
    let owned_texels = host.runner.report().owned_texels;
    let bench = Bench {
        gpu: &gpu,
        scene: &scene,
        tracer: &tracer,
        buffers: &buffers,
        frame: &frame,
        view,
        surface: &surface,
    };
    let judgements = host.judge(&bench, arguments.judged, progress)?;
    overlay::write(&arguments.out, &host, &bench)?;
    let costs = MOTIONS
        .iter()
        .map(|motion| {
            let mut host = Host::new(&gpu, &town, &buffers, &LightOptions::default())?;
            host.costs(motion, arguments.frames)
        })
        .collect::<Result<Vec<_>, LabError>>()?;
    overlay::write_strip(&arguments.out, &gpu, &town, &buffers, &tracer)?;

    let flicker = flicker::flicker(&gpu, &town, &buffers, &frame)?;
    let report = LightsReport {
        scene: scene.name.clone(),
        width: arguments.size.0,
        height: arguments.size.1,
        map_side: arguments.map,
        owned_texels,
        adapter: gpu.adapter(),
        costs,
        flicker,
        judgements,
    };
    write_json(&arguments.out.join("lights.json"), &report)?;
    let text = table::markdown(&report);
    let path = arguments.out.join("lights.md");
    std::fs::write(&path, &text).map_err(|source| LabError::Write { path, source })?;
    Ok(text)
}

/// The scene with its lights, its cars and a view.
pub struct Town<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// The declarations, in the order of [`CaseHandle`]s.
    pub cases: Vec<LightCase>,
    /// The lights, the sun first.
    pub lights: Vec<PlantedLight>,
    /// Instances that drive.
    pub cars: Vec<usize>,
    /// Where the camera starts.
    pub view: View,
}

impl<'s> Town<'s> {
    /// The lights of a scene with lamp posts, around its street view.
    ///
    /// # Errors
    /// A scene without the viewpoint or with too few lamp posts.
    pub fn new(scene: &'s Scene, size: (u32, u32), map_side: u32) -> Result<Self, LabError> {
        let cases = CASES
            .iter()
            .map(|(file, name, text)| {
                with_map_size(pick_case(std::path::Path::new(file), text, Some(name))?, (map_side, map_side))
            })
            .collect::<Result<Vec<_>, LabError>>()?;
        let spot = scene.views.get(VIEWPOINT).ok_or(LabError::NoView)?;
        let (view, sun) = spot.pictured(size)?;
        let lights = plant::lights(scene, &view, sun)?;
        Ok(Self { scene, cases, lights, cars: plant::cars(scene, &view), view })
    }

    /// The case that serves a light.
    pub fn case(&self, light: usize) -> CaseHandle {
        let kind = self.lights[light].light.kind();
        let serves = self.cases.iter().position(|case| case.light == kind);
        CaseHandle(serves.unwrap_or(0) as u32)
    }
}

/// A service that runs a town's lights.
pub struct Host<'a> {
    town: &'a Town<'a>,
    /// The service.
    pub runner: LightRunner<'a>,
    casters: Vec<CasterInstance>,
    /// One for each light.
    pub handles: Vec<LightHandle>,
}

impl<'a> Host<'a> {
    /// A service with all lights and casters.
    ///
    /// # Errors
    /// Whatever the generator, the service or the device says.
    pub fn new(
        gpu: &'a Gpu,
        town: &'a Town<'a>,
        buffers: &SceneBuffers,
        options: &LightOptions,
    ) -> Result<Self, LabError> {
        let generated = town.cases.iter().map(cssm_codegen::generate).collect::<Result<Vec<_>, _>>()?;
        let tables: Vec<_> = town.cases.iter().zip(generated.iter().map(|one| &one.table)).collect();
        let mut runner = LightRunner::new(gpu, &tables, options)?;
        let casters = buffers.add_by(&mut |description| runner.service.add_mesh(description), town.scene)?;
        let mut handles = Vec::with_capacity(town.lights.len());
        for (index, planted) in town.lights.iter().enumerate() {
            let usual = LightDescription::new(town.case(index), planted.light);
            let added = runner.service.add_light(&match index {
                0 => LightDescription { priority: SUN_PRIORITY, ..usual },
                _ => LightDescription { max_side_texels: LAMP_SIDE_TEXELS, ..usual },
            });
            handles.push(added.map_err(crate::gpu::GpuError::from)?);
        }
        Ok(Self { town, runner, casters, handles })
    }

    /// Prepares and draws a frame in which the cars have driven for so many frames. Returns how many milliseconds
    /// preparing took.
    ///
    /// # Errors
    /// What the service says.
    pub fn frame(&mut self, view: &View, car_frames: u32) -> Result<f64, LabError> {
        let cars = &self.town.cars;
        let is_car = |index: &usize| cars.binary_search(index).is_ok();
        let still: Vec<_> =
            (0..self.casters.len()).filter(|index| !is_car(index)).map(|index| self.casters[index]).collect();
        let moving: Vec<_> = cars
            .iter()
            .map(|car| CasterInstance {
                world_from_object: driven(&self.town.scene.instances[*car], car_frames).world_from_object,
                ..self.casters[*car]
            })
            .collect();
        let start = Instant::now();
        self.runner.prepare(&LightFrame {
            bounds: SceneBounds::of(self.town.scene.bounds_world()),
            ..LightFrame::new(view, &still, &moving)
        })?;
        let milliseconds = start.elapsed().as_secs_f64() * 1e3;
        self.runner.draw()?;
        Ok(milliseconds)
    }

    /// Judges lights of the last frame, evenly picked, the sun among them.
    ///
    /// # Errors
    /// What the service or the device says.
    pub fn judge(&self, bench: &Bench, count: usize, progress: Progress) -> Result<Vec<Judgement>, LabError> {
        let lights = self.handles.len();
        let count = count.clamp(1, lights);
        let bar = progress.bar(count as u64, "judging lights");
        let mut found = Vec::with_capacity(count);
        for pick in 0..count {
            let index = pick * lights / count;
            let planted = &self.town.lights[index];
            let case = &self.town.cases[self.town.case(index).0 as usize];
            found.push(bench.judge(&self.runner, self.handles[index], &planted.name, case, planted.light)?);
            bar.inc(1);
        }
        bar.finish_and_clear();
        Ok(found)
    }

    /// Runs a motion and takes means.
    ///
    /// # Errors
    /// What the service says.
    pub fn costs(&mut self, motion: &Motion, frames: u32) -> Result<MotionCosts, LabError> {
        let mut costs = MotionCosts { name: motion.name, ..MotionCosts::default() };
        let counted = f64::from(frames.saturating_sub(WARM_UP_FRAMES).max(1));
        for number in 0..frames.max(WARM_UP_FRAMES + 1) {
            let view = motion.view(&self.town.view, number);
            let milliseconds = self.frame(&view, if motion.cars_drive { number } else { 0 })?;
            if number < WARM_UP_FRAMES {
                continue;
            }
            let report = self.runner.report();
            costs.redrawn_texels += report.redrawn_texels as f64 / counted;
            costs.static_texels += report.static_texels as f64 / counted;
            costs.triangles += report.triangles as f64 / counted;
            costs.draws += f64::from(report.draws) / counted;
            costs.planned += f64::from(report.planned) / counted;
            costs.waiting += f64::from(report.waiting) / counted;
            costs.prepare_milliseconds += milliseconds / counted;
        }
        Ok(costs)
    }
}
