//! `cssm-lab footprint`: how many screen pixels a map texel spans, for the plan the runtime would upload, beside what a
//! prototype of the same technique measured.

pub mod cases;
pub mod figures;
pub mod grid;
pub mod omni;
pub mod reference;
mod tables;

use std::path::PathBuf;

use clap::Args;
use cssm_core::glam::DVec3;
use cssm_core::{Light, PlanError, View, footprint};
use rayon::prelude::*;
use serde::Serialize;

use cases::{BuiltIn, HORIZON_METRES};
use figures::{Figures, Measured, measure};
use grid::{Class, Direction, light_grid, parse_direction};
use omni::{OmniError, PLACES, Place};
use reference::Reference;

/// Scores the texel footprints of cases over the visible volume and on the ground.
#[derive(Debug, Args)]
pub struct FootprintArguments {
    /// Declaration files to score; without any, the built-in cases
    #[arg(long = "case", value_name = "FILE")]
    cases: Vec<PathBuf>,
    /// Built-in cases whose names contain this; may be given again
    #[arg(long, value_name = "TEXT")]
    only: Vec<String>,
    /// Vertical field of view in degrees
    #[arg(long, value_name = "DEG", default_value_t = 60.0)]
    fov_y: f64,
    /// Image width / height
    #[arg(long, value_name = "R", default_value_t = 1.0)]
    aspect: f64,
    /// Near plane in metres
    #[arg(long, value_name = "M", default_value_t = 0.2)]
    near: f64,
    /// Far plane in metres, or inf
    #[arg(long, value_name = "M|inf", default_value = "1000")]
    far: f64,
    /// Screen lines
    #[arg(long, default_value_t = 1080)]
    lines: u32,
    /// Texels of the whole map
    #[arg(long, value_name = "N", default_value_t = 2048 * 2048)]
    texels: u32,
    /// Focus distance in metres, for techniques that have one
    #[arg(long, value_name = "M", default_value_t = 10.0)]
    focus: f64,
    /// Direction towards the light in camera space, degrees: elevation, azimuth (0 ahead, 90 right, 180 behind);
    /// without any, the grid of 36 and the omni lights
    #[arg(long = "light", value_name = "EL,AZ", value_parser = parse_direction, allow_hyphen_values = true)]
    lights: Vec<Direction>,
    /// Sample receivers for each light
    #[arg(long, default_value_t = 20_000)]
    samples: usize,
    /// Write every row as JSON
    #[arg(long, value_name = "OUT")]
    json: Option<PathBuf>,
}

/// Why nothing could be scored.
#[derive(Debug, thiserror::Error)]
pub enum FootprintError {
    /// A file could not be read or written.
    #[error("{path}: {source}")]
    File {
        /// The file.
        path: PathBuf,
        /// The reason.
        source: std::io::Error,
    },
    /// A declaration is wrong.
    #[error("{0}")]
    Declaration(String),
    /// The view makes no sense.
    #[error(transparent)]
    View(#[from] cssm_core::view::ViewError),
    /// A case has no plan.
    #[error("case {case}, light {elevation},{azimuth}: {source}")]
    Plan {
        /// Name of the case.
        case: String,
        /// Elevation in degrees.
        elevation: f64,
        /// Azimuth in degrees.
        azimuth: f64,
        /// The reason.
        source: PlanError,
    },
    /// A configuration has no figures under a lamp.
    #[error("{configuration}, lamp at {position:?}: {source}")]
    Omni {
        /// The configuration.
        configuration: &'static str,
        /// Where the lamp stands.
        position: [f64; 3],
        /// The reason.
        source: OmniError,
    },
    /// The map has no room.
    #[error("{0} texels make no map; use 4096 to 268435456")]
    Texels(u32),
}

/// What is scored: a view, a size of map, a density of samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// The view.
    pub view: View,
    /// Side of a square map of all texels.
    pub side: u32,
    /// Focus distance in metres.
    pub focus_metres: f64,
    /// Sample receivers for each light.
    pub samples: usize,
}

