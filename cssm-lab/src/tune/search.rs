//! The second stage: the promising variants by ray-cast truth, cheapest first, until the budget holds.

use cssm_core::LightCase;

use super::bench::{Bench, Errors, Measured};
use super::budget::{Metric, Promise};
use super::error::TuneError;
use super::features::sides;
use super::predict::Prediction;
use super::space::label;
use crate::progress::Progress;

/// Variants that are measured at most before the best of them is taken; more only while none holds.
const MOST_MEASURED: usize = 32;
const MOST_MEASURED_IN_VAIN: usize = 64;
/// Predictions are trusted this far: a variant that is expected to be so many times worse is not measured.
const TRUST: f64 = 2.0;
/// Variants that are measured in full when none holds, to say how far the best one is off.
const MISSED: usize = 3;

/// A variant that was measured, or judged by its prediction.
#[derive(Debug, Clone, PartialEq)]
pub struct Contender {
    /// Name of its technique.
    pub technique: &'static str,
    /// What it is.
    pub label: String,
    /// Side of its map.
    pub side: u32,
    /// Bytes that move in a frame.
    pub bytes: f64,
    /// Its error, or a lower bound of it, or what is expected.
    pub error: f64,
    /// How that is known.
    pub known: Known,
}

/// How much is known of a contender.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Known {
    /// It was measured and keeps the limit.
    Keeps,
    /// It was measured in full and does not.
    Misses,
    /// It was measured until it missed.
    MissesBy,
    /// It was planned.
    Predicted,
}

/// What the search found.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The variant.
    pub case: LightCase,
    /// What it has.
    pub errors: Errors,
    /// The promise that it was chosen by.
    pub promise: Promise,
    /// The best of each technique.
    pub contenders: Vec<Contender>,
}

/// Contenders and how predictions fared.
#[derive(Default)]
struct Notes {
    contenders: Vec<Contender>,
    /// Sum of the logarithms of measured over predicted error, and their number.
    drift: (f64, usize),
}

impl Notes {
    fn note(&mut self, case: &LightCase, prediction: &Prediction, measured: &Measured, keeps: bool) {
        let side = case.map.width;
        let cost = prediction.cost.with_map(&case.map);
        if let Measured::Whole(errors) = measured {
            let ratio = errors.error / expected(prediction, side);
            if ratio > 0.0 && ratio.is_finite() {
                self.drift = (self.drift.0 + libm::log(ratio), self.drift.1 + 1);
            }
        }
        let Some(error) = measured.error() else { return };
        let known = match measured {
            Measured::Whole(_) if keeps => Known::Keeps,
            Measured::Whole(_) => Known::Misses,
            _ => Known::MissesBy,
        };
        let (technique, label) = (case.technique.name, label(case));
        self.contenders.push(Contender { technique, label, side, bytes: cost.bytes(), error, known });
    }

    /// How many times larger errors are than expected, so far.
    fn drift(&self) -> f64 {
        if self.drift.1 == 0 { 1.0 } else { libm::exp(self.drift.0 / self.drift.1 as f64) }
    }
}

/// Footprints, and errors with them, fall as the side grows.
pub fn expected(prediction: &Prediction, side: u32) -> f64 {
    prediction.error * f64::from(prediction.case.map.width) / f64::from(side)
}

/// The case with a square map of a side.
pub fn sized(case: &LightCase, side: u32) -> LightCase {
    let mut sized = case.clone();
    (sized.map.width, sized.map.height) = (side, side);
    sized
}

