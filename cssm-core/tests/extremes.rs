//! The extremes: depth ranges to infinity, fields of view from 1 to 170 degrees, images a tenth as wide as high, lights
//! along every special direction and a hair off it, ten thousand kilometres from the origin. Plans are rounded to f32
//! once and evaluated as a shader does, against f64.
//!
//! The normal run samples the sweep; `CSSM_FULL=1` runs all of it.

mod support;

use cssm_core::case::LightKind;
use cssm_core::facet::FacetRows;
use cssm_core::footprint::quantile;
use cssm_core::glam::{DMat3, DVec2, DVec3, DVec4, Vec3, Vec4};
use cssm_core::homography::{Gradients, singular_values};
use cssm_core::remap::{Curve, Remap};
use cssm_core::table::shear_parts;
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use support::{
    Random, bounds_for, cases, extreme_lights, extreme_views, lamps, level_view, local_cases, shining, sun,
    toward,
};

/// Largest coordinate error in texels.
const TEXEL_LIMIT: f64 = 5e-3;
/// Depth error in texels along the light that one receiver in a hundred may exceed.
const DEPTH_LIMIT: f64 = 1e-3;
/// The same at one degree of view, where the range is a hundred thousand texels deep and floats hold no more.
const NARROW_DEPTH_LIMIT: f64 = 1e-2;
/// The same, and the share of receivers beyond the depth limit, of configurations chosen for local lights, and of every
/// configuration of them alone.
const LOCAL_CHOSEN_LIMITS: (f64, f64) = (1.2e-2, 0.08);
const LOCAL_LIMITS: (f64, f64) = (8e-2, 0.16);
/// Share of receivers beyond the depth limit.
const DEPTH_SHARE: f64 = 0.01;
/// Distance from a lamp below which receivers are not asked for, in distances of the lamp from the eye (at least a
/// metre): positions relative to the eye hold no more.
const NEAREST: f64 = 0.05;
/// Sample receivers of each plan.
const POINTS: usize = 2000;

/// Rows and points in sheared camera axes, as records and shaders have them, rounded to f32.
struct Rounded {
    camera_from_world: DMat3,
    shear: DVec2,
    bends: bool,
}

impl Rounded {
    fn of(plan: &ShadowPlan) -> Self {
        let remap = plan.facets.iter().any(|facet| !facet.rows.remap.is_none());
        Self { camera_from_world: plan.camera_from_world, shear: plan.shear, bends: remap }
    }

    fn row(&self, row: DVec4) -> Vec4 {
        let camera = self.camera_from_world * row.truncate();
        let along = camera.z - self.shear.dot(camera.truncate());
        DVec4::new(camera.x, camera.y, along, row.w).as_vec4()
    }

    /// Step by step as the shader moves positions along the light, without a fused multiplication.
    fn position(&self, point_camera: DVec3) -> Vec3 {
        let point = point_camera.as_vec3();
        let (leading, rest) = shear_parts(self.shear);
        let (leading, rest) = (leading.as_vec2(), rest.as_vec2());
        let bits = point.z.to_bits();
        let upper = f32::from_bits(bits & 0xffff_f000);
        let lower = (bits & 0xfff) as f32;
        let step = f32::from_bits(bits & 0xff80_0000) * f32::EPSILON;
        let moved = point.truncate() + leading * upper;
        let moved = moved + (leading * step) * lower;
        (moved + rest * point.z).extend(point.z)
    }

    /// Clip coordinates as a shader computes them.
    fn ndc(&self, rows: &FacetRows, point_camera: DVec3) -> DVec3 {
        let point = self.position(point_camera);
        let dot = |row: DVec4| {
            let row = self.row(row);
            row.x * point.x + row.y * point.y + row.z * point.z + row.w
        };
        let w = dot(rows.w);
        let [x, y, z] = [rows.x, rows.y, rows.z].map(|row| f64::from(dot(row) / w));
        if self.bends { DVec3::new(x, bent_in_f32(rows, y as f32), z) } else { DVec3::new(x, y, z) }
    }
}

/// The remap with every step rounded, as the records and shaders have it.
fn bent_in_f32(rows: &FacetRows, k: f32) -> f64 {
    let Remap { curve, scale, shift } = rows.remap;
    let (scale, shift) = (scale as f32, shift as f32);
    let y = match curve {
        Curve::Straight => shift + scale * k,
        Curve::Perspective { push_back_metres } => shift + scale * k / (1.0 + push_back_metres as f32 * k),
        Curve::Logarithmic { reference_metres, horizon_metres } => {
            let horizon = (1.0 / horizon_metres) as f32;
            if k <= horizon {
                rows.remap.y(0.0) as f32 - (f64::from(scale) * horizon_metres) as f32 * k
            } else {
                shift - scale * (k * reference_metres as f32).ln()
            }
        }
    };
    f64::from(y)
}

/// What rounding does to the plans of one case.
#[derive(Debug, Clone, Default)]
struct Errors {
    /// Largest error across the map, texels, and where.
    texels: f64,
    place: String,
    /// Receivers, and those beyond the depth limit; largest 99th percentile of one plan.
    receivers: u64,
    beyond: u64,
    depth_p99_texels: f64,
}

