//! `cssm-lab tune`: the declaration that keeps a budget on given views, and nothing in it that they do not need.
//!
//! Three stages. Every variant is planned on every station, which says what it will cost and about how wrong it will be
//! (`predict`). The promising ones are judged by ray-cast truth with the f64 twin, cheapest first, until the budget holds
//! (`search`). Then everything is taken away that the promise holds without (`minimise`). The result is a declaration
//! file whose comments hold the promise and the evidence, and a check on views that tuning did not see (`confirm`).

pub mod bench;
pub mod budget;
pub mod confirm;
pub mod cost;
pub mod declaration;
pub mod error;
pub mod features;
pub mod minimise;
pub mod predict;
pub mod race;
pub mod search;
pub mod sites;
pub mod space;

use std::path::{Path, PathBuf};

use bench::Bench;
use budget::{Budget, Metric, Promise, parse_error_limit, parse_margin, parse_ratio};
use confirm::{Confirmation, Shown};
use declaration::{Declared, Searched, Time, named};
use error::TuneError;
use minimise::{Minimal, minimise};
use predict::{Predictions, predict};
use race::Track;
use search::{Contender, Found, cheapest, finest, sized};
use sites::Sites;

use crate::arguments::parse_image_size;
use crate::error::LabError;
use crate::gpu::ResolveMethod;
use crate::measure::paths::{self, ViewPath};
use crate::progress::Progress;
use crate::scene::Scene;
use crate::truth::Tracer;

/// Side of the maps that variants are planned with when the size is not given.
const REFERENCE_SIDE: u32 = 1024;
/// Smallest side that a declaration may ask for.
const LEAST_SIDE: u32 = 64;

/// Finds the declaration that keeps a budget of error, time or texels on a scene's views, with nothing to spare.
#[derive(Debug, clap::Args)]
#[command(group(clap::ArgGroup::new("budget").required(true).args(["max_error", "max_time", "max_texels"])))]
pub struct TuneArguments {
    /// A built-in scene (palm, city, pavilion, forest) or a glTF 2.0 file
    #[arg(long, value_name = "NAME|FILE")]
    pub scene: String,
    /// View paths: all that are built in, some of them by name (walk,drive,..), or a .json file
    #[arg(long, value_name = "builtin|NAMES|FILE", default_value = "builtin")]
    pub views: String,
    /// Views to check the promise on, where --views is a file
    #[arg(long, value_name = "FILE")]
    pub unseen: Option<PathBuf>,
    /// Largest error, in the unit of --error; shares also as percentages; the cheapest variant is chosen
    #[arg(long, value_name = "X", value_parser = parse_error_limit)]
    pub max_error: Option<f64>,
    /// Longest time of capture and resolve, as a multiple of the customary standard map's on the same adapter; the
    /// smallest error is chosen
    #[arg(long, value_name = "R", value_parser = parse_ratio)]
    pub max_time: Option<f64>,
    /// Most texels of the map; the smallest error is chosen
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(4096..))]
    pub max_texels: Option<u64>,
    /// Which error counts
    #[arg(long, value_enum, default_value = "mismatch")]
    pub error: Metric,
    /// Share of an error budget that is kept free for views not seen; of other budgets, by how much the error may exceed
    /// the smallest found
    #[arg(long, value_name = "SHARE", value_parser = parse_margin, default_value = "0.2")]
    pub margin: f64,
    /// Size of the images in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "320x180")]
    pub pixels: (u32, u32),
    /// Stations of each path, at most; 0: all
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub stations: usize,
    /// Largest side of a map, texels
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(64..=16384), default_value = "4096")]
    pub max_side: u32,
    /// Interface that the engine resolves through
    #[arg(long, value_enum, default_value = "function")]
    pub resolve: ResolveMethod,
    /// Check the promise through the generated shaders on the device too
    #[arg(long)]
    pub shaders: bool,
    /// File for the declaration
    #[arg(long, value_name = "FILE.cssm")]
    pub out: Option<PathBuf>,
}

