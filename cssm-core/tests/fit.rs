//! Fit to what is seen: exact knowledge cuts, late knowledge only moves texels, nothing pops.

mod support;

use cssm_core::case::Fit;
use cssm_core::fit::{BINS, DepthHistogram, bin, bin_range_metres};
use cssm_core::footprint::{quantile, volume};
use cssm_core::glam::{DMat3, DVec3};
use cssm_core::plan::plan_seen;
use cssm_core::receivers::Polytope;
use cssm_core::schema::Word;
use cssm_core::{BoundingBox, LightCase, SceneBounds, Seen, ShadowPlan, View, plan, samples};
use support::{Random, level_view, sun, toward};

const FITS: [Fit; 3] = [Fit::Bounds, Fit::DepthMinMax, Fit::Histogram];

fn case(configuration: &'static str, distribution: &'static str, fit: Fit) -> LightCase {
    let builder = LightCase::builder("Fitted").configurations(&[configuration]).fit(fit);
    builder.distribution(Word::plain(distribution)).map_size_texels(1024, 1024).build().unwrap()
}

fn cases(fit: Fit) -> Vec<LightCase> {
    let mut cases = Vec::new();
    for configuration in ["face_columns", "one_plane"] {
        for distribution in ["bands", "perspective", "logarithmic", "two_segment"] {
            cases.push(case(configuration, distribution, fit));
        }
    }
    cases.push(LightCase::builder("Fitted").configurations(&["four_plane"]).fit(fit).build().unwrap());
    cases
}

/// A walker over a plain with a wall, at a place on the way and a heading.
fn walker(metres: f64, yaw_degrees: f64) -> View {
    let turn = DMat3::from_rotation_y(-yaw_degrees.to_radians());
    let level = level_view(0.1, f64::INFINITY);
    View {
        eye_world: DVec3::new(0.3 * metres, 1.7, -metres),
        camera_from_world: turn,
        size_pixels: (320, 180),
        left: -16.0 / 9.0 * level.top,
        right: 16.0 / 9.0 * level.top,
        ..level
    }
}

/// The wall, and the ground as far as it matters.
fn boxes() -> [BoundingBox; 2] {
    let wall = BoundingBox { min: DVec3::new(-6.0, 0.0, -22.0), max: DVec3::new(4.0, 5.0, -20.0) };
    let ground = BoundingBox { min: DVec3::new(-80.0, -0.1, -120.0), max: DVec3::new(80.0, 0.0, 40.0) };
    [wall, ground]
}

/// Depth of what a ray sees.
fn depth(view: &View, ray: DVec3) -> f64 {
    let hit = |bounds: &BoundingBox| {
        let (mut low, mut high) = (0.0_f64, f64::INFINITY);
        for axis in 0..3 {
            let one = (bounds.min[axis] - view.eye_world[axis]) / ray[axis];
            let two = (bounds.max[axis] - view.eye_world[axis]) / ray[axis];
            low = low.max(one.min(two));
            high = high.min(one.max(two));
        }
        if low <= high { low } else { f64::INFINITY }
    };
    boxes().iter().map(hit).fold(f64::INFINITY, f64::min)
}

/// What a view of the plain sees: points relative to the eye, world axes, and its depths.
fn look(view: &View) -> (Vec<DVec3>, DepthHistogram) {
    let (mut points, mut depths) = (Vec::new(), Vec::new());
    for y in 0..view.size_pixels.1 {
        for x in 0..view.size_pixels.0 {
            let ray = view.ray_world(f64::from(x) + 0.5, f64::from(y) + 0.5);
            let metres = depth(view, ray);
            depths.push(metres as f32);
            if metres.is_finite() {
                points.push(ray * metres);
            }
        }
    }
    (points, DepthHistogram::measure(view, depths))
}

/// Whether a point has texels: a facet, and a place in its tile.
fn is_covered(plan: &ShadowPlan, point: DVec3) -> bool {
    let facet = plan.facet(plan.selection.cell(point.extend(1.0)));
    facet.is_some_and(|facet| {
        let rows = &facet.rows;
        let w = rows.w.dot(point.extend(1.0));
        let (x, y) = (rows.x.dot(point.extend(1.0)) / w, rows.y.dot(point.extend(1.0)) / w);
        w > 0.0 && x.abs() <= 1.0 && rows.remap.y(y).abs() <= 1.0
    })
}

/// Footprints of what is seen, ascending.
fn footprints(plan: &ShadowPlan, view: &View, points: &[DVec3]) -> Vec<f64> {
    let footprint = |point: &DVec3| {
        let facet = plan.facet(plan.selection.cell(point.extend(1.0)));
        facet.map_or(f64::INFINITY, |facet| volume(facet, view, *point).major_pixels)
    };
    let mut pixels: Vec<f64> = points.iter().step_by(7).map(footprint).collect();
    pixels.sort_by(f64::total_cmp);
    pixels
}

fn p95(plan: &ShadowPlan, view: &View, points: &[DVec3]) -> f64 {
    quantile(&footprints(plan, view, points), 0.95)
}