impl Errors {
    fn share_beyond(&self) -> f64 {
        self.beyond as f64 / self.receivers.max(1) as f64
    }

    fn add(
        &mut self,
        (plan, light): (&ShadowPlan, &Light),
        view: &View,
        reach: f64,
        limit: f64,
        random: &mut Random,
        place: &dyn Fn() -> String,
    ) {
        let rounded = Rounded::of(plan);
        let mut depths = Vec::with_capacity(POINTS);
        for _ in 0..POINTS {
            let depth = view.near_metres * (reach / view.near_metres).powf(random.between(0.0, 0.999));
            let x = random.unit() * f64::from(view.size_pixels.0);
            let y = random.unit() * f64::from(view.size_pixels.1);
            // The position itself is f32: compare what both do with the same numbers.
            let camera = (view.camera_from_world * view.ray_world(x, y) * depth).as_vec3().as_dvec3();
            let point = view.camera_from_world.transpose() * camera;
            let Some(facet) = plan.facet(plan.selection.cell(point.extend(1.0))) else { continue };
            let from_light = point.distance(plan.light.truncate());
            if !light.reaches(view.eye_world + point)
                || plan.light.w > 0.0 && from_light < NEAREST * plan.light.truncate().length().max(1.0)
            {
                continue;
            }
            let exact = Gradients::at(&facet.rows, point);
            let error = (rounded.ndc(&facet.rows, camera) - exact.ndc).abs();
            let (width, height) = (f64::from(facet.tile.width), f64::from(facet.tile.height));
            let texels = (error.x * width).max(error.y * height) * 0.5;
            if texels > self.texels {
                (self.texels, self.place) = (texels, place());
            }

            // Depth error in metres along the light, over the texel there.
            let (across, up) = exact.across_light();
            let texel = singular_values(across * (2.0 / width), up * (2.0 / height));
            let distance = if plan.light.w > 0.0 { point.distance(plan.light.truncate()) } else { 1.0 };
            let metres = error.z * exact.w / facet.depth_per_metre * distance;
            if (-0.01..=1.01).contains(&exact.ndc.z) {
                depths.push(metres / texel.0);
            }
        }
        self.receivers += depths.len() as u64;
        self.beyond += depths.iter().filter(|depth| **depth > limit).count() as u64;
        depths.sort_by(f64::total_cmp);
        if !depths.is_empty() {
            self.depth_p99_texels = self.depth_p99_texels.max(quantile(&depths, 0.99));
        }
    }
}

#[test]
fn rounding_moves_nothing_anyone_could_see() {
    let full = std::env::var_os("CSSM_FULL").is_some();
    let mut random = Random::new(11);
    let names: Vec<String> = cases(2048, 1000.0).into_iter().map(|case| case.name).collect();
    let mut found = [vec![Errors::default(); names.len()], vec![Errors::default(); names.len()]];
    let mut plans = 0;
    for view in extreme_views() {
        let reach = view.far_metres.min(1e6 * view.near_metres);
        let narrow = (view.right - view.left).min(view.top - view.bottom) < 0.1;
        let limit = if narrow { NARROW_DEPTH_LIMIT } else { DEPTH_LIMIT };
        let cases = cases(2048, reach);
        for light in extreme_lights(&view, &mut random) {
            for (index, case) in cases.iter().enumerate() {
                if !full && !random.bits().is_multiple_of(24) {
                    continue;
                }
                let place = || {
                    let View { near_metres, far_metres, size_pixels, .. } = view;
                    let fov = (2.0 * view.top.atan()).to_degrees();
                    let camera = view.camera_from_world * light;
                    format!(
                        "{}: {near_metres} to {far_metres} m, {fov:.0} degrees, {size_pixels:?}, light {camera}",
                        case.name
                    )
                };
                let plan = plan(case, &view, &sun(light), &SceneBounds::default());
                let plan = plan.unwrap_or_else(|error| panic!("{error}: {}", place()));
                assert_finite(&plan, case);
                plans += 1;

                // A configuration that answers for a light it is not made for only has to answer.
                if plan.choice.made_for_position.is_empty() {
                    let errors = &mut found[usize::from(narrow)][index];
                    errors.add((&plan, &sun(light)), &view, reach, limit, &mut random, &place);
                }
            }
        }
    }
    println!(
        "{plans} plans: worst error across the map in texels; along the light in texels: worst p99 of a plan,"
    );
    println!("share of all receivers beyond {DEPTH_LIMIT} (beyond {NARROW_DEPTH_LIMIT} at 1 degree)");
    println!("{:<14}{:^32}{:^32}", "", "60 and 170 degrees", "1 degree");
    for (name, (wide, narrow)) in names.iter().zip(found[0].iter().zip(&found[1])) {
        let figures = |errors: &Errors| {
            let (texels, p99) = (errors.texels, errors.depth_p99_texels);
            format!("{texels:>10.1e}{p99:>10.1e}{:>10.3} %", 100.0 * errors.share_beyond())
        };
        println!("{name:<14}{}{}", figures(wide), figures(narrow));
    }
    for errors in found.iter().flatten() {
        assert!(errors.texels <= TEXEL_LIMIT, "{} texels: {}", errors.texels, errors.place);
        assert!(errors.share_beyond() <= DEPTH_SHARE, "{errors:?}");
    }
}

