//! `cssm-lab stability`: what each way to keep texels where they are saves in flicker, and what it costs in errors.
//!
//! A camera creeps through a scene by less than a texel a frame. The points that its first frame sees are asked again in
//! every frame; truth does not change, so whatever flips is the map's doing. The f64 twin draws every map.

mod chart;

use std::fmt::Write as _;
use std::path::PathBuf;

use cssm_core::LightCase;
use cssm_core::facet::Facet;
use serde::Serialize;

use crate::arguments::parse_image_size;
use crate::creep::{Creep, Flips, carried};
use crate::error::LabError;
use crate::figures::cases::case;
use crate::progress::Progress;
use crate::report_files::{create_folder, write_json};
use crate::scene::Scene;
use crate::sight::{Sight, StageOptions};
use crate::truth::{Frame, Tracer};
use crate::twin::{TwinCasters, outcome, visibility};

/// Techniques that are compared, as declarations spell them.
const TECHNIQUES: [(&str, &str); 4] = [
    ("face columns", "camera_space"),
    ("4 logarithmic splits", "parallel_split { splits: 4, scheme: logarithmic }"),
    ("one standard map", "standard"),
    ("4 stable cascades", "stable_cascades { splits: 4, scheme: logarithmic }"),
];

/// Modes that are compared, the plain one first. A technique that a mode changes nothing of is measured without it.
const MODES: [&str; 5] = [
    "none",
    "snapped",
    "quantised { move: 10 cm, turn: 0.25 deg }",
    "quantised { move: 25 cm, turn: 0.5 deg }",
    "quantised { move: 1 m, turn: 2 deg }",
];

/// Flicker of every mode of stability against its errors.
#[derive(Debug, clap::Args)]
pub struct StabilityArguments {
    /// Folder for the table and the chart
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// The scene
    #[arg(long, value_name = "NAME", default_value = "palm")]
    scene: String,
    /// Size of the images in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "320x180")]
    size: (u32, u32),
    /// Side of the square map in texels
    #[arg(long, value_name = "TEXELS", default_value_t = 1024)]
    side: u32,
    /// How far receivers are in shadow, metres
    #[arg(long, value_name = "METRES", default_value_t = 100.0)]
    distance: f64,
    /// Frames of each motion
    #[arg(long, value_name = "FRAMES", default_value_t = 100)]
    frames: u32,
}

/// One mode of one technique.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StabilityFinding {
    /// The technique.
    pub technique: &'static str,
    /// The mode.
    pub mode: &'static str,
    /// Share of light-facing pixels of the first frame that are wrong.
    pub wrong: f64,
    /// Share of them that is wrong away from edges and creases.
    pub interior: f64,
    /// Mean share of light-facing points that flip in a frame, for each of [`Creep::ALL`].
    pub flicker: [f64; 2],
    /// Largest such share, for each.
    pub worst_frame: [f64; 2],
}

/// Runs the command; returns the table as Markdown.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &StabilityArguments, progress: Progress) -> Result<String, LabError> {
    create_folder(&arguments.out)?;
    let scene = Scene::load(&arguments.scene)?;
    let tracer = Tracer::new(&scene);
    let (view, light) = scene.views.first().ok_or(LabError::NoView)?.pictured(arguments.size)?;
    let options = StageOptions { supersample: scene.has_masks(), progress };
    let sight = Sight::trace(&scene, &tracer, view, light, options)?;
    let mut found: Vec<StabilityFinding> = Vec::new();
    let bar = progress.bar((TECHNIQUES.len() * MODES.len()) as u64, "modes of stability");
    for (technique, declared) in TECHNIQUES {
        let mut plain: Option<Vec<Facet>> = None;
        for mode in MODES {
            let fields = format!("stability: {mode},");
            let case = case(declared, &fields, arguments.side, arguments.distance)?;
            let facets = sight.plan(&case)?.facets;
            if plain.as_ref() != Some(&facets) {
                found.push(find(arguments, &sight, &case, (technique, mode))?);
            }
            plain.get_or_insert(facets);
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    write_json(&arguments.out.join("stability.json"), &found)?;
    let text = markdown(&found);
    let path = arguments.out.join("stability.md");
    std::fs::write(&path, &text).map_err(|source| LabError::Write { path, source })?;
    chart::draw(&found, arguments)?.write_png(&arguments.out.join("stability.png"))?;
    Ok(text)
}

fn find(
    arguments: &StabilityArguments,
    sight: &Sight<'_>,
    case: &LightCase,
    (technique, mode): (&'static str, &'static str),
) -> Result<StabilityFinding, LabError> {
    let casters = TwinCasters::new(sight.scene, sight.view.eye_world);
    let score = outcome(sight, &casters, case)?.outcome.score;
    let (mut flicker, mut worst_frame) = ([0.0; 2], [0.0; 2]);
    for (index, creep) in Creep::ALL.into_iter().enumerate() {
        let mut all = Flips::default();
        let mut before: Option<(Frame, Vec<f32>)> = None;
        for number in 0..=arguments.frames {
            let view = creep.moved(&sight.view, number);
            let points = carried(&sight.frame, &sight.view, &view);
            let now = Sight::of_frame(sight.scene, view, sight.light, points);
            let casters = TwinCasters::new(now.scene, view.eye_world);
            let (_, shown) = visibility(&now, &casters, case, &now.plan(case)?);
            if let Some((earlier, visibility)) = &before {
                let mut frame = Flips::default();
                frame.add((earlier, visibility), (&now.frame, &shown));
                worst_frame[index] = frame.share().max(worst_frame[index]);
                all.flipped += frame.flipped;
                all.asked += frame.asked;
            }
            before = Some((now.frame, shown));
        }
        flicker[index] = all.share();
    }
    Ok(StabilityFinding {
        technique,
        mode,
        wrong: score.mismatch,
        interior: score.interior_wrong_pixels as f64 / score.facing_pixels.max(1) as f64,
        flicker,
        worst_frame,
    })
}

fn markdown(found: &[StabilityFinding]) -> String {
    let mut text = String::from(
        "| technique | mode | wrong | interior | flicker, 1 cm a frame | worst frame | flicker, 0.05° a frame | worst frame |\n\
         |---|---|---:|---:|---:|---:|---:|---:|\n",
    );
    for finding in found {
        let StabilityFinding { technique, mode, wrong, interior, flicker, worst_frame } = finding;
        let percent = |share: f64| format!("{:.3} %", 100.0 * share);
        let _ = writeln!(
            text,
            "| {technique} | `{mode}` | {} | {} | {} | {} | {} | {} |",
            percent(*wrong),
            percent(*interior),
            percent(flicker[0]),
            percent(worst_frame[0]),
            percent(flicker[1]),
            percent(worst_frame[1]),
        );
    }
    text
}
