//! `cssm-lab render`: one case on one view of one scene, with pictures, a frame and a report.

use std::path::{Path, PathBuf};

use cssm_core::glam::DVec3;
use cssm_core::{Light, View};

use crate::arguments::{LIGHT_FORMS, parse_depth, parse_image_size, parse_light, parse_point, parse_size};
use crate::case_file::{load_case, with_map_size};
use crate::error::LabError;
use crate::exr_file::FrameLayers;
use crate::gpu::{Gpu, ResolveMethod};
use crate::picture::{error_picture, map_picture, shaded_picture};
use crate::progress::Progress;
use crate::report::{Report, create_folder, write_json};
use crate::scene::Scene;
use crate::stage::{Attempt, Outcome, Stage, StageOptions};
use crate::timing::time_in_turns;
use crate::truth::Tracer;

/// Renders a scene with a case's shadows and checks every pixel against ray casting.
#[derive(Debug, clap::Args)]
pub struct RenderArguments {
    /// Declaration file; with several cases, the one to take
    #[arg(long, value_name = "FILE[:Name]")]
    case: String,
    /// A built-in scene (palm, city, pavilion, forest) or a glTF 2.0 file
    #[arg(long, value_name = "NAME|FILE")]
    scene: String,
    /// Eye in world space, metres; without it, the scene's first view
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_point, allow_hyphen_values = true)]
    eye: Option<DVec3>,
    /// Point to look at; without it, that of the scene's first view
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_point, allow_hyphen_values = true)]
    target: Option<DVec3>,
    /// Direction that is up in the image
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_point, allow_hyphen_values = true, default_value = "0,1,0")]
    up: DVec3,
    /// Vertical field of view in degrees
    #[arg(long, value_name = "DEG", default_value_t = 60.0)]
    fov_y: f64,
    /// Near plane in metres
    #[arg(long, value_name = "M", value_parser = parse_depth, default_value = "0.2")]
    near: f64,
    /// Far plane in metres, or inf
    #[arg(long, value_name = "M|inf", value_parser = parse_depth, default_value = "inf")]
    far: f64,
    /// Size of the image in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "640x360")]
    size: (u32, u32),
    /// The light: direction of travel, or position, direction, half angle and range, world axes, y up, metres; without
    /// it, that of the scene's first view
    #[arg(long, value_name = LIGHT_FORMS, value_parser = parse_light)]
    light: Option<Light>,
    /// One of the scene's lamps by name, with its view, instead of a light
    #[arg(long, value_name = "NAME", conflicts_with = "light")]
    lamp: Option<String>,
    /// Size of the map in texels instead of the declared one
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    map: Option<(u32, u32)>,
    /// Interface that resolves; without it, the function if the case declares one
    #[arg(long)]
    resolve: Option<ResolveMethod>,
    /// Find true edges at pixel centres only, not with 4 x 4 samples a pixel: faster, but blames the map for shadows
    /// thinner than a pixel
    #[arg(long)]
    coarse_edges: bool,
    /// Timed runs after warm-up; 0: none
    #[arg(long, default_value_t = 15)]
    runs: usize,
    /// Folder for the results
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
}

