//! `cssm-lab measure`: every technique on the same views at equal texels.

use std::collections::BTreeMap;
use std::path::PathBuf;

use cssm_core::LightCase;
use cssm_core::case::{Filter, MAP_SIDE_LIMIT_TEXELS};

use super::bench::{Bench, BenchOptions, JudgeKind, Receivers};
use super::cells::{CaseChoice, Item, Keys, shaders_hash};
use super::evaluate::{Candidate, Evaluation, light_kinds};
use super::html::{self, Pictures};
use super::paths::{self, ViewPath};
use super::results::{CaseEntry, Cell, PathEntry, Results, write_whole};
use super::variants::FILTERS;
use super::{plot, summary};
use crate::arguments::parse_image_size;
use crate::error::LabError;
use crate::gpu::{Gpu, GpuError};
use crate::progress::Progress;
use crate::scene::Scene;
use crate::truth::Tracer;

/// Compares techniques on a scene: errors against ray casting, footprints, flicker, costs, and the front of the best.
#[derive(Debug, clap::Args)]
pub struct MeasureArguments {
    /// A built-in scene (palm, city, pavilion, forest) or a glTF 2.0 file
    #[arg(long, value_name = "NAME|FILE")]
    scene: String,
    /// Every configuration and distribution of every technique, every technique with its defaults in its variants, the
    /// cases of a declaration file, or names of techniques with commas between
    #[arg(long, value_name = "all|variants|FILE.cssm|NAMES", default_value = "all")]
    cases: String,
    /// The built-in view paths, the same at stations that tuning does not see, or a JSON file of your own
    #[arg(long, value_name = "builtin|unseen|FILE", default_value = "builtin")]
    views: String,
    /// Most stations of each path; 0: all
    #[arg(long, default_value_t = 4)]
    stations: usize,
    /// Sides of the square maps in texels, equal for all cases
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_value = "512,1024,2048,4096",
          value_parser = clap::value_parser!(u32).range(64..=MAP_SIDE_LIMIT_TEXELS as i64))]
    sizes: Vec<u32>,
    /// Filters: none, hardware_2x2, gather_2x2; without it, gather_2x2, or what a declaration file says
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = parse_filter)]
    filters: Vec<Filter>,
    /// Size of the images in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "640x360")]
    pixels: (u32, u32),
    /// What draws the maps that are judged
    #[arg(long, default_value = "auto")]
    judge: JudgeKind,
    /// What plans are told of the receivers beside the scene's bounds; techniques that fit their map to what is seen use it
    #[arg(long, default_value = "boxes")]
    receivers: Receivers,
    /// Find true edges at pixel centres only: faster, but blames the map for shadows thinner than a pixel
    #[arg(long)]
    coarse_edges: bool,
    /// Timed runs of each case in turns with the first one, on the first station of the first path; 0: none
    #[arg(long, default_value_t = 0)]
    runs: usize,
    /// Results; a run that was cut short, or one with more to measure, goes on where this file ends
    #[arg(long, value_name = "FILE")]
    json: PathBuf,
    /// The front of error against cost
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
    /// Report with pictures, plots and tables, in one file
    #[arg(long, value_name = "FILE.html")]
    html: Option<PathBuf>,
}

/// A case on a path that is still to be measured, or was before.
struct Slot<'a> {
    item: &'a Item,
    path: usize,
    key: String,
    done: Option<Evaluation>,
}

