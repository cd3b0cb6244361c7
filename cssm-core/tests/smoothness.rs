//! Face columns change smoothly: along every path of the light or the camera, through general, border and dueling
//! positions, the 95th percentile of the volume footprint changes by less than a twentieth in a tenth of a degree.
//!
//! With a directional light and receivers anywhere, a plan depends on the light's direction in camera axes alone, so
//! paths on that sphere are all paths; some are walked by turning the camera all the same. `CSSM_FULL=1` walks whole
//! sweeps and prints the worst steps.

mod support;

use std::f64::consts::PI;

use cssm_core::footprint::{quantile, volume};
use cssm_core::glam::{DMat3, DQuat, DVec3};
use cssm_core::receivers::Polytope;
use cssm_core::samples::{self, SAMPLED_HORIZON_METRES};
use cssm_core::{LightCase, SceneBounds, View, plan};
use support::{Random, level_view, sun, toward};

/// Largest change of p95 in one step.
const LIMIT: f64 = 0.05;
/// The same for four bands, at corners of the view.
const COARSE_LIMIT: f64 = 0.07;
/// Length of a step, degrees.
const STEP_DEGREES: f64 = 0.1;

/// A view with the samples by which every plan on a path is measured.
struct Meter {
    name: &'static str,
    view: View,
    /// Camera axes.
    points: Vec<DVec3>,
}

impl Meter {
    fn new(name: &'static str, view: View, count: usize) -> Self {
        let far = view.far_metres.min(SAMPLED_HORIZON_METRES);
        let points = samples::receivers(&view, &Polytope::frustum(&view, far), count);
        Self { name, view, points }
    }

    /// p95 in pixels with the camera turned; a sample without a facet counts as infinite.
    fn p95(&self, case: &LightCase, pose: &Pose) -> f64 {
        let view = View { camera_from_world: pose.camera_from_world, ..self.view };
        let plan = plan(case, &view, &sun(pose.toward_light), &SceneBounds::default()).unwrap();
        let world_from_camera = view.camera_from_world.transpose();
        let footprint = |point: &DVec3| {
            let point = world_from_camera * *point;
            let facet = plan.facet(plan.selection.cell(point.extend(1.0)));
            facet.map_or(f64::INFINITY, |facet| volume(facet, &view, point).major_pixels)
        };
        let mut pixels: Vec<f64> = self.points.iter().map(footprint).collect();
        pixels.sort_by(f64::total_cmp);
        quantile(&pixels, 0.95)
    }

    fn corners(&self) -> [DVec3; 4] {
        self.view.corner_tangents().map(|(x, y)| DVec3::new(x, y, -1.0))
    }
}

/// Camera and light of one step.
#[derive(Debug, Clone, Copy)]
struct Pose {
    camera_from_world: DMat3,
    toward_light: DVec3,
}

/// A named path in steps of at most [`STEP_DEGREES`].
struct Path {
    name: String,
    poses: Vec<Pose>,
}

impl Path {
    /// The light moves, the camera stands.
    fn of_light(name: String, lights: impl Iterator<Item = DVec3>) -> Self {
        let pose = |toward_light| Pose { camera_from_world: DMat3::IDENTITY, toward_light };
        Self { name, poses: lights.map(pose).collect() }
    }

    /// The camera turns about an axis of its own, the light stands.
    fn of_camera(name: &str, axis: DVec3, degrees: f64, light: DVec3) -> Self {
        let pose = |step: u32| {
            let turn = DMat3::from_axis_angle(axis, (f64::from(step) * STEP_DEGREES).to_radians());
            Pose { camera_from_world: turn, toward_light: light }
        };
        Self { name: name.into(), poses: (0..steps(degrees)).map(pose).collect() }
    }

    /// The light moves about an axis, through a direction in the middle.
    fn across(name: String, middle: DVec3, axis: DVec3, degrees: f64) -> Self {
        let (count, axis) = (steps(degrees), axis.normalize());
        let light = move |step: u32| {
            let angle = (f64::from(step) - 0.5 * f64::from(count) + 0.37) * STEP_DEGREES;
            DQuat::from_axis_angle(axis, angle.to_radians()) * middle
        };
        Self::of_light(name, (0..count).map(light))
    }
}

