//! What only measuring can have wrong.

use std::path::PathBuf;

/// Why a measurement cannot be made or written.
#[derive(Debug, thiserror::Error)]
pub enum MeasureError {
    /// A technique's own list of variants is at fault.
    #[error("variant `{label}` does not declare a case; report it\n{report}")]
    Variant {
        /// The variant.
        label: String,
        /// What the declaration's parser said.
        report: String,
    },
    /// No technique has that name.
    #[error("there is no technique `{name}`; give `all`, `variants`, a .cssm file, or names out of {}", known.join(", "))]
    NoSuchTechnique {
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<&'static str>,
    },
    /// Nothing is left to measure.
    #[error("no case is made for the lights of the view paths; give cases for {}", lights.join(", "))]
    NothingToMeasure {
        /// Kinds of the paths' lights.
        lights: Vec<&'static str>,
    },
    /// An earlier result cannot be read.
    #[error("{} is no result of an earlier measurement: {source}; move it away or give another --json", path.display())]
    Earlier {
        /// The file.
        path: PathBuf,
        /// What the parser said.
        source: serde_json::Error,
    },
    /// An earlier result cannot be opened.
    #[error("cannot read {}: {source}; check the path", path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The plot cannot be drawn.
    #[error("cannot draw the plot: {reason}; give a larger --plot or report it")]
    Plot {
        /// What the library said.
        reason: String,
    },
}
