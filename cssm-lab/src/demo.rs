//! `cssm-lab demo`: face columns beside logarithmic parallel splits at equal texels, on two of the built-in scenes.

mod table;

use std::path::{Path, PathBuf};

use cssm_core::LightCase;
use serde::Serialize;
use shaders_gen::shipped;

use crate::arguments::{parse_image_size, parse_size};
use crate::case_file::{pick_case, with_map_size};
use crate::error::LabError;
use crate::gpu::{Gpu, ResolveMethod};
use crate::picture::{Picture, error_picture, shaded_picture};
use crate::progress::Progress;
use crate::render::write_results;
use crate::report::{Report, create_folder, write_json};
use crate::scene::Scene;
use crate::stage::{Stage, StageOptions};
use crate::timing::time_in_turns;
use crate::truth::Tracer;

/// The declarations that ship, and the names under which the demo shows them.
const CASES: [(&str, &str, &str); 2] =
    [("sun.cssm", "Sun", shipped::SUN), ("pssm4_log.cssm", "Pssm4Log", shipped::PSSM4_LOG)];

/// Shows the technique against the customary one: pictures, errors, times.
#[derive(Debug, clap::Args)]
pub struct DemoArguments {
    /// Folder for the pictures and the table
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Size of the images in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "640x360")]
    size: (u32, u32),
    /// Size of every map in texels
    #[arg(long, value_name = "WxH", value_parser = parse_size, default_value = "2048x2048")]
    map: (u32, u32),
    /// Timed runs after warm-up
    #[arg(long, default_value_t = 15)]
    runs: usize,
}

/// Everything the demo found.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DemoReport {
    /// One entry for each scene and case.
    pub runs: Vec<Report>,
}

/// Runs the command; returns what was found and its table as Markdown.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &DemoArguments, progress: Progress) -> Result<(DemoReport, String), LabError> {
    let cases: Vec<LightCase> = CASES
        .iter()
        .map(|(file, name, text)| with_map_size(pick_case(Path::new(file), text, Some(name))?, arguments.map))
        .collect::<Result<_, _>>()?;
    create_folder(&arguments.out)?;
    let gpu = Gpu::open(&cases.iter().collect::<Vec<_>>(), arguments.size)?;
    let mut runs = Vec::new();
    for scene in [Scene::palm(), Scene::city()] {
        runs.extend(show_scene(arguments, &gpu, &scene, &cases, progress)?);
    }
    let report = DemoReport { runs };
    write_json(&arguments.out.join("demo.json"), &report)?;
    let table = table::markdown(&report.runs);
    let path = arguments.out.join("table.md");
    std::fs::write(&path, &table).map_err(|source| LabError::Write { path, source })?;
    Ok((report, table))
}

/// Tries all cases on the scene's first view and writes their pictures side by side.
fn show_scene(
    arguments: &DemoArguments,
    gpu: &Gpu,
    scene: &Scene,
    cases: &[LightCase],
    progress: Progress,
) -> Result<Vec<Report>, LabError> {
    let spinner = progress.spinner(&format!("building {}", scene.name));
    let tracer = Tracer::new(scene);
    spinner.finish_and_clear();
    let spot = scene.views.first().ok_or(LabError::NoView)?;
    let (view, light) = spot.pictured(arguments.size)?;
    let options = StageOptions { supersample: true, progress };
    let stage = Stage::new(gpu, scene, &tracer, view, light, options)?;

    let attempts = cases
        .iter()
        .map(|case| stage.attempt(case, ResolveMethod::of(case)))
        .collect::<Result<Vec<_>, _>>()?;
    let times = time_in_turns(&attempts, arguments.runs, progress)?;
    let mut reports = Vec::new();
    let mut columns = Vec::new();
    for (attempt, time) in attempts.iter().zip(times) {
        let outcome = attempt.outcome()?;
        let report = Report::new(attempt, &outcome, Some(time));
        let folder = arguments.out.join(format!("{}-{}", scene.name, attempt.case.prefix));
        create_folder(&folder)?;
        write_results(&folder, attempt, &outcome, &report)?;

        let frame = &stage.frame;
        let shaded = shaded_picture(scene, frame, &outcome.visibility, &stage.light);
        let errors = error_picture(frame.width, frame.height, &outcome.verdicts, &outcome.score);
        columns.push(Picture::stacked(&[shaded.titled(&title(&report)), errors]));
        reports.push(report);
    }
    Picture::beside(&columns).write_png(&arguments.out.join(format!("{}.png", scene.name)))?;
    Ok(reports)
}

fn title(report: &Report) -> String {
    format!(
        "{} on {}: {} facets, {} x {} texels, footprint p95 {:.2} px",
        report.case, report.scene, report.facets, report.map.width, report.map.height, report.footprint.p95
    )
}