/// Runs the command; returns a table of what was found.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &MeasureArguments, progress: Progress) -> Result<String, LabError> {
    // Read what is cheap to refuse first.
    let mut sides = arguments.sizes.clone();
    sides.sort_unstable();
    sides.dedup();
    let earlier = Results::read(&arguments.json)?.map(Results::by_key).unwrap_or_default();
    let scene = Scene::load(&arguments.scene)?;
    let spinner = progress.spinner("building the ray tracer's tree");
    let tracer = Tracer::new(&scene);
    spinner.finish_and_clear();
    let paths = view_paths(arguments, &scene, &tracer)?;
    let kinds = light_kinds(&paths);
    let (cases, items) = CaseChoice::of(&arguments.cases).items(&kinds, &sides, &arguments.filters)?;
    let gpu = open(arguments.judge, &items, arguments.pixels)?;
    let adapter = gpu.as_ref().map_or_else(|| "none, the f64 twin draws".to_owned(), Gpu::adapter);

    // Recognise what was measured before.
    let MeasureArguments { pixels, coarse_edges, runs, receivers, .. } = arguments;
    let judged = format!("{adapter} {pixels:?} {coarse_edges} {runs} {receivers:?}");
    let keys = Keys::new(&scene, &judged);
    let drawn = |case: &LightCase| arguments.judge.draws(case, gpu.as_ref());
    let slots = slots(&keys, &items, &paths, earlier, &drawn, progress)?;
    let mut results = Results {
        scene: scene.name.clone(),
        triangles: scene.triangles() as u64,
        pixels: arguments.pixels,
        adapter,
        paths: paths.iter().map(path_entry).collect(),
        cases,
        sides,
        cells: Vec::new(),
    };

    // Measure the rest; trace only if there is something left to judge or to show.
    let missing = slots.iter().any(|slot| slot.done.is_none());
    let bench = if missing || arguments.html.is_some() {
        let supersample = !arguments.coarse_edges;
        let options = BenchOptions {
            supersample,
            judge: arguments.judge,
            receivers: arguments.receivers,
            flicker: true,
            progress,
        };
        Some(Bench::new(&scene, &tracer, &paths, gpu.as_ref(), options)?)
    } else {
        None
    };
    let taken_over = slots.iter().filter(|slot| slot.done.is_some()).count();
    let measured = slots.len() - taken_over;
    measure(arguments, bench.as_ref(), slots, &mut results, progress)?;

    // Show it.
    if let Some(path) = &arguments.plot {
        write_whole(path, &plot::svg(&results)?)?;
    }
    if let (Some(path), Some(bench)) = (&arguments.html, &bench) {
        let pictures = Pictures::draw(bench, &results, &items, progress)?;
        write_whole(path, &html::page(&results, &pictures)?)?;
    }
    Ok(format!(
        "{}{measured} measured, {taken_over} taken over, on {}\n",
        summary::text(&results),
        results.adapter
    ))
}

/// The device, as far as one is wanted and there is one.
fn open(judge: JudgeKind, items: &[Item], pixels: (u32, u32)) -> Result<Option<Gpu>, LabError> {
    let declared: Vec<_> = items.iter().map(|item| &item.case).collect();
    match (judge, || Gpu::open(&declared, pixels)) {
        (JudgeKind::Twin, _) => Ok(None),
        (JudgeKind::Gpu, open) => Ok(Some(open()?)),
        (JudgeKind::Auto, open) => match open() {
            Err(GpuError::NoAdapter(_)) => Ok(None),
            opened => Ok(Some(opened?)),
        },
    }
}

fn view_paths(
    arguments: &MeasureArguments,
    scene: &Scene,
    tracer: &Tracer,
) -> Result<Vec<ViewPath>, LabError> {
    let paths = match arguments.views.as_str() {
        "builtin" => paths::builtin(scene, tracer, arguments.pixels)?,
        "unseen" => paths::unseen(scene, tracer, arguments.pixels)?,
        file => paths::from_file(file.as_ref(), arguments.pixels)?,
    };
    Ok(paths.into_iter().map(|path| path.thinned(arguments.stations)).collect())
}

fn path_entry(path: &ViewPath) -> PathEntry {
    PathEntry { name: path.name.clone(), summary: path.summary.clone(), stations: path.stations.len() }
}