/// One case under one light.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// Name of the case.
    pub case: String,
    /// Its technique.
    pub technique: &'static str,
    /// The configuration that the plan took.
    pub configuration: &'static str,
    /// Elevation of the light in degrees.
    pub elevation_deg: f64,
    /// Azimuth of the light in degrees.
    pub azimuth_deg: f64,
    /// Texels of the map.
    pub texels: u64,
    /// The figures.
    #[serde(flatten)]
    pub figures: Figures,
    /// p95 over the smallest possible.
    pub p95_per_bound: f64,
    /// Samples without a facet or outside its window.
    pub unassigned: usize,
    /// Samples in several facets.
    pub multiply_assigned: usize,
    /// Where the light stands.
    #[serde(skip)]
    pub class: Class,
}

/// One configuration under one lamp.
#[derive(Debug, Clone, PartialEq)]
pub struct OmniRow {
    /// What was measured.
    pub place: Place,
    /// The figures.
    pub measured: Measured,
}

#[derive(Debug, Serialize)]
struct Report<'a> {
    rows: &'a [Row],
}

impl Survey {
    /// The one that the reference was measured in.
    ///
    /// # Errors
    /// None that can be met.
    pub fn reference(samples: usize) -> Result<Self, FootprintError> {
        let view = level_view(60.0, 0.2, 1000.0, (1080, 1080))?;
        Ok(Self { view, side: 2048, focus_metres: 10.0, samples })
    }

    /// Depth to which is scored.
    pub fn far_metres(&self) -> f64 {
        self.view.far_metres.min(HORIZON_METRES)
    }

    /// The built-in directional cases.
    ///
    /// # Errors
    /// When a declaration is wrong.
    pub fn cases(&self) -> Result<Vec<BuiltIn>, FootprintError> {
        cases::directional(self.side, self.far_metres(), self.view.near_metres, self.focus_metres).map_err(
            |errors| {
                let texts: Vec<String> = errors.iter().map(ToString::to_string).collect();
                FootprintError::Declaration(texts.join("\n"))
            },
        )
    }

    /// Scores a case under directional lights.
    ///
    /// # Errors
    /// When a light has no plan.
    pub fn rows(&self, built: &BuiltIn, lights: &[Direction]) -> Result<Vec<Row>, FootprintError> {
        lights.par_iter().map(|direction| self.row(built, direction)).collect()
    }

    fn row(&self, built: &BuiltIn, direction: &Direction) -> Result<Row, FootprintError> {
        let BuiltIn { name, case, .. } = built;
        let toward = self.view.camera_from_world.transpose() * direction.unit();
        let light = Light::Directional { toward_light_world: toward };
        let far = self.far_metres().min(case.shadow_distance_metres.unwrap_or(f64::INFINITY));
        let Measured { configuration, figures, unassigned, multiply_assigned, .. } =
            measure(case, &self.view, &light, far, self.samples).map_err(|source| FootprintError::Plan {
                case: name.clone(),
                elevation: direction.elevation_degrees,
                azimuth: direction.azimuth_degrees,
                source,
            })?;
        let texels = u64::from(case.map.width) * u64::from(case.map.height);
        Ok(Row {
            case: name.clone(),
            technique: case.technique.name,
            configuration,
            elevation_deg: direction.elevation_degrees,
            azimuth_deg: direction.azimuth_degrees,
            texels,
            figures,
            p95_per_bound: figures.p95 / footprint::bound(&self.view, toward, texels as f64, far),
            unassigned,
            multiply_assigned,
            class: direction.class(&self.view),
        })
    }

