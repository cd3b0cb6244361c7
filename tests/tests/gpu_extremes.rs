//! The extremes on the device: depth ranges to infinity, fields of view from 1 to 170 degrees, images a tenth as wide as
//! high, lights along every special direction and a hair off it, ten thousand kilometres from the origin. The
//! generated resolve shaders place the very positions that f64 places.
//!
//! The normal run samples the sweep; `CSSM_FULL=1` runs all of it.

use cssm_codegen::generate;
use cssm_core::footprint::quantile;
use cssm_core::glam::{DVec2, DVec3, DVec4, Vec3};
use cssm_core::homography::{Gradients, singular_values};
use cssm_core::table::{CaseTable, Meaning, RecordKind, write_shadow_record};
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use cssm_tests::gpu::exclusive;
use cssm_tests::gpu::place_probe::{PLANS, PlaceProbe, Placed};
use cssm_tests::random::Random;
use shaders_gen::shipped;

/// Largest coordinate error in texels.
const TEXEL_LIMIT: f64 = 5e-3;
/// Depth error in texels along the light that one receiver in a hundred may exceed.
const DEPTH_LIMIT: f64 = 1e-3;
/// The same at one degree of view, where the range is a hundred thousand texels deep and floats hold no more.
const NARROW_DEPTH_LIMIT: f64 = 1e-2;
/// Share of receivers beyond the depth limit.
const DEPTH_SHARE: f64 = 0.01;
/// Receivers of each plan.
const POINTS: usize = 1024;
/// One situation in this many is taken in the normal run.
const SAMPLED: u64 = 24;

/// A view, a light, and what makes them a shipped case's situation.
struct Situation {
    view: View,
    toward_light_world: DVec3,
    reach_metres: f64,
}

impl Situation {
    fn narrow(&self) -> bool {
        (self.view.right - self.view.left).min(self.view.top - self.view.bottom) < 0.1
    }

    fn depth_limit(&self) -> f64 {
        if self.narrow() { NARROW_DEPTH_LIMIT } else { DEPTH_LIMIT }
    }

    fn plan(&self, case: &LightCase) -> ShadowPlan {
        // What cannot fit infinity gets the reach; the others really see it.
        let mut case = case.clone();
        let bounded = !case.technique_spec().fits_infinity;
        case.shadow_distance_metres = bounded.then_some(self.reach_metres);
        let light = Light::directional_travelling(-self.toward_light_world).unwrap();
        plan(&case, &self.view, &light, &SceneBounds::default())
            .unwrap_or_else(|error| panic!("{}: {error}: {self}", case.name))
    }

    /// Receivers in camera axes as shaders get them; some of them on borders of facets, up to 8 ulp off.
    fn receivers(&self, plan: &ShadowPlan, random: &mut Random) -> Vec<Vec3> {
        let view = &self.view;
        let borders = border_rows(plan);
        let mut receivers = Vec::with_capacity(POINTS);
        while receivers.len() < POINTS {
            let depth = view.near_metres * (self.reach_metres / view.near_metres).powf(random.unit());
            let x = random.unit() * f64::from(view.size_pixels.0);
            let y = random.unit() * f64::from(view.size_pixels.1);
            let mut point = view.ray_world(x, y) * depth;
            if random.below(4) == 0
                && let Some(row) = borders.get(random.below(borders.len()))
            {
                point -= row.truncate() * (row.dot(point.extend(1.0)) / row.truncate().length_squared());
            }
            let mut ulp = || 1.0 + (random.below(17) as f64 - 8.0) * f64::from(f32::EPSILON);
            let camera = view.camera_from_world * point * DVec3::new(ulp(), ulp(), ulp());
            let camera = camera.as_vec3();
            if self.sees(camera.as_dvec3()) {
                receivers.push(camera);
            }
        }
        receivers
    }