/// Runs the command and returns its report.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &RenderArguments, progress: Progress) -> Result<Report, LabError> {
    // Read what is cheap to refuse first.
    let mut case = load_case(&arguments.case)?;
    if let Some(size) = arguments.map {
        case = with_map_size(case, size)?;
    }
    let scene = Scene::load(&arguments.scene)?;
    let lamp = arguments.lamp.as_ref().map(|name| scene.lamp(name)).transpose()?;
    let spot = lamp.map(|lamp| &lamp.viewpoint).or(scene.views.first());
    let eye = arguments.eye.or(spot.map(|spot| spot.eye_world)).ok_or(LabError::NoView)?;
    let target = arguments.target.or(spot.map(|spot| spot.target_world)).ok_or(LabError::NoView)?;
    let view = View::perspective(
        eye,
        target,
        arguments.up,
        arguments.fov_y.to_radians(),
        arguments.near,
        arguments.far,
        arguments.size,
    )?;
    let light = match (arguments.light, lamp, spot) {
        (Some(light), ..) => light,
        (None, Some(lamp), _) => lamp.light,
        (None, None, Some(spot)) => Light::directional_travelling(spot.light_travels)?,
        (None, None, None) => return Err(LabError::NoView),
    };
    create_folder(&arguments.out)?;

    let gpu = Gpu::open(&[&case], arguments.size)?;
    let spinner = progress.spinner("building the ray tracer's tree");
    let tracer = Tracer::new(&scene);
    spinner.finish_and_clear();
    let options = StageOptions { supersample: !arguments.coarse_edges, progress };
    let stage = Stage::new(&gpu, &scene, &tracer, view, light, options)?;
    let method = arguments.resolve.unwrap_or_else(|| ResolveMethod::of(&case));
    let attempts = [stage.attempt(&case, method)?];
    let outcome = attempts[0].outcome()?;
    let time = match arguments.runs {
        0 => None,
        runs => time_in_turns(&attempts, runs, progress)?.pop(),
    };
    let report = Report::new(&attempts[0], &outcome, time);
    write_results(&arguments.out, &attempts[0], &outcome, &report)?;
    Ok(report)
}

/// Writes `shaded.png`, `map.png`, `error.png`, `frame.exr` and `report.json`.
///
/// # Errors
/// When a file cannot be written.
pub fn write_results(
    folder: &Path,
    attempt: &Attempt<'_>,
    outcome: &Outcome,
    report: &Report,
) -> Result<(), LabError> {
    let (stage, frame) = (attempt.stage(), &attempt.stage().frame);
    shaded_picture(stage.scene, frame, &outcome.visibility, &stage.light)
        .write_png(&folder.join("shaded.png"))?;
    map_picture(&attempt.plan, &attempt.map()?).write_png(&folder.join("map.png"))?;
    error_picture(frame.width, frame.height, &outcome.verdicts, &outcome.score)
        .write_png(&folder.join("error.png"))?;
    FrameLayers {
        frame,
        visibility: &outcome.visibility,
        facets: &outcome.assignment.facets,
        footprints: &outcome.assignment.footprints,
    }
    .write_exr(&folder.join("frame.exr"))?;
    write_json(&folder.join("report.json"), report)
}

/// The report in a few lines for the terminal.
pub fn summary(report: &Report) -> String {
    let score = &report.score;
    let percent = |share: f64| format!("{:.4} %", 100.0 * share);
    let split = |split: &crate::score::Split| {
        format!(
            "{} (edge {}, crease {}, interior {})",
            percent(split.total),
            percent(split.edge),
            percent(split.crease),
            percent(split.interior)
        )
    };
    let displacement = &score.edge_displacement.true_to_map;
    let mut lines = vec![
        format!(
            "{} ({} / {}) on {}: {} facets in {} x {} texels",
            report.case,
            report.technique,
            report.configuration,
            report.scene,
            report.facets,
            report.map.width,
            report.map.height
        ),
        format!("leak       {}", split(&score.leak)),
        format!("acne       {}", split(&score.acne)),
        format!(
            "edges      p95 {:.2} px, {:.2} footprints from true to map",
            displacement.pixels.p95, displacement.footprints.p95
        ),
        format!(
            "footprint  median {:.2}, p95 {:.2}, p99 {:.2}, max {:.2} px",
            report.footprint.median, report.footprint.p95, report.footprint.p99, report.footprint.max
        ),
        format!(
            "map        {} read by visible pixels, {} in the visible volume",
            percent(report.utilisation.scene),
            percent(report.utilisation.beam)
        ),
        format!(
            "capture    {} draws, {} of {} triangles",
            report.draws, report.triangles_submitted, report.scene_triangles
        ),
    ];
    if let Some(time) = &report.time {
        lines.push(format!(
            "time       capture {} ms, resolve {} ms ({})",
            time.capture, time.resolve, time.method
        ));
    }
    lines.push(format!("adapter    {}", report.adapter));
    lines.join("\n")
}
