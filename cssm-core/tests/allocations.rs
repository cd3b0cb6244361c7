//! How often planning asks for memory, stated and held: a plan owns its facets' lists, and its drafts are thrown away; a
//! held plan is brought to the next frame, asked and judged without any.

use allocation_counter::measure;
use cssm_core::case::{LightKind, Stretch};
use cssm_core::glam::{DMat3, DVec3};
use cssm_core::plan::{PlanRequest, Planner, ShadowPlan, ViewMargin};
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
        (14, bounded("Standard", Word::plain("standard")).build().unwrap()),
        (33, bounded("Splits", splits).build().unwrap()),
        (14, one_plane.distribution(Word::plain("perspective")).build().unwrap()),
        (125, LightCase::builder("Sun").bands(8, 1e5).build().unwrap()),
        (220, LightCase::builder("Lamp").light(LightKind::Omni).build().unwrap()),
    ]
}

fn view() -> View {
    let (eye, target) = (DVec3::new(0.0, 1.7, 0.0), DVec3::new(2.0, 1.2, -10.0));
    View::perspective(eye, target, DVec3::Y, 1.0, 0.1, 5000.0, (1280, 720)).unwrap()
}

fn light(case: &LightCase) -> Light {
    match case.light {
        LightKind::Omni => Light::omni(DVec3::new(2.0, 4.0, -9.0), 30.0).unwrap(),
        LightKind::Spot => {
            let (place, way) = (DVec3::new(2.0, 5.0, -9.0), DVec3::new(0.1, -1.0, 0.05));
            Light::spot(place, way, 0.6, 20.0).unwrap()
        }
        _ => Light::directional_travelling(DVec3::new(-0.4, -0.8, 0.3)).unwrap(),
    }
}

#[test]
fn a_plan_asks_for_memory_no_more_often_than_stated() {
    for (most, case) in cases() {
        let mut made = None;
        let light = light(&case);
        let info = measure(|| made = plan(&case, &view(), &light, &SceneBounds::default()).ok());
        let facets = made.map_or(0, |plan| plan.facets.len());
        println!("{:<10}{:>6} allocations, {facets} facets", case.name, info.count_total);
        assert!(facets > 0 && info.count_total <= most, "{}: {} > {most}", case.name, info.count_total);
        // Not a loose bound.
        assert!(2 * info.count_total > most, "{}: {} of {most}", case.name, info.count_total);
    }
}

#[test]
fn a_held_plan_asks_for_no_memory() {
    let margin = ViewMargin { turn_radians: 0.05, move_metres: 0.5 };
    for (_, case) in cases() {
        let light = light(&case);
        let mut held =
            PlanRequest { margin, ..PlanRequest::new(&case, &view(), &light, SceneBounds::default()) }
                .plan()
                .unwrap();
        for frame in 0..5_u32 {
            // The camera turns and moves.
            let turn = DMat3::from_rotation_y(0.005 * f64::from(frame));
            let view = View {
                eye_world: view().eye_world + DVec3::X * (0.02 * f64::from(frame)),
                camera_from_world: turn * view().camera_from_world,
                ..view()
            };
            let request = PlanRequest::new(&case, &view, &light, SceneBounds::default());
            let (mut covers, mut p95) = (false, 0.0);
            let info = measure(|| {
                held.rebase(&view);
                covers = held.covers(&request);
                p95 = held.p95_pixels(&view);
            });
            assert!(covers && p95 > 0.0, "{} {frame}", case.name);
            assert_eq!(info.count_total, 0, "{} {frame}", case.name);
        }

        // A copy of it does, and is seen to.
        let info = measure(|| drop(held.rebased(&view())));
        assert!(info.count_total > held.facets.len() as u64, "{}", case.name);
    }
}

const EXACT: Stretch = Stretch::Exact { bound_texels: 0.25 };

/// A walk of the camera: it turns about and moves, so that facets come and go.
fn walked(frame: u32) -> View {
    let (turn, step) = (0.11 * f64::from(frame), 0.4 * f64::from(frame));
    let rotation = DMat3::from_rotation_x(0.3 * (2.0 * turn).sin()) * DMat3::from_rotation_y(turn);
    View {
        eye_world: view().eye_world + DVec3::new(step.sin(), 0.2 * turn.sin(), -0.1 * step),
        camera_from_world: rotation * view().camera_from_world,
        ..view()
    }
}

#[test]
fn a_planner_asks_for_no_memory_once_it_has_some() {
    let mut all = cases();
    let planes = ["one_plane", "four_plane", "face_columns"];
    all.push((0, LightCase::builder("Chosen").configurations(&planes).bands(8, 1e5).build().unwrap()));
    all.push((
        0,
        LightCase::builder("Folds").distribution(Word::plain("logarithmic")).stretch(EXACT).build().unwrap(),
    ));
    all.push((0, LightCase::builder("Beam").light(LightKind::Spot).build().unwrap()));
    for (_, case) in all {
        let light = light(&case);
        let (mut planner, mut plan) = (Planner::new(), ShadowPlan::empty());
        let mut facets = Vec::new();
        for frame in 0..100 {
            let view = walked(frame);
            let request = PlanRequest::new(&case, &view, &light, SceneBounds::default());
            let mut result = Ok(());
            let info = measure(|| result = planner.plan(&request, &mut plan));
            result.unwrap();
            assert!(frame < 2 || info.count_total == 0, "{} {frame}: {}", case.name, info.count_total);
            // It is the plan that anyone makes.
            assert_eq!(plan, request.plan().unwrap(), "{} {frame}", case.name);
            facets.push(plan.facets.len());
        }
        facets.dedup();
        println!("{:<10} {facets:?}", case.name);
    }
}
