//! The captured map equals the f64 twin's: coverage away from 1/64 texel of an edge, depth within 1e-5 plus what the
//! surface rises over 1/64 texel. Wrong matrices, tiles and orders are caught.

use cssm_core::case::{DepthFormat, LightCase};
use cssm_core::schema::{Value, Word};
use cssm_core::{SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::Options;
use cssm_tests::gpu::depth_bracket::{DepthBracket, SLIVERS};
use cssm_tests::gpu::exclusive;
use cssm_tests::gpu::stage::Stage;
use cssm_tests::gpu::yard::{Yard, suns, views};

fn cases() -> Vec<LightCase> {
    let case = |name: &str, technique: Word, format| {
        LightCase::builder(name)
            .technique(technique)
            .map_size_texels(256, 256)
            .map_format(format)
            .shadow_distance_metres(150.0)
            .build()
            .unwrap()
    };
    let splits = || Word::with("parallel_split", [("splits", Value::Count(4))]);
    vec![
        case("Standard", Word::plain("standard"), DepthFormat::Depth32Float),
        case("Splits", splits(), DepthFormat::Depth32Float),
        case("Columns", Word::plain("camera_space"), DepthFormat::Depth32Float),
        case("Coarse", splits(), DepthFormat::Depth16Unorm),
    ]
}

fn planned(case: &LightCase, view: &View, sun: usize) -> ShadowPlan {
    plan(case, view, &suns()[sun], &SceneBounds::default()).unwrap()
}

#[test]
fn the_device_draws_what_the_twin_draws() {
    let (gpu, yard) = (exclusive(), Yard::new());
    for case in &cases() {
        let mut stage = Stage::new(&gpu, &yard, case, &Options::default());
        let (mut violations, mut texels, mut covered) = (0, 0, 0);
        for view in &views((160, 90)) {
            for sun in 0..3 {
                let plan = planned(case, view, sun);
                let map = stage.capture(&plan, view);
                let bracket = DepthBracket::new(&yard, &plan, case.map.format);
                violations += bracket.violations(&map);
                texels += map.depths.len();
                covered += map.depths.iter().filter(|depth| **depth < 1.0).count();
            }
        }
        assert!(covered > texels / 10, "{}: only {covered} of {texels} texels are covered", case.name);
        let share = violations as f64 / texels as f64;
        assert!(share <= SLIVERS, "{}: {violations} of {texels} texels leave the bracket", case.name);
    }
}

#[test]
fn clamping_in_fragments_draws_the_same() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let case = &cases()[2];
    let clamp = Options { clamp_in_fragments: true, ..Options::default() };
    let mut unclipped = Stage::new(&gpu, &yard, case, &Options::default());
    let mut clamped = Stage::new(&gpu, &yard, case, &clamp);
    assert_ne!(unclipped.service.capture_shader(), clamped.service.capture_shader());
    for view in &views((160, 90)) {
        let plan = planned(case, view, 1);
        let (one, other) = (unclipped.capture(&plan, view).depths, clamped.capture(&plan, view).depths);
        let worst = one.iter().zip(&other).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
        assert!(worst <= 2e-6, "worst difference {worst}");
        assert!(one.contains(&0.0), "something is flattened onto depth 0");
    }
}

#[test]
fn wrong_plans_are_caught() {
    let (gpu, yard) = (exclusive(), Yard::new());
    type Change = (&'static str, fn(&mut ShadowPlan));
    let changes: [Change; 4] = [
        ("swapped tiles", |plan| {
            let tiles: Vec<_> = plan.facets.iter().map(|facet| facet.tile).collect();
            plan.facets.iter_mut().zip(tiles.into_iter().rev()).for_each(|(facet, tile)| facet.tile = tile);
        }),
        ("a shifted tile", |plan| {
            for facet in &mut plan.facets {
                facet.tile.x += 1;
                facet.tile.width -= 1;
            }
        }),
        ("a row off by a twentieth of a texel", |plan| {
            for facet in &mut plan.facets {
                facet.rows.x += facet.rows.w * (0.1 / f64::from(facet.tile.width));
            }
        }),
        // The standard technique has w = 1, so this is one matrix element.
        ("depth off by 1e-4", |plan| {
            for facet in &mut plan.facets {
                facet.rows.z += facet.rows.w * 1e-4;
            }
        }),
    ];
    for case in [&cases()[0], &cases()[2]] {
        let mut stage = Stage::new(&gpu, &yard, case, &Options::default());
        let view = &views((160, 90))[0];
        let good = planned(case, view, 0);
        let bracket = DepthBracket::new(&yard, &good, case.map.format);
        let unchanged = bracket.violations(&stage.capture(&good, view));
        assert!(unchanged <= 1, "{}: {unchanged} texels without a change", case.name);
        for (what, change) in changes {
            let mut plan = good.clone();
            change(&mut plan);
            let wrong = bracket.violations(&stage.capture(&plan, view));
            // A single facet has nobody to swap with.
            let limit = if plan == good { 0 } else { 50 };
            assert!(wrong >= limit, "{}: {what} changes only {wrong} texels", case.name);
        }
    }
}
