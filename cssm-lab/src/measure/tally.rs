//! Stations of a path, put together into one evaluation.

use cssm_core::footprint;

use super::counts::{Counts, FrameCounts, StaticCounts};
use super::evaluate::{Evaluation, Figures, Judged, Refusal};
use crate::score::Score;
use crate::score::statistics::Percentiles;

/// Significant digits that results keep: finer ones mean nothing and make files large.
const DIGITS: i32 = 5;

/// What was found so far.
#[derive(Default)]
pub(super) struct Tally {
    stations: usize,
    refusals: Vec<Refusal>,
    configurations: Vec<String>,
    scores: Vec<Score>,
    footprints: Vec<f64>,
    surface_footprints: Vec<f64>,
    scene_utilisation: f64,
    beam_utilisation: f64,
    flicker: Vec<f64>,
    counts: Vec<FrameCounts>,
}

impl Tally {
    /// Adds a station.
    pub(super) fn add(&mut self, judged: Judged) {
        let Judged { plan, outcome, counts, flicker } = judged;
        self.stations += 1;
        if !self.configurations.iter().any(|known| known == plan.configuration) {
            self.configurations.push(plan.configuration.to_owned());
        }
        let found = &outcome.assignment.footprints;
        self.footprints.extend(found.iter().flatten().map(|footprint| footprint.volume_pixels));
        let pixels = found.iter().zip(&outcome.verdicts);
        self.surface_footprints.extend(pixels.filter_map(|(footprint, verdict)| {
            verdict.as_ref().filter(|verdict| verdict.facing)?;
            Some(footprint.as_ref()?.surface_pixels)
        }));
        self.scene_utilisation += outcome.assignment.scene_utilisation;
        self.beam_utilisation += footprint::beam_utilisation(&plan);
        self.flicker.extend(flicker);
        self.counts.push(counts);
        self.scores.push(outcome.score);
    }

    /// Adds a station without a map.
    pub(super) fn refuse(&mut self, reason: String) {
        match self.refusals.iter_mut().find(|known| known.reason == reason) {
            Some(known) => known.stations += 1,
            None => self.refusals.push(Refusal { stations: 1, reason }),
        }
    }

    /// The whole path.
    pub(super) fn evaluation(self, judge: &str, constant: StaticCounts) -> Evaluation {
        let Self { stations, ref refusals, .. } = self;
        let refusals = refusals.clone();
        let figures = (stations > 0).then(|| self.figures(constant));
        Evaluation { judge: judge.to_owned(), stations, refusals, figures }
    }

    fn figures(self, constant: StaticCounts) -> Figures {
        let stations = self.stations as f64;
        let facing: u64 = self.scores.iter().map(|score| score.facing_pixels).sum();
        let pooled = |share: fn(&Score) -> f64| {
            let wrong: f64 = self.scores.iter().map(|score| share(score) * score.facing_pixels as f64).sum();
            rounded(wrong / (facing.max(1)) as f64)
        };
        let edges = |p95: fn(&Percentiles) -> f64, footprints: bool| {
            let (mut sum, mut count) = (0.0, 0);
            for score in &self.scores {
                let both = [&score.edge_displacement.map_to_true, &score.edge_displacement.true_to_map];
                let set = |index: usize| {
                    p95(if footprints { &both[index].footprints } else { &both[index].pixels })
                };
                sum += set(0).max(set(1)) * both[1].count as f64;
                count += both[1].count;
            }
            rounded(sum / count.max(1) as f64)
        };
        let flicker = self.flicker.iter().copied().reduce(f64::max).map(rounded);
        Figures {
            configurations: self.configurations,
            facing_pixels: facing,
            mismatch: pooled(|score| score.mismatch),
            leak: pooled(|score| score.leak.total),
            acne: pooled(|score| score.acne.total),
            interior: pooled(|score| score.leak.interior + score.acne.interior),
            edge_pixels_p95: edges(|found| found.p95, false),
            edge_footprints_p95: edges(|found| found.p95, true),
            footprint: percentiles(self.footprints),
            surface_footprint: percentiles(self.surface_footprints),
            scene_utilisation: rounded(self.scene_utilisation / stations),
            beam_utilisation: rounded(self.beam_utilisation / stations),
            flicker,
            counts: Counts::of(constant, &self.counts),
            times: None,
        }
    }
}

fn percentiles(values: Vec<f64>) -> Percentiles {
    let Percentiles { median, p95, p99, max } = Percentiles::of(values);
    Percentiles { median: rounded(median), p95: rounded(p95), p99: rounded(p99), max: rounded(max) }
}

/// A number with as many digits as mean something.
fn rounded(value: f64) -> f64 {
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let digits = DIGITS - 1 - libm::floor(libm::log10(value.abs())) as i32;
    let scale = libm::pow(10.0, f64::from(digits.abs()));
    if digits >= 0 { (value * scale).round() / scale } else { (value / scale).round() * scale }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_five_digits() {
        assert_eq!(rounded(0.012_345_678), 0.012_346);
        assert_eq!(rounded(-1_234_567.0), -1_234_600.0);
        assert_eq!(rounded(0.0), 0.0);
        assert!(rounded(f64::INFINITY).is_infinite());
        assert_eq!(rounded(2.0 / 3.0).to_string(), "0.66667");
    }

    #[test]
    fn equal_refusals_are_counted_once() {
        let mut tally = Tally::default();
        ["too small", "unbounded", "too small"].iter().for_each(|reason| tally.refuse((*reason).to_owned()));
        let stations: Vec<usize> = tally.refusals.iter().map(|refusal| refusal.stations).collect();
        assert_eq!(stations, [2, 1]);
    }
}
