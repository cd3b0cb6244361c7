//! Frames of all contenders in turns.

use cssm_core::LightCase;
use cssm_lab::gpu::{Gpu, SceneBuffers, Stopwatch};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::timing::Interval;

use crate::contender::{Contender, FrameTimes, PASSES, case, time_without_light};
use crate::error::BenchError;
use crate::situation::{Situation, situations};
use crate::view_passes::ViewPasses;

/// How much is measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent<'a> {
    /// Size of the image.
    pub image_pixels: (u32, u32),
    /// Sides of the maps in texels.
    pub map_sides_texels: &'a [u32],
    /// Contenders of each situation, at most.
    pub contenders: usize,
    /// Turns that count.
    pub runs: usize,
    /// Turns that do not count.
    pub warm_up_runs: usize,
    /// Whether progress is shown.
    pub progress: Progress,
}

/// Everything measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// Name, backend and driver of the adapter.
    pub adapter: String,
    /// Whether the adapter is a program that runs on the CPU.
    pub software: bool,
    /// What times are taken by.
    pub method: &'static str,
    /// Turns that count.
    pub runs: usize,
    /// Triangles of the scene.
    pub triangles: usize,
    /// Size of the image.
    pub image_pixels: (u32, u32),
    /// One for each situation.
    pub situations: Vec<SituationTimes>,
}

/// One situation with maps of every size.
#[derive(Debug, Clone, PartialEq)]
pub struct SituationTimes {
    /// In words.
    pub name: &'static str,
    /// One for each size, ascending.
    pub maps: Vec<MapTimes>,
}

/// All contenders with maps of one size.
#[derive(Debug, Clone, PartialEq)]
pub struct MapTimes {
    /// Side in texels.
    pub side_texels: u32,
    /// Frames without light, one for each turn.
    pub without_light: Vec<FrameTimes>,
    /// One for each contender.
    pub contenders: Vec<ContenderTimes>,
}

/// One contender with a map of one size.
#[derive(Debug, Clone, PartialEq)]
pub struct ContenderTimes {
    /// The case's name.
    pub name: &'static str,
    /// Facets of its plan.
    pub facets: usize,
    /// Draw calls.
    pub draws: u32,
    /// Triangles submitted.
    pub triangles: u64,
    /// Frames, one for each turn.
    pub frames: Vec<FrameTimes>,
}

impl MapTimes {
    /// A contender by name.
    pub fn contender(&self, name: &str) -> Option<&ContenderTimes> {
        self.contenders.iter().find(|contender| contender.name == name)
    }

    /// Ratios of two contenders, turn by turn.
    pub fn ratio(&self, name: &str, reference: &str, of: fn(&FrameTimes) -> f64) -> Option<Interval> {
        let (ours, theirs) = (self.contender(name)?, self.contender(reference)?);
        let ratios = ours.frames.iter().zip(&theirs.frames).map(|(ours, theirs)| of(ours) / of(theirs));
        Some(Interval::of(ratios.collect()))
    }

    /// What a contender's light adds to the frame without light of the same turn, as a share of it.
    pub fn increase(&self, name: &str) -> Option<Interval> {
        let frames = &self.contender(name)?.frames;
        let shares =
            frames.iter().zip(&self.without_light).map(|(with, without)| with.shadows() / without.frame);
        Some(Interval::of(shares.collect()))
    }
}

/// Runs everything on a device that was opened for [`opened_for`].
///
/// # Errors
/// What the device, planning or the generator says.
pub fn measure(gpu: &Gpu, scene: &Scene, extent: &Extent<'_>) -> Result<Measurement, BenchError> {
    let stopwatch = Stopwatch::new(gpu, PASSES)?;
    let buffers = SceneBuffers::new(gpu, scene)?;
    let mut measured = Vec::new();
    for situation in situations(scene, extent.image_pixels)? {
        let passes = ViewPasses::new(
            gpu,
            scene,
            &situation.view,
            situation.light.toward_world(situation.view.eye_world),
        )?;
        let maps = extent.map_sides_texels.iter().map(|side| {
            let contenders = situation
                .cases
                .iter()
                .take(extent.contenders)
                .map(|name| Contender::new(gpu, scene, &buffers, &situation, name, *side));
            let contenders = contenders.collect::<Result<Vec<_>, _>>()?;
            take_turns(gpu, &stopwatch, &passes, &contenders, *side, &situation, extent)
        });
        measured.push(SituationTimes { name: situation.name, maps: maps.collect::<Result<_, _>>()? });
    }
    Ok(Measurement {
        adapter: gpu.adapter(),
        software: gpu.is_software(),
        method: stopwatch.method(),
        runs: extent.runs,
        triangles: scene.triangles(),
        image_pixels: extent.image_pixels,
        situations: measured,
    })
}

/// Cases that a device has to serve for an extent.
///
/// # Errors
/// When a size is out of range.
pub fn opened_for(scene: &Scene, extent: &Extent<'_>) -> Result<Vec<LightCase>, BenchError> {
    let mut cases = Vec::new();
    for situation in situations(scene, extent.image_pixels)? {
        for name in situation.cases.iter().take(extent.contenders) {
            for side in extent.map_sides_texels {
                cases.push(case(name, *side)?);
            }
        }
    }
    Ok(cases)
}

/// Runs every contender once in every turn; each turn begins with another one.
fn take_turns(
    gpu: &Gpu,
    stopwatch: &Stopwatch,
    passes: &ViewPasses,
    contenders: &[Contender],
    side_texels: u32,
    situation: &Situation,
    extent: &Extent<'_>,
) -> Result<MapTimes, BenchError> {
    let mut without_light = Vec::with_capacity(extent.runs);
    let mut frames = vec![Vec::with_capacity(extent.runs); contenders.len()];
    let turns = extent.warm_up_runs + extent.runs;
    let doing = format!("{side_texels} x {side_texels}, {}", situation.name);
    let bar = extent.progress.bar(turns as u64, &doing);
    for turn in 0..turns {
        for place in 0..=contenders.len() {
            let index = (turn + place) % (contenders.len() + 1);
            let (times, list) = match contenders.get(index).zip(frames.get_mut(index)) {
                Some((contender, list)) => (contender.time(gpu, passes, stopwatch)?, list),
                None => (time_without_light(gpu, passes, stopwatch)?, &mut without_light),
            };
            if turn >= extent.warm_up_runs {
                list.push(times);
            }
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let contenders = contenders.iter().zip(frames).map(|(contender, frames)| {
        let statistics = contender.statistics();
        ContenderTimes {
            name: contender.name,
            facets: contender.plan.facets.len(),
            draws: statistics.draws,
            triangles: statistics.triangles,
            frames,
        }
    });
    Ok(MapTimes { side_texels, without_light, contenders: contenders.collect() })
}