    fn sees(&self, camera: DVec3) -> bool {
        let (view, depth) = (&self.view, -camera.z);
        (view.near_metres..=self.reach_metres * 0.999).contains(&depth)
            && (view.left..=view.right).contains(&(camera.x / depth))
            && (view.bottom..=view.top).contains(&(camera.y / depth))
    }
}

impl std::fmt::Display for Situation {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let View { near_metres, far_metres, size_pixels, eye_world, .. } = self.view;
        let fov = (2.0 * self.view.top.atan()).to_degrees();
        let light = self.view.camera_from_world * self.toward_light_world;
        write!(
            f,
            "{near_metres} to {far_metres} m, {fov:.0} degrees, {size_pixels:?}, eye {eye_world}, light {light}"
        )
    }
}

/// Rows that are zero on the borders between facets.
fn border_rows(plan: &ShadowPlan) -> Vec<DVec4> {
    let selection = &plan.selection;
    let mut rows: Vec<DVec4> = selection.borders.iter().copied().filter(|row| row.w == 0.0).collect();
    for (row, limits) in selection.distances.iter().zip(&selection.thresholds) {
        let limits = limits.iter().filter(|limit| **limit < 1e12);
        rows.extend(limits.map(|limit| *row - DVec4::W * *limit));
    }
    rows.retain(|row| row.truncate() != DVec3::ZERO);
    rows
}

/// Every view with every light: 54 times 48.
fn situations() -> Vec<Situation> {
    let mut random = Random(11);
    let mut situations = Vec::new();
    for (near, far) in [(0.1, 1e6), (1e-4, 1e3), (0.1, f64::INFINITY)] {
        for fov in [1.0, 60.0, 170.0_f64] {
            for size in [(100, 1000), (1000, 700), (2000, 200)] {
                for origin in [0.0, 1e7] {
                    let eye = DVec3::new(1.0, -0.5, 0.7) * origin;
                    let target = eye + DVec3::new(0.3, -0.1, -1.0);
                    let view = View::perspective(eye, target, DVec3::Y, fov.to_radians(), near, far, size);
                    let view = view.unwrap();
                    let reach_metres = far.min(1e6 * near);
                    situations.extend(
                        lights(&view, &mut random).into_iter().map(|toward_light_world| Situation {
                            view,
                            toward_light_world,
                            reach_metres,
                        }),
                    );
                }
            }
        }
    }
    situations
}

/// Along the axis, an edge, a corner and the near plane of a view, ahead and behind, exactly and a hair off.
fn lights(view: &View, random: &mut Random) -> Vec<DVec3> {
    let to_world = view.camera_from_world.transpose();
    let corner = DVec3::new(view.right, view.top, -1.0);
    let edge = DVec3::new(0.3 * view.left, view.top, -1.0);
    let mut lights = Vec::new();
    for special in [DVec3::NEG_Z, edge, corner, DVec3::new(0.6, 0.8, 0.0)] {
        for offset in [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2] {
            for sign in [1.0, -1.0] {
                let (turn, height) = (std::f64::consts::TAU * random.unit(), 2.0 * random.unit() - 1.0);
                let level = (1.0 - height * height).sqrt();
                let anywhere = DVec3::new(level * turn.cos(), height, level * turn.sin());
                let camera = (special.normalize() + anywhere * offset) * sign;
                lights.push((to_world * camera).normalize());
            }
        }
    }
    lights
}

/// How a case fares in a group of situations.
#[derive(Debug, Clone, Default)]
struct Found {
    plans: u64,
    receivers: u64,
    /// Plans for lights that their configuration is not made for.
    degraded: u64,
    /// Receivers for which f32 chose another facet than f64.
    other_facet: u64,
    /// Receivers without a facet, outside their tile or not covered, and where.
    lost: u64,
    lost_place: String,
    /// Largest error across the map, texels, and where.
    texels: f64,
    texels_place: String,
    /// Receivers whose depth is judged, those beyond the limit; largest 99th percentile of one plan.
    depths: u64,
    beyond: u64,
    depth_p99_texels: f64,
}

impl Found {
    fn share_beyond(&self) -> f64 {
        self.beyond as f64 / self.depths.max(1) as f64
    }

