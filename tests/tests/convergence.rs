//! Convergence against ray casting: errors shrink with the map, interiors are right, for every scene and shipped case.
//!
//! The normal run judges one view of a scene of thin leaves and of one of solid objects at 640 x 360; `cargo xtask test
//! --full` judges every seeded view of every scene.

use std::path::Path;

use cssm_core::glam::DVec3;
use cssm_core::{Light, LightCase, SceneBounds, View, plan};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_lab::convergence::{Level, SIDES, convergence};
use cssm_lab::error::LabError;
use cssm_lab::gpu::{Gpu, ResolveMethod};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::stage::{Stage, StageOptions};
use cssm_lab::truth::Tracer;
use shaders_gen::shipped;

const SIZE: (u32, u32) = (640, 360);
/// Steepest allowed slope of log mismatch over log map side, solid objects.
const SOLID_SLOPE: f64 = -0.77;
/// The same where surfaces are thinner than a pixel.
const THIN_SLOPE: f64 = -0.3;
/// Largest share of interior errors, solid objects.
const SOLID_INTERIOR: f64 = 5e-5;
/// The same where surfaces are thinner than a pixel.
const THIN_INTERIOR: f64 = 1e-4;

fn cases() -> Vec<LightCase> {
    let pick = |text: &&str| {
        let case = pick_case(Path::new("case.cssm"), text, None).unwrap();
        with_map_size(case, (4096, 4096)).unwrap()
    };
    shipped::ALL.iter().map(pick).filter(|case| !case.light.is_local()).collect()
}

/// Map side, mismatch and edge displacement in footprints of one level.
fn figures(level: &Level) -> String {
    let displacement = level.score.edge_displacement.true_to_map.footprints.p95;
    format!("{}: {:.2} % {displacement:.2}", level.side, 100.0 * level.score.mismatch)
}

/// Whether a case has a configuration that is made for the light; without one it answers, but promises nothing.
fn is_made_for(case: &LightCase, view: &View, light: &Light, bounds: &SceneBounds) -> bool {
    plan(case, view, light, bounds).unwrap().choice.made_for_position.is_empty()
}

fn is_full() -> bool {
    std::env::var_os("CSSM_FULL").is_some()
}

fn judge(scene: &Scene, thin: bool) {
    let full = is_full();
    let tracer = Tracer::new(scene);
    let cases = cases();
    let gpu = Gpu::open(&cases.iter().collect::<Vec<_>>(), SIZE).unwrap();
    let bounds = SceneBounds::of(scene.bounds_world());
    let mut pooled = vec![(0, 0); cases.len()];
    let mut judged = vec![0; cases.len()];
    for (number, spot) in scene.views.iter().enumerate() {
        let (eye, target) = (spot.eye_world, spot.target_world);
        let view = View::perspective(eye, target, DVec3::Y, 1.0, 0.2, f64::INFINITY, SIZE).unwrap();
        let light = Light::directional_travelling(spot.light_travels).unwrap();

        // The normal run judges each case on the first view whose light it is made for.
        let wanted = |(index, case): (usize, &LightCase)| {
            (full || judged[index] == 0) && is_made_for(case, &view, &light, &bounds)
        };
        let wanted: Vec<bool> = cases.iter().enumerate().map(wanted).collect();
        if !wanted.contains(&true) {
            continue;
        }
        // Leaves and lamp posts are thinner than a pixel somewhere in every scene: find true edges between centres too.
        let options = StageOptions { supersample: true, progress: Progress::Hidden };
        let stage = Stage::new(&gpu, scene, &tracer, view, light, options).unwrap();
        for (index, case) in cases.iter().enumerate().filter(|(index, _)| wanted[*index]) {
            // Coarse maps need the large sides only to be judged at all; the normal run leaves them to --full.
            let sides = match case.name.as_str() {
                _ if full => &SIDES[..],
                "Sun" => &SIDES[..],
                "Planes" | "OnePlane" | "FourPlane" => &SIDES[1..4],
                _ => &SIDES[2..4],
            };
            judged[index] += 1;
            let is_camera_space = case.technique.name == "camera_space";
            let found = match convergence(&stage, case, ResolveMethod::Function, sides) {
                Ok(found) => found,
                // Texels so large near the eye that the edge band covers most of the image.
                Err(LabError::NothingJudged { .. }) if !is_camera_space => {
                    println!("{} view {number} {}: too coarse to be judged", scene.name, case.name);
                    continue;
                }
                Err(error) => panic!("{} on {}: {error}", case.name, scene.name),
            };
            let figures: Vec<String> = found.levels.iter().map(figures).collect();
            println!(
                "{} view {number} {}: {} slope {:.2} interior {:?}",
                scene.name,
                case.name,
                figures.join(", "),
                found.slope.unwrap_or(f64::NAN),
                found.interior_pooled
            );
            let first = &found.levels[0].score;
            assert!(first.shadowed >= 0.04 && first.true_edge_pixels >= 4000, "{} is no test", scene.name);
            // Cases whose texels are larger than the finest reliefs have not reached their slope at these sizes; with
            // a focus they fall slowly, splits are judged by their interior and by falling at all.
            let configuration = plan(case, &view, &light, &bounds).unwrap().configuration;
            let has_focus = case.name == "OnePlane" || configuration == "four_plane";
            let bar = if thin || has_focus { THIN_SLOPE } else { SOLID_SLOPE };
            if is_camera_space {
                assert!(found.slope.is_none_or(|slope| slope <= bar), "{} on {}", case.name, scene.name);
            }
            assert!(
                found.levels.windows(2).all(|pair| pair[1].score.mismatch < pair[0].score.mismatch),
                "{} on {}: halving the map must raise the mismatch",
                case.name,
                scene.name
            );
            pooled[index].0 += found.interior_pooled.0;
            pooled[index].1 += found.interior_pooled.1;
        }
    }
    assert!(judged.iter().all(|views| *views > 0), "{}: a case is made for no view: {judged:?}", scene.name);
    for (case, (wrong, pixels)) in cases.iter().zip(pooled) {
        let share = wrong as f64 / f64::max(pixels as f64, 1.0);
        let bar = if thin { THIN_INTERIOR } else { SOLID_INTERIOR };
        assert!(share <= bar, "{} on {}: interior {share:.1e}, {wrong} of {pixels}", case.name, scene.name);
    }
}

#[test]
fn errors_on_the_palms_shrink_as_the_map_grows() {
    judge(&Scene::palm(), true);
}

#[test]
fn errors_in_the_city_shrink_as_the_map_grows() {
    judge(&Scene::city(), false);
}

#[test]
fn errors_in_the_pavilion_shrink_as_the_map_grows() {
    if is_full() {
        judge(&Scene::pavilion(), false);
    }
}

#[test]
fn errors_in_the_forest_shrink_as_the_map_grows() {
    if is_full() {
        judge(&Scene::forest(), true);
    }
}
