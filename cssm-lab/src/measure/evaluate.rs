//! What a case is worth on a path: errors, footprints, use of the map, flicker, and what it costs.
//!
//! A [`Candidate`] is a case made ready once; it is then judged on any path of a [`Bench`]. What cannot be planned is a
//! result, not a failure: [`Evaluation::refusals`] holds the planner's own words.

use cssm_core::case::{Casters, LightKind};
use cssm_core::plan::DepthOrder;
use cssm_core::{LightCase, ShadowPlan};
use serde::{Deserialize, Serialize};

use super::bench::{Bench, Device, TracedPath, TracedStation};
use super::counts::{Counts, FrameCounts, StaticCounts};
use super::tally::Tally;
use crate::error::LabError;
use crate::gpu::{CaseRunner, GpuError, PassTimes, ResolveMethod, Stopwatch, Surface};
use crate::score::LIT_VISIBILITY;
use crate::score::statistics::Percentiles;
use crate::sight::{Outcome, Sight};
use crate::timing::Interval;
use crate::twin::{self, TwinCasters};

/// Timed runs that are not counted.
const WARM_UP_RUNS: usize = 2;
/// Capture and resolve.
const PASSES: u32 = 2;

/// A case on the stations of one path.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Evaluation {
    /// What drew the maps: `gpu` or `twin`.
    pub judge: String,
    /// Stations that could be planned.
    pub stations: usize,
    /// Stations that could not, in the planner's words; equal reasons once.
    pub refusals: Vec<Refusal>,
    /// What was found at the stations that could; absent where none could.
    pub figures: Option<Figures>,
}

/// Why stations have no map.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Refusal {
    /// How many stations.
    pub stations: usize,
    /// The words.
    pub reason: String,
}

/// Everything measured, over all stations of a path.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Figures {
    /// Configurations that the plans took, in order of first use.
    pub configurations: Vec<String>,
    /// Light-facing pixels that were judged.
    pub facing_pixels: u64,
    /// Share of them that is wrong.
    pub mismatch: f64,
    /// Share that is wrongly lit.
    pub leak: f64,
    /// Share that is wrongly shadowed.
    pub acne: f64,
    /// Share that is wrong away from every edge and crease.
    pub interior: f64,
    /// Distance between true edges and the map's, the worse direction: 95 % lie below, screen pixels.
    pub edge_pixels_p95: f64,
    /// The same in local surface footprints.
    pub edge_footprints_p95: f64,
    /// Texel footprint across the light over the visible pixels, screen pixels.
    pub footprint: Percentiles,
    /// Texel footprint on the light-facing surfaces, screen pixels.
    pub surface_footprint: Percentiles,
    /// Share of texels that a visible pixel reads.
    pub scene_utilisation: f64,
    /// Share of texels whose beam meets the visible volume.
    pub beam_utilisation: f64,
    /// Share of points whose shadow flips while the camera steps or turns by less than a texel, the worse of both.
    pub flicker: Option<f64>,
    /// What does not depend on the machine.
    pub counts: Counts,
    /// Times against a reference case, where they were taken.
    pub times: Option<Times>,
}

/// Times of the passes as multiples of a reference case's, measured in turns with it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Times {
    /// The reference case.
    pub reference: String,
    /// How they were taken.
    pub method: String,
    /// Runs that count.
    pub runs: usize,
    /// Rendering casters into the map.
    pub capture: Interval,
    /// From the map to visibility.
    pub resolve: Interval,
    /// Both together.
    pub whole: Interval,
}

/// A case that is ready to be judged.
pub struct Candidate<'b> {
    bench: &'b Bench<'b>,
    /// The case; alpha-tested where the scene has masks, whatever was declared.
    pub case: LightCase,
    constant: StaticCounts,
    runner: Option<CaseRunner>,
    refused: Option<String>,
}

/// One case on one traced path. For several paths, make a [`Candidate`] once.
///
/// # Errors
/// As [`Candidate::new`] and [`Candidate::evaluate`].
pub fn evaluate<'b>(
    bench: &'b Bench<'b>,
    case: &LightCase,
    path: &TracedPath<'_>,
) -> Result<Evaluation, LabError> {
    Candidate::new(bench, case)?.evaluate(path)
}

