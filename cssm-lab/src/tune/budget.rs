//! What is asked for: a limit on the error, the time or the size, and which error counts.

use std::fmt;

/// What may not be exceeded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Budget {
    /// The error, in the metric's unit; the cheapest variant is wanted.
    Error(f64),
    /// Capture and resolve together, as a multiple of what the customary standard map takes; the smallest error is
    /// wanted.
    Time(f64),
    /// Texels of the map; the smallest error is wanted.
    Texels(u64),
}

/// Which error counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
#[value(rename_all = "snake_case")]
pub enum Metric {
    /// Share of the light-facing pixels whose shadow is wrong, all pixels of a path together.
    Mismatch,
    /// Distance between true shadow edges and the map's, the worse direction: 95th percentile in pixels, mean over the
    /// stations of a path by their edge pixels.
    EdgePx,
    /// Footprint of a texel across the light in pixels: 95th percentile over all visible pixels of a path.
    FootprintP95,
}

impl Metric {
    /// Name on the command line and in reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mismatch => "mismatch",
            Self::EdgePx => "edge_px",
            Self::FootprintP95 => "footprint_p95",
        }
    }

    /// An error with its unit.
    pub fn text(self, error: f64) -> String {
        match self {
            Self::Mismatch => percent(error),
            Self::EdgePx | Self::FootprintP95 => format!("{error:.3} px"),
        }
    }
}

/// A share with four significant digits, as shares of wrong pixels are small.
fn percent(share: f64) -> String {
    format!("{:.4} %", 100.0 * share)
}

/// What the chosen declaration promises, and what it is tuned to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Promise {
    /// Which error counts.
    pub metric: Metric,
    /// What is promised of every path, all its views together, as `cssm-lab measure` reports it.
    pub promised: f64,
    /// Largest error of any single view that it was tuned on: views that were not tuned on are not quite the same.
    pub limit: f64,
    /// Largest mismatch of any single view besides; infinite where nothing is said of it.
    pub mismatch_limit: f64,
}

impl Promise {
    /// Of paths and single views alike.
    pub const fn of(metric: Metric, limit: f64) -> Self {
        Self { metric, promised: limit, limit, mismatch_limit: f64::INFINITY }
    }
}

impl fmt::Display for Budget {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Error(error) => write!(out, "an error of at most {error}"),
            Self::Time(ratio) => write!(out, "at most {ratio} times the customary standard map's time"),
            Self::Texels(texels) => write!(out, "at most {texels} texels"),
        }
    }
}

/// A positive number, or a percentage such as `0.5%`.
///
/// # Errors
/// What to write instead.
pub fn parse_error_limit(text: &str) -> Result<f64, String> {
    let (number, unit) = match text.trim().strip_suffix('%') {
        Some(number) => (number, 0.01),
        None => (text, 1.0),
    };
    match number.trim().parse::<f64>() {
        Ok(limit) if limit > 0.0 && limit.is_finite() => Ok(limit * unit),
        _ => Err("write a positive number, or a percentage such as 0.5%".to_owned()),
    }
}

/// A positive number.
///
/// # Errors
/// What to write instead.
pub fn parse_ratio(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(ratio) if ratio > 0.0 && ratio.is_finite() => Ok(ratio),
        _ => Err("write a positive multiple of the standard map's time, such as 1.2".to_owned()),
    }
}

/// A share from 0 up to, but without, 1.
///
/// # Errors
/// What to write instead.
pub fn parse_margin(text: &str) -> Result<f64, String> {
    match text.trim().parse::<f64>() {
        Ok(margin) if (0.0..1.0).contains(&margin) => Ok(margin),
        _ => Err("write a share of the budget from 0 to below 1, such as 0.1".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_are_shares_or_percentages() {
        assert_eq!(parse_error_limit("0.5%"), Ok(0.005));
        assert_eq!(parse_error_limit("2"), Ok(2.0));
        for wrong in ["-1", "0", "inf", "much", "%"] {
            assert!(parse_error_limit(wrong).is_err(), "{wrong}");
        }
        assert!(parse_ratio("0").is_err() && parse_ratio("1.5").is_ok());
        assert!(parse_margin("1").is_err() && parse_margin("0").is_ok());
    }
}
