//! Numerics: plans rounded to f32 once and evaluated as a shader does, against f64.

mod support;

use cssm_core::facet::FacetRows;
use cssm_core::glam::{DVec3, DVec4};
use cssm_core::homography::{Gradients, singular_values};
use cssm_core::{SceneBounds, View, plan};
use support::{Random, cases, sun};

/// Largest coordinate error in texels.
const TEXEL_LIMIT: f64 = 5e-3;
/// The same at one degree of view: there the sums of f32 products in world axes cancel.
const NARROW_TEXEL_LIMIT: f64 = 0.15;

fn dot(row: DVec4, point: DVec3) -> f32 {
    let (x, y, z) = (point.x as f32, point.y as f32, point.z as f32);
    row.x as f32 * x + row.y as f32 * y + row.z as f32 * z + row.w as f32
}

/// Clip coordinates as a shader computes them.
fn ndc_in_f32(rows: &FacetRows, point: DVec3) -> DVec3 {
    let w = dot(rows.w, point);
    DVec3::new(
        f64::from(dot(rows.x, point) / w),
        f64::from(dot(rows.y, point) / w),
        f64::from(dot(rows.z, point) / w),
    )
}

/// Worst error of a view and light over all cases: texels across the map, texels along the light.
fn worst(view: &View, light: DVec3, random: &mut Random) -> (f64, f64) {
    let reach = view.far_metres.min(1e6 * view.near_metres);
    let mut worst = (0.0_f64, 0.0_f64);
    for case in cases(2048, reach) {
        let plan = plan(&case, view, &sun(light), &SceneBounds::default());
        let plan = plan.unwrap_or_else(|error| panic!("{error}: {} {view:?} {light}", case.name));
        for _ in 0..300 {
            let depth = view.near_metres * (reach / view.near_metres).powf(random.between(0.0, 0.999));
            let x = random.unit() * f64::from(view.size_pixels.0);
            let y = random.unit() * f64::from(view.size_pixels.1);
            // The position itself is f32: compare what both do with the same numbers.
            let point = (view.ray_world(x, y) * depth).as_vec3().as_dvec3();
            let Some(facet) = plan.facet(plan.selection.facet(point.extend(1.0))) else { continue };
            let exact = Gradients::at(&facet.rows, point);
            let rounded = ndc_in_f32(&facet.rows, point);
            let error = (rounded - exact.ndc).abs();
            let texels =
                (error.x * f64::from(facet.tile.width)).max(error.y * f64::from(facet.tile.height)) * 0.5;
            let (across, up) = exact.across_light();
            let texel = singular_values(
                across * (2.0 / f64::from(facet.tile.width)),
                up * (2.0 / f64::from(facet.tile.height)),
            );
            let in_range = (-0.01..=1.01).contains(&exact.ndc.z);
            let metres = error.z * exact.w / facet.depth_per_metre;
            worst.0 = worst.0.max(texels);
            worst.1 = worst.1.max(if in_range { metres / texel.0 } else { 0.0 });
        }
    }
    worst
}

#[test]
fn texel_coordinates_survive_extreme_ranges_and_angles() {
    let mut random = Random::new(11);
    let (mut wide, mut narrow) = ((0.0_f64, 0.0_f64), (0.0_f64, 0.0_f64));
    for (near, far) in [(0.2, 1000.0), (0.1, 1e6), (1e-4, 1e3), (0.1, f64::INFINITY)] {
        for fov in [1.0, 30.0, 60.0, 170.0_f64] {
            let eye = DVec3::new(3.0, 1.7, 5.0);
            let target = eye + DVec3::new(0.3, -0.1, -1.0);
            let view =
                View::perspective(eye, target, DVec3::Y, fov.to_radians(), near, far, (1000, 700)).unwrap();
            let axis = view.camera_from_world.transpose() * DVec3::NEG_Z;
            let side = view.camera_from_world.transpose() * DVec3::new(0.8, 0.6, 0.0);
            let mut lights: Vec<DVec3> =
                [0.0, 1e-12, 1e-9, 1e-6, 1e-2].map(|angle| (axis + side * angle).normalize()).to_vec();
            lights.extend([-lights[0], -lights[4], side, random.direction(), random.direction()]);
            for light in lights {
                let (texels, along) = worst(&view, light, &mut random);
                let limit = if fov < 30.0 { NARROW_TEXEL_LIMIT } else { TEXEL_LIMIT };
                assert!(texels <= limit, "{texels} texels: near {near} far {far} fov {fov} light {light}");
                let most = if fov < 30.0 { &mut narrow } else { &mut wide };
                *most = (most.0.max(texels), most.1.max(along));
            }
        }
    }
    println!("fov 30 to 170: {:.2e} texels across, {:.2e} texels along the light", wide.0, wide.1);
    println!("fov 1: {:.2e} texels across, {:.2e} texels along the light", narrow.0, narrow.1);
}

#[test]
fn one_matrix_element_off_is_seen() {
    let mut random = Random::new(5);
    let view = support::level_view(0.2, 1000.0);
    let case = &cases(2048, 1000.0)[3];
    let plan = plan(case, &view, &sun(support::toward(60.0, 150.0)), &SceneBounds::default()).unwrap();
    let mut most = 0.0_f64;
    for _ in 0..500 {
        let ray = view.ray_world(random.unit() * 1080.0, random.unit() * 1080.0);
        let point = ray * 0.2 * 5000_f64.powf(random.unit());
        let Some(facet) = plan.facet(plan.selection.facet(point.extend(1.0))) else { continue };
        let mut rows = facet.rows;
        rows.x.x *= 1.0 + 1e-4;
        let error = (ndc_in_f32(&rows, point) - Gradients::at(&facet.rows, point).ndc).abs();
        most = most.max(error.x * f64::from(facet.tile.width) * 0.5);
    }
    assert!(most > TEXEL_LIMIT);
}
