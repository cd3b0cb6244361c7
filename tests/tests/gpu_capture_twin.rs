//! The captured map equals the f64 twin's: coverage away from 1/64 texel of an edge, depth within 1e-5 plus what the
//! surface rises over 1/64 texel. Wrong matrices, tiles and orders are caught.

use cssm_codegen::generate;
use cssm_core::case::{DepthFormat, LightCase};
use cssm_core::schema::{Value, Word};
use cssm_core::twin::{DepthMap, capture};
use cssm_core::{SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{Options, ShadowService};
use cssm_tests::gpu::yard::{Yard, suns, views};
use cssm_tests::gpu::{TestDevice, exclusive};

/// Distance from an edge within which drivers may disagree about coverage, texels.
const EDGE_TEXELS: f64 = 1.0 / 64.0;
/// Depth error of an f32 rasteriser.
const DEPTH_TOLERANCE: f64 = 1e-5;
/// Share of texels at which a driver may still leave the bracket: slivers thinner than it samples.
const SLIVERS: f64 = 2e-5;

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

/// Smallest and largest depth that a texel may hold.
struct Bracket {
    low: DepthMap,
    high: DepthMap,
}

impl Bracket {
    /// The twin's maps with every tile shifted by up to [`EDGE_TEXELS`]; casters are culled as the service culls.
    fn new(yard: &Yard, plan: &ShadowPlan, format: DepthFormat) -> Self {
        let (width, height) = plan.map_size_texels;
        let mut low = DepthMap::cleared(width, height);
        let mut high = DepthMap { depths: vec![0.0; low.depths.len()], ..low.clone() };
        for (x, y) in (-1..=1).flat_map(|y| (-1..=1).map(move |x| (x, y))) {
            let mut map = DepthMap::cleared(width, height);
            for number in 0..plan.facets.len() {
                let places = (0..yard.places.len()).filter(|place| yard.reaches(*place, plan, number));
                let triangles: Vec<_> =
                    places.flat_map(|place| yard.place_from_eye(place, plan.eye_world)).collect();
                let mut facet = plan.facets[number].clone();
                let step = |side: u32, steps: i32| 2.0 * EDGE_TEXELS / f64::from(side) * f64::from(steps);
                facet.rows.x += facet.rows.w * step(facet.tile.width, x);
                facet.rows.y += facet.rows.w * step(facet.tile.height, y);
                let shifted = capture(&ShadowPlan { facets: vec![facet], ..plan.clone() }, &triangles);
                map.depths
                    .iter_mut()
                    .zip(shifted.depths)
                    .for_each(|(depth, drawn)| *depth = depth.min(drawn));
            }
            low.depths.iter_mut().zip(&map.depths).for_each(|(low, depth)| *low = low.min(*depth));
            high.depths.iter_mut().zip(&map.depths).for_each(|(high, depth)| *high = high.max(*depth));
        }
        Self { low: low.stored(format), high: high.stored(format) }
    }

    /// Number of texels outside.
    fn violations(&self, map: &[f32], format: DepthFormat) -> usize {
        let tolerance = DEPTH_TOLERANCE + format.rounding();
        let limits = self.low.depths.iter().zip(&self.high.depths);
        let outside = |(stored, (low, high)): &(&f32, (&f64, &f64))| {
            let stored = f64::from(**stored);
            stored < *low - tolerance || stored > *high + tolerance
        };
        map.iter().zip(limits).filter(outside).count()
    }
}

struct Stage<'a> {
    gpu: &'a TestDevice,
    yard: &'a Yard,
    case: &'a LightCase,
    service: ShadowService,
    buffers: Vec<cssm_tests::gpu::casters::GeometryBuffers>,
}

impl<'a> Stage<'a> {
    fn new(gpu: &'a TestDevice, yard: &'a Yard, case: &'a LightCase, options: &Options) -> Self {
        let table = generate(case).unwrap().table;
        let service = ShadowService::new(&gpu.device, &gpu.queue, &table, options).unwrap();
        Self { gpu, yard, case, service, buffers: yard.upload(gpu) }
    }

    /// What the device captures for a plan.
    fn map(&mut self, plan: &ShadowPlan, view: &View) -> Vec<f32> {
        let casters = self.yard.add_to(&mut self.service, &self.buffers).unwrap();
        let frame = self.service.prepare(plan, view, &casters).unwrap();
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.service.capture(&mut encoder, &frame, None).unwrap();
        self.gpu.queue.submit([encoder.finish()]);
        for caster in casters {
            self.service.remove_mesh(caster.mesh);
        }
        self.service.read_map().unwrap()
    }

    fn plan(&self, view: &View, sun: usize) -> ShadowPlan {
        plan(self.case, view, &suns()[sun], &SceneBounds::default()).unwrap()
    }
}

#[test]
fn the_device_draws_what_the_twin_draws() {
    let (gpu, yard) = (exclusive(), Yard::new());
    for case in &cases() {
        let mut stage = Stage::new(&gpu, &yard, case, &Options::default());
        let (mut violations, mut texels, mut covered) = (0, 0, 0);
        for view in &views((160, 90)) {
            for sun in 0..3 {
                let plan = stage.plan(view, sun);
                let map = stage.map(&plan, view);
                let bracket = Bracket::new(&yard, &plan, case.map.format);
                let wrong = bracket.violations(&map, case.map.format);
                violations += wrong;
                texels += map.len();
                covered += map.iter().filter(|depth| **depth < 1.0).count();
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
        let plan = unclipped.plan(view, 1);
        let (one, other) = (unclipped.map(&plan, view), clamped.map(&plan, view));
        let worst = one.iter().zip(&other).map(|(one, other)| (one - other).abs()).fold(0.0, f32::max);
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
        let good = stage.plan(view, 0);
        let bracket = Bracket::new(&yard, &good, case.map.format);
        let format = case.map.format;
        let unchanged = bracket.violations(&stage.map(&good, view), format);
        assert!(unchanged <= 1, "{}: {unchanged} texels without a change", case.name);
        for (what, change) in changes {
            let mut plan = good.clone();
            change(&mut plan);
            let wrong = bracket.violations(&stage.map(&plan, view), format);
            // A single facet has nobody to swap with.
            let limit = if plan == good { 0 } else { 50 };
            assert!(wrong >= limit, "{}: {what} changes only {wrong} texels", case.name);
        }
    }
}
