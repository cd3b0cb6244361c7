//! The extremes on the device: the generated resolve functions place the very positions that f64 places, and the
//! capture draws casters where the functions look for them.
//!
//! The normal run samples the sweep; `CSSM_FULL=1` runs all of it.

use cssm_codegen::generate;
use cssm_core::facet::Facet;
use cssm_core::footprint::quantile;
use cssm_core::glam::{DAffine3, DMat3, DVec2, DVec3, Vec3};
use cssm_core::homography::{Gradients, singular_values};
use cssm_core::table::{CaseTable, Meaning, Record, RecordKind, write_shadow_record};
use cssm_core::twin::{DepthMap, capture};
use cssm_core::{LightCase, ShadowPlan};
use cssm_runtime::{CasterInstance, Options, ShadowService};
use cssm_tests::gpu::extremes::{BORDER_EVERY, Situation};
use cssm_tests::gpu::place_probe::{PLANS, PlaceProbe, Placed};
use cssm_tests::gpu::{Geometry, TestDevice, exclusive};
use cssm_tests::random::Random;
use shaders_gen::shipped;

/// Largest coordinate error in texels.
const TEXEL_LIMIT: f64 = 5e-3;
/// Depth error in texels along the light that one receiver in a hundred may exceed.
const DEPTH_LIMIT: f64 = 1e-3;
/// The same at one degree of view, where the range is a hundred thousand texels deep and floats hold no more.
const NARROW_DEPTH_LIMIT: f64 = 1e-2;
/// Share of receivers beyond the depth limit.
const DEPTH_SHARE: f64 = 0.015;
/// Share of receivers on slivers of the image, thinner than rounding, that even f64 gives no facet.
const SLIVER_SHARE: f64 = 1e-4;
/// Receivers of each plan.
const POINTS: usize = 1024;
/// One situation in this many is taken in the normal run.
const SAMPLED: u64 = 24;

/// How a case fares in a group of situations.
#[derive(Debug, Clone, Default)]
struct Found {
    plans: u64,
    receivers: u64,
    /// Plans for lights that their configuration is not made for.
    degraded: u64,
    /// Receivers for which f32 chose another facet than f64, and those that f64 gives none.
    other_facet: u64,
    slivers: u64,
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
    fn add(&mut self, job: &Job<'_>, placed: &[Placed]) {
        let (situation, plan) = (job.situation, &job.plan);
        self.plans += 1;
        let mut depths = Vec::with_capacity(placed.len());
        for (number, (receiver, placed)) in job.receivers.iter().zip(placed).enumerate() {
            let point = plan.camera_from_world.transpose() * receiver.as_dvec3();
            let own = plan.selection.cell(point.extend(1.0));
            self.receivers += 1;
            if plan.facet(own).is_none() {
                self.slivers += 1;
                continue;
            }
            self.other_facet += u64::from(placed.facet != own);

            // On a border f32 may choose the neighbour, if the texel lies in its tile.
            let place = || format!("{situation}, receiver {receiver}, facet {own}, {placed:?}");
            let facet = plan.facet(placed.facet).filter(|facet| {
                let exact = Gradients::at(&facet.rows, point);
                exact.w > 0.0 && exact.ndc.truncate().abs().max_element() <= 1.0
            });
            let (Some(facet), true) = (facet, placed.covered) else {
                self.lost += 1;
                self.lost_place = place();
                continue;
            };

            // Compare across the map.
            let exact = Gradients::at(&facet.rows, point);
            let texel = DVec2::from(facet.tile.texel_from_ndc(exact.ndc.x, exact.ndc.y));
            let error = (placed.texel - texel).abs().max_element();
            if error > self.texels {
                (self.texels, self.texels_place) = (error, place());
            }

            // Compare along the light, in metres over the texel there; receivers on borders crowd around the light's own
            // ray and would weigh too much.
            if number % BORDER_EVERY != BORDER_EVERY - 1 && (-0.01..=1.01).contains(&exact.ndc.z) {
                let error = (placed.signed_depth - plan.depth_order.sign() * exact.ndc.z).abs();
                depths.push(error * exact.w / facet.depth_per_metre / texel_metres(facet, &exact));
            }
        }
        let limit = if situation.narrow() { NARROW_DEPTH_LIMIT } else { DEPTH_LIMIT };
        self.depths += depths.len() as u64;
        self.beyond += depths.iter().filter(|depth| **depth > limit || depth.is_nan()).count() as u64;
        depths.sort_by(f64::total_cmp);
        if !depths.is_empty() {
            self.depth_p99_texels = self.depth_p99_texels.max(quantile(&depths, 0.99));
        }
    }

