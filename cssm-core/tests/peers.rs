//! What each peer technique is known to fail at, and that it does so by degrees: no peer pops without saying so, and every
//! one converges where it is defined.

mod support;

use cssm_core::case::LightKind;
use cssm_core::fit::Sighted;
use cssm_core::footprint::{beam_utilisation, quantile, volume};
use cssm_core::glam::{DMat3, DQuat, DVec2, DVec3, DVec4};
use cssm_core::plan::{BoundingBox, PlanError, plan_over};
use cssm_core::receivers::Polytope;
use cssm_core::samples;
use cssm_core::schema::{Value, Word};
use cssm_core::technique::Situation;
use cssm_core::technique::trapezoidal::FocusTable;
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use support::{Random, level_view, peers, sun, toward};

const FAR: f64 = 1000.0;

fn case(technique: Word) -> LightCase {
    LightCase::builder("Peer").technique(technique).shadow_distance_metres(FAR).build().unwrap()
}

fn plain(technique: &'static str) -> LightCase {
    case(Word::plain(technique))
}

fn with(technique: &'static str, field: &'static str, name: &'static str) -> LightCase {
    case(Word::with(technique, [(field, Value::Word(Word::plain(name)))]))
}

fn planned(case: &LightCase, view: &View, toward_light: DVec3) -> ShadowPlan {
    plan(case, view, &sun(toward_light), &SceneBounds::default()).unwrap()
}

/// Footprints at points of a view's camera axes; infinite where a point has no facet.
fn footprints(plan: &ShadowPlan, view: &View, points: &[DVec3]) -> Vec<f64> {
    let to_world = view.camera_from_world.transpose();
    let one = |point: &DVec3| {
        let point = to_world * *point;
        let facet = plan.facet(plan.selection.cell(point.extend(1.0)));
        facet.map_or(f64::INFINITY, |facet| volume(facet, view, point).major_pixels)
    };
    points.iter().map(one).collect()
}

fn p95(plan: &ShadowPlan, view: &View, points: &[DVec3]) -> f64 {
    let mut pixels = footprints(plan, view, points);
    pixels.sort_by(f64::total_cmp);
    quantile(&pixels, 0.95)
}

fn points(view: &View) -> Vec<DVec3> {
    samples::receivers(view, &Polytope::frustum(view, FAR), 300)
}

/// A view along -z and what its middle ray sees at a depth.
fn ahead(depth: f64) -> DVec3 {
    DVec3::new(0.01, 0.02, -1.0) * depth
}

#[test]
fn standard_maps_starve_what_is_near() {
    let view = level_view(0.2, FAR);
    for case in [plain("standard"), plain("bounding_box")] {
        let plan = planned(&case, &view, toward(60.0, 90.0));
        let [near, far] = footprints(&plan, &view, &[ahead(0.3), ahead(900.0)])[..] else { unreachable!() };
        assert!(near > 1000.0 && far < 1.0, "{near} {far}");
    }
}

#[test]
fn a_box_of_least_area_turns_at_once_when_another_edge_is_better() {
    // The trapezoidal paper's figure 2: a hair of motion, another map. A standard map turns with the light only.
    let view = level_view(0.2, 100.0);
    let axis = |case: &LightCase, elevation: f64| {
        planned(case, &view, toward(elevation, 150.0)).facets[0].rows.x.truncate().normalize()
    };
    let largest_turn = |case: &LightCase| {
        let axes: Vec<DVec3> = (0..1800).map(|step| axis(case, 0.05 * f64::from(step))).collect();
        let turn = |pair: &[DVec3]| pair[0].angle_between(pair[1]).sin().abs();
        axes.windows(2).map(turn).fold(0.0, f64::max)
    };
    let boxed = largest_turn(&plain("bounding_box"));
    let standard = largest_turn(&plain("standard"));
    assert!(boxed > 0.1 && standard < 0.01, "{boxed} {standard}");
}