/// What tuning found.
#[derive(Debug, Clone)]
pub struct Tuned {
    /// The declaration file.
    pub text: String,
    /// The declaration and its evidence.
    pub minimal: Minimal,
    /// What is promised.
    pub promise: Promise,
    /// The best of each technique.
    pub contenders: Vec<Contender>,
    /// How much was searched.
    pub searched: Searched,
    /// What it has on views that tuning did not see.
    pub unseen: Option<Confirmation>,
    /// What the generated shaders show, if a device was asked.
    pub shown: Option<Shown>,
}

/// Runs the command; returns what it prints.
///
/// # Errors
/// A [`LabError`] that says what to change; without a variant that keeps the budget, the best there is.
pub fn run(arguments: &TuneArguments, progress: Progress) -> Result<String, LabError> {
    let tuned = tune(arguments, progress)?;
    if let Some(path) = &arguments.out {
        std::fs::write(path, &tuned.text).map_err(|source| LabError::Write { path: path.clone(), source })?;
    }
    Ok(tuned.text)
}

/// Finds the declaration.
///
/// # Errors
/// As [`run`].
pub fn tune(arguments: &TuneArguments, progress: Progress) -> Result<Tuned, LabError> {
    let scene = Scene::load(&arguments.scene)?;
    let tracer = Tracer::new(&scene);
    let (seen, unseen) = views(arguments, &scene, &tracer)?;
    let sites = Sites::trace(&scene, &tracer, &seen, progress)?;
    let budget = arguments.budget();

    // Plan every variant on every station.
    let side = match budget {
        Budget::Texels(texels) => (texels.isqrt() as u32).clamp(LEAST_SIDE, arguments.max_side),
        Budget::Error(_) | Budget::Time(_) => REFERENCE_SIDE,
    };
    let variants = space::variants(sites.light()?, side, scene.has_masks(), sites.are_finite())?;
    let predictions = predict(&sites, variants, arguments.error, progress);
    let (refused, reason) = predictions.refused.clone();
    if predictions.possible.is_empty() {
        return Err(TuneError::NothingPlanned { tried: refused, reason }.into());
    }

    // Ray cast the promising ones.
    let mut bench = Bench::new(&sites, arguments.error);
    let margin = arguments.margin;
    let mut track: Option<Track<'_>> = None;
    let mut found: Found = match budget {
        Budget::Error(limit) => {
            let whole = Promise::of(arguments.error, limit);
            let promise = Promise { limit: limit * (1.0 - margin), ..whole };
            cheapest(&mut bench, &predictions.possible, promise, arguments.max_side, progress)?
        }
        Budget::Texels(_) => finest(&mut bench, &predictions.possible, margin, progress)?,
        Budget::Time(ratio) => {
            let track = track.insert(arguments.track(&scene, &tracer, &seen, &predictions, progress)?);
            let within = track.within(&predictions.possible, ratio, arguments.max_side)?;
            finest(&mut bench, &within, margin, progress)?
        }
    };
    if arguments.error != Metric::Mismatch {
        // Footprints and edges say nothing of what is lost in between.
        found.promise.mismatch_limit = found.errors.mismatch * (1.0 + margin);
    }

    // Leave out what is not needed, and look elsewhere.
    let mut minimal = minimise(&mut bench, &found, arguments.resolve, progress);
    let doc =
        format!("Shadows of `{}` with no more than its views need; the evidence stands above.", scene.name);
    minimal.case = named(&minimal.case, &scene.name, &sites.paths, &doc);
    let confirmation = match &unseen[..] {
        [] => None,
        paths => {
            let elsewhere = Sites::trace(&scene, &tracer, paths, progress)?;
            Some(Confirmation::of(&minimal.case, &elsewhere, &found.promise))
        }
    };
    let shown = if arguments.shaders {
        let (case, promise) = (&minimal.case, &found.promise);
        Some(Shown::of(&scene, &tracer, case, (&seen, &unseen), promise, progress)?)
    } else {
        None
    };
    let time = match &track {
        None => None,
        Some(track) => {
            let ratios = track.ratios(std::slice::from_ref(&minimal.case))?;
            ratios.first().copied().flatten().map(|ratio| Time { ratio, adapter: track.adapter() })
        }
    };
    let searched = Searched { planned: predictions.possible.len(), refused, measured: bench.measured };
    let text = Declared {
        scene: &scene.name,
        pixels: arguments.pixels,
        paths: &sites.paths,
        budget,
        margin,
        promise: &found.promise,
        searched: searched.clone(),
        contenders: &found.contenders,
        minimal: &minimal,
        time: time.as_ref(),
        unseen: confirmation.as_ref(),
        shown: shown.as_ref(),
    }
    .text();
    let Found { promise, contenders, .. } = found;
    Ok(Tuned { text, minimal, promise, contenders, searched, unseen: confirmation, shown })
}