    /// Two columns of the table.
    fn figures(&self) -> String {
        let share = 100.0 * self.share_beyond();
        format!("{:>10.1e}{:>10.1e}{share:>9.3} %", self.texels, self.depth_p99_texels)
    }
}

/// Displacements across the light by a texel to the right and by one up, metres.
fn texel_axes(facet: &Facet, exact: &Gradients) -> (DVec3, DVec3) {
    let (across, up) = exact.across_light();
    (across * (2.0 / f64::from(facet.tile.width)), up * (2.0 / f64::from(facet.tile.height)))
}

/// Larger axis of a texel across the light, metres.
fn texel_metres(facet: &Facet, exact: &Gradients) -> f64 {
    let (across, up) = texel_axes(facet, exact);
    singular_values(across, up).0
}

/// A plan that the device evaluates.
struct Job<'a> {
    situation: &'a Situation,
    plan: ShadowPlan,
    receivers: Vec<Vec3>,
}

impl Job<'_> {
    /// Where a receiver has a facet, the device has numbers for it.
    fn assert_finite(&self, placed: &[Placed]) {
        for placed in placed.iter().filter(|placed| self.plan.facet(placed.facet).is_some()) {
            let numbers = [placed.texel.x, placed.texel.y, placed.signed_depth, placed.w];
            assert!(numbers.iter().all(|number| number.is_finite()), "{}: {placed:?}", self.situation);
        }
    }
}

/// A shipped case and the jobs it has.
struct Shipped<'a> {
    case: LightCase,
    table: CaseTable,
    jobs: Vec<Job<'a>>,
}

impl<'a> Shipped<'a> {
    fn new(text: &str, situations: impl Iterator<Item = &'a Situation>, random: &mut Random) -> Self {
        let case = cssm_codegen::dsl::parse_file("case.cssm", text).unwrap().remove(0);
        let table = generate(&case).unwrap().table;
        assert_eq!((case.map.width, case.map.height), (2048, 2048));
        let job = |situation: &'a Situation| {
            let plan = situation.plan(&case);
            let receivers = situation.receivers(&plan, POINTS, random);
            Job { situation, plan, receivers }
        };
        let jobs = situations.map(job).collect();
        Self { case, table, jobs }
    }

    /// Evaluates the jobs on the device, with records by `write`; what it finds at 60 and 170 degrees, then at 1.
    fn judge(&self, gpu: &TestDevice, write: impl Fn(&CaseTable, &ShadowPlan) -> Vec<u8>) -> [Found; 2] {
        let probe = PlaceProbe::new(gpu, &self.table);
        let mut found = [Found::default(), Found::default()];
        for jobs in self.jobs.chunks(PLANS) {
            let records: Vec<_> = jobs.iter().map(|job| write(&self.table, &job.plan)).collect();
            let positions: Vec<_> = jobs.iter().map(|job| job.receivers.clone()).collect();
            for (job, placed) in jobs.iter().zip(probe.place(&records, &positions)) {
                let found = &mut found[usize::from(job.situation.narrow())];

                // A configuration that answers for a light it is not made for only has to answer.
                if job.plan.choice.made_for_position.is_empty() {
                    found.add(job, &placed);
                } else {
                    found.degraded += 1;
                    job.assert_finite(&placed);
                }
            }
        }
        found
    }
}

