//! Times of several cases, measured in turns so that whatever disturbs one disturbs all.

use serde::{Deserialize, Serialize};

use crate::error::LabError;
use crate::gpu::{PassTimes, Stopwatch};
use crate::progress::Progress;
use crate::score::statistics::quantile;
use crate::stage::Attempt;

/// Runs that are not counted.
const WARM_UP_RUNS: usize = 2;

/// Capture and resolve.
const PASSES: u32 = 2;

/// Shares of the runs that end the reported interval.
const INTERVAL: (f64, f64) = (0.1, 0.9);

/// Times of one case.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Timing {
    /// How they were taken.
    pub method: &'static str,
    /// Runs that count.
    pub runs: usize,
    /// Rendering casters into the map, milliseconds.
    pub capture: Interval,
    /// From the map to visibility, milliseconds.
    pub resolve: Interval,
}

/// Median of the runs, and what four fifths of them lie in.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// Half the runs were faster.
    pub median: f64,
    /// A tenth of the runs were faster.
    pub low: f64,
    /// A tenth of the runs were slower.
    pub high: f64,
}

impl Interval {
    /// Interval of numbers in any order.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        Self {
            median: quantile(&values, 0.5),
            low: quantile(&values, INTERVAL.0),
            high: quantile(&values, INTERVAL.1),
        }
    }
}

impl std::fmt::Display for Interval {
    fn fmt(&self, out: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(out, "{:.2} [{:.2}, {:.2}]", self.median, self.low, self.high)
    }
}

/// Times each of the attempts `runs` times, in turns.
///
/// # Errors
/// What the device says.
pub fn time_in_turns(
    attempts: &[Attempt<'_>],
    runs: usize,
    progress: Progress,
) -> Result<Vec<Timing>, LabError> {
    let Some(first) = attempts.first() else {
        return Ok(Vec::new());
    };
    let stopwatch = Stopwatch::new(first.stage().gpu(), PASSES)?;
    let mut times: Vec<Vec<PassTimes>> = vec![Vec::with_capacity(runs); attempts.len()];
    let bar = progress.bar(((WARM_UP_RUNS + runs) * attempts.len()) as u64, "timing passes");
    for run in 0..WARM_UP_RUNS + runs {
        for (attempt, times) in attempts.iter().zip(&mut times) {
            let time = attempt.time(&stopwatch)?;
            if run >= WARM_UP_RUNS {
                times.push(time);
            }
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    Ok(times
        .into_iter()
        .map(|times| Timing {
            method: stopwatch.method(),
            runs,
            capture: Interval::of(times.iter().map(|time| time.capture_milliseconds).collect()),
            resolve: Interval::of(times.iter().map(|time| time.resolve_milliseconds).collect()),
        })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn intervals_hold_four_fifths() {
        let interval = Interval::of((0..=20).rev().map(f64::from).collect());
        assert_eq!((interval.median, interval.low, interval.high), (10.0, 2.0, 18.0));
        assert_eq!(interval.to_string(), "10.00 [2.00, 18.00]");
    }
}
