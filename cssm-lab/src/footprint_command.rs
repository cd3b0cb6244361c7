//! `cssm-lab footprint`: how many screen pixels a map texel spans, for the plan the runtime would upload.

use std::path::PathBuf;

use clap::Args;
use cssm_core::case::{LightCase, LightCaseBuilder};
use cssm_core::footprint::{self, VolumeScore};
use cssm_core::glam::DVec3;
use cssm_core::schema::{Value, Word};
use cssm_core::{Light, PlanError, SceneBounds, View, plan};
use serde::Serialize;

/// Scores the texel footprints of cases over the visible volume.
#[derive(Debug, Args)]
pub struct FootprintArguments {
    /// Declaration files to score; without any, the built-in cases
    #[arg(long = "case", value_name = "FILE")]
    cases: Vec<PathBuf>,
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
    /// without any, the grid of 36
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
    /// The map has no room.
    #[error("{0} texels make no map; use 4096 to 268435456")]
    Texels(u32),
}

/// Depth to which an infinite view is scored, in metres.
const HORIZON_METRES: f64 = 1e5;

/// Direction towards the light in camera space, degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Direction {
    elevation_degrees: f64,
    azimuth_degrees: f64,
}

impl Direction {
    fn unit(&self) -> DVec3 {
        let (elevation, azimuth) = (self.elevation_degrees.to_radians(), self.azimuth_degrees.to_radians());
        let level = elevation.cos();
        DVec3::new(level * azimuth.sin(), elevation.sin(), -level * azimuth.cos())
    }

    /// Where the light stands to the view: general (45 degrees and higher), dueling (in or behind the view), border
    /// (just outside), side (low, from elsewhere).
    fn class(&self, view: &View) -> &'static str {
        let unit = self.unit();
        let (x, y) = (unit.x / unit.z.abs(), unit.y / unit.z.abs());
        let inside = x > view.left && x < view.right && y > view.bottom && y < view.top;
        match (inside, self.elevation_degrees) {
            (true, _) => "dueling",
            (_, elevation) if elevation >= 45.0 => "general",
            (_, elevation) if elevation >= 30.0 && unit.x.abs() < 1e-9 => "border",
            _ => "side",
        }
    }
}

fn parse_direction(text: &str) -> Result<Direction, String> {
    let numbers: Option<Vec<f64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some([elevation, azimuth]) if elevation.is_finite() && azimuth.is_finite() => {
            Ok(Direction { elevation_degrees: *elevation, azimuth_degrees: *azimuth })
        }
        _ => Err("write elevation,azimuth in degrees, such as 45,180".into()),
    }
}

/// The grid of metrics: eight elevations, five azimuths, the zenith once.
fn light_grid() -> Vec<Direction> {
    let mut grid = Vec::new();
    for elevation_degrees in [5.0, 15.0, 25.0, 35.0, 45.0, 60.0, 75.0] {
        for azimuth_degrees in [0.0, 45.0, 90.0, 135.0, 180.0] {
            grid.push(Direction { elevation_degrees, azimuth_degrees });
        }
    }
    grid.push(Direction { elevation_degrees: 90.0, azimuth_degrees: 0.0 });
    grid
}

#[derive(Debug, Serialize)]
struct Report {
    rows: Vec<Row>,
}

#[derive(Debug, Serialize)]
struct Row {
    case: String,
    technique: &'static str,
    configuration: &'static str,
    elevation_deg: f64,
    azimuth_deg: f64,
    texels: u64,
    median: f64,
    p95: f64,
    p99: f64,
    max: f64,
    geometric_p95: f64,
    beam_utilisation: f64,
    unassigned: usize,
    multiply_assigned: usize,
    #[serde(skip)]
    class: &'static str,
    #[serde(skip)]
    p95_per_bound: f64,
}