    /// Judges what the device found for the receivers of one plan.
    fn add(&mut self, situation: &Situation, plan: &ShadowPlan, receivers: &[Vec3], placed: &[Placed]) {
        self.plans += 1;
        let mut depths = Vec::with_capacity(receivers.len());
        for (receiver, placed) in receivers.iter().zip(placed) {
            let camera = receiver.as_dvec3();
            let point = plan.camera_from_world.transpose() * camera;
            let homogeneous = point.extend(1.0);
            let own = plan.selection.facet(homogeneous);
            self.receivers += 1;
            self.other_facet += u64::from(placed.facet != own);
            let facet = plan.facet(placed.facet);
            let inside = facet.is_some_and(|facet| {
                let exact = Gradients::at(&facet.rows, point);
                exact.w > 0.0 && exact.ndc.truncate().abs().max_element() <= 1.0
            });
            let (Some(facet), true) = (facet, inside && placed.covered) else {
                self.lost += 1;
                self.lost_place = format!("{situation}, receiver {camera}, own facet {own}, {placed:?}");
                continue;
            };

            // Across the map.
            let exact = Gradients::at(&facet.rows, point);
            let texel = DVec2::from(facet.tile.texel_from_ndc(exact.ndc.x, exact.ndc.y));
            let error = (placed.texel - texel).abs().max_element();
            if error > 5e-3 && error > self.texels {
                let sheared = plan.capture_from_world() * point;
                println!("{error:.1e} shear {:?} camera {camera} sheared {sheared} gpu {} own {own} facet {} order {:?} w {} {} tex {} {}", plan.shear, placed.pt, placed.facet, plan.depth_order, exact.w, placed.w, texel, placed.texel);
                let sh = plan.shear; let c = plan.camera_from_world; let row=|r: DVec4| { let q = c * r.truncate(); DVec3::new(q.x,q.y,q.z - sh.dot(q.truncate())) };
                println!("   rows x {} {} y {} w {} {}", row(facet.rows.x), facet.rows.x.w, row(facet.rows.y), row(facet.rows.w), facet.rows.w.w);
            }
            if error.is_nan() || error > self.texels {
                (self.texels, self.texels_place) = (error, format!("{situation}, receiver {camera}"));
            }

            // Along the light, in metres over the texel there.
            if (-0.01..=1.01).contains(&exact.ndc.z) {
                let (width, height) = (f64::from(facet.tile.width), f64::from(facet.tile.height));
                let (across, up) = exact.across_light();
                let texel = singular_values(across * (2.0 / width), up * (2.0 / height));
                let error = (placed.signed_depth - plan.depth_order.sign() * exact.ndc.z).abs();
                depths.push(error * exact.w / facet.depth_per_metre / texel.0);
            }
        }
        let limit = situation.depth_limit();
        self.depths += depths.len() as u64;
        self.beyond += depths.iter().filter(|depth| depth.is_nan() || **depth > limit).count() as u64;
        depths.sort_by(f64::total_cmp);
        if !depths.is_empty() {
            self.depth_p99_texels = self.depth_p99_texels.max(quantile(&depths, 0.99));
        }
    }
}

/// A plan that the device evaluates.
struct Job<'a> {
    situation: &'a Situation,
    plan: ShadowPlan,
    receivers: Vec<Vec3>,
}

impl<'a> Job<'a> {
    fn new(case: &LightCase, situation: &'a Situation, random: &mut Random) -> Self {
        let plan = situation.plan(case);
        let receivers = situation.receivers(&plan, random);
        Self { situation, plan, receivers }
    }
}

/// A shipped case behind the probe.
struct Shipped {
    case: LightCase,
    table: CaseTable,
}

impl Shipped {
    fn parse(text: &str) -> Self {
        let case = cssm_codegen::dsl::parse_file("case.cssm", text).unwrap().remove(0);
        let table = generate(&case).unwrap().table;
        assert_eq!((case.map.width, case.map.height), (2048, 2048));
        Self { case, table }
    }