#[test]
fn a_box_over_what_is_visible_is_finer_and_leaves_the_rest_out() {
    let view = level_view(0.2, FAR);
    let light = sun(toward(50.0, 120.0));
    let visible = BoundingBox { min: DVec3::new(-2.0, -1.7, -30.0), max: DVec3::new(3.0, 2.0, -20.0) };
    let over = |technique: Word, volumes: &[BoundingBox]| {
        let case = case(technique);
        let plan = plan_over(&case, &view, &light, &SceneBounds::default(), volumes).unwrap();
        footprints(&plan, &view, &[DVec3::new(0.0, 0.0, -25.0)])[0]
    };
    for name in ["bounding_box", "perspective"] {
        let word = || match name {
            "bounding_box" => Word::with(name, [("over", Value::Word(Word::plain("visible")))]),
            _ => Word::plain(name),
        };
        let (whole, boxed) = (over(word(), &[]), over(word(), &[visible]));
        assert!(boxed < 0.2 * whole, "{name}: {boxed} of {whole}");

        // Visible pixels are boxes without an extent.
        let corner = |k: u32| {
            let pick = |bit: u32, low: f64, high: f64| if k & (1 << bit) == 0 { low } else { high };
            let (min, max) = (visible.min, visible.max);
            let place = DVec3::new(pick(0, min.x, max.x), pick(1, min.y, max.y), pick(2, min.z, max.z));
            BoundingBox { min: place, max: place }
        };
        let pixels: Vec<BoundingBox> = (0..8).map(corner).collect();
        let by_pixels = over(word(), &pixels);
        assert!((by_pixels / boxed - 1.0).abs() < 1e-6, "{name}: {by_pixels} {boxed}");
    }
    let wrong = BoundingBox { min: visible.max, max: visible.min };
    let case = plain("bounding_box");
    let refused = plan_over(&case, &view, &light, &SceneBounds::default(), &[wrong]);
    assert!(matches!(refused, Err(PlanError::Bounds { .. })));
}

#[test]
fn splits_step_in_quality_at_their_limits() {
    let view = level_view(0.2, FAR);
    let scheme = |name: &'static str| with("parallel_split", "scheme", name);
    let step = |case: &LightCase, limit: f64| {
        let plan = planned(case, &view, toward(60.0, 150.0));
        let [before, after] = footprints(&plan, &view, &[ahead(limit * 0.9999), ahead(limit * 1.0001)])[..]
        else {
            unreachable!()
        };
        after / before
    };
    let limit = 0.2 * 5000_f64.powf(0.5);
    assert!(step(&scheme("logarithmic"), limit) > 5.0);
    let faces = LightCase::builder("Faces").build().unwrap();
    assert!(step(&faces, limit) < 3.0);
}

#[test]
fn cascades_hold_their_texels_still_in_the_world_and_pay_with_texels() {
    let case = with("stable_cascades", "scheme", "logarithmic");
    let moving = with("parallel_split", "scheme", "logarithmic");
    let (light, mut random) = (toward(50.0, 70.0), Random::new(8));
    let view = |eye: DVec3, target: DVec3| {
        View::perspective(eye, target, DVec3::Y, 1.0, 0.2, FAR, (640, 360)).unwrap()
    };

    // The place of a world point within its texel, in the slab that holds it, whatever the camera does.
    let texel = |case: &LightCase, view: &View, point: DVec3| {
        let plan = planned(case, view, light);
        let from_eye = (point - view.eye_world).extend(1.0);
        let facet = plan.facet(plan.selection.cell(from_eye)).unwrap();
        let w = facet.rows.w.dot(from_eye);
        let (x, y) =
            facet.tile.texel_from_ndc(facet.rows.x.dot(from_eye) / w, facet.rows.y.dot(from_eye) / w);
        (facet.first_cell(), DVec2::new(x, y).fract())
    };
    for offset in [0.0, 1e5] {
        let origin = DVec3::new(3.0, 1.7, -2.0) + DVec3::new(1.0, 0.0, -1.0) * offset;
        let point = origin + DVec3::new(2.0, -1.0, -12.0);
        let first = view(origin, point);
        let (slab, place) = texel(&case, &first, point);
        let (mut same, mut moved) = (0, 0.0_f64);
        for _ in 0..200 {
            let eye = origin + random.direction() * 0.5;
            let turned = view(eye, point + random.direction() * 1.5);
            let (other, there) = texel(&case, &turned, point);
            if other == slab {
                same += 1;
                // A wrap around 0 is no move.
                let step = (there - place).abs();
                let step = step.min(DVec2::ONE - step).max_element();
                assert!(step < 1e-5, "{step} texels");
            }
            let (_, loose) = texel(&moving, &turned, point);
            moved = moved.max((loose - texel(&moving, &first, point).1).abs().max_element());
        }
        assert!(same > 100 && moved > 0.1, "{same} {moved}");
    }
    let used = beam_utilisation(&planned(&case, &level_view(0.2, FAR), light));
    assert!(used < 0.5, "{used}");
}