/// Runs the command.
///
/// # Errors
/// A [`FootprintError`] that names the file, case or argument at fault.
pub fn run(arguments: &FootprintArguments) -> Result<(), FootprintError> {
    let width = ((f64::from(arguments.lines) * arguments.aspect).round().max(1.0)) as u32;
    let view = View::perspective(
        DVec3::ZERO,
        DVec3::NEG_Z,
        DVec3::Y,
        arguments.fov_y.to_radians(),
        arguments.near,
        arguments.far,
        (width, arguments.lines),
    )?;
    let grid = light_grid();
    let lights = if arguments.lights.is_empty() { &grid } else { &arguments.lights };
    let mut rows = Vec::new();
    for (name, case) in cases(arguments)? {
        for light in lights {
            rows.push(row(&name, &case, &view, light, arguments)?);
        }
    }
    print!("{}", table(&rows, !arguments.lights.is_empty()));
    if let Some(path) = &arguments.json {
        let report = Report { rows };
        let text = serde_json::to_string_pretty(&report).map_err(std::io::Error::from);
        let written = text.and_then(|text| std::fs::write(path, text + "\n"));
        written.map_err(|source| FootprintError::File { path: path.clone(), source })?;
    }
    Ok(())
}

/// The cases to score, all with the map size asked for.
fn cases(arguments: &FootprintArguments) -> Result<Vec<(String, LightCase)>, FootprintError> {
    let mut cases = Vec::new();
    for path in &arguments.cases {
        let text = std::fs::read_to_string(path)
            .map_err(|source| FootprintError::File { path: path.clone(), source })?;
        let parsed = cssm_codegen::dsl::parse_file(&path.display().to_string(), &text)
            .map_err(|report| FootprintError::Declaration(report.render()))?;
        cases.extend(parsed.into_iter().map(|case| (case.name.clone(), case)));
    }
    if arguments.cases.is_empty() {
        cases = built_in_cases(arguments.far.min(HORIZON_METRES), arguments.focus)?;
    }

    // A square map, or the nearest to it that has no more texels.
    let side = f64::from(arguments.texels).sqrt().floor() as u32;
    if !(64..=16384).contains(&side) {
        return Err(FootprintError::Texels(arguments.texels));
    }
    for (_, case) in &mut cases {
        (case.map.width, case.map.height) = (side, arguments.texels / side);
    }
    Ok(cases)
}