/// Every case on every path that has its light, with what an earlier run found.
fn slots<'a>(
    keys: &Keys,
    items: &'a [Item],
    paths: &[ViewPath],
    mut earlier: BTreeMap<String, Cell>,
    drawn: &dyn Fn(&LightCase) -> bool,
    progress: Progress,
) -> Result<Vec<Slot<'a>>, LabError> {
    let bar = progress.bar(items.len() as u64, "planning");
    let mut slots = Vec::new();
    for item in items {
        let shaders = shaders_hash(&item.case)?;
        for (index, path) in paths.iter().enumerate() {
            if path.stations.iter().any(|station| station.light.kind() != item.case.light) {
                continue;
            }
            let key = keys.key(&item.case, shaders, path, drawn(&item.case));
            let done = earlier.remove(&key).map(|cell| cell.found);
            slots.push(Slot { item, path: index, key, done });
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(slots)
}

/// Fills the results, cell by cell, and writes them after each.
fn measure(
    arguments: &MeasureArguments,
    bench: Option<&Bench<'_>>,
    slots: Vec<Slot<'_>>,
    results: &mut Results,
    progress: Progress,
) -> Result<(), LabError> {
    // What is there already stands first, so that a run that is cut short keeps it.
    let done = |slot: &Slot<'_>| slot.done.clone().map(|found| cell(slot, found, results));
    let kept: Vec<Option<Cell>> = slots.iter().map(done).collect();
    results.cells = kept.iter().flatten().cloned().collect();
    results.write(&arguments.json)?;

    let bar = progress.bar(slots.len() as u64, "measuring");
    let mut cells = Vec::with_capacity(slots.len());
    let mut candidate: Option<(&Item, Candidate<'_>)> = None;
    let mut reference: Option<(&Item, Candidate<'_>)> = None;
    for (slot, kept) in slots.iter().zip(&kept) {
        bar.inc(1);
        let (Some(bench), None) = (bench, kept) else {
            cells.extend(kept.clone());
            continue;
        };
        let path = &bench.paths[slot.path];
        bar.set_message(format!(
            "{} {}, {}",
            results.cases[slot.item.entry].label, slot.item.case.map.width, path.name
        ));
        let ready = ready(&mut candidate, bench, slot.item)?;
        let mut found = ready.evaluate(path)?;
        if arguments.runs > 0 && slot.path == 0 {
            let first = reference_item(&slots, slot.item);
            let beside = self::ready(&mut reference, bench, first)?;
            let times = ready.times(beside, &path.stations[0], arguments.runs)?;
            if let Some(figures) = &mut found.figures {
                figures.times = times;
            }
        }
        let cell = cell(slot, found, results);
        cells.push(cell.clone());
        results.cells.push(cell);
        results.write(&arguments.json)?;
    }
    bar.finish_and_clear();

    // Leave the cells in the order of cases and paths.
    results.cells = cells;
    results.write(&arguments.json)
}

/// The candidate of an item, made anew only when the item changes.
fn ready<'c, 'a, 'b>(
    slot: &'c mut Option<(&'a Item, Candidate<'b>)>,
    bench: &'b Bench<'b>,
    item: &'a Item,
) -> Result<&'c mut Candidate<'b>, LabError> {
    if slot.as_ref().is_some_and(|(known, _)| *known != item) {
        *slot = None;
    }
    let fresh = match slot.take() {
        Some(kept) => kept,
        None => (item, Candidate::new(bench, &item.case)?),
    };
    Ok(&mut slot.insert(fresh).1)
}

/// The first case with an item's size and filter.
fn reference_item<'a>(slots: &[Slot<'a>], item: &'a Item) -> &'a Item {
    let same = |slot: &&Slot<'a>| {
        let (one, two) = (&slot.item.case, &item.case);
        (one.map.width, one.filter, one.light) == (two.map.width, two.filter, two.light)
    };
    slots.iter().find(same).map_or(item, |slot| slot.item)
}

fn cell(slot: &Slot<'_>, found: Evaluation, results: &Results) -> Cell {
    let entry: &CaseEntry = &results.cases[slot.item.entry];
    Cell {
        key: slot.key.clone(),
        case: entry.label.clone(),
        side: slot.item.case.map.width,
        filter: slot.item.case.filter.name().to_owned(),
        path: results.paths[slot.path].name.clone(),
        found,
    }
}

fn parse_filter(text: &str) -> Result<Filter, String> {
    let known = || FILTERS.iter().map(|filter| filter.name()).collect::<Vec<_>>().join(", ");
    let found = FILTERS.into_iter().find(|filter| filter.name() == text);
    found.ok_or_else(|| format!("there is no such filter; give any of {}", known()))
}