impl<'b> Candidate<'b> {
    /// Generates the case's shaders and, on a device, its pipelines.
    ///
    /// # Errors
    /// When the generator is at fault or the device is lost. A device that refuses the case is a refusal.
    pub fn new(bench: &'b Bench<'b>, case: &LightCase) -> Result<Self, LabError> {
        let mut case = case.clone();
        if bench.scene.has_masks() {
            case.casters = Casters::AlphaTested;
        }
        let generated = cssm_codegen::generate(&case)?;
        let constant = StaticCounts::of(&case, &generated.table);
        let made = bench.device_for(&case).map(|Device { gpu, buffers }| {
            CaseRunner::new(gpu, &case, &generated.table, bench.scene, buffers, ResolveMethod::of(&case))
        });
        let (runner, refused) = match made.transpose() {
            Ok(runner) => (runner, None),
            Err(error) if is_lost(&error) => return Err(error.into()),
            Err(error) => (None, Some(error.to_string())),
        };
        Ok(Self { bench, case, constant, runner, refused })
    }

    /// Judges the case at every station of a path.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn evaluate(&mut self, path: &TracedPath<'_>) -> Result<Evaluation, LabError> {
        let mut tally = Tally::default();
        for station in &path.stations {
            match self.judge(station) {
                Ok(judged) => tally.add(judged),
                Err(error) => tally.refuse(reason(error)?),
            }
        }
        let judge = if self.bench.device_for(&self.case).is_some() { "gpu" } else { "twin" };
        Ok(tally.evaluation(judge, self.constant))
    }

    /// The verdict on one station with what the map gives every pixel, for pictures; or the words of a refusal.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn pictured(&mut self, station: &TracedStation<'_>) -> Result<Result<Outcome, String>, LabError> {
        match self.judge(station) {
            Ok(judged) => Ok(Ok(judged.outcome)),
            Err(error) => reason(error).map(Err),
        }
    }

    /// Whether the case is for the light of a path.
    pub fn is_for(&self, path: &TracedPath<'_>) -> bool {
        path.stations.iter().all(|station| station.station.light.kind() == self.case.light)
    }

    /// Times the passes at a station in turns with a reference case; nothing where either cannot be planned or no device
    /// draws.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn times(
        &mut self,
        reference: &mut Self,
        station: &TracedStation<'_>,
        runs: usize,
    ) -> Result<Option<Times>, LabError> {
        let (Some(Device { gpu, .. }), Some(surface)) = (self.bench.device_for(&self.case), &station.surface)
        else {
            return Ok(None);
        };
        let name = reference.case.name.clone();
        let sight = &station.sight;
        let (Ok(own), Ok(other)) = (sight.plan(&self.case), sight.plan(&reference.case)) else {
            return Ok(None);
        };
        let (Some(one), Some(two)) = (&mut self.runner, &mut reference.runner) else {
            return Ok(None);
        };
        let (first, second) = (one.prepare(&own, &sight.view)?, two.prepare(&other, &sight.view)?);
        let stopwatch = Stopwatch::new(gpu, PASSES)?;
        let [mut captures, mut resolves, mut wholes] = [const { Vec::new() }; 3];
        for run in 0..WARM_UP_RUNS + runs {
            let times = |passes: PassTimes| [passes.capture_milliseconds, passes.resolve_milliseconds];
            let [capture, resolve] = times(one.time(gpu, &first, surface, &stopwatch)?);
            let [beside_capture, beside_resolve] = times(two.time(gpu, &second, surface, &stopwatch)?);
            if run >= WARM_UP_RUNS {
                captures.push(capture / beside_capture);
                resolves.push(resolve / beside_resolve);
                wholes.push((capture + resolve) / (beside_capture + beside_resolve));
            }
        }
        Ok(Some(Times {
            reference: name,
            method: stopwatch.method().to_owned(),
            runs,
            capture: Interval::of(captures),
            resolve: Interval::of(resolves),
            whole: Interval::of(wholes),
        }))
    }

    /// Judges one station: the frame itself, then the next frames of a slow camera.
    fn judge(&mut self, station: &TracedStation<'_>) -> Result<Judged, LabError> {
        if let Some(reason) = &self.refused {
            return Err(LabError::Gpu(GpuError::Refused { what: "the case", reason: reason.clone() }));
        }
        let plan = station.sight.plan(&self.case)?;
        let shown = self.show(&station.sight, station.surface.as_ref(), &plan, true)?;
        let counts = FrameCounts {
            draws: shown.draws,
            triangles_submitted: shown.triangles,
            texels_written: shown.texels_written,
            ..FrameCounts::of(&plan, &self.bench.boxes)
        };
        let outcome = station.sight.judge(&plan, self.case.filter, shown.visibility);

        // Count the points whose shadow flips in the next frame.
        let mut flicker: Option<f64> = None;
        for next in &station.next {
            let moved = next.sight.plan(&self.case)?;
            let shown = self.show(&next.sight, next.surface.as_ref(), &moved, false)?;
            let share = flips(&outcome.visibility, &shown.visibility, &next.sight);
            flicker = Some(flicker.map_or(share, |worst| worst.max(share)));
        }
        Ok(Judged { plan, outcome, counts, flicker })
    }

    /// Draws a plan's map and asks it about the pixels of a sight.
    fn show(
        &mut self,
        sight: &Sight<'_>,
        surface: Option<&Surface>,
        plan: &ShadowPlan,
        counted: bool,
    ) -> Result<Shown, LabError> {
        let written = |depths: &[f32], order: DepthOrder| {
            depths.iter().filter(|depth| **depth != order.cleared() as f32).count() as u64
        };
        let (Some(Device { gpu, .. }), Some(runner), Some(surface)) =
            (self.bench.device_for(&self.case), &mut self.runner, surface)
        else {
            let casters = TwinCasters::new(self.bench.scene, sight.view.eye_world);
            let found = twin::outcome_of_plan(sight, &casters, &self.case, plan.clone());
            let texels_written = written(&found.depths, plan.depth_order);
            return Ok(Shown {
                visibility: found.outcome.visibility,
                draws: None,
                triangles: None,
                texels_written,
            });
        };
        let prepared = runner.prepare(plan, &sight.view)?;
        let visibility = runner.visibility(gpu, &prepared, surface)?;
        let statistics = prepared.statistics();
        let (draws, triangles) = (Some(u64::from(statistics.draws)), Some(statistics.triangles));
        let texels_written = if counted { written(&runner.map()?, plan.depth_order) } else { 0 };
        Ok(Shown { visibility, draws, triangles, texels_written })
    }
}