/// Mean of the footprint: what is wrong along shadow edges goes with it.
fn mean(plan: &ShadowPlan, view: &View, points: &[DVec3]) -> f64 {
    let pixels = footprints(plan, view, points);
    pixels.iter().sum::<f64>() / pixels.len() as f64
}

/// Everything that may be visible, relative to the eye, world axes.
fn anything(view: &View) -> Vec<DVec3> {
    let to_world = view.camera_from_world.transpose();
    let points = samples::receivers(view, &Polytope::frustum(view, f64::INFINITY), 4000);
    points.into_iter().map(|point| to_world * point).collect()
}

#[test]
fn a_case_that_fits_nothing_takes_nothing() {
    let view = walker(0.0, 10.0);
    let (_, histogram) = look(&view);
    let bounds = boxes();
    let seen = Seen {
        volumes_world: &bounds,
        casters_world: Some(bounds[0]),
        near_hint_metres: Some(2.0),
        depth: Some(&histogram),
    };
    for case in cases(Fit::None) {
        let light = sun(toward(40.0, 30.0));
        let plain = plan(&case, &view, &light, &SceneBounds::default()).unwrap();
        let told = plan_seen(&case, &view, &light, &SceneBounds::default(), &seen).unwrap();
        assert_eq!(plain, told);
    }
    // Nothing known is nothing fitted, and so is depth that makes no sense.
    let nonsense = [
        DepthHistogram::empty(&view),
        DepthHistogram { nearest_metres: f64::NAN, ..histogram },
        DepthHistogram { nearest_metres: 5.0, farthest_metres: 2.0, ..histogram },
    ];
    for fit in FITS {
        for case in cases(fit) {
            let light = sun(toward(40.0, 30.0));
            let bounds = SceneBounds::default();
            let none = LightCase { fit: Fit::None, ..case.clone() };
            let plain = plan(&none, &view, &light, &bounds).unwrap();
            assert_eq!(plain, plan(&case, &view, &light, &bounds).unwrap());
            for depth in &nonsense {
                let seen = Seen { depth: Some(depth), ..Seen::default() };
                assert_eq!(plain, plan_seen(&case, &view, &light, &bounds, &seen).unwrap());
            }
        }
    }
}

#[test]
fn late_depth_never_leaves_a_receiver_without_texels() {
    let mut random = Random::new(7);
    let now = walker(0.0, 0.0);
    let light_directions: Vec<DVec3> = (0..6).map(|_| random.direction()).collect();
    for yaw in [0.0, 3.0, 90.0, 180.0] {
        let then = walker(4.0, yaw);
        let histogram = DepthHistogram { latency_frames: 2, ..look(&then).1 };
        let seen = Seen { depth: Some(&histogram), ..Seen::default() };
        for case in cases(Fit::Histogram).into_iter().chain(cases(Fit::DepthMinMax)) {
            for toward_light in &light_directions {
                let (light, bounds) = (sun(*toward_light), SceneBounds::default());
                let none = LightCase { fit: Fit::None, ..case.clone() };
                let whole = plan(&none, &now, &light, &bounds).unwrap();
                let fitted = plan_seen(&case, &now, &light, &bounds, &seen).unwrap();
                for point in anything(&now) {
                    assert!(
                        is_covered(&fitted, point) || !is_covered(&whole, point),
                        "{yaw} {} {point} {toward_light}",
                        fitted.choice
                    );
                }
            }
        }
    }
}

#[test]
fn late_depth_of_elsewhere_costs_little() {
    let now = walker(0.0, 0.0);
    let (points, _) = look(&now);
    for yaw in [90.0, 180.0] {
        let histogram = DepthHistogram { latency_frames: 1, ..look(&walker(0.0, yaw)).1 };
        let seen = Seen { depth: Some(&histogram), ..Seen::default() };
        for case in cases(Fit::Histogram) {
            for azimuth in [20.0, 100.0, 170.0] {
                let (light, bounds) = (sun(toward(35.0, azimuth)), SceneBounds::default());
                let none = LightCase { fit: Fit::None, ..case.clone() };
                let plain = p95(&plan(&none, &now, &light, &bounds).unwrap(), &now, &points);
                let fitted = plan_seen(&case, &now, &light, &bounds, &seen).unwrap();
                let ratio = p95(&fitted, &now, &points) / plain;
                println!(
                    "elsewhere {yaw} {azimuth} {:?} {ratio:.2}",
                    case.distribution.as_ref().map(|word| word.name)
                );
                assert!(ratio < 1.5, "{} {yaw} {azimuth}: {ratio}", fitted.choice);
            }
        }
    }
}