/// The variant that moves the fewest bytes and keeps the limit, with maps of at most `most_side`.
///
/// # Errors
/// [`TuneError::NoVariant`] with the best there is.
pub fn cheapest(
    bench: &mut Bench<'_, '_>,
    predictions: &[Prediction],
    promise: Promise,
    most_side: u32,
    progress: Progress,
) -> Result<Found, TuneError> {
    // Order the variants by what they are expected to cost where they are expected to hold.
    let sides: Vec<u32> = sides().filter(|side| *side <= most_side).collect();
    let largest = sides.last().copied().unwrap_or(most_side);
    let side_for = |prediction: &Prediction, drift: f64| {
        let holds = |side: &&u32| expected(prediction, **side) * drift <= promise.limit;
        sides.iter().find(holds).copied()
    };
    let bytes = |prediction: &Prediction| {
        let side = side_for(prediction, 1.0).unwrap_or(largest);
        let excess = (expected(prediction, side) / promise.limit).max(1.0);
        prediction.cost.with_map(&sized(&prediction.case, side).map).bytes() * excess * excess
    };
    let mut order: Vec<&Prediction> = predictions.iter().collect();
    order.sort_by(|one, two| bytes(one).total_cmp(&bytes(two)));

    // Measure each where it would be cheaper than the best so far.
    let mut notes = Notes::default();
    let mut best: Option<(LightCase, Errors)> = None;
    let mut tried = 0;
    let bar = progress.bar(MOST_MEASURED as u64, "ray casting the promising");
    for prediction in &order {
        let most = if best.is_some() { MOST_MEASURED } else { MOST_MEASURED_IN_VAIN };
        bar.set_length(most as u64);
        if tried >= most {
            break;
        }
        let cheaper = |side: &&u32| {
            let cost = prediction.cost.with_map(&sized(&prediction.case, **side).map);
            best.as_ref().is_none_or(|(_, errors)| cost.bytes() < errors.cost.bytes())
        };
        let Some(cap) = sides.iter().rev().find(cheaper).copied() else { continue };
        let hopeless = expected(prediction, cap) * notes.drift() > TRUST * promise.limit;
        if hopeless && (best.is_some() || tried > 0) {
            continue;
        }
        let start = side_for(prediction, notes.drift()).unwrap_or(cap).min(cap);
        if let Some(found) = smallest(bench, prediction, &promise, (start, cap), &mut notes) {
            best = Some(found);
        }
        tried += 1;
        bar.inc(1);
    }
    bar.finish_and_clear();
    let Some((case, errors)) = best else {
        return Err(missed(bench, &order, promise, largest, predictions.len()));
    };
    let contenders = best_of_each(notes.contenders, predictions, |prediction| {
        side_for(prediction, 1.0).unwrap_or(largest)
    });
    Ok(Found { case, errors, promise, contenders })
}

/// The smallest map of a variant that keeps the promise, between a first guess and a cap.
fn smallest(
    bench: &mut Bench<'_, '_>,
    prediction: &Prediction,
    promise: &Promise,
    (start, cap): (u32, u32),
    notes: &mut Notes,
) -> Option<(LightCase, Errors)> {
    let sides: Vec<u32> = sides().filter(|side| *side <= cap).collect();
    let mut index = sides.iter().position(|side| *side >= start)?;
    let mut best: Option<(usize, LightCase, Errors)> = None;
    loop {
        let case = sized(&prediction.case, sides[index]);
        let measured = bench.measure(&case, Some(promise));
        let keeps = measured.keeps(promise);
        notes.note(&case, prediction, &measured, keeps);
        let error = measured.error()?;

        // Aim where the error found says that the limit is met, but move by a step at least.
        let aim = f64::from(sides[index]) * error / promise.limit;
        let aimed = sides.iter().position(|side| f64::from(*side) >= aim).unwrap_or(sides.len() - 1);
        match measured {
            Measured::Whole(errors) if keeps => {
                best = Some((index, case, errors));
                if index == 0 {
                    break;
                }
                index = aimed.min(index - 1);
            }
            _ => {
                let ceiling = best.as_ref().map_or(sides.len(), |(index, ..)| *index);
                index = aimed.max(index + 1);
                if index >= ceiling {
                    break;
                }
            }
        }
        if best.as_ref().is_some_and(|(known, ..)| index > *known) {
            break;
        }
    }
    best.map(|(_, case, errors)| (case, errors))
}