fn steps(degrees: f64) -> u32 {
    (degrees / STEP_DEGREES) as u32
}

/// Relative changes of a series, with the step each happens at.
fn changes(series: &[f64]) -> Vec<(f64, usize)> {
    let change = |(step, pair): (usize, &[f64])| ((pair[1] / pair[0] - 1.0).abs(), step);
    series.windows(2).enumerate().map(change).collect()
}

/// Largest change of a series; a value that is no number is the largest.
fn worst(series: &[f64]) -> (f64, usize) {
    changes(series).into_iter().max_by(|one, two| one.0.total_cmp(&two.0)).unwrap_or_default()
}

fn full() -> bool {
    std::env::var_os("CSSM_FULL").is_some()
}

fn meters() -> Vec<Meter> {
    let count = if full() { 2000 } else { 800 };
    let view = |size: (u32, u32), near: f64, far: f64| {
        View::perspective(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 60_f64.to_radians(), near, far, size).unwrap()
    };
    vec![
        Meter::new("square", level_view(0.2, 1000.0), count),
        Meter::new("wide", view((1920, 1080), 0.2, 1000.0), count),
        Meter::new("infinite", view((1920, 1080), 0.2, f64::INFINITY), count),
        Meter::new("deep", view((1080, 1080), 0.1, 1e4), count),
    ]
}

fn case(bands: u32) -> LightCase {
    LightCase::builder("Smooth").configurations(&["face_columns"]).bands(bands, 1e5).build().unwrap()
}

/// Walks paths, prints the worst steps in a full run, and refuses any over the limit.
fn assert_smooth(meter: &Meter, bands: u32, paths: &[Path]) {
    let case = case(bands);
    let limit = if bands < 8 { COARSE_LIMIT } else { LIMIT };
    let (mut all, mut largest) = (Vec::new(), (0.0, String::new()));
    for path in paths {
        let series: Vec<f64> = path.poses.iter().map(|pose| meter.p95(&case, pose)).collect();
        let (change, step) = worst(&series);
        let place = format!(
            "{} {}, step {step}: {:.3} px to {:.3} px",
            meter.name,
            path.name,
            series[step],
            series[step + 1]
        );
        if full() && change > 0.02 {
            println!("{:5.2} % {place}", 100.0 * change);
        }
        assert!(change < limit, "{bands} bands, {place}");
        all.extend(changes(&series).into_iter().map(|(change, _)| change));
        if change > largest.0 {
            largest = (change, place);
        }
    }
    all.sort_by(f64::total_cmp);
    let percent = |share: f64| 100.0 * quantile(&all, share);
    println!(
        "{} bands {bands}: {} steps, median {:.3} %, p99 {:.2} %, largest {:.2} % ({})",
        meter.name,
        all.len(),
        percent(0.5),
        percent(0.99),
        percent(1.0),
        largest.1
    );
}

/// Short stretches across the planes of the view's side faces, where faces come and go: inside the face, where light
/// enters the view, and outside it, where the face is seen edge on; at corners; and anywhere.
fn crossings(meter: &Meter, degrees: f64, random: &mut Random) -> Vec<Path> {
    let corners = meter.corners();
    let mut paths = Vec::new();
    for k in 0..4 {
        let (one, two) = (corners[k], corners[(k + 1) % 4]);
        for (a, b) in [(1.0, 1.0), (1.0, 0.2), (1.0, 0.0), (1.0, -0.3), (1.0, -0.8), (-0.6, 1.0)] {
            let side = if random.unit() < 0.5 { 1.0 } else { -1.0 };
            let middle = (one * a + two * b).normalize() * side;
            let along = one.cross(two).cross(middle);
            paths.push(Path::across(format!("face {k} at {a} {b}"), middle, along, degrees));
        }
    }
    for index in 0..6 {
        let (middle, axis) = (random.direction(), random.direction());
        paths.push(Path::across(format!("anywhere {index}"), middle, axis.cross(middle), 2.0 * degrees));
    }
    paths
}

