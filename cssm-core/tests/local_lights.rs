//! Footprints of local lights: the bipyramid against the cube, four planes and face columns, at the places of the
//! reference table (facet algebra, section 4). All maps hold 2048^2 texels.

mod support;

use cssm_core::case::LightKind;
use cssm_core::footprint::{VolumeScore, score_volume};
use cssm_core::glam::DVec3;
use cssm_core::schema::Word;
use cssm_core::{Light, LightCase, SceneBounds, plan};
use support::level_view;

/// How much worse than its reference a footprint may be.
const TOLERANCE: f64 = 1.05;

fn case(configuration: &'static str, distribution: &'static str, size: (u32, u32)) -> LightCase {
    let builder = LightCase::builder("Lamp").light(LightKind::Omni).map_size_texels(size.0, size.1);
    let builder = builder.configurations(&[configuration]);
    if distribution.is_empty() { builder } else { builder.distribution(Word::plain(distribution)) }
        .build()
        .unwrap()
}

fn score(case: &LightCase, place: (f64, f64, f64)) -> VolumeScore {
    let view = level_view(0.2, 1000.0);
    let lamp = Light::omni(view.eye_world + DVec3::from(place), f64::INFINITY).unwrap();
    let plan = plan(case, &view, &lamp, &SceneBounds::default()).unwrap();
    let score = score_volume(&plan, &view, 1000.0, 20_000);
    assert_eq!((score.unassigned, score.multiply_assigned), (0, 0), "{place:?}: {}", plan.choice);
    score
}

#[test]
fn eight_planes_beat_the_cube_by_the_reference_ratios() {
    // Squares of equal texels: 2 x 1448^2 and 6 x 836^2.
    let eight = case("eight_plane", "", (2896, 1448));
    let cube = case("cube", "", (2508, 1672));
    for (place, eight_reference, cube_reference, least_ratio) in [
        ((1.0, 1.0, -3.0), 4.0, 19.6, 4.9),
        ((0.0, 1.0, -10.0), 5.9, 70.6, 12.0),
        ((2.0, 2.0, -30.0), 8.5, 216.0, 25.0),
        ((3.0, 4.0, -60.0), 10.7, 435.0, 40.0),
    ] {
        let (eight, cube) = (score(&eight, place).p95_pixels, score(&cube, place).p95_pixels);
        println!(
            "{place:?}: eight planes {eight:.2} px ({eight_reference}), cube {cube:.1} px ({cube_reference})"
        );
        assert!(eight <= TOLERANCE * eight_reference, "{place:?} {eight}");
        assert!((cube / cube_reference - 1.0).abs() < 0.05, "{place:?} {cube}");
        assert!(cube >= least_ratio * eight, "{place:?} {cube} {eight}");
    }
}

#[test]
fn enlarged_eight_planes_serve_lights_beside_the_view() {
    let eight = case("eight_plane", "", (2896, 1448));
    for (height, reference) in
        [(5.6, 5.4), (5.9, 5.4), (6.6, 5.6), (8.0, 6.2), (10.0, 6.9), (15.0, 9.3), (30.0, 17.0)]
    {
        let found = score(&eight, (0.0, height, -10.0)).p95_pixels;
        println!("light {height} m up: {found:.2} px ({reference})");
        assert!(found <= TOLERANCE * reference, "{height} {found}");
    }
}

#[test]
fn points_behind_and_beside_the_eye_are_as_good_as_the_reference() {
    let square = (2048, 2048);
    let rows = [
        ("four_plane", "", (1.0, 1.0, 20.0), 8.6),
        ("four_plane", "", (0.2, 0.3, 2.0), 1.9),
        ("face_columns", "logarithmic", (1.0, 1.0, 20.0), 3.5),
        ("face_columns", "logarithmic", (0.2, 0.3, 2.0), 3.4),
        ("face_columns", "logarithmic", (0.0, 15.0, -10.0), 5.8),
        ("face_columns", "logarithmic", (0.0, 30.0, -20.0), 6.0),
        ("face_columns", "bands", (1.0, 1.0, 20.0), 3.5),
        ("face_columns", "bands", (0.2, 0.3, 2.0), 3.4),
    ];
    for (configuration, distribution, place, reference) in rows {
        let found = score(&case(configuration, distribution, square), place).p95_pixels;
        println!("{configuration} {distribution} {place:?}: {found:.2} px ({reference})");
        assert!(found <= TOLERANCE * reference, "{configuration} {place:?} {found}");
    }
}

/// Largest change of p95 in a step of a tenth of a degree, as the eye sees the lamp move: relative, or in pixels.
const LIMIT: f64 = 0.05;
const LIMIT_PIXELS: f64 = 0.5;

#[test]
fn a_moving_lamp_is_served_without_pops_or_gaps() {
    let view = level_view(0.2, 1000.0);
    let case = LightCase::builder("Lamp").light(LightKind::Omni).build().unwrap();
    // Past the view's upper edge, from before the eye to behind it, across the view, around it, and away.
    let paths: [(&str, DVec3, DVec3); 5] = [
        ("up through the edge", DVec3::new(0.5, 2.0, -10.0), DVec3::new(0.5, 20.0, -10.0)),
        ("overhead", DVec3::new(1.0, 4.0, -15.0), DVec3::new(1.0, 4.0, 15.0)),
        ("across the view", DVec3::new(-12.0, 1.0, -8.0), DVec3::new(12.0, 1.0, -8.0)),
        ("from behind to the side", DVec3::new(0.3, 0.5, 6.0), DVec3::new(9.0, 0.5, 6.0)),
        ("away", DVec3::new(0.5, 0.5, -2.0), DVec3::new(5.0, 5.0, -60.0)),
    ];
    // The normal run looks at one step in ten.
    let stride = if std::env::var_os("CSSM_FULL").is_some() { 1.0 } else { 10.0 };
    let mut used = std::collections::BTreeSet::new();
    for (name, from, to) in paths {
        let mut share: f64 = 0.0;
        let mut worst = (0.0, String::new());
        while share < 1.0 {
            let step = 0.1_f64.to_radians() * from.lerp(to, share).length() / from.distance(to);
            let [(before, last), (after, p95)] = [share, share + step].map(|share| {
                let place = from.lerp(to, share);
                let lamp = Light::omni(view.eye_world + place, f64::INFINITY).unwrap();
                let plan = plan(&case, &view, &lamp, &SceneBounds::default()).unwrap();
                assert!(plan.choice.complete, "{name} {place}: {}", plan.choice);
                let p95 = score_volume(&plan, &view, 1000.0, 2000).p95_pixels;
                (plan, p95)
            });
            used.insert(after.configuration);
            let change = f64::abs(p95 / last - 1.0);
            if change > worst.0 {
                let place = from.lerp(to, share);
                let (before, after) = (before.configuration, after.choice);
                worst = (change, format!("{place}: {last:.2} to {p95:.2} px, {before} to {after}"));
            }
            assert!(
                change < LIMIT || f64::abs(p95 - last) < LIMIT_PIXELS,
                "{name}: {} at {}",
                worst.0,
                worst.1
            );
            share += stride * step;
        }
        println!("{name}: largest step {:.1} % at {}", 100.0 * worst.0, worst.1);
    }
    assert!(used.len() >= 2, "{used:?}");
}