#[test]
fn the_original_trapezoid_does_not_keep_its_focus_region() {
    // The slides' first problem; the focused rule mends it. The share of the focus region's corners beyond the line.
    let view = level_view(0.2, FAR);
    let (focus, share) = (10.0, 0.8);
    let beyond = |rule: &'static str| {
        let arguments = [
            ("rule", Value::Word(Word::plain(rule))),
            ("line", Value::Word(Word::plain("fixed"))),
            ("share", Value::Number(share)),
        ];
        let plan = planned(&case(Word::with("trapezoidal", arguments)), &view, toward(50.0, 180.0));
        let rows = plan.facets[0].rows;
        let corners = view.corner_tangents().map(|(x, y)| DVec3::new(x, y, -1.0) * focus);
        let place = |point: DVec3| {
            let point = point.extend(1.0);
            (rows.y.dot(point) / rows.w.dot(point) + 1.0) / 2.0
        };
        // The near edge of the region lies at one end of the map, its far edge within the share.
        corners.into_iter().filter(|corner| place(*corner) > share + 0.005).count()
    };
    assert!(beyond("original") > 0);
    assert_eq!(beyond("focused"), 0);
}

#[test]
fn the_original_trapezoid_stretches_the_foreground_beyond_what_the_view_does() {
    // The slides' second problem. Ratio of texel densities across at near and at the focus, over the view's own.
    let view = level_view(0.2, FAR);
    let stretch = |rule: &'static str| {
        let plan = planned(&with("trapezoidal", "rule", rule), &view, toward(25.0, 90.0));
        let facet = &plan.facets[0];
        let w = |depth: f64| facet.rows.w.dot(ahead(depth).extend(1.0));
        (w(10.0) / w(0.2)) / (10.0 / 0.2)
    };
    assert!(stretch("focused") <= 1.0 + 1e-9);
    assert!(stretch("original") > 0.0);
    assert!(stretch("focused") <= stretch("original") + 1e-9);
}

#[test]
fn the_trapezoids_depth_shortcut_is_wrong_inside_large_triangles() {
    // Section 4: (x_T, y_T, z_L w_T / w_L, w_T) is right at vertices and wrong between them.
    let view = level_view(0.2, FAR);
    let plan = planned(&plain("trapezoidal"), &view, toward(50.0, 150.0));
    let rows = plan.facets[0].rows;
    let light_depth = |point: DVec4| -(plan.light.truncate().dot(point.truncate()));
    let triangle =
        [DVec3::new(-3.0, -1.7, -2.0), DVec3::new(40.0, 5.0, -60.0), DVec3::new(-20.0, -1.7, -80.0)];
    let corners = triangle.map(|corner| corner.extend(1.0));
    let (mut wrong, mut right) = (0.0_f64, 0.0_f64);
    for step in 0..100 {
        let u = f64::from(step) / 100.0;
        let weights = [0.5 * u, 0.3 + 0.2 * u, 0.7 - 0.7 * u];
        let inside = (0..3).fold(DVec4::ZERO, |sum, k| sum + corners[k] * weights[k]);
        // What rasterisers interpolate: z/w over the screen, so z itself over the triangle.
        let (mut shortcut, mut w) = (0.0, 0.0);
        for k in 0..3 {
            let w_there = rows.w.dot(corners[k]);
            shortcut += weights[k] * light_depth(corners[k]) * w_there;
            w += weights[k] * w_there;
        }
        wrong = wrong.max((shortcut / w - light_depth(inside)).abs());
        let ours: f64 = (0..3).map(|k| weights[k] * rows.z.dot(corners[k])).sum();
        right = right.max((ours / w - rows.z.dot(inside) / rows.w.dot(inside)).abs());
    }
    assert!(wrong > 1.0, "{wrong} m");
    assert!(right < 1e-12, "{right}");
}