/// Techniques that need finite receivers are bounded by `far_metres`; those with a focus have it at `focus_metres`.
fn built_in_cases(far_metres: f64, focus_metres: f64) -> Result<Vec<(String, LightCase)>, FootprintError> {
    let split = |scheme: Word| {
        let arguments = [("splits", Value::Count(4)), ("scheme", Value::Word(scheme))];
        LightCase::builder("Split").technique(Word::with("parallel_split", arguments))
    };
    let practical = Word::with("practical", [("lambda", Value::Number(0.5))]);
    let focused = ("focus", Value::Number(focus_metres));
    let perspective = Word::with("perspective", [focused.clone(), ("share", Value::Number(0.5))]);
    let camera_space =
        |name: &str, configuration: Word| LightCase::builder(name).configuration_words(vec![configuration]);
    let four_plane =
        |push| Word::with("four_plane", [focused.clone(), ("push", Value::Word(Word::plain(push)))]);
    let bounded = |builder: LightCaseBuilder| builder.shadow_distance_metres(far_metres);
    let builders = [
        ("standard", bounded(LightCase::builder("Standard").technique(Word::plain("standard")))),
        ("pssm4_log", bounded(split(Word::plain("logarithmic")))),
        ("pssm4_practical", bounded(split(practical))),
        ("one_plane", camera_space("OnePlane", Word::plain("one_plane")).distribution(perspective)),
        ("one_plane_8", camera_space("Bands", Word::plain("one_plane")).bands(8, HORIZON_METRES)),
        ("four_plane", camera_space("FourPlane", four_plane("t"))),
        ("four_plane_camera", camera_space("Straight", four_plane("camera"))),
        ("face_columns_8", LightCase::builder("Faces").bands(8, HORIZON_METRES)),
    ];
    let build = |(name, builder): (&str, LightCaseBuilder)| {
        let case = builder.build().map_err(|errors| {
            FootprintError::Declaration(errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n"))
        })?;
        Ok((name.to_string(), case))
    };
    builders.into_iter().map(build).collect()
}

fn row(
    name: &str,
    case: &LightCase,
    view: &View,
    direction: &Direction,
    arguments: &FootprintArguments,
) -> Result<Row, FootprintError> {
    let toward = direction.unit();
    let light = Light::Directional { toward_light_world: toward };
    let plan = plan(case, view, &light, &SceneBounds::default()).map_err(|source| FootprintError::Plan {
        case: name.to_string(),
        elevation: direction.elevation_degrees,
        azimuth: direction.azimuth_degrees,
        source,
    })?;
    let far = view.far_metres.min(case.shadow_distance_metres.unwrap_or(f64::INFINITY)).min(HORIZON_METRES);
    let VolumeScore {
        median_pixels,
        p95_pixels,
        p99_pixels,
        max_pixels,
        geometric_p95_pixels,
        beam_utilisation,
        unassigned,
        multiply_assigned,
    } = footprint::score_volume(&plan, view, far, arguments.samples);
    let texels = u64::from(case.map.width) * u64::from(case.map.height);
    Ok(Row {
        case: name.to_string(),
        technique: case.technique.name,
        configuration: plan.configuration,
        elevation_deg: direction.elevation_degrees,
        azimuth_deg: direction.azimuth_degrees,
        texels,
        median: median_pixels,
        p95: p95_pixels,
        p99: p99_pixels,
        max: max_pixels,
        geometric_p95: geometric_p95_pixels,
        beam_utilisation,
        unassigned,
        multiply_assigned,
        class: direction.class(view),
        p95_per_bound: p95_pixels / footprint::bound(view, toward, texels as f64, far),
    })
}

/// One line for each light, or medians over each class of lights.
fn table(rows: &[Row], each: bool) -> String {
    let head =
        ["median", "p95", "p99", "max", "geo95", "util", "p95/bound"].map(|name| format!("{name:>10}"));
    let mut text = format!("{:<18} {:<16}{}\n", "case", "light (el,az)", head.concat());
    let line = |case: &str, light: &str, numbers: [f64; 7]| {
        let numbers = numbers.map(|number| format!("{number:>10.2}"));
        format!("{case:<18} {light:<16}{}\n", numbers.concat())
    };
    let numbers = |row: &Row| {
        [row.median, row.p95, row.p99, row.max, row.geometric_p95, row.beam_utilisation, row.p95_per_bound]
    };
    if each {
        for row in rows {
            let light = format!("{},{}", row.elevation_deg, row.azimuth_deg);
            text += &line(&row.case, &light, numbers(row));
        }
        return text;
    }
    let mut names: Vec<&str> = rows.iter().map(|row| row.case.as_str()).collect();
    names.dedup();
    for name in names {
        for class in ["general", "border", "dueling", "side"] {
            let of_class: Vec<[f64; 7]> =
                rows.iter().filter(|row| row.case == name && row.class == class).map(numbers).collect();
            let medians = std::array::from_fn(|column| {
                let mut values: Vec<f64> = of_class.iter().map(|numbers| numbers[column]).collect();
                values.sort_by(f64::total_cmp);
                footprint::quantile(&values, 0.5)
            });
            text += &line(name, &format!("{class} ({})", of_class.len()), medians);
        }
        let unassigned: usize = rows.iter().filter(|row| row.case == name).map(|row| row.unassigned).sum();
        let multiple: usize =
            rows.iter().filter(|row| row.case == name).map(|row| row.multiply_assigned).sum();
        text += &format!("{name:<18} receivers in no facet: {unassigned}, in several: {multiple}\n");
    }

    // Compare with logarithmic splits light by light.
    let p95 = |name: &str| rows.iter().filter(|row| row.case == name).map(|row| row.p95).collect::<Vec<_>>();
    let (splits, faces) = (p95("pssm4_log"), p95("face_columns_8"));
    if splits.len() == faces.len() && !faces.is_empty() {
        let worst = splits.iter().zip(&faces).map(|(split, face)| split / face).fold(f64::INFINITY, f64::min);
        text += &format!("pssm4_log p95 / face_columns_8 p95, worst light: {worst:.2}\n");
    }
    text
}
