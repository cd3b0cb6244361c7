//! `cssm-lab figures`: the figures of the papers, with the house's techniques.

pub mod canvas;
pub mod cases;
pub mod density;
pub mod flicker;
pub mod focus_area;
pub mod map_grid;
pub mod plates;
pub mod wind;

use std::fmt::Write as _;
use std::path::PathBuf;

use plotters::coord::CoordTranslate;
use plotters::prelude::*;

use self::canvas::{PAPER, paint};
use crate::error::LabError;
use crate::picture::Picture;
use crate::progress::Progress;
use crate::report_files::{create_folder, write_json};

/// Draws the figures of the papers: focus regions, split schemes, trapezoidal problems, equal-focus plates, flicker.
#[derive(Debug, clap::Args)]
pub struct FiguresArguments {
    /// Folder for the figures
    #[arg(long, value_name = "DIR", default_value = "docs/figures")]
    out: PathBuf,
    /// Figures by name; without any, all of them
    #[arg(long, value_name = "NAME", value_parser = ["focus-area", "split-density", "trapezoidal-problems", "equal-focus", "flicker"])]
    only: Vec<String>,
    /// Coarse and small: to see whether everything can be drawn
    #[arg(long)]
    quick: bool,
}

/// How figures are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FigureOptions {
    /// Coarse and small.
    pub quick: bool,
    /// Whether progress is shown.
    pub progress: Progress,
}

/// A figure.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Name of its file.
    pub file: &'static str,
    /// The picture.
    pub picture: Picture,
    /// What it shows, in a sentence.
    pub shows: &'static str,
    /// The numbers behind it, if they are kept.
    pub data: Option<serde_json::Value>,
}

/// Name of a figure and what draws it.
type Painter = (&'static str, fn(&FigureOptions) -> Result<Vec<Figure>, LabError>);

const PAINTERS: [Painter; 5] = [
    ("focus-area", |options| Ok(vec![focus_area::figure(options)?])),
    ("split-density", |options| Ok(vec![density::figure(options)?])),
    ("trapezoidal-problems", |options| Ok(vec![map_grid::figure(options)?])),
    ("equal-focus", plates::figures),
    ("flicker", |options| Ok(vec![flicker::figure(options)?])),
];

/// Runs the command; returns what was written.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &FiguresArguments, progress: Progress) -> Result<String, LabError> {
    let options = FigureOptions { quick: arguments.quick, progress };
    create_folder(&arguments.out)?;
    let wanted = |name: &str| arguments.only.is_empty() || arguments.only.iter().any(|only| only == name);
    let mut readme = String::from(
        "# Figures of the papers\n\nDrawn by the f64 twin, on any machine: `cargo run -p cssm-lab -- figures`; one of them by \
         `--only NAME`.\n\n| figure | shows | by |\n|---|---|---|\n",
    );
    let mut written = String::new();
    for (name, paint) in PAINTERS.into_iter().filter(|(name, _)| wanted(name)) {
        let spinner = progress.spinner(name);
        for figure in paint(&options)? {
            let path = arguments.out.join(figure.file);
            figure.picture.write_png(&path)?;
            let _ = writeln!(written, "{}", path.display());
            let _ = writeln!(readme, "| [{0}]({0}) | {1} | `--only {name}` |", figure.file, figure.shows);
            if let Some(data) = &figure.data {
                write_json(&path.with_extension("json"), data)?;
            }
        }
        spinner.finish_and_clear();
    }
    if arguments.only.is_empty() {
        let path = arguments.out.join("README.md");
        std::fs::write(&path, readme).map_err(|source| LabError::Write { path, source })?;
    }
    Ok(written)
}

/// Draws the names of a chart's series, framed.
pub(crate) fn legend<'a, D: DrawingBackend + 'a, C: CoordTranslate>(
    chart: &mut ChartContext<'a, D, C>,
    position: SeriesLabelPosition,
) -> Result<(), LabError> {
    drawn(
        chart
            .configure_series_labels()
            .position(position)
            .label_font(("monospace", 20))
            .background_style(paint(PAPER))
            .border_style(paint([214, 214, 212]))
            .draw(),
    )
}

/// What the plotting library drew; on pictures it can only fail where a chart has no room.
pub(crate) fn drawn<T, E: std::error::Error>(result: Result<T, E>) -> Result<T, LabError> {
    result.map_err(|error| LabError::Chart { message: error.to_string() })
}