#[test]
fn the_trapezoid_is_a_box_around_the_far_plane_where_centres_coincide() {
    let view = level_view(0.2, FAR);
    let case = plain("trapezoidal");
    let on_axis = planned(&case, &view, DVec3::NEG_Z);
    let fallback = on_axis.choice.fallback.unwrap();
    assert!(
        (fallback.share - 1.0).abs() < 1e-12 && on_axis.choice.to_string().contains("falls back to the box")
    );
    let rows = on_axis.facets[0].rows;
    let tangents = view.corner_tangents().map(|(x, y)| DVec4::new(x * FAR, y * FAR, -FAR, 1.0));
    let filled = tangents.iter().all(|corner| {
        let (x, y) = (rows.x.dot(*corner) / rows.w.dot(*corner), rows.y.dot(*corner) / rows.w.dot(*corner));
        (0.99..=1.0).contains(&x.abs()) && (0.99..=1.0).contains(&y.abs())
    });
    assert!(filled);
    assert!(planned(&case, &view, toward(60.0, 90.0)).choice.fallback.is_none());
}

#[test]
fn trapezoids_under_facing_light_are_no_better_than_a_standard_map() {
    let view = level_view(0.2, FAR);
    let points = points(&view);
    for name in ["trapezoidal", "perspective"] {
        let light = toward(10.0, 180.0);
        let standard = p95(&planned(&plain("standard"), &view, light), &view, &points);
        let warped = p95(&planned(&plain(name), &view, light), &view, &points);
        assert!(warped > 0.9 * standard, "{name}: {warped} {standard}");
    }
}

#[test]
fn warps_give_way_to_a_uniform_map_with_the_eye_in_the_silhouette_and_say_so() {
    let view = level_view(0.2, FAR);
    let points = points(&view);
    let light = toward(10.0, 180.0);
    let standard = p95(&planned(&plain("standard"), &view, light), &view, &points);
    for name in ["light_space_perspective", "generalized_linear", "warp_family", "logarithmic_perspective"] {
        let plan = planned(&plain(name), &view, light);
        assert_eq!(plan.choice.fallback.map(|fallback| fallback.share), Some(1.0), "{name}");
        let ratio = p95(&plan, &view, &points) / standard;
        assert!((0.5..1.1).contains(&ratio), "{name}: {ratio}");
        assert!(planned(&plain(name), &view, toward(60.0, 150.0)).choice.fallback.is_none(), "{name}");
    }
}

#[test]
fn the_early_notes_lose_what_is_beside_the_eye_and_flip_with_the_lights_height() {
    let view = level_view(0.2, FAR);
    let early = with("light_space_perspective", "rule", "early_notes");
    let plan = planned(&early, &view, toward(60.0, 120.0));
    assert!(!plan.choice.complete && plan.choice.fallback.is_some());

    // The up vector divides by the light's y: the map turns over where it changes sign.
    let rows = |elevation: f64| {
        let case = with("light_space_perspective", "rule", "early_notes");
        planned(&case, &view, toward(elevation, 150.0)).facets[0].rows.w.truncate().normalize()
    };
    let flip = (rows(1e-4) - rows(-1e-4)).length();
    let steady = (rows(40.0) - rows(40.0001)).length();
    assert!(flip > 1.0 && steady < 1e-3, "{flip} {steady}");
}