/// The variant with the smallest error, all maps being as large as they may be.
///
/// # Errors
/// [`TuneError::NothingPlanned`] when nothing could be measured.
pub fn finest(
    bench: &mut Bench<'_, '_>,
    predictions: &[Prediction],
    margin: f64,
    progress: Progress,
) -> Result<Found, TuneError> {
    let mut order: Vec<&Prediction> = predictions.iter().collect();
    order.sort_by(|one, two| {
        one.error.total_cmp(&two.error).then(one.cost.bytes().total_cmp(&two.cost.bytes()))
    });
    let mut notes = Notes::default();
    let mut best: Option<(LightCase, Errors)> = None;
    let mut reason = "nothing was tried".to_owned();
    let bar = progress.bar(MOST_MEASURED as u64, "ray casting the promising");
    for prediction in order.iter().take(MOST_MEASURED) {
        let hopeless = |errors: &Errors| prediction.error * notes.drift() > TRUST * errors.error;
        if best.as_ref().is_some_and(|(_, errors)| hopeless(errors)) {
            break;
        }
        let limit = best.as_ref().map_or(f64::INFINITY, |(_, errors)| errors.error);
        let better = Promise::of(bench.metric, limit);
        let measured = bench.measure(&prediction.case, Some(&better));
        let keeps = measured.keeps(&better);
        notes.note(&prediction.case, prediction, &measured, keeps);
        match measured {
            Measured::Whole(errors) if keeps => best = Some((prediction.case.clone(), errors)),
            Measured::Unplannable { reason: said } => reason = said,
            _ => {}
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    let tried = predictions.len();
    let (case, errors) = best.ok_or(TuneError::NothingPlanned { tried, reason })?;
    let promise = Promise::of(bench.metric, errors.error * (1.0 + margin));
    for contender in &mut notes.contenders {
        // Those that were the best for a while are not any more.
        if contender.known == Known::Keeps && contender.error > errors.error {
            contender.known = Known::Misses;
        }
    }
    let contenders = best_of_each(notes.contenders, predictions, |prediction| prediction.case.map.width);
    Ok(Found { case, errors, promise, contenders })
}

/// For each technique what came nearest, in the order of bytes; by prediction where nothing of it was measured.
fn best_of_each(
    measured: Vec<Contender>,
    predictions: &[Prediction],
    side: impl Fn(&Prediction) -> u32,
) -> Vec<Contender> {
    let predicted = predictions.iter().map(|prediction| {
        let side = side(prediction);
        Contender {
            technique: prediction.case.technique.name,
            label: label(&prediction.case),
            side,
            bytes: prediction.cost.with_map(&sized(&prediction.case, side).map).bytes(),
            error: expected(prediction, side),
            known: Known::Predicted,
        }
    });
    let mut best: Vec<Contender> = Vec::new();
    for contender in measured.into_iter().chain(predicted) {
        let rank = |one: &Contender| (one.known, one.bytes, one.error);
        match best.iter_mut().find(|known| known.technique == contender.technique) {
            None => best.push(contender),
            Some(known) => {
                let (old, new) = (rank(known), rank(&contender));
                // Among those that keep the limit bytes count, among the others the error.
                let better = match (new.0, old.0) {
                    (Known::Keeps, Known::Keeps) => new.1 < old.1,
                    (one, two) if one == two => new.2 < old.2,
                    (one, two) => one < two,
                };
                if better {
                    *known = contender;
                }
            }
        }
    }
    best.sort_by(|one, two| one.known.cmp(&two.known).then(one.bytes.total_cmp(&two.bytes)));
    best
}

/// The error that says how far the best variant is off.
fn missed(
    bench: &mut Bench<'_, '_>,
    order: &[&Prediction],
    promise: Promise,
    side: u32,
    tried: usize,
) -> TuneError {
    let mut closest: Vec<&Prediction> = order.to_vec();
    closest.sort_by(|one, two| one.error.total_cmp(&two.error));
    let mut best: Option<(String, f64)> = None;
    let mut reason = "no variant is left".to_owned();
    for prediction in closest.into_iter().take(MISSED) {
        let case = sized(&prediction.case, side);
        match bench.measure(&case, None) {
            Measured::Whole(errors) if best.as_ref().is_none_or(|(_, least)| errors.error < *least) => {
                best = Some((format!("{} at {side} x {side}", label(&case)), errors.error));
            }
            Measured::Unplannable { reason: said } => reason = said,
            _ => {}
        }
    }
    let text = |error: f64| promise.metric.text(error);
    match best {
        None => TuneError::NothingPlanned { tried, reason },
        Some((best, value)) => TuneError::NoVariant {
            wanted: wanted(promise.metric, promise.limit),
            tried,
            best,
            value: text(value),
            by: text(value - promise.limit),
            best_value: value,
        },
    }
}

fn wanted(metric: Metric, limit: f64) -> String {
    format!("a {} of at most {} in every view, the margin taken off", metric.name(), metric.text(limit))
}