#[test]
fn rounding_moves_nothing_under_local_lights_and_bent_rows() {
    let full = std::env::var_os("CSSM_FULL").is_some();
    let mut random = Random::new(12);
    let names: Vec<String> = local_cases(2048).into_iter().map(|case| case.name).collect();
    let mut found = vec![Errors::default(); names.len()];
    for view in extreme_views() {
        let narrow = (view.right - view.left).min(view.top - view.bottom) < 0.1;
        // A lamp is a place: from ten thousand kilometres off the origin it is as exact as the eye is.
        let reach = view.far_metres.min(1e4 * view.near_metres.max(0.01));
        let limit = if narrow { NARROW_DEPTH_LIMIT } else { DEPTH_LIMIT };
        let lamps = lamps(&view, &mut random);
        let suns: Vec<_> = extreme_lights(&view, &mut random).into_iter().map(sun).collect();
        // Lamps ten thousand near distances away are suns.
        let lamps = if view.near_metres < 1e-3 { Vec::new() } else { lamps };
        for (index, case) in local_cases(2048).iter().enumerate() {
            let lights: &[Light] = if case.light.is_local() { &lamps } else { &suns };
            for light in lights {
                if !full && !random.bits().is_multiple_of(24) {
                    continue;
                }
                let light = match case.light {
                    LightKind::Spot => shining(&view, *light, &mut random),
                    LightKind::Directional | LightKind::Omni => *light,
                };
                let place = || {
                    let fov = (2.0 * view.top.atan()).to_degrees();
                    let at = view.camera_from_world * light.homogeneous(view.eye_world).truncate();
                    format!("{}: near {}, {fov:.0} degrees, light {at}", case.name, view.near_metres)
                };
                let plan = plan(case, &view, &light, &bounds_for(case, &view));
                let plan = plan.unwrap_or_else(|error| panic!("{error}: {}", place()));
                assert_finite(&plan, case);
                if plan.choice.complete && plan.choice.made_for_position.is_empty() {
                    let place = || format!("{}, {}", place(), plan.choice);
                    found[index].add((&plan, &light), &view, reach, limit, &mut random, &place);
                }
            }
        }
    }
    println!("worst texels, worst p99 of depth, share beyond the depth limit");
    for (name, errors) in names.iter().zip(&found) {
        let (texels, p99) = (errors.texels, errors.depth_p99_texels);
        println!(
            "{name:<16}{texels:>10.1e}{p99:>10.1e}{:>10.3} %  {}",
            100.0 * errors.share_beyond(),
            errors.place
        );
    }
    for (name, errors) in names.iter().zip(&found) {
        // A lamp's rays run every way: more sums cancel than under a sun, and one order of depth serves all facets.
        let (texels, share) = if name.ends_with("Chosen") { LOCAL_CHOSEN_LIMITS } else { LOCAL_LIMITS };
        assert!(errors.texels <= texels, "{name} {} texels: {}", errors.texels, errors.place);
        assert!(errors.share_beyond() <= share, "{name} {errors:?}");
    }
}

/// Every number of a plan is finite, in f32 too.
fn assert_finite(plan: &ShadowPlan, case: &LightCase) {
    for facet in &plan.facets {
        let rows = [facet.rows.x, facet.rows.y, facet.rows.z, facet.rows.w];
        assert!(rows.iter().chain(&facet.clip).all(|row| row.as_vec4().is_finite()), "{}", case.name);
        let scalars = [facet.depth_per_metre, facet.texel_metres_per_w, facet.receiver_plane_depth];
        assert!(scalars.iter().all(|scalar| (*scalar as f32).is_finite()), "{}", case.name);
    }
}

#[test]
fn one_matrix_element_off_is_seen() {
    let mut random = Random::new(5);
    let view = level_view(0.2, 1000.0);
    let case = &cases(2048, 1000.0)[3];
    let mut plan = plan(case, &view, &sun(toward(60.0, 150.0)), &SceneBounds::default()).unwrap();
    let right = plan.clone();
    for facet in &mut plan.facets {
        facet.rows.x.x *= 1.0 + 1e-4;
    }
    let rounded = Rounded::of(&plan);
    let mut most = 0.0_f64;
    for _ in 0..500 {
        let ray = view.ray_world(random.unit() * 1080.0, random.unit() * 1080.0);
        let point = ray * 0.2 * 5000_f64.powf(random.unit());
        let index = plan.selection.cell(point.extend(1.0));
        let (Some(wrong), Some(right)) = (plan.facet(index), right.facet(index)) else { continue };
        let camera = view.camera_from_world * point;
        let error = (rounded.ndc(&wrong.rows, camera) - Gradients::at(&right.rows, point).ndc).abs();
        most = most.max(error.x * f64::from(right.tile.width) * 0.5);
    }
    assert!(most > TEXEL_LIMIT);
}