#[test]
fn post_projective_space_needs_a_far_plane_and_lives_by_its_near_plane() {
    let infinite = level_view(0.2, f64::INFINITY);
    let bare = LightCase::builder("Bare").technique(Word::plain("perspective")).scene_bounds(true);
    let case = bare.build().unwrap();
    let refused = plan(&case, &infinite, &sun(toward(60.0, 90.0)), &SceneBounds::default());
    assert!(matches!(refused, Err(PlanError::Unbounded { technique: "perspective" })));

    let near = |near: f64| {
        let view = level_view(near, FAR);
        let plan = planned(&with("perspective", "slide_back", "none"), &view, toward(60.0, 150.0));
        footprints(&plan, &view, &[ahead(500.0)])[0]
    };
    let (close, middle, off) = (near(0.8), near(3.2), near(12.8));
    assert!(close > 2.5 * middle && middle > 2.5 * off, "{close} {middle} {off}");
}

#[test]
fn casters_behind_the_camera_come_first_without_a_virtual_camera() {
    // Along rays from behind the eye, through the plane where post-projective space turns over.
    let view = level_view(0.2, FAR);
    for configuration in ["single", "cube_faces"] {
        let builder = LightCase::builder("Peer").technique(Word::plain("perspective"));
        let case = builder.configurations(&[configuration]).shadow_distance_metres(FAR).build().unwrap();
        for light in [toward(20.0, 180.0), toward(60.0, 150.0), toward(30.0, 0.0)] {
            let plan = planned(&case, &view, light);
            let receiver = ahead(8.0);
            let facet = plan.facet(plan.selection.cell(receiver.extend(1.0))).unwrap();
            let image = |step: u32| {
                let point = (receiver + light * 3.0 * f64::from(step)).extend(1.0);
                let w = facet.rows.w.dot(point);
                assert!(w > 0.0);
                DVec3::new(facet.rows.x.dot(point), facet.rows.y.dot(point), facet.rows.z.dot(point)) / w
            };
            let places: Vec<DVec3> = (0..40).map(image).collect();
            assert!(places.iter().all(|place| (place.truncate() - places[0].truncate()).length() < 1e-9));
            let sign = plan.depth_order.sign();
            assert!(places.windows(2).all(|pair| sign * (pair[1].z - pair[0].z) < 0.0), "{configuration}");
        }
    }
}

#[test]
fn the_families_ends_are_the_standard_and_the_light_space_maps() {
    let view = level_view(0.2, FAR);
    let points = points(&view);
    let light = toward(70.0, 150.0);
    let eta = |eta: f64| {
        let case = case(Word::with("warp_family", [("eta", Value::Number(eta))]));
        p95(&planned(&case, &view, light), &view, &points)
    };
    let of = |name: &'static str| p95(&planned(&plain(name), &view, light), &view, &points);
    assert!((eta(0.0) / of("light_space_perspective") - 1.0).abs() < 1e-9);
    assert!((0.6..1.4).contains(&(eta(-1.0) / of("standard"))));
    let series: Vec<f64> = (0..=200).map(|step| eta(-1.0 + 0.01 * f64::from(step))).collect();
    let least = series.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(series[0] > 5.0 * least && series[200] > 2.0 * least);
}

/// Peers that pop, and the largest relative step of p95 that motion however small makes: tiles that turn or move to another
/// strip (cube faces, bands), the light camera's up vector, the largest of several maxima in the search of the
/// trapezoid's focus line. The paper on trapezoids claims continuity; of the area that it maximises it is true.
const POPS: [(&str, f64); 5] = [
    ("Perspective", 0.3),
    ("SlidPerspective", 0.1),
    ("Logarithm", 0.2),
    ("TrapezoidSplits", 0.6),
    ("Faces", 0.3),
];
/// A step that nobody sees.
const UNSEEN: f64 = 0.05;
/// Degrees between the lights of a sweep.
const SWEEP_DEGREES: f64 = 0.4;
/// Halvings of a step in search of a pop: what remains is 5e-5 degrees.
const HALVINGS: u32 = 13;