#[test]
fn what_is_in_a_volume_or_measured_now_keeps_its_texels_and_gains() {
    let bounds = boxes();
    for yaw in [0.0, 25.0, -60.0] {
        let view = walker(0.0, yaw);
        let (points, histogram) = look(&view);
        let volumes = Seen::volumes(&bounds);
        let measured = Seen { depth: Some(&histogram), ..Seen::default() };
        let late = DepthHistogram { latency_frames: 1, ..histogram };
        let late = Seen { depth: Some(&late), ..Seen::default() };
        // Largest ratio of the mean footprint to that without a fit, and of its 95th percentile.
        for (fit, seen, limits) in [
            (Fit::Bounds, volumes, (0.95, 1.5)),
            (Fit::Histogram, measured, (0.95, 1.2)),
            (Fit::Histogram, late, (1.2, 1.6)),
        ] {
            for case in cases(fit) {
                for azimuth in [20.0, 100.0, 170.0] {
                    let (light, nowhere) = (sun(toward(35.0, azimuth)), SceneBounds::default());
                    let none = LightCase { fit: Fit::None, ..case.clone() };
                    let plain = plan(&none, &view, &light, &nowhere).unwrap();
                    let fitted = plan_seen(&case, &view, &light, &nowhere, &seen).unwrap();
                    for point in &points {
                        assert!(is_covered(&fitted, *point), "{fit:?} {yaw} {azimuth} {}", fitted.choice);
                    }
                    let ratio = |of: fn(&ShadowPlan, &View, &[DVec3]) -> f64| {
                        of(&fitted, &view, &points) / of(&plain, &view, &points)
                    };
                    // The four planes' triangles are not fitted, only dropped.
                    // One perspective gains where its focus is put at the expense of what lies beyond.
                    let name = case.distribution.as_ref().map(|word| word.name);
                    let limits = match name {
                        Some("perspective") => (limits.0, 1.8),
                        Some(_) => limits,
                        None => (1.01, 1.01),
                    };
                    let (mean, p95) = (ratio(mean), ratio(p95));
                    println!("{fit:?} {} {yaw} {azimuth} {name:?} {mean:.2} {p95:.2}", seen.depth.is_some());
                    assert!(mean < limits.0 && p95 < limits.1, "{fit:?} {}: {mean} {p95}", fitted.choice);
                }
            }
        }
    }
}

#[test]
fn a_volume_that_lies_leaves_receivers_without_texels() {
    // The negative control of coverage: only the wall is told of, the ground is left out.
    let (view, bounds) = (walker(0.0, 0.0), boxes());
    let (points, _) = look(&view);
    let case = case("face_columns", "bands", Fit::Bounds);
    let light = sun(toward(35.0, 100.0));
    let plan =
        plan_seen(&case, &view, &light, &SceneBounds::default(), &Seen::volumes(&bounds[..1])).unwrap();
    assert!(points.iter().any(|point| !is_covered(&plan, *point)));
}

#[test]
fn bins_are_quarters_of_octaves() {
    assert_eq!((bin(0.5), bin(1.0), bin(1.24), bin(1.25), bin(2.0)), (0, 0, 0, 1, 4));
    assert_eq!((bin(f32::MAX), bin(f32::INFINITY), bin(f32::NAN)), (BINS - 1, BINS - 1, 0));
    for index in 0..BINS - 1 {
        let (low, high) = bin_range_metres(index, 0.5);
        assert_eq!(bin((low / 0.5) as f32), index);
        assert_eq!(bin((0.999 * high / 0.5) as f32), index);
    }
}

/// Largest relative change of p95 on a path whose plans are told depth as a filter over frames gives it.
fn worst_step(case: &LightCase, views: &[View], rate: f64, light: DVec3) -> (f64, usize) {
    let mut known: Option<DepthHistogram> = None;
    let mut before: Option<f64> = None;
    let mut worst = (0.0, 0);
    for (step, view) in views.iter().enumerate() {
        let (points, measured) = look(view);
        let late = known.map(|known| DepthHistogram { latency_frames: 1, ..known });
        let seen = Seen { depth: late.as_ref(), ..Seen::default() };
        let plan = plan_seen(case, view, &sun(light), &SceneBounds::default(), &seen).unwrap();
        let p95 = p95(&plan, view, &points);
        let change = before.map_or(0.0, |before: f64| (p95 / before - 1.0).abs());
        // The first frames know nothing, then something.
        if step > 2 && change > worst.0 {
            worst = (change, step);
        }
        before = Some(p95);
        known = Some(known.map_or(measured, |known| known.blended(&measured, rate)));
    }
    worst
}

#[test]
fn plans_told_of_late_depth_do_not_pop() {
    let turning: Vec<View> = (0..40).map(|step| walker(0.0, 8.0 + 0.1 * f64::from(step))).collect();
    let walking: Vec<View> = (0..40).map(|step| walker(0.01 * f64::from(step), 20.0)).collect();
    for case in cases(Fit::Histogram) {
        let plain = LightCase { fit: Fit::None, ..case.clone() };
        for views in [&turning, &walking] {
            let light = toward(35.0, 100.0);
            let (worst, step) = worst_step(&case, views, 0.1, light);
            let (usual, _) = worst_step(&plain, views, 0.1, light);
            println!("{:?} {:.3} % (none: {:.3} %)", case.distribution, 100.0 * worst, 100.0 * usual);
            assert!(worst < 0.05, "{:?} {worst} at {step}, without fit {usual}", case.configurations);
        }
    }
}