#[test]
fn the_device_places_receivers_where_f64_does() {
    let full = std::env::var_os("CSSM_FULL").is_some();
    let (gpu, situations, mut random) = (exclusive(), Situation::all(), Random(29));
    println!(
        "worst error across the map in texels; along the light in texels: worst p99 of a plan, share of"
    );
    println!("receivers beyond {DEPTH_LIMIT} (beyond {NARROW_DEPTH_LIMIT} at 1 degree)");
    println!("{:<16}{:>6}{:>10}{:^31}{:^31}", "", "plans", "degraded", "60 and 170 degrees", "1 degree");
    let mut all = Vec::new();
    for text in shipped::ALL.iter().filter(|text| text.contains("light: directional")) {
        let mut draws = random.clone();
        random.bits();
        let taken = situations.iter().filter(|_| full || draws.bits().is_multiple_of(SAMPLED));
        let shipped = Shipped::new(text, taken, &mut random);
        let found = shipped.judge(&gpu, write_shadow_record);
        let (name, plans) = (&shipped.case.name, shipped.jobs.len());
        let sum = |of: fn(&Found) -> u64| found.iter().map(of).sum::<u64>();
        println!(
            "{name:<16}{plans:>6}{:>10}{}{}  {} of {} receivers in another facet than in f64, {} slivers",
            sum(|found| found.degraded),
            found[0].figures(),
            found[1].figures(),
            sum(|found| found.other_facet),
            sum(|found| found.receivers),
            sum(|found| found.slivers),
        );
        all.extend(found.map(|found| (name.clone(), found)));
    }
    for (case, found) in all {
        assert!(found.plans > 0, "{case}");
        assert!(found.lost == 0, "{case}: {} lost: {}", found.lost, found.lost_place);
        assert!(found.texels <= TEXEL_LIMIT, "{case}: {} texels: {}", found.texels, found.texels_place);
        assert!(found.share_beyond() <= DEPTH_SHARE, "{case}: {found:?}");
        assert!(found.slivers as f64 <= SLIVER_SHARE * found.receivers as f64, "{case}: {found:?}");
    }
}

/// Multiplies floats of a record from an offset in bytes.
fn scale(record: &mut [u8], offset: usize, floats: usize, factor: f32) {
    for bytes in record[offset..].chunks_exact_mut(4).take(floats) {
        let value = f32::from_le_bytes(std::array::from_fn(|byte| bytes[byte])) * factor;
        bytes.copy_from_slice(&value.to_le_bytes());
    }
}

/// Offset and stride of a record's field.
fn field(record: &Record, meaning: Meaning) -> (usize, usize) {
    let field = record.fields.iter().find(|field| field.meaning == meaning).unwrap();
    (field.offset_bytes as usize, field.stride_bytes as usize)
}