    /// Scores every place of the omni table.
    ///
    /// # Errors
    /// When a lamp has no plan.
    pub fn omni_rows(&self) -> Result<Vec<OmniRow>, FootprintError> {
        let row = |place: &Place| {
            let measured = place
                .measure(&self.view, self.side, self.focus_metres, self.far_metres(), self.samples)
                .map_err(|source| FootprintError::Omni {
                    configuration: place.configuration,
                    position: place.position,
                    source,
                })?;
            Ok(OmniRow { place: *place, measured })
        };
        PLACES.par_iter().map(row).collect()
    }
}

/// Medians of the rows of a class of lights; `None` where there are none.
pub fn medians(rows: &[Row], class: Class) -> Option<Figures> {
    let of_class: Vec<Figures> =
        rows.iter().filter(|row| row.class == class).map(|row| row.figures).collect();
    (!of_class.is_empty()).then(|| Figures::medians(&of_class))
}

/// Runs the command; returns its tables.
///
/// # Errors
/// A [`FootprintError`] that names the file, case or argument at fault.
pub fn run(arguments: &FootprintArguments) -> Result<String, FootprintError> {
    let side = f64::from(arguments.texels).sqrt().floor() as u32;
    if !(64..=16384).contains(&side) {
        return Err(FootprintError::Texels(arguments.texels));
    }
    let width = ((f64::from(arguments.lines) * arguments.aspect).round().max(1.0)) as u32;
    let size = (width, arguments.lines);
    let view = level_view(arguments.fov_y, arguments.near, arguments.far, size)?;
    let survey = Survey { view, side, focus_metres: arguments.focus, samples: arguments.samples };
    let cases = if arguments.cases.is_empty() {
        let named = |built: &BuiltIn| {
            arguments.only.is_empty() || arguments.only.iter().any(|part| built.name.contains(part))
        };
        survey.cases()?.into_iter().filter(named).collect()
    } else {
        declared(arguments, side)?
    };

    let grid = light_grid();
    let each = !arguments.lights.is_empty();
    let lights = if each { &arguments.lights } else { &grid };
    let mut text = String::new();
    let mut rows = Vec::new();
    for built in &cases {
        let of_case = survey.rows(built, lights)?;
        text += &tables::directional(built, &of_case, each, text.is_empty());
        rows.extend(of_case);
    }
    if !each {
        text += &tables::against_splits(&rows);
    }
    if !each && arguments.cases.is_empty() && arguments.only.iter().all(|part| "omni".contains(part)) {
        text += &tables::omni(&survey.omni_rows()?);
    }
    if let Some(path) = &arguments.json {
        let report = serde_json::to_string_pretty(&Report { rows: &rows }).map_err(std::io::Error::from);
        let written = report.and_then(|text| std::fs::write(path, text + "\n"));
        written.map_err(|source| FootprintError::File { path: path.clone(), source })?;
    }
    Ok(text)
}

/// A level view along -z from the origin.
fn level_view(
    fov_y_degrees: f64,
    near_metres: f64,
    far_metres: f64,
    size_pixels: (u32, u32),
) -> Result<View, FootprintError> {
    let (eye, target, fov_y) = (DVec3::ZERO, DVec3::NEG_Z, fov_y_degrees.to_radians());
    Ok(View::perspective(eye, target, DVec3::Y, fov_y, near_metres, far_metres, size_pixels)?)
}

/// The cases of declaration files, with a square map, or the nearest to it that has no more texels.
fn declared(arguments: &FootprintArguments, side: u32) -> Result<Vec<BuiltIn>, FootprintError> {
    let mut cases = Vec::new();
    for path in &arguments.cases {
        let text = std::fs::read_to_string(path)
            .map_err(|source| FootprintError::File { path: path.clone(), source })?;
        let parsed = cssm_codegen::dsl::parse_file(&path.display().to_string(), &text)
            .map_err(|report| FootprintError::Declaration(report.render()))?;
        cases.extend(parsed.into_iter().map(|mut case| {
            (case.map.width, case.map.height) = (side, arguments.texels / side);
            BuiltIn { name: case.name.clone(), case, reference: Reference::NONE }
        }));
    }
    Ok(cases)
}