#[test]
fn peers_change_by_degrees_through_every_position_of_the_light() {
    let view = level_view(0.2, FAR);
    let points = points(&view);
    let mut found = Vec::new();
    for case in peers(1024, FAR, LightKind::Directional) {
        let (mut pop, mut steepest, mut place) = (0.0_f64, 0.0_f64, (0.0, 0.0));
        for azimuth in [180.0, 150.0, 10.0] {
            let at = |elevation: f64| p95(&planned(&case, &view, toward(elevation, azimuth)), &view, &points);
            let series: Vec<f64> = (0..=225).map(|step| at(SWEEP_DEGREES * f64::from(step))).collect();
            let change = |one: f64, two: f64| (one.max(two) / one.min(two)) - 1.0;
            for step in 0..225_u32 {
                let ends = (series[step as usize], series[step as usize + 1]);
                steepest = steepest.max(change(ends.0, ends.1));
                if change(ends.0, ends.1) <= UNSEEN {
                    continue;
                }

                // Follow the larger half of the change: a pop stays, a slope vanishes.
                let (mut low, mut high) =
                    (SWEEP_DEGREES * f64::from(step), SWEEP_DEGREES * f64::from(step + 1));
                let (mut one, mut two) = ends;
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    let there = at(middle);
                    if change(one, there) > change(there, two) {
                        (high, two) = (middle, there);
                    } else {
                        (low, one) = (middle, there);
                    }
                }
                if change(one, two) > pop {
                    (pop, place) = (change(one, two), (low, azimuth));
                }
            }
        }
        println!(
            "{}: steepest {steepest:.3} in {SWEEP_DEGREES} degrees, pops {pop:.3} at {place:?}",
            case.name
        );
        let known = POPS.iter().find(|(name, _)| *name == case.name).map_or(UNSEEN, |(_, most)| *most);
        if pop > known {
            found.push(format!("{}: {pop:.3} at {place:?}", case.name));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn local_lights_have_trapezoids_and_cube_faces() {
    let view = level_view(0.2, 100.0);
    let turn = DMat3::from_quat(DQuat::from_rotation_y(0.3));
    let spot =
        Light::spot(DVec3::new(2.0, 6.0, -12.0), turn * DVec3::new(0.1, -1.0, -0.3), 0.7, 40.0).unwrap();
    let omni = Light::omni(DVec3::new(1.0, 2.0, -12.0), 30.0).unwrap();
    for (kind, light) in [(LightKind::Spot, spot), (LightKind::Omni, omni)] {
        let cases = peers(1024, 100.0, kind);
        assert!(cases.len() >= 3 || kind == LightKind::Omni, "{}", cases.len());
        for case in cases {
            let plan = plan(&case, &view, &light, &SceneBounds::default()).unwrap();
            assert!(plan.choice.complete && !plan.facets.is_empty(), "{}: {}", case.name, plan.choice);
        }
    }
}

#[test]
fn a_table_of_focus_lines_replaces_the_search() {
    let view = level_view(0.2, FAR);
    let case = plain("trapezoidal");
    let situation = |angle: f64| Situation {
        case: &case,
        map_size_texels: (case.map.width, case.map.height),
        view: &view,
        light: DVec3::new(0.0, angle.sin(), angle.cos()).extend(0.0),
        cone: None,
        eye_height_metres: None,
        receivers: Polytope::frustum(&view, FAR),
        seen: Vec::new(),
        sighted: Sighted::default(),
    };
    let table = FocusTable::build(90, situation);
    let points = points(&view);
    for degrees in [43.3, 55.5, 71.2, 88.8_f64] {
        let angle = degrees.to_radians();
        let searched = planned(&case, &view, situation(angle).light.truncate());
        let arguments =
            [("line", Value::Word(Word::plain("fixed"))), ("share", Value::Number(table.share(angle)))];
        let looked_up = Word::with("trapezoidal", arguments);
        let looked_up = planned(&self::case(looked_up), &view, situation(angle).light.truncate());
        let ratio = p95(&looked_up, &view, &points) / p95(&searched, &view, &points);
        assert!((ratio - 1.0).abs() < 0.1, "{degrees}: {ratio}");
    }
}
