//! What a receiver's visibility depends on: texels of its own facet, however wide the kernel and whatever edge is near.

mod support;

use cssm_core::case::{Filter, Kernel, PcfSize, Source};
use cssm_core::facet::Facet;
use cssm_core::glam::DVec3;
use cssm_core::schema::{Value, Word};
use cssm_core::twin::{DepthMap, Triangle, capture, resolve};
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use support::{Random, level_view};

/// Side of the caster that covers every texel, metres.
const ENDLESS: f64 = 1e6;
const SIDE: u32 = 512;

fn filters() -> Vec<Filter> {
    let mut filters = vec![Filter::None, Filter::Hardware2x2, Filter::Gather2x2];
    let pcf = |size, kernel| Filter::Pcf { size, kernel };
    filters.extend(PcfSize::ALL.map(|size| pcf(size, Kernel::Texels)));
    filters.push(pcf(PcfSize::Seven, Kernel::Metres(0.3)));
    filters.push(Filter::Pcss { source: Source::Angle(20.0), reach_texels: 7 });
    filters.push(Filter::Evsm2 { exponent: 20.0, blur_texels: 4, bleeding: 0.1 });
    filters
}

/// Cases whose facets have tiles of their own, and one whose triangles share a tile.
fn cases(filter: Filter) -> Vec<LightCase> {
    let builder = || LightCase::builder("Reach").filter(filter).map_size_texels(SIDE, SIDE);
    let splits = Word::with("parallel_split", [("splits", Value::Count(4))]);
    vec![
        builder().configurations(&["face_columns"]).build().unwrap(),
        builder().technique(splits).shadow_distance_metres(150.0).build().unwrap(),
        builder().configurations(&["four_plane"]).build().unwrap(),
    ]
}

/// Whether two of a plan's facets share a tile.
fn shares_tile(plan: &ShadowPlan) -> bool {
    plan.facets.iter().enumerate().any(|(k, one)| plan.facets[..k].iter().any(|two| two.tile == one.tile))
}

/// The map of one facet.
fn capture_one(plan: &ShadowPlan, facet: &Facet, triangles: &[Triangle]) -> DepthMap {
    capture(&ShadowPlan { facets: vec![facet.clone()], ..plan.clone() }, triangles)
}

/// A slope that receives shadows, near on one side of the view and far on the other: its normal.
fn slope(toward: DVec3) -> DVec3 {
    (toward + DVec3::new(0.3, 0.7, 0.0)).normalize()
}

/// Distance of the slope from the eye, metres.
const SLOPE: f64 = 3.0;

/// The slope, and strips before it, so that shadows' edges are everywhere.
fn casters(toward: DVec3) -> Vec<Triangle> {
    let normal = slope(toward);
    let flat = triangle_around(normal, -SLOPE);
    let across = toward.any_orthonormal_vector();
    let along = toward.cross(across);
    let place = |x: f64, y: f64| toward * 30.0 + across * x + along * y;
    let strip = |k: i32| {
        let (left, right) = (f64::from(k) * 0.8, f64::from(k) * 0.8 + 0.4);
        let (a, b, c, d) =
            (place(left, -300.0), place(right, -300.0), place(right, 300.0), place(left, 300.0));
        [[a, b, c], [a, c, d]]
    };
    std::iter::once(flat).chain((-300..300).flat_map(strip)).collect()
}

/// An endless triangle at a distance along its normal.
fn triangle_around(normal: DVec3, distance: f64) -> Triangle {
    let across = normal.any_orthonormal_vector() * ENDLESS;
    let along = normal.cross(across);
    let corners = [-across - along, across * 3.0 - along, along * 3.0 - across];
    corners.map(|corner| corner + normal * distance)
}

/// The largest change of visibility at points of the view when texels that are not their facet's change.
fn largest_change(case: &LightCase, view: &View, light: &Light) -> (f64, usize, bool) {
    let plan = plan(case, view, light, &SceneBounds::default()).unwrap();
    let toward = plan.light.truncate().normalize();
    let cover = triangle_around(toward, 50.0);
    let nearest = if plan.depth_order.cleared() == 0.0 { 1.0 } else { 0.0 };
    let (casters, normal) = (casters(toward), slope(toward));

    // Foreign texels are empty in one map and full in the other.
    let maps: Vec<_> = plan
        .facets
        .iter()
        .map(|facet| {
            let empty = capture_one(&plan, facet, &casters);
            let covered = capture_one(&plan, facet, &[cover]);
            let mut full = empty.clone();
            for (depth, covered) in full.depths.iter_mut().zip(&covered.depths) {
                if *covered == plan.depth_order.cleared() {
                    *depth = nearest;
                }
            }
            (empty, full)
        })
        .collect();
    let (mut largest, mut edges) = (0.0_f64, 0);
    let mut random = Random::new(11);
    for _ in 0..20_000 {
        let (x, y) = (random.between(view.left, view.right), random.between(view.bottom, view.top));
        let ray = DVec3::new(x, y, -1.0);
        let point = ray * (-SLOPE / normal.dot(ray));
        if point.z > -0.2 || point.z < -150.0 {
            continue;
        }
        let cell = plan.selection.cell(point.extend(1.0));
        let Some(k) = plan.facets.iter().position(|facet| facet.cells.contains(&cell)) else { continue };
        let at = |map| resolve(case, &plan, map, point, normal).visibility;
        let (empty, full) = (at(&maps[k].0), at(&maps[k].1));
        largest = largest.max((empty - full).abs());
        edges += usize::from(empty > 0.0 && empty < 1.0);
    }
    (largest, edges, shares_tile(&plan))
}

#[test]
fn visibility_depends_on_texels_of_the_own_facet_alone() {
    let view = level_view(0.2, 1000.0);
    let light = Light::directional_travelling(DVec3::new(0.15, -0.3, -1.0)).unwrap();
    let mut shared = 0;
    for filter in filters() {
        for case in cases(filter) {
            let (change, edges, shares) = largest_change(&case, &view, &light);
            println!("{filter:?} {}: {change:.1e}, {edges} in edges", case.technique.name);
            assert!(change < 1e-9, "{filter:?} of {}: {change}", case.technique.name);
            assert!(edges > 100 || filter == Filter::None, "{edges}");
            shared += usize::from(shares);
        }
    }
    assert_eq!(shared, filters().len());
}