#[test]
fn face_columns_change_smoothly_where_faces_come_and_go() {
    let mut random = Random::new(4);
    for meter in meters() {
        let degrees = if full() { 6.0 } else { 0.8 };
        assert_smooth(&meter, 8, &crossings(&meter, degrees, &mut random));
        if meter.name == "square" || full() {
            for bands in [4, 16] {
                assert_smooth(&meter, bands, &crossings(&meter, degrees, &mut random));
            }
        }
    }
}

#[test]
fn face_columns_change_smoothly_along_sweeps() {
    let azimuths = [0.0, 20.0, 45.0, 90.0, 130.0, 160.0, 180.0, 217.0, 300.0];
    let elevations = [-40.0, 2.0, 12.0, 22.0, 29.0, 33.0, 45.0, 65.0];
    let mut paths = Vec::new();
    if full() {
        let rising = |azimuth: f64| {
            let light = move |step: u32| toward(0.1 + f64::from(step) * STEP_DEGREES, azimuth);
            Path::of_light(format!("azimuth {azimuth}"), (0..steps(89.8)).map(light))
        };
        let circling = |elevation: f64| {
            let light = move |step: u32| toward(elevation, f64::from(step) * STEP_DEGREES);
            Path::of_light(format!("elevation {elevation}"), (0..steps(360.0)).map(light))
        };
        paths.extend(azimuths.map(rising));
        paths.extend(elevations.map(circling));
        for (name, axis) in [("yaw", DVec3::Y), ("pitch", DVec3::X), ("roll", DVec3::Z)] {
            for (elevation, azimuth) in [(50.0, 30.0), (25.0, 200.0)] {
                let name = format!("{name} with light at {elevation} {azimuth}");
                paths.push(Path::of_camera(&name, axis, 360.0, toward(elevation, azimuth)));
            }
        }
        for meter in meters() {
            assert_smooth(&meter, 8, &paths);
        }
        return;
    }

    // The light and the camera where the layout once flipped between partitions, and a little of each kind.
    let rising = |elevation: f64, azimuth: f64| {
        let light = move |step: u32| toward(elevation + f64::from(step) * STEP_DEGREES, azimuth);
        Path::of_light(format!("azimuth {azimuth} from {elevation}"), (0..steps(4.0)).map(light))
    };
    paths.push(rising(18.5, 130.0));
    paths.extend([(20.0, 45.0), (8.0, 70.0), (28.0, 0.0), (28.0, 180.0)].map(|(e, a)| rising(e, a)));
    for (name, axis) in [("yaw", DVec3::Y), ("pitch", DVec3::X), ("roll", DVec3::Z)] {
        paths.push(Path::of_camera(name, axis, 8.0, toward(45.0, 26.0)));
    }
    assert_smooth(&meters()[0], 8, &paths);
}

#[test]
fn the_measure_sees_a_layout_that_pops() {
    // Two declared foldings, each smooth, one taken over by the other halfway.
    let meter = &meters()[0];
    let folded = |strips: u32| {
        let builder = LightCase::builder("Folded").configurations(&["face_columns"]);
        builder.bands(8, 1e5).map_columns(strips).build().unwrap()
    };
    let path = Path::of_camera("yaw", DVec3::Y, 2.0, toward(50.0, 100.0));
    let series = |strips: [u32; 2]| -> Vec<f64> {
        let cases = strips.map(folded);
        let half = path.poses.len() / 2;
        let pose = |(step, pose): (usize, &Pose)| meter.p95(&cases[step / half], pose);
        path.poses.iter().enumerate().map(pose).collect()
    };
    assert!(worst(&series([4, 4])).0 < LIMIT && worst(&series([8, 8])).0 < LIMIT);
    let (change, step) = worst(&series([4, 8]));
    assert!(change > LIMIT && step + 1 == path.poses.len() / 2, "{change} at {step}");

    // A series with one value off, up or down, or missing.
    for off in [1.06, 0.94, f64::INFINITY, f64::NAN] {
        let mut smooth: Vec<f64> = (0..200).map(|k| 3.0 + 0.2 * (f64::from(k) * PI / 100.0).sin()).collect();
        assert!(worst(&smooth).0 < LIMIT);
        smooth[120] *= off;
        let within = worst(&smooth).0 < LIMIT;
        assert!(!within, "{off}");
    }
}
