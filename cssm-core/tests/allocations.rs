//! How often planning asks for memory, stated and held: a plan owns its facets' lists, and its drafts are thrown away.

use allocation_counter::measure;
use cssm_core::case::LightKind;
use cssm_core::glam::DVec3;
use cssm_core::schema::{Value, Word};
use cssm_core::{Light, LightCase, SceneBounds, View, plan};

/// Largest number of allocations in a plan of each case, and the case.
fn cases() -> Vec<(u64, LightCase)> {
    let bounded = |name: &str, technique: Word| {
        LightCase::builder(name).technique(technique).shadow_distance_metres(1000.0)
    };
    let splits = Word::with("parallel_split", [("splits", Value::Count(4))]);
    let one_plane = LightCase::builder("OnePlane").configurations(&["one_plane"]);
    vec![
        (90, bounded("Standard", Word::plain("standard")).build().unwrap()),
        (160, bounded("Splits", splits).build().unwrap()),
        (70, one_plane.distribution(Word::plain("perspective")).build().unwrap()),
        (300, LightCase::builder("Sun").bands(8, 1e5).build().unwrap()),
        (900, LightCase::builder("Lamp").light(LightKind::Omni).build().unwrap()),
    ]
}

#[test]
fn a_plan_asks_for_memory_no_more_often_than_stated() {
    let eye = DVec3::new(0.0, 1.7, 0.0);
    let view =
        View::perspective(eye, DVec3::new(2.0, 1.2, -10.0), DVec3::Y, 1.0, 0.1, 5000.0, (1280, 720)).unwrap();
    let sun = Light::directional_travelling(DVec3::new(-0.4, -0.8, 0.3)).unwrap();
    let lamp = Light::omni(DVec3::new(2.0, 4.0, -9.0), 30.0).unwrap();
    for (most, case) in cases() {
        let light = if case.light == LightKind::Omni { lamp } else { sun };
        let mut made = None;
        let info = measure(|| made = plan(&case, &view, &light, &SceneBounds::default()).ok());
        let facets = made.map_or(0, |plan| plan.facets.len());
        println!("{:<10}{:>6} allocations, {facets} facets", case.name, info.count_total);
        assert!(facets > 0 && info.count_total <= most, "{}: {} > {most}", case.name, info.count_total);
        // Not a loose bound.
        assert!(2 * info.count_total > most, "{}: {} of {most}", case.name, info.count_total);
    }
}
