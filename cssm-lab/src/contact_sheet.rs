//! `cssm-lab contact-sheet`: every case on every scene in one picture, with its figures.

mod cell;

use std::path::{Path, PathBuf};

use cssm_core::LightCase;
use indicatif::ProgressBar;
use shaders_gen::shipped;

use crate::arguments::{parse_image_size, parse_size};
use crate::case_file::{load_case, pick_case, with_map_size};
use crate::error::LabError;
use crate::gpu::{Gpu, ResolveMethod};
use crate::picture::{LABEL_BACKGROUND, LINE_PIXELS, Picture, broken, labelled, legend, triptych};
use crate::progress::Progress;
use crate::report::{Report, create_folder, write_json};
use crate::scene::{BUILT_IN, Scene};
use crate::stage::{Stage, StageOptions};
use crate::truth::Tracer;

/// Shows every case on every scene in one picture: view, map, errors and figures.
#[derive(Debug, clap::Args)]
pub struct ContactSheetArguments {
    /// Folder for the picture and the figures
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Size of the images that are judged, in pixels; the sheet shows them smaller
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "640x360")]
    size: (u32, u32),
    /// Size of every map in texels
    #[arg(long, value_name = "WxH", value_parser = parse_size, default_value = "2048x2048")]
    map: (u32, u32),
    /// A built-in scene (palm, city, pavilion, forest) or a glTF 2.0 file; may be given again; without it, all that
    /// are built in
    #[arg(long, value_name = "NAME|FILE")]
    scene: Vec<String>,
    /// Number of the scene's view, from 0; a scene with fewer shows its last
    #[arg(long, value_name = "N", default_value_t = 0)]
    view: usize,
    /// A declaration file; with several cases, the one to take; may be given again; without it, all that ship
    #[arg(long, value_name = "FILE[:Name]")]
    case: Vec<String>,
}

/// Runs the command; returns the figures as lines for the terminal.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &ContactSheetArguments, progress: Progress) -> Result<String, LabError> {
    // Read what is cheap to refuse first.
    let cases = cases(arguments)?;
    let names: Vec<&str> = match &arguments.scene[..] {
        [] => BUILT_IN.to_vec(),
        given => given.iter().map(String::as_str).collect(),
    };
    let scenes: Vec<Scene> = names.into_iter().map(Scene::load).collect::<Result<_, _>>()?;
    create_folder(&arguments.out)?;
    let gpu = Gpu::open(&cases.iter().collect::<Vec<_>>(), arguments.size)?;

    let bar = progress.bar((scenes.len() * cases.len()) as u64, "trying cases on scenes");
    let mut shown = Vec::with_capacity(scenes.len());
    for scene in &scenes {
        shown.push(show_scene(arguments, &gpu, scene, &cases, &bar)?);
    }
    bar.finish_and_clear();
    let sheet = joined(&shown);
    let sheet = Picture::stacked(&[heading(sheet.width, arguments, &gpu), sheet]);
    sheet.write_png(&arguments.out.join("contact_sheet.png"))?;
    let reports: Vec<&Report> = shown.iter().flatten().map(|(_, report)| report).collect();
    write_json(&arguments.out.join("contact_sheet.json"), &reports)?;
    Ok(reports.into_iter().map(|report| cell::figures(report).join("\n") + "\n").collect())
}

/// What a case showed of a scene.
type Shown = (Picture, Report);

/// A column for each scene, a row for each case, with as many lines of text over a row as its longest needs.
fn joined(shown: &[Vec<Shown>]) -> Picture {
    let rows = shown.iter().map(Vec::len).max().unwrap_or(0);
    let row = |number: usize| {
        let cells: Vec<_> = shown
            .iter()
            .filter_map(|column| column.get(number))
            .map(|(pictures, report)| (pictures, broken(&cell::figures(report), pictures.width)))
            .collect();
        let lines = cells.iter().map(|(_, text)| text.len()).max().unwrap_or(0);
        let cells: Vec<_> = cells.iter().map(|(pictures, text)| labelled(pictures, text, lines)).collect();
        Picture::beside(&cells)
    };
    Picture::stacked(&(0..rows).map(row).collect::<Vec<_>>())
}

/// The cases that were asked for, or all that ship for a sun, with maps of one size.
fn cases(arguments: &ContactSheetArguments) -> Result<Vec<LightCase>, LabError> {
    let cases: Vec<LightCase> = match &arguments.case[..] {
        [] => shipped::ALL
            .iter()
            .map(|text| pick_case(Path::new("shipped.cssm"), text, None))
            .filter(|case| case.as_ref().map_or(true, |case| !case.light.is_local()))
            .collect::<Result<_, _>>()?,
        given => given.iter().map(|case| load_case(case)).collect::<Result<_, _>>()?,
    };
    cases.into_iter().map(|case| with_map_size(case, arguments.map)).collect()
}

/// What the sheet shows, and what its colours mean.
fn heading(width: usize, arguments: &ContactSheetArguments, gpu: &Gpu) -> Picture {
    let blank = Picture::filled(width, 0, LABEL_BACKGROUND);
    let text = format!(
        "views of {} x {} pixels, maps of {} x {} texels, on {}; pixels, wrong ones enlarged:",
        arguments.size.0,
        arguments.size.1,
        arguments.map.0,
        arguments.map.1,
        gpu.adapter()
    );
    let legend = legend(width, &Default::default());
    let rule = Picture::filled(width, LINE_PIXELS / 3, LABEL_BACKGROUND);
    Picture::stacked(&[blank.titled(&text), legend, rule])
}

/// Tries all cases on one view of a scene.
fn show_scene(
    arguments: &ContactSheetArguments,
    gpu: &Gpu,
    scene: &Scene,
    cases: &[LightCase],
    bar: &ProgressBar,
) -> Result<Vec<Shown>, LabError> {
    let tracer = Tracer::new(scene);
    let spot = scene.views.get(arguments.view).or(scene.views.last()).ok_or(LabError::NoView)?;
    let (view, light) = spot.pictured(arguments.size)?;
    let options = StageOptions { supersample: true, progress: Progress::Hidden };
    let stage = Stage::new(gpu, scene, &tracer, view, light, options)?;

    cases
        .iter()
        .map(|case| {
            let attempt = stage.attempt(case, ResolveMethod::of(case))?;
            let outcome = attempt.outcome()?;
            bar.inc(1);
            let pictures = triptych(&stage, &attempt.plan, &attempt.map()?, &outcome);
            Ok((pictures, Report::new(&attempt, &outcome, None)))
        })
        .collect()
}
