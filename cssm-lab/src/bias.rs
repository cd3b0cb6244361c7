//! `cssm-lab bias`: where shadows begin and where surfaces shadow themselves, at every angle of the light.
//!
//! A bias that is too small leaves acne, one that is too large moves shadows off what casts them. Both are measured at
//! once, for lights from one degree above the horizon to the zenith, on every scene.

use std::fmt::Write as _;
use std::path::PathBuf;

use cssm_core::glam::DVec3;
use cssm_core::{Light, LightCase};
use serde::Serialize;
use shaders_gen::shipped;

use crate::arguments::{parse_image_size, parse_size};
use crate::case_file::{pick_case, with_map_size};
use crate::error::LabError;
use crate::gpu::{Gpu, ResolveMethod};
use crate::progress::Progress;
use crate::report::{create_folder, write_json};
use crate::scene::{BUILT_IN, Scene};
use crate::score::Score;
use crate::stage::{Stage, StageOptions};
use crate::truth::Tracer;

/// Elevations of the light above the horizon, degrees.
const ELEVATIONS_DEGREES: [f64; 10] = [1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 35.0, 50.0, 70.0, 90.0];
/// Where the light stands, counted from the view's direction to the right, degrees.
const AZIMUTHS_DEGREES: [f64; 2] = [60.0, 200.0];
/// Largest 95th percentile of the way from true edges to the map's, surface footprints.
const MOST_FOOTPRINTS: f64 = 1.0;
/// Largest share of self-shadowed pixels away from edges and creases.
const MOST_ACNE: f64 = 1e-4;

/// Edge displacement and acne at every angle of the light.
#[derive(Debug, clap::Args)]
pub struct BiasArguments {
    /// Folder for the tables
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Scenes; all that are built in unless named
    #[arg(long = "scene", value_name = "NAME")]
    scenes: Vec<String>,
    /// Size of the images in pixels
    #[arg(long, value_name = "WxH", value_parser = parse_image_size, default_value = "320x180")]
    size: (u32, u32),
    /// Size of the map in texels
    #[arg(long, value_name = "WxH", value_parser = parse_size, default_value = "2048x2048")]
    map: (u32, u32),
}

/// One scene under one light.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BiasFinding {
    /// The scene.
    pub scene: String,
    /// Elevation of the light, degrees.
    pub elevation_degrees: f64,
    /// Azimuth of the light from the view's direction, degrees.
    pub azimuth_degrees: f64,
    /// 95th percentile of the way from true edges to the map's, surface footprints.
    pub displacement_footprints: f64,
    /// Number of true edge pixels.
    pub true_edge_pixels: u64,
    /// The percentile over edges with no crease within a footprint, behind which the map's edge might lie unseen.
    pub open_displacement_footprints: f64,
    /// Number of those edge pixels.
    pub open_edge_pixels: u64,
    /// Share of light-facing pixels away from edges and creases that shadow themselves.
    pub acne: f64,
    /// The same number of pixels.
    pub acne_pixels: u64,
    /// Pixels whose surfaces face the light at 1 to 3 degrees.
    pub shallow_pixels: u64,
    /// Share of them that shadow themselves.
    pub shallow_acne: f64,
    /// Share of them that is wrong away from edges and creases.
    pub shallow_interior: f64,
}

impl BiasFinding {
    /// Whether shadows begin where they should and surfaces stay lit.
    pub fn holds(&self) -> bool {
        self.displacement_footprints <= MOST_FOOTPRINTS
            && self.acne <= MOST_ACNE
            && self.shallow_interior <= MOST_ACNE
    }
}

