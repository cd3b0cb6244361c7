//! Percentiles, shares, slopes.

use cssm_core::footprint;
use serde::{Deserialize, Serialize};

/// Median and upper percentiles of a set of numbers; all zero for an empty set.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Percentiles {
    /// Half lie below.
    pub median: f64,
    /// 95 % lie below.
    pub p95: f64,
    /// 99 % lie below.
    pub p99: f64,
    /// The largest.
    pub max: f64,
}

impl Percentiles {
    /// Percentiles of numbers in any order.
    pub fn of(mut values: Vec<f64>) -> Self {
        values.sort_by(f64::total_cmp);
        Self {
            median: quantile(&values, 0.5),
            p95: quantile(&values, 0.95),
            p99: quantile(&values, 0.99),
            max: quantile(&values, 1.0),
        }
    }
}

/// Quantile of ascending numbers, between neighbours by linear interpolation; 0 of an empty slice.
pub fn quantile(ascending: &[f64], share: f64) -> f64 {
    if ascending.is_empty() { 0.0 } else { footprint::quantile(ascending, share) }
}

/// `count / total`; 0 of nothing.
pub fn share(count: u64, total: u64) -> f64 {
    if total == 0 { 0.0 } else { count as f64 / total as f64 }
}

/// Least-squares slope of y over x; `None` for fewer than two different x.
pub fn slope(points: &[(f64, f64)]) -> Option<f64> {
    let count = points.len() as f64;
    let mean = |pick: fn(&(f64, f64)) -> f64| points.iter().map(pick).sum::<f64>() / count;
    let (x_mean, y_mean) = (mean(|point| point.0), mean(|point| point.1));
    let spread: f64 = points.iter().map(|(x, _)| (x - x_mean) * (x - x_mean)).sum();
    let common: f64 = points.iter().map(|(x, y)| (x - x_mean) * (y - y_mean)).sum();
    (spread > 0.0).then(|| common / spread)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_interpolate() {
        let percentiles = Percentiles::of((0..=100).rev().map(f64::from).collect());
        assert_eq!(percentiles, Percentiles { median: 50.0, p95: 95.0, p99: 99.0, max: 100.0 });
        assert_eq!(quantile(&[1.0, 2.0], 0.25), 1.25);
        assert_eq!(Percentiles::of(Vec::new()), Percentiles::default());
    }

    #[test]
    fn slopes_are_least_squares() {
        assert_eq!(slope(&[(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)]), Some(2.0));
        assert_eq!(slope(&[(1.0, 1.0), (1.0, 3.0)]), None);
        assert_eq!(slope(&[]), None);
    }
}