    /// Evaluates jobs on the device, with records as written by `write`; results for 60 and 170 degrees, then for 1.
    fn judge(
        &self,
        probe: &PlaceProbe<'_>,
        jobs: &[Job<'_>],
        write: &dyn Fn(&CaseTable, &ShadowPlan) -> Vec<u8>,
    ) -> [Found; 2] {
        let mut found = [Found::default(), Found::default()];
        for jobs in jobs.chunks(PLANS) {
            let records: Vec<_> = jobs.iter().map(|job| write(&self.table, &job.plan)).collect();
            let positions: Vec<_> = jobs.iter().map(|job| job.receivers.clone()).collect();
            for (job, placed) in jobs.iter().zip(probe.place(&records, &positions)) {
                let found = &mut found[usize::from(job.situation.narrow())];

                // A configuration that answers for a light it is not made for only has to answer.
                if job.plan.choice.made_for_position.is_empty() {
                    found.add(job.situation, &job.plan, &job.receivers, &placed);
                } else {
                    found.degraded += 1;
                    assert_finite(job, &placed);
                }
            }
        }
        found
    }
}

/// Where a receiver has a facet, the device has numbers for it.
fn assert_finite(job: &Job<'_>, placed: &[Placed]) {
    for placed in placed.iter().filter(|placed| job.plan.facet(placed.facet).is_some()) {
        let numbers = [placed.texel.x, placed.texel.y, placed.signed_depth, placed.w];
        assert!(numbers.iter().all(|number| number.is_finite()), "{}: {placed:?}", job.situation);
    }
}

#[test]
fn the_device_places_receivers_where_f64_does() {
    let full = std::env::var_os("CSSM_FULL").is_some();
    let (gpu, situations) = (exclusive(), situations());
    let mut random = Random(29);
    let mut all = Vec::new();
    println!(
        "worst error across the map in texels; along the light in texels: worst p99 of a plan, share of all"
    );
    println!("receivers beyond {DEPTH_LIMIT} ({NARROW_DEPTH_LIMIT} at 1 degree)");
    println!("{:<16}{:>7}{:^34}{:^34}{:>14}", "", "plans", "60 and 170 degrees", "1 degree", "other facet");
    for text in shipped::ALL {
        let shipped = Shipped::parse(text);
        let probe = PlaceProbe::new(&gpu, &shipped.table);
        let mut found = [Found::default(), Found::default()];
        let sampled: Vec<_> =
            situations.iter().filter(|_| full || random.bits().is_multiple_of(SAMPLED)).collect();
        let jobs: Vec<_> =
            sampled.iter().map(|situation| Job::new(&shipped.case, situation, &mut random)).collect();
        found.clone_from_slice(&shipped.judge(&probe, &jobs, &write_shadow_record));

        let figures = |found: &Found| {
            let share = 100.0 * found.share_beyond();
            format!("{:>12.1e}{:>10.1e}{share:>10.3} %", found.texels, found.depth_p99_texels)
        };
        let [wide, narrow] = &found;
        let other = wide.other_facet + narrow.other_facet;
        let receivers = wide.receivers + narrow.receivers;
        println!(
            "{:<16}{:>7}{}{}{other:>8} of {receivers}, {} degraded, {} lost",
            shipped.case.name,
            jobs.len(),
            figures(wide),
            figures(narrow),
            wide.degraded + narrow.degraded,
            wide.lost + narrow.lost
        );
        all.extend(found.map(|found| (shipped.case.name.clone(), found)));
    }
    for (case, found) in all {
        assert!(found.plans > 0, "{case}");
        assert!(found.lost == 0, "{case}: {} lost: {}", found.lost, found.lost_place);
        assert!(found.texels <= TEXEL_LIMIT, "{case}: {} texels: {}", found.texels, found.texels_place);
        assert!(found.share_beyond() <= DEPTH_SHARE, "{case}: {found:?}");
    }
}