/// Runs the command; returns the table as Markdown.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &BiasArguments, progress: Progress) -> Result<String, LabError> {
    create_folder(&arguments.out)?;
    let case = pick_case(std::path::Path::new("sun.cssm"), shipped::SUN, Some("Sun"))?;
    let case = with_map_size(case, arguments.map)?;
    let gpu = Gpu::open(&[&case], arguments.size)?;
    let names: Vec<&str> = match arguments.scenes.as_slice() {
        [] => BUILT_IN.to_vec(),
        named => named.iter().map(String::as_str).collect(),
    };
    let mut findings = Vec::new();
    for name in names {
        let scene = Scene::load(name)?;
        let tracer = Tracer::new(&scene);
        let lights = (AZIMUTHS_DEGREES.len() * ELEVATIONS_DEGREES.len()) as u64;
        let bar = progress.bar(lights, &format!("lights on {name}"));
        for azimuth in AZIMUTHS_DEGREES {
            for elevation in ELEVATIONS_DEGREES {
                findings.push(find(arguments, &gpu, &scene, &tracer, &case, (elevation, azimuth))?);
                bar.inc(1);
            }
        }
        bar.finish_and_clear();
    }
    write_json(&arguments.out.join("bias.json"), &findings)?;
    let text = markdown(&findings);
    let path = arguments.out.join("bias.md");
    std::fs::write(&path, &text).map_err(|source| LabError::Write { path, source })?;
    Ok(text)
}

fn find(
    arguments: &BiasArguments,
    gpu: &Gpu,
    scene: &Scene,
    tracer: &Tracer,
    case: &LightCase,
    (elevation_degrees, azimuth_degrees): (f64, f64),
) -> Result<BiasFinding, LabError> {
    let spot = scene.views.first().ok_or(LabError::NoView)?;
    let (view, _) = spot.pictured(arguments.size)?;
    let ahead = -view.camera_from_world.transpose().z_axis;
    let level = DVec3::new(ahead.x, 0.0, ahead.z).normalize_or(DVec3::NEG_Z);
    let right = level.cross(DVec3::Y);
    let (sin, cos) = azimuth_degrees.to_radians().sin_cos();
    let (rise, run) = elevation_degrees.to_radians().sin_cos();
    let toward = (level * cos + right * sin) * run + DVec3::Y * rise;
    let light = Light::directional_travelling(-toward)?;
    let options = StageOptions { supersample: scene.has_masks(), progress: Progress::Hidden };
    let stage = Stage::new(gpu, scene, tracer, view, light, options)?;
    let Score { acne, wide_edge_displacement: displacement, shallow, facing_pixels, .. } =
        stage.attempt(case, ResolveMethod::Function)?.outcome()?.score;
    Ok(BiasFinding {
        scene: scene.name.clone(),
        elevation_degrees,
        azimuth_degrees,
        displacement_footprints: displacement.true_to_map.footprints.p95,
        true_edge_pixels: displacement.true_to_map.count,
        open_displacement_footprints: displacement.open.footprints.p95,
        open_edge_pixels: displacement.open.count,
        acne: acne.interior,
        acne_pixels: (acne.interior * facing_pixels as f64).round() as u64,
        shallow_pixels: shallow.pixels,
        shallow_acne: shallow.acne,
        shallow_interior: shallow.interior,
    })
}

fn markdown(findings: &[BiasFinding]) -> String {
    let mut text = String::from(
        "| scene | light from | elevation | displacement p95, footprints | edge pixels | away from creases | edge pixels | acne, pixels | 1 to 3 degrees: pixels | acne | interior | |\n\
         |---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n",
    );
    for found in findings {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {} | {} | {} | {:.2} | {} | {:.2} | {} | {} | {} | {:.4} | {:.4} | {} |",
            found.scene,
            found.azimuth_degrees,
            found.elevation_degrees,
            found.displacement_footprints,
            found.true_edge_pixels,
            found.open_displacement_footprints,
            found.open_edge_pixels,
            found.acne_pixels,
            found.shallow_pixels,
            found.shallow_acne,
            found.shallow_interior,
            if found.holds() { "holds" } else { "**fails**" },
        );
    }
    let held = findings.iter().filter(|found| found.holds()).count();
    let _ = writeln!(text, "\n{held} of {} hold.", findings.len());
    text
}