/// What one station gave.
pub(super) struct Judged {
    pub(super) plan: ShadowPlan,
    pub(super) outcome: Outcome,
    pub(super) counts: FrameCounts,
    pub(super) flicker: Option<f64>,
}

struct Shown {
    visibility: Vec<f32>,
    draws: Option<u64>,
    triangles: Option<u64>,
    texels_written: u64,
}

/// Share of light-facing points, seen in both frames, whose shadow state differs.
fn flips(before: &[f32], after: &[f32], next: &Sight<'_>) -> f64 {
    let (mut facing, mut flipped) = (0, 0);
    for ((before, after), pixel) in before.iter().zip(after).zip(&next.frame.pixels) {
        if pixel.as_ref().is_some_and(crate::truth::Visible::faces_light) {
            facing += 1;
            flipped += u64::from((*before >= LIT_VISIBILITY) != (*after >= LIT_VISIBILITY));
        }
    }
    crate::score::statistics::share(flipped, facing)
}

/// The words of an error that says a case cannot be; a lost device stays an error.
fn reason(error: LabError) -> Result<String, LabError> {
    match error {
        LabError::Plan(error) => Ok(error.to_string()),
        LabError::Gpu(error) if !is_lost(&error) => Ok(error.to_string()),
        error => Err(error),
    }
}

fn is_lost(error: &GpuError) -> bool {
    matches!(error, GpuError::Service(cssm_runtime::ServiceError::DeviceLost))
}

/// Kinds of light of a list of stations, each once.
pub fn light_kinds(paths: &[super::paths::ViewPath]) -> Vec<LightKind> {
    let mut kinds = Vec::new();
    for station in paths.iter().flat_map(|path| &path.stations) {
        if !kinds.contains(&station.light.kind()) {
            kinds.push(station.light.kind());
        }
    }
    kinds
}
