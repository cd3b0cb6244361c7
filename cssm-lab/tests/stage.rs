//! Cases on a stage: right ones score well, wrong ones are caught.

use std::path::Path;

use cssm_core::case::Casters;
use cssm_core::glam::DVec3;
use cssm_core::{Light, LightCase, ShadowPlan, View, plan};
use cssm_lab::case_file::pick_case;
use cssm_lab::convergence::convergence;
use cssm_lab::gpu::{Gpu, ResolveMethod};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::score::Score;
use cssm_lab::stage::{Stage, StageOptions};
use cssm_lab::truth::Tracer;

const SIZE: (u32, u32) = (320, 180);

fn sun() -> LightCase {
    let text =
        "pub case Sun { map: { size: 1024 x 1024 }, resolve: [mask, function { group: 0 }], prefix: sun }";
    pick_case(Path::new("sun.cssm"), text, None).unwrap()
}

/// Sets the palm stage on a device of its own.
fn on_stage(act: impl FnOnce(&Stage<'_>)) {
    let scene = Scene::palm();
    on_stage_of(&scene, &scene, act);
}

/// Sets a stage that draws one scene and traces another.
fn on_stage_of(scene: &Scene, traced: &Scene, act: impl FnOnce(&Stage<'_>)) {
    let spot = scene.views[0];
    let view = View::perspective(spot.eye_world, spot.target_world, DVec3::Y, 1.0, 0.2, f64::INFINITY, SIZE)
        .unwrap();
    let light = Light::directional_travelling(spot.light_travels).unwrap();
    let gpu = Gpu::open(&[&sun()], SIZE).unwrap();
    let options = StageOptions { supersample: true, progress: Progress::Hidden };
    act(&Stage::new(&gpu, scene, &Tracer::new(traced), view, light, options).unwrap());
}

fn planned(stage: &Stage<'_>, case: &LightCase) -> ShadowPlan {
    plan(case, &stage.view, &stage.light, &stage.bounds).unwrap()
}

fn score(stage: &Stage<'_>, case: &LightCase, plan: ShadowPlan, method: ResolveMethod) -> Score {
    stage.attempt_with_plan(case, plan, method).unwrap().outcome().unwrap().score
}

fn interior(score: &Score) -> f64 {
    score.leak.interior + score.acne.interior
}

#[test]
fn a_right_plan_scores_well_and_wrong_ones_are_caught() {
    on_stage(|stage| {
        let case = sun();
        let right = planned(stage, &case);
        for method in [ResolveMethod::Function, ResolveMethod::Mask] {
            let score = score(stage, &case, right.clone(), method);
            assert!(score.mismatch < 0.05, "{method:?}: {}", score.mismatch);
            assert!(interior(&score) <= 5e-5, "{method:?}: {} interior", interior(&score));
            assert!(score.shadowed > 0.04 && score.true_edge_pixels > 1000, "{score:?}");
        }
        let good = score(stage, &case, right.clone(), ResolveMethod::Function);

        // Lift the bias by the whole depth range: every shadow leaks.
        let mut biased = right.clone();
        biased.facets.iter_mut().for_each(|facet| facet.receiver_plane_depth += 1.0);
        let leaking = score(stage, &case, biased, ResolveMethod::Function);
        assert!(leaking.leak.total > 2.0 * good.leak.total, "{:?} after {:?}", leaking.leak, good.leak);

        // Lower it by a hundredth: lit surfaces shadow themselves.
        let mut sunk = right.clone();
        sunk.facets.iter_mut().for_each(|facet| facet.receiver_plane_depth -= 0.01);
        assert!(score(stage, &case, sunk, ResolveMethod::Function).acne.interior > 0.01);

        // Swap facets: receivers ask the wrong tiles.
        let mut swapped = right.clone();
        let last = swapped.facets.len() - 1;
        for near in 0..swapped.facets.len() / 2 {
            let cells = |index: usize| swapped.facets[index].cells.clone();
            let (one, other) = (cells(near), cells(last - near));
            (swapped.facets[near].cells, swapped.facets[last - near].cells) = (other, one);
        }
        swapped.facets.sort_by_key(|facet| facet.first_cell());
        let swapped = score(stage, &case, swapped, ResolveMethod::Function);
        assert!(swapped.mismatch > 2.0 * good.mismatch, "{} after {}", swapped.mismatch, good.mismatch);
    });
}

#[test]
fn errors_shrink_as_the_map_grows() {
    on_stage(|stage| {
        let found = convergence(stage, &sun(), ResolveMethod::Function, &[256, 512, 1024]).unwrap();
        let mismatches: Vec<f64> = found.levels.iter().map(|level| level.score.mismatch).collect();
        assert!(mismatches.is_sorted_by(|coarse, fine| coarse > fine), "{mismatches:?}");
        assert!(found.interior <= 1e-4, "{}", found.interior);
    });
}

#[test]
fn masks_are_drawn_with_their_holes() {
    let forest = Scene::forest();
    let on = |drawn: &Scene| {
        let mut found = None;
        on_stage_of(drawn, &forest, |stage| {
            let attempt = stage.attempt(&sun(), ResolveMethod::Function).unwrap();
            found = Some((attempt.case.casters, attempt.outcome().unwrap().score));
        });
        found.unwrap()
    };
    let (casters, right) = on(&forest);
    assert_eq!(casters, Casters::AlphaTested);
    assert!(right.true_edge_pixels > 1000 && interior(&right) <= 1e-4, "{right:?}");

    // Drawn without its masks the forest casts the shadows of whole cards.
    let mut whole = forest.clone();
    whole.meshes.iter_mut().for_each(|mesh| mesh.mask = None);
    let (casters, wrong) = on(&whole);
    assert_eq!(casters, Casters::Opaque);
    assert!(wrong.acne.total > 3.0 * right.acne.total, "{:?} after {:?}", wrong.acne, right.acne);
}