#[test]
fn wrong_records_are_seen_and_the_shear_is_needed() {
    let (gpu, situations, mut random) = (exclusive(), Situation::all(), Random(31));
    let taken = situations.iter().step_by(SAMPLED as usize + 1);
    let shipped = Shipped::new(shipped::SUN, taken, &mut random);
    let facet_rows = |table: &CaseTable, meaning| {
        let (facets, stride) = field(table.record(RecordKind::Shadow).unwrap(), Meaning::Facets);
        let (row, _) = field(table.record(RecordKind::Facet).unwrap(), meaning);
        (0..table.cells() as usize).map(move |facet| facets + facet * stride + row)
    };
    type Write<'w> = &'w dyn Fn(&CaseTable, &ShadowPlan) -> Vec<u8>;
    let without_shear: Write<'_> = &|table, plan| {
        let mut record = write_shadow_record(table, plan);
        scale(&mut record, field(table.record(RecordKind::Shadow).unwrap(), Meaning::Shear).0, 4, 0.0);
        record
    };
    let without_rest: Write<'_> = &|table, plan| {
        let mut record = write_shadow_record(table, plan);
        scale(&mut record, field(table.record(RecordKind::Shadow).unwrap(), Meaning::Shear).0 + 8, 2, 0.0);
        record
    };
    let one_element: Write<'_> = &|table, plan| {
        let mut record = write_shadow_record(table, plan);
        facet_rows(table, Meaning::RowX).for_each(|row| scale(&mut record, row, 1, 1.0 + 1e-4));
        record
    };
    let plain_axes: Write<'_> =
        &|table, plan| write_shadow_record(table, &ShadowPlan { shear: DVec2::ZERO, ..plan.clone() });
    let changes = [
        ("a record without its shear", without_shear),
        ("a shear rounded to f32", without_rest),
        ("an element off by 1e-4", one_element),
        ("rows and positions in plain camera axes", plain_axes),
    ];
    let unchanged = shipped.judge(&gpu, write_shadow_record);
    assert!(unchanged.iter().all(|found| found.plans > 0 && found.texels <= TEXEL_LIMIT));
    for (what, write) in changes {
        let [wide, narrow] = shipped.judge(&gpu, write);
        println!("{what}: {:.1e} texels, at 1 degree {:.1e}", wide.texels, narrow.texels);
        assert!(wide.texels.max(narrow.texels) > 4.0 * TEXEL_LIMIT, "{what} goes unseen");
    }
}

/// Casters of each plan.
const CASTERS: usize = 16;
/// Corners of a caster around its receiver, texels: the circle inside covers the receiver's texel centre, the one
/// outside reaches no other.
const CASTER_RADIUS: f64 = 0.8;
/// Distance from a texel's centre of the receivers that get a caster, texels.
const CENTRED: f64 = 0.15;

/// Receivers in the middle of texels, with what the shader found for them.
fn centred(job: &Job<'_>, placed: &[Placed]) -> Vec<(DVec3, Placed)> {
    let mut chosen: Vec<(DVec3, Placed)> = Vec::new();
    for (receiver, placed) in job.receivers.iter().zip(placed) {
        let from_centre = placed.texel - placed.texel.floor() - 0.5;
        let alone = chosen.iter().all(|(_, other)| other.texel.distance(placed.texel) > 4.0);
        if from_centre.length() < CENTRED && alone && placed.covered && chosen.len() < CASTERS {
            chosen.push((job.plan.camera_from_world.transpose() * receiver.as_dvec3(), *placed));
        }
    }
    chosen
}

/// Instances of an equilateral triangle across the light around receivers, moved by a number of texels.
fn casters(plan: &ShadowPlan, chosen: &[(DVec3, Placed)], moved_texels: f64) -> Vec<DAffine3> {
    let around = |(point, placed): &(DVec3, Placed)| {
        let facet = plan.facet(placed.facet).unwrap();
        let (across, up) = texel_axes(facet, &Gradients::at(&facet.rows, *point));
        let along = plan.light.truncate() * across.length();
        let columns = DMat3::from_cols(across * CASTER_RADIUS, up * CASTER_RADIUS, along);
        DAffine3::from_mat3_translation(columns, plan.eye_world + *point + across * moved_texels)
    };
    chosen.iter().map(around).collect()
}

/// Distance along the light at which a receiver meets its caster, texels.
const MET_TEXELS: f64 = 0.1;

/// How many receivers find a caster.
#[derive(Debug, Default)]
struct Met {
    casters: usize,
    /// Those that find their own.
    own: usize,
    /// Those that find another, nearer to the light.
    nearer: usize,
    /// Those of which the twin's map says otherwise.
    unlike_twin: usize,
}

