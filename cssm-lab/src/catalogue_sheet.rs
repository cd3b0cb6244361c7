//! `cssm-lab catalogue`: every configuration under every kind of light in one picture, by the f64 twin.

use std::path::PathBuf;

use cssm_core::plan;

use crate::arguments::{parse_image_size, parse_size};
use crate::case_file::with_map_size;
use crate::catalogue::{Entry, Situation, entries, situations};
use crate::error::LabError;
use crate::picture::{LABEL_BACKGROUND, LINE_PIXELS, Picture, broken, labelled, legend, triptych};
use crate::progress::Progress;
use crate::report_files::create_folder;
use crate::scene::Scene;
use crate::sight::{Sight, StageOptions};
use crate::truth::Tracer;
use crate::twin::{self, TwinCasters, TwinOutcome};

/// Shows every configuration and distribution under every kind of light in one picture: view, map, errors and figures,
/// each in the first situations of a scene that it is made for. The f64 twin draws, no graphics device is needed.
#[derive(Debug, clap::Args)]
pub struct CatalogueArguments {
    /// Folder for the picture
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Size of the images that are judged, in pixels; the sheet shows them smaller
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "640x360")]
    size: (u32, u32),
    /// Size of every map in texels
    #[arg(long, value_name = "WxH", value_parser = parse_size, default_value = "1024x1024")]
    map: (u32, u32),
    /// A built-in scene with lamps: palm, city, pavilion or forest
    #[arg(long, value_name = "NAME", default_value = "palm")]
    scene: String,
    /// Find true edges at pixel centres only: faster, but blames the map for shadows thinner than a pixel
    #[arg(long)]
    coarse_edges: bool,
}

/// Columns of the sheet.
const COLUMNS: usize = 2;

/// A cell of the sheet.
struct Shown {
    pictures: Picture,
    lines: Vec<String>,
}

/// Runs the command; returns the figures as lines for the terminal.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &CatalogueArguments, progress: Progress) -> Result<String, LabError> {
    let scene = Scene::load(&arguments.scene)?;
    let situations = situations(&scene, arguments.size)?;
    create_folder(&arguments.out)?;
    let tracer = Tracer::new(&scene);
    let bar = progress.bar(situations.len() as u64, "trying every configuration");

    // Each case in the first situation that it is made for.
    let mut waiting: Vec<Entry> = Vec::new();
    for kind in crate::catalogue::KINDS {
        waiting.extend(entries(kind).map_err(|errors| LabError::Catalogue { errors })?);
    }
    let mut shown: Vec<(usize, Shown)> = Vec::new();
    let order: Vec<String> = waiting.iter().map(|entry| entry.name.clone()).collect();
    for situation in &situations {
        let suits = |entry: &Entry| suits(entry, situation, &scene);
        let (chosen, rest): (Vec<Entry>, Vec<Entry>) = waiting.into_iter().partition(suits);
        waiting = rest;
        for (name, cell) in show(arguments, &scene, &tracer, situation, &chosen)? {
            shown.push((order.iter().position(|known| *known == name).unwrap_or(order.len()), cell));
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    shown.sort_by_key(|(place, _)| *place);
    let cells: Vec<Shown> = shown.into_iter().map(|(_, cell)| cell).collect();

    let sheet = joined(&cells);
    let sheet = Picture::stacked(&[heading(sheet.width, arguments), sheet]);
    sheet.write_png(&arguments.out.join("catalogue.png"))?;
    Ok(cells.iter().map(|cell| cell.lines.join("\n") + "\n").collect())
}

/// Whether a case is made for a situation.
fn suits(entry: &Entry, situation: &Situation, scene: &Scene) -> bool {
    let bounds = cssm_core::SceneBounds::of(scene.bounds_world());
    entry.case.light == situation.light.kind()
        && plan(&entry.case, &situation.view, &situation.light, &bounds)
            .is_ok_and(|plan| plan.choice.complete && plan.choice.made_for_position.is_empty())
}

/// The cells of one situation, by the names of their cases.
fn show(
    arguments: &CatalogueArguments,
    scene: &Scene,
    tracer: &Tracer,
    situation: &Situation,
    entries: &[Entry],
) -> Result<Vec<(String, Shown)>, LabError> {
    if entries.is_empty() {
        return Ok(Vec::new());
    }
    let options = StageOptions { supersample: !arguments.coarse_edges, progress: Progress::Hidden };
    let sight = Sight::trace(scene, tracer, situation.view, situation.light, options)?;
    let casters = TwinCasters::new(scene, situation.view.eye_world);
    entries
        .iter()
        .map(|entry| {
            let case = with_map_size(entry.case.clone(), arguments.map)?;
            let TwinOutcome { plan, depths, outcome } = twin::outcome(&sight, &casters, &case)?;
            let score = &outcome.score;
            let lines = vec![
                format!(
                    "{} in {} on {}, {} facets",
                    entry.name,
                    situation.name,
                    scene.name,
                    plan.facets.len()
                ),
                format!(
                    "wrong {:.2} %, interior {} px, footprint p95 {:.2} px, edge p95 {:.2} footprints",
                    100.0 * score.mismatch,
                    score.interior_wrong_pixels,
                    outcome.footprint.volume.p95,
                    score.edge_displacement.true_to_map.footprints.p95
                ),
            ];
            let pictures = triptych(&sight, &plan, &depths, &outcome);
            Ok((entry.name.clone(), Shown { pictures, lines }))
        })
        .collect()
}

/// Cells in rows.
fn joined(cells: &[Shown]) -> Picture {
    let rows = cells.chunks(COLUMNS).map(|row| {
        let texts: Vec<_> = row.iter().map(|cell| broken(&cell.lines, cell.pictures.width)).collect();
        let lines = texts.iter().map(Vec::len).max().unwrap_or(0);
        let cells: Vec<_> =
            row.iter().zip(&texts).map(|(cell, text)| labelled(&cell.pictures, text, lines)).collect();
        Picture::beside(&cells)
    });
    Picture::stacked(&rows.collect::<Vec<_>>())
}

/// What the sheet shows, and what its colours mean.
fn heading(width: usize, arguments: &CatalogueArguments) -> Picture {
    let text = format!(
        "views of {} x {} pixels, maps of {} x {} texels, drawn by the f64 twin; pixels, wrong ones enlarged:",
        arguments.size.0, arguments.size.1, arguments.map.0, arguments.map.1
    );
    let blank = Picture::filled(width, 0, LABEL_BACKGROUND);
    let rule = Picture::filled(width, LINE_PIXELS / 3, LABEL_BACKGROUND);
    Picture::stacked(&[blank.titled(&text), legend(width, &Default::default()), rule])
}
