//! Choosing among declared configurations: the best one, without pops, with a reason; degrading where the one that is
//! made for the light is not declared.

mod support;

use cssm_core::choose::{ChoiceReason, Chooser};
use cssm_core::footprint::score_volume;
use cssm_core::light::LightPosition;
use cssm_core::schema::{Value, Word};
use cssm_core::{LightCase, PlanError, SceneBounds, ShadowPlan, View, plan};
use support::{level_view, sun, toward};

fn case(name: &str, configurations: &[&'static str]) -> LightCase {
    LightCase::builder(name).configurations(configurations).build().unwrap()
}

fn planned(case: &LightCase, view: &View, elevation: f64, azimuth: f64) -> ShadowPlan {
    plan(case, view, &sun(toward(elevation, azimuth)), &SceneBounds::default()).unwrap()
}

fn p95(plan: &ShadowPlan, view: &View) -> f64 {
    score_volume(plan, view, view.far_metres, 4000).p95_pixels
}

#[test]
fn the_configuration_follows_the_light() {
    let view = level_view(0.2, 1000.0);
    let case = case("Both", &["four_plane", "one_plane"]);
    let low = planned(&case, &view, 10.0, 180.0);
    assert_eq!((low.configuration, low.choice.position), ("four_plane", LightPosition::Dueling));
    let high = planned(&case, &view, 80.0, 90.0);
    assert_eq!((high.configuration, high.choice.position), ("one_plane", LightPosition::General));
    assert_eq!(high.choice.reason, ChoiceReason::SmallestFootprint);
    assert!(high.choice.made_for_position.is_empty());
    let reason = high.choice.to_string();
    assert!(reason.contains("one_plane") && reason.contains("outside the view"), "{reason}");
}

#[test]
fn what_is_predicted_is_what_is_measured() {
    let view = level_view(0.2, 1000.0);
    let case = case("Both", &["four_plane", "one_plane"]);
    for (elevation, azimuth) in [(10.0, 180.0), (35.0, 0.0), (60.0, 150.0), (80.0, 90.0), (25.0, 90.0)] {
        let plan = planned(&case, &view, elevation, azimuth);
        let predicted = plan.choice.predictions.iter().map(|prediction| prediction.p95_pixels);
        let predicted = predicted.fold(f64::INFINITY, f64::min);
        let measured = p95(&plan, &view);
        assert!((predicted / measured - 1.0).abs() < 0.1, "{elevation},{azimuth}: {predicted} {measured}");
    }
}

/// Configuration of a plan, and whether it has several facets.
fn form(case: &LightCase, view: &View, elevation: f64, azimuth: f64) -> (&'static str, bool) {
    let plan = planned(case, view, elevation, azimuth);
    (plan.configuration, plan.facets.len() > 1)
}

/// The elevation between two at which the plan takes another configuration or form, from both sides.
fn switch_between(case: &LightCase, view: &View, azimuth: f64, low: f64, high: f64) -> (f64, f64) {
    let form = |elevation: f64| form(case, view, elevation, azimuth);
    let (mut low, mut high) = (low, high);
    let before = form(low);
    assert_ne!(before, form(high));
    while high - low > 1e-7 {
        let middle = 0.5 * (low + high);
        if form(middle) == before { low = middle } else { high = middle }
    }
    (low, high)
}

#[test]
fn both_sides_of_every_switch_are_equally_good() {
    let view = level_view(0.2, 1000.0);
    let mut switches = 0;
    for names in [&["four_plane", "one_plane"][..], &["four_plane"]] {
        let case = case("Path", names);
        for azimuth in [180.0, 0.0, 130.0, 90.0] {
            let form = |elevation: f64| form(&case, &view, elevation, azimuth);
            let path: Vec<f64> = (0..170).map(|step| 4.0 + 0.5 * f64::from(step)).collect();
            for pair in path.windows(2).filter(|pair| form(pair[0]) != form(pair[1])) {
                let (low, high) = switch_between(&case, &view, azimuth, pair[0], pair[1]);
                let [low, high] = [low, high].map(|e| p95(&planned(&case, &view, e, azimuth), &view));
                switches += 1;
                let place = format!("{names:?} {pair:?},{azimuth}: {low} {high}");
                assert!((low / high - 1.0).abs() < 0.05, "{place}");
            }
        }
    }
    assert!(switches >= 5, "{switches}");
}

#[test]
fn face_columns_change_smoothly_along_light_paths_through_the_border() {
    let view = level_view(0.2, 1000.0);
    let case = case("Faces", &["face_columns"]);
    for azimuth in [180.0, 0.0] {
        let at = |step: u32| p95(&planned(&case, &view, 4.0 + 0.1 * f64::from(step), azimuth), &view);
        let path: Vec<f64> = (0..850).map(at).collect();
        for (step, pair) in path.windows(2).enumerate() {
            let change = f64::abs(pair[1] / pair[0] - 1.0);
            assert!(change < 0.05, "azimuth {azimuth} step {step}: {pair:?}");
        }
    }
}

#[test]
fn a_chooser_dwells_where_two_are_equally_good() {
    // Find the light at which both are equally good.
    let view = level_view(0.2, 1000.0);
    let case = case("Both", &["four_plane", "one_plane"]);
    let light = |elevation: f64| sun(toward(elevation, 180.0));
    let at = |elevation: f64| plan(&case, &view, &light(elevation), &SceneBounds::default()).unwrap();
    let (low, _) = switch_between(&case, &view, 180.0, 25.0, 45.0);

    // Rock the light across it: without memory every frame switches.
    let rocking = |frame: u32| low + if frame.is_multiple_of(2_u32) { -1e-3 } else { 1e-3 };
    let configurations: Vec<_> = (0..100).map(|frame| at(rocking(frame)).configuration).collect();
    let switches = |names: &[&str]| names.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert_eq!(switches(&configurations), 99);
    let mut chooser = Chooser::new(25);
    let dwelling: Vec<_> = (0..100)
        .map(|frame| {
            let plan = chooser.plan(&case, &view, &light(rocking(frame)), &SceneBounds::default()).unwrap();
            plan.configuration
        })
        .collect();
    assert!(switches(&dwelling) <= 4, "{}", switches(&dwelling));

    // A choice that is much worse is not waited out.
    chooser.plan(&case, &view, &light(5.0), &SceneBounds::default()).unwrap();
    let jumped = chooser.plan(&case, &view, &light(85.0), &SceneBounds::default()).unwrap();
    assert_eq!(jumped.configuration, at(85.0).configuration);
}

#[test]
fn an_undeclared_need_degrades_and_says_so() {
    for far in [1000.0, f64::INFINITY] {
        let view = level_view(0.2, far);
        let plane = case("Plane", &["one_plane"]);
        let plan = planned(&plane, &view, 10.0, 180.0);
        assert_eq!(plan.choice.reason, ChoiceReason::Only);
        assert_eq!(plan.choice.made_for_position, ["face_columns", "four_plane"]);
        let reason = plan.choice.to_string();
        assert!(reason.contains("degraded") && reason.contains("face_columns or four_plane"), "{reason}");
        assert!(!plan.facets.is_empty());

        // Four planes serve light from the side by their form on one plane.
        let four = planned(&case("Four", &["four_plane"]), &view, 85.0, 90.0);
        assert_eq!((four.configuration, four.facets.len()), ("four_plane", 1));
        assert!(four.choice.to_string().contains("face_columns or one_plane is made for this light"));
        assert!(planned(&plane, &view, 85.0, 90.0).choice.made_for_position.is_empty());
    }
}

#[test]
fn pushing_straight_ahead_is_worse_than_along_the_light() {
    let view = level_view(0.2, 1000.0);
    let four = |push: &'static str| {
        let word = Word::with("four_plane", [("push", Value::Word(Word::plain(push)))]);
        LightCase::builder("Four").configuration_words(vec![word]).build().unwrap()
    };
    let (along, straight) = (four("t"), four("camera"));
    for (elevation, azimuth) in [(15.0, 180.0), (25.0, 180.0), (25.0, 0.0), (15.0, 0.0)] {
        let of = |case: &LightCase| p95(&planned(case, &view, elevation, azimuth), &view);
        let (along, straight) = (of(&along), of(&straight));
        assert!(straight > 1.15 * along, "{elevation},{azimuth}: {straight} {along}");
        assert!(along < 24.4 * 1.1, "{elevation},{azimuth}: {along}");
    }
    // On the axis both are the same.
    let on_axis = |case: &LightCase| p95(&planned(case, &view, 0.0, 180.0), &view);
    assert!((on_axis(&along) / on_axis(&straight) - 1.0).abs() < 1e-6);
}

#[test]
fn a_case_without_configurations_is_refused() {
    let mut none = case("None", &["face_columns"]);
    none.configurations.clear();
    let view = level_view(0.2, 1000.0);
    let refused = plan(&none, &view, &sun(toward(45.0, 90.0)), &SceneBounds::default());
    assert!(matches!(refused, Err(PlanError::Degenerate { .. })), "{refused:?}");
}