/// How far a receiver's own texel lies behind the receiver's own caster there, in texels along the light.
fn texels_past(plan: &ShadowPlan, map: &DepthMap, (receiver, placed): &(DVec3, Placed)) -> f64 {
    let facet = plan.facet(placed.facet).unwrap();
    let exact = Gradients::at(&facet.rows, *receiver);
    let (sign, centre) = (plan.depth_order.sign(), placed.texel.floor() + 0.5);

    // Follow the caster, which lies across the light, to the texel's centre.
    let (per_x, per_y) = exact.depth_along_surface(plan.light.truncate());
    let x = 2.0 * (centre.x - placed.texel.x) / f64::from(facet.tile.width);
    let y = -2.0 * (centre.y - placed.texel.y) / f64::from(facet.tile.height);
    let expected = placed.signed_depth + sign * (per_x * x + per_y * y);
    let expected = expected.clamp(sign.min(0.0), sign.max(0.0));
    let stored = map.depth(placed.texel.x as i64, placed.texel.y as i64);
    (sign * stored - expected) * exact.w / facet.depth_per_metre / texel_metres(facet, &exact)
}

#[test]
fn casters_land_in_the_texels_that_receivers_look_at() {
    let (gpu, situations, mut random) = (exclusive(), Situation::all(), Random(37));
    let triangle = Geometry::triangle([[1.0, 0.0, 0.0], [-0.5, 0.866_025_4, 0.0], [-0.5, -0.866_025_4, 0.0]]);
    let buffers = triangle.upload(&gpu);
    for text in [shipped::SUN, shipped::PLANES, shipped::PSSM4_LOG] {
        let taken = situations.iter().skip(random.below(50)).step_by(397);
        let shipped = Shipped::new(text, taken, &mut random);
        let mut service =
            ShadowService::new(&gpu.device, &gpu.queue, &shipped.table, &Options::default()).unwrap();
        let mesh = service.add_mesh(&buffers.description()).unwrap();
        let probe = PlaceProbe::new(&gpu, &shipped.table);
        let mut counts = [Met::default(), Met::default()];
        for job in shipped.jobs.iter().filter(|job| job.plan.choice.made_for_position.is_empty()) {
            let (plan, view) = (&job.plan, &job.situation.view);
            let record = write_shadow_record(&shipped.table, plan);
            let placed = probe.place(&[record], std::slice::from_ref(&job.receivers)).remove(0);
            let chosen = centred(job, &placed);
            for (moved, counts) in counts.iter_mut().enumerate() {
                let places = casters(plan, &chosen, 2.0 * moved as f64);
                let instance = |place: &DAffine3| CasterInstance { mesh, world_from_object: *place };
                let instances: Vec<_> = places.iter().map(instance).collect();
                let frame = service.prepare(plan, view, &instances).unwrap();
                let mut encoder = gpu.device.create_command_encoder(&Default::default());
                service.capture(&mut encoder, &frame, None).unwrap();
                gpu.queue.submit([encoder.finish()]);
                let (width, height) = plan.map_size_texels;
                let depths = service.read_map().unwrap().into_iter().map(f64::from).collect();
                let map = DepthMap { width, height, depths };

                // The twin draws the very same triangles.
                let turn = plan.capture_from_world();
                let triangles =
                    places.iter().flat_map(|place| triangle.triangles_from_eye(place, plan.eye_world, &turn));
                let twin = capture(plan, &triangles.collect::<Vec<_>>());
                let own = |past: f64| past.abs() <= MET_TEXELS;
                for receiver in &chosen {
                    let drawn = texels_past(plan, &map, receiver);
                    counts.casters += 1;
                    counts.own += usize::from(own(drawn));
                    counts.nearer += usize::from(drawn < -MET_TEXELS);
                    counts.unlike_twin += usize::from(own(drawn) != own(texels_past(plan, &twin, receiver)));
                }
            }
        }
        let [there, moved] = counts;
        println!("{}: {there:?}, moved by two texels {moved:?}", shipped.case.name);
        assert!(there.casters >= 50 && there.own >= there.casters / 2);
        assert_eq!(there.own + there.nearer, there.casters);
        assert!(there.unlike_twin + moved.unlike_twin <= there.casters / 100);
        assert!(moved.own <= there.casters / 10);
    }
}