impl TuneArguments {
    /// Where variants are timed.
    fn track<'a>(
        &self,
        scene: &'a Scene,
        tracer: &'a Tracer,
        paths: &'a [ViewPath],
        predictions: &Predictions,
        progress: Progress,
    ) -> Result<Track<'a>, LabError> {
        let any = predictions.possible.first().map(|prediction| sized(&prediction.case, self.max_side));
        let any = any.ok_or_else(|| TuneError::NothingPlanned {
            tried: predictions.refused.0,
            reason: predictions.refused.1.clone(),
        })?;
        Track::new(scene, tracer, paths, &any, progress)
    }

    /// The one budget that was given.
    fn budget(&self) -> Budget {
        match (self.max_error, self.max_time, self.max_texels) {
            (Some(error), ..) => Budget::Error(error),
            (_, Some(ratio), _) => Budget::Time(ratio),
            (_, _, texels) => Budget::Texels(texels.unwrap_or(u64::MAX)),
        }
    }
}

/// The paths to tune on, and those to check on.
fn views(
    arguments: &TuneArguments,
    scene: &Scene,
    tracer: &Tracer,
) -> Result<(Vec<ViewPath>, Vec<ViewPath>), LabError> {
    let thinned = |paths: Vec<ViewPath>| -> Vec<ViewPath> {
        paths.into_iter().map(|path| path.thinned(arguments.stations)).collect()
    };
    let file = Path::new(&arguments.views);
    if file.extension().is_some_and(|extension| extension == "json") || file.is_file() {
        let seen = paths::from_file(file, arguments.pixels)?;
        let unseen = arguments.unseen.as_ref().map(|file| paths::from_file(file, arguments.pixels));
        return Ok((thinned(seen), unseen.transpose()?.unwrap_or_default()));
    }
    let seen = picked(paths::builtin(scene, tracer, arguments.pixels)?, &arguments.views)?;
    let unseen = match &arguments.unseen {
        Some(file) => paths::from_file(file, arguments.pixels)?,
        None => {
            let mut unseen = paths::unseen(scene, tracer, arguments.pixels)?;
            unseen.retain(|path| seen.iter().any(|seen| seen.name == path.name));
            thinned(unseen)
        }
    };
    Ok((thinned(seen), unseen))
}

/// The paths of a list of names; all for `builtin`.
fn picked(paths: Vec<ViewPath>, names: &str) -> Result<Vec<ViewPath>, TuneError> {
    if names == "builtin" {
        return Ok(paths);
    }
    let mut picked = Vec::new();
    for name in names.split(',').map(str::trim) {
        let no_such = || TuneError::NoSuchPath {
            name: name.to_owned(),
            known: paths.iter().map(|path| path.name.clone()).collect(),
        };
        picked.push(paths.iter().find(|path| path.name == name).ok_or_else(no_such)?.clone());
    }
    Ok(picked)
}
