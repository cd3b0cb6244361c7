//! Times on the device at hand: variants in turns with the customary standard map.

use std::path::Path;

use cssm_core::LightCase;
use cssm_core::case::{Filter, Stretch};
use shaders_gen::shipped;

use super::error::TuneError;
use super::predict::Prediction;
use super::search::{expected, sized};
use super::space::label;
use crate::case_file::pick_case;
use crate::error::LabError;
use crate::gpu::{Gpu, ResolveMethod};
use crate::measure::paths::ViewPath;
use crate::progress::Progress;
use crate::scene::Scene;
use crate::stage::{Attempt, Stage, StageOptions};
use crate::timing::time_in_turns;
use crate::truth::Tracer;

/// Timed runs that count.
const RUNS: usize = 15;
/// Variants that run, each at several sides.
const RUNNERS: usize = 12;
/// Sides that each runs at, in quarters of the largest.
const QUARTERS: [u32; 4] = [1, 2, 3, 4];

/// The track: a device and the first station of each path.
pub struct Track<'a> {
    scene: &'a Scene,
    tracer: &'a Tracer,
    paths: &'a [ViewPath],
    gpu: Gpu,
    standard: LightCase,
    progress: Progress,
}

impl<'a> Track<'a> {
    /// Opens a device that can hold maps of a side.
    ///
    /// # Errors
    /// When there is no device or it is too small.
    pub fn new(
        scene: &'a Scene,
        tracer: &'a Tracer,
        paths: &'a [ViewPath],
        largest: &LightCase,
        progress: Progress,
    ) -> Result<Self, LabError> {
        let standard = pick_case(Path::new("standard.cssm"), shipped::STANDARD, None)?;
        let stations = || paths.iter().flat_map(|path| path.stations.first());
        let pixels = stations().map(|station| station.view.size_pixels);
        let size = pixels.fold((1, 1), |(one, two), (x, y)| (x.max(one), y.max(two)));
        let gpu = Gpu::open(&[largest, &standard], size)?;
        Ok(Self { scene, tracer, paths, gpu, standard, progress })
    }

    /// The device.
    pub fn adapter(&self) -> String {
        self.gpu.adapter()
    }

    /// Capture and resolve of each case as multiples of the standard map's, the largest of the paths; `None` where the
    /// device refuses a case.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn ratios(&self, cases: &[LightCase]) -> Result<Vec<Option<f64>>, LabError> {
        let mut ratios = vec![Some(0.0_f64); cases.len()];
        for station in self.paths.iter().flat_map(|path| path.stations.first()) {
            let options = StageOptions { supersample: false, progress: Progress::Hidden };
            let (view, light) = (station.view, station.light);
            let stage = Stage::new(&self.gpu, self.scene, self.tracer, view, light, options)?;

            // Line up what can run.
            let mut attempts = vec![stage.attempt(&self.standard, ResolveMethod::Function)?];
            let mut lanes = Vec::new();
            for (index, case) in cases.iter().enumerate() {
                match stage.attempt(case, ResolveMethod::of(case)) {
                    Ok(attempt) => {
                        attempts.push(attempt);
                        lanes.push(index);
                    }
                    Err(_) => ratios[index] = None,
                }
            }
            let times = self.milliseconds(&attempts)?;
            let (standard, others) = (times[0], &times[1..]);
            for (index, time) in lanes.into_iter().zip(others) {
                ratios[index] = ratios[index].map(|worst| worst.max(time / standard));
            }
        }
        Ok(ratios)
    }

    /// Median time of both passes together.
    fn milliseconds(&self, attempts: &[Attempt<'_>]) -> Result<Vec<f64>, LabError> {
        let times = time_in_turns(attempts, RUNS, self.progress)?;
        Ok(times.iter().map(|time| time.capture.median + time.resolve.median).collect())
    }

    /// Variants at sides that keep within a ratio, with what is expected of them there.
    ///
    /// # Errors
    /// [`TuneError::NoVariant`] when all take longer; whatever the device says.
    pub fn within(
        &self,
        predictions: &[Prediction],
        ratio: f64,
        most_side: u32,
    ) -> Result<Vec<Prediction>, LabError> {
        let runners: Vec<Prediction> = teams(predictions)
            .into_iter()
            .flat_map(|prediction| {
                QUARTERS
                    .map(|quarters| at_side(prediction, (most_side / 4 * quarters).max(super::LEAST_SIDE)))
            })
            .collect();
        let cases: Vec<LightCase> = runners.iter().map(|runner| runner.case.clone()).collect();
        let ratios = self.ratios(&cases)?;
        let within = |index: usize| ratios[index].is_some_and(|taken| taken <= ratio);
        let fastest = ratios.iter().zip(&cases).filter_map(|(taken, case)| Some(((*taken)?, case)));
        let fastest = fastest.min_by(|(one, _), (two, _)| one.total_cmp(two));
        let kept = (0..runners.len()).filter(|index| within(*index)).map(|index| &runners[index]);

        // Team mates work alike: what one of them has time for, so have the others.
        let mut mates: Vec<Prediction> = Vec::new();
        for runner in kept {
            let alike = predictions.iter().filter(|mate| team(&mate.case) == team(&runner.case));
            mates.extend(alike.map(|mate| at_side(mate, runner.case.map.width)));
        }
        match fastest {
            Some((taken, case)) if mates.is_empty() => Err(TuneError::NoVariant {
                wanted: format!("{ratio} times the time of the customary standard map"),
                tried: predictions.len(),
                best: format!("{} at {} x {}", label(case), case.map.width, case.map.height),
                value: format!("{taken:.3} times that time"),
                by: format!("{:.3}", taken - ratio),
                best_value: taken,
            }
            .into()),
            None => {
                let reason = "the device refuses every variant".to_owned();
                Err(TuneError::NothingPlanned { tried: predictions.len(), reason }.into())
            }
            Some(_) => Ok(mates),
        }
    }
}

/// What decides how long a frame takes, but for the size: technique with its configurations, facets, stretching.
fn team(case: &LightCase) -> (&'static str, Vec<&'static str>, u32, bool) {
    let configurations = case.configurations.iter().map(|word| word.name).collect();
    (case.technique.name, configurations, case.shape().cells(), case.stretch != Stretch::None)
}

/// The best of each team with the filter that takes longest, the best teams only.
fn teams(predictions: &[Prediction]) -> Vec<&Prediction> {
    let mut order: Vec<&Prediction> =
        predictions.iter().filter(|prediction| prediction.case.filter == Filter::Gather2x2).collect();
    order.sort_by(|one, two| one.error.total_cmp(&two.error));
    let mut best: Vec<&Prediction> = Vec::new();
    for prediction in order {
        if best.len() < RUNNERS && best.iter().all(|known| team(&known.case) != team(&prediction.case)) {
            best.push(prediction);
        }
    }
    best
}

fn at_side(prediction: &Prediction, side: u32) -> Prediction {
    let case = sized(&prediction.case, side);
    let (error, cost) = (expected(prediction, side), prediction.cost.with_map(&case.map));
    Prediction { case, error, cost }
}
