//! Plans held over frames: regions of the map, widened views, other eyes, and what is no longer covered.

mod support;

use cssm_core::case::{Fit, LightKind};
use cssm_core::glam::{DMat3, DQuat, DVec2, DVec3, DVec4};
use cssm_core::plan::{BoundingBox, MapRegion, PlanRequest, ViewMargin};
use cssm_core::receivers::Polytope;
use cssm_core::schema::{Value, Word};
use cssm_core::twin::{capture, resolve};
use cssm_core::view::ViewError;
use cssm_core::{Chooser, Light, LightCase, PlanError, SceneBounds, ShadowPlan, View, plan};
use support::{
    Random, cases, lamps, level_view, local_cases, off_centre_view, shining, sun, toward, turned_view,
};

/// The view after a turn about some axis and a move.
fn nearby(view: &View, random: &mut Random, turn_radians: f64, move_metres: f64) -> View {
    let turn = DMat3::from_quat(DQuat::from_axis_angle(random.direction(), turn_radians));
    View {
        eye_world: view.eye_world + random.direction() * move_metres,
        camera_from_world: turn * view.camera_from_world,
        ..*view
    }
}

/// Corners of a view's frustum relative to an eye, world axes; w = 0 at infinity.
fn corners(view: &View, eye_world: DVec3) -> Vec<DVec4> {
    let to_world = view.camera_from_world.transpose();
    let frustum = Polytope::frustum(view, view.far_metres);
    let way = view.eye_world - eye_world;
    let corner = |vertex: &DVec4| (to_world * vertex.truncate() + way * vertex.w).extend(vertex.w);
    frustum.vertices.iter().map(corner).collect()
}

/// The least that a corner of the view lies inside the other's frustum, relative to its distance.
fn least_inside(outer: &View, inner: &View) -> f64 {
    let frustum = Polytope::frustum(outer, outer.far_metres);
    let mut least = f64::INFINITY;
    for corner in corners(inner, outer.eye_world) {
        let camera = (outer.camera_from_world * corner.truncate()).extend(corner.w);
        for plane in &frustum.planes {
            let terms = plane.truncate().length() * camera.truncate().length() + (plane.w * camera.w).abs();
            least = least.min(plane.dot(camera) / terms);
        }
    }
    least
}

fn random_view(random: &mut Random) -> View {
    let far = if random.unit() < 0.3 { f64::INFINITY } else { random.between(5.0, 5000.0) };
    let fov = random.between(2.0, 100.0_f64).to_radians();
    let target = random.direction();
    let size = (random.between(100.0, 3000.0) as u32, random.between(500.0, 2000.0) as u32);
    let mut view = View::perspective(
        random.direction() * random.between(0.0, 1e4),
        DVec3::ZERO,
        target,
        fov,
        random.between(0.01, 1.0),
        far,
        size,
    )
    .unwrap();
    if random.unit() < 0.4 {
        let (width, height) = (view.right - view.left, view.top - view.bottom);
        let shift = DVec2::new(random.between(-0.6, 0.6) * width, random.between(-0.6, 0.6) * height);
        (view.left, view.right) = (view.left + shift.x, view.right + shift.x);
        (view.bottom, view.top) = (view.bottom + shift.y, view.top + shift.y);
    }
    view
}

#[test]
fn a_widened_view_sees_what_every_view_nearby_sees() {
    let mut random = Random::new(11);
    let (mut tried, mut refused, mut tight) = (0, 0, 0);
    for _ in 0..400 {
        let view = random_view(&mut random);
        let turn = random.between(0.0, 12.0_f64).to_radians() * random.unit();
        let metres = random.between(0.0, 5.0) * random.unit();
        let wide = match view.widened(turn, metres) {
            Ok(wide) => wide,
            Err(error) => {
                assert_eq!(error, ViewError::FieldOfView, "{view:?} {turn} {metres}");
                refused += 1;
                continue;
            }
        };
        tried += 1;
        let ratio = wide.pixels_per_tangent() / view.pixels_per_tangent();
        assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
        let mut least = f64::INFINITY;
        for _ in 0..60 {
            let inner = nearby(&view, &mut random, turn, metres);
            let inside = least_inside(&wide, &inner);
            assert!(inside >= -1e-12, "{inside} {view:?} {wide:?} {turn} {metres}");
            least = least.min(inside);
        }
        // Beyond the margin something is lost.
        let outside = (0..60).any(|_| {
            let inner = nearby(&view, &mut random, 1.6 * turn + 0.02, 1.6 * metres);
            least_inside(&wide, &inner) < 0.0
        });
        assert!(outside, "{view:?} {turn} {metres}");
        tight += usize::from(least < 0.05);
    }
    assert!(tried > 300 && refused > 0 && tight > 250, "{tried} {refused} {tight}");
}

#[test]
fn a_view_that_cannot_be_widened_says_why() {
    let size = (1000, 1000);
    let wide = View::perspective(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 2.9, 0.1, f64::INFINITY, size).unwrap();
    assert_eq!(wide.widened(0.2, 0.0), Err(ViewError::FieldOfView));
    assert_eq!(wide.widened(2.0, 0.0), Err(ViewError::FieldOfView));
    for (turn, metres) in [(-0.1, 0.0), (0.0, -1.0), (f64::NAN, 0.0), (0.0, f64::INFINITY)] {
        assert!(matches!(wide.widened(turn, metres), Err(ViewError::NotFinite { .. })));
    }
    assert_eq!(wide.widened(0.0, 0.0), Ok(wide));
    let case = &cases(512, 100.0)[3];
    let light = sun(toward(50.0, 40.0));
    let margin = ViewMargin { turn_radians: 0.5, move_metres: 0.0 };
    let request = PlanRequest { margin, ..PlanRequest::new(case, &wide, &light, SceneBounds::default()) };
    assert_eq!(request.plan(), Err(PlanError::Margin(ViewError::FieldOfView)));
}

/// Requests of every kind of case and light.
fn for_each_request(check: &mut dyn FnMut(&PlanRequest<'_>, &mut Random)) {
    let mut random = Random::new(5);
    for view in [level_view(0.2, f64::INFINITY), turned_view(0.1, 800.0), off_centre_view(0.3, 2000.0)] {
        for case in cases(1024, 300.0) {
            for toward_light in [toward(55.0, 100.0), toward(20.0, 190.0), toward(4.0, 3.0)] {
                let toward_world = view.camera_from_world.transpose() * toward_light;
                let light = sun(toward_world);
                check(&PlanRequest::new(&case, &view, &light, SceneBounds::default()), &mut random);
            }
        }
        let lamps = lamps(&view, &mut random);
        for case in local_cases(1024) {
            for lamp in lamps.iter().step_by(5) {
                let light = match case.light {
                    LightKind::Spot => shining(&view, *lamp, &mut random),
                    _ => *lamp,
                };
                if case.light == LightKind::Directional {
                    continue;
                }
                check(&PlanRequest::new(&case, &view, &light, SceneBounds::default()), &mut random);
            }
        }
    }
}

const REGION: MapRegion = MapRegion { x: 320, y: 64, width: 512, height: 640 };

#[test]
fn a_region_is_a_map_of_its_own() {
    for_each_request(&mut |request, _| {
        let mut small = request.case.clone();
        (small.map.width, small.map.height) = (REGION.width, REGION.height);
        let alone = PlanRequest { case: &small, ..*request }.plan();
        let inside = PlanRequest { region: Some(REGION), ..*request }.plan();
        let (Ok(alone), Ok(inside)) = (&alone, &inside) else {
            assert_eq!(alone.is_err(), inside.is_err());
            return;
        };
        assert_eq!((inside.map_size_texels, inside.region), ((1024, 1024), REGION));
        assert_eq!(inside.facets.len(), alone.facets.len());
        for (one, two) in inside.facets.iter().zip(&alone.facets) {
            let mut moved = two.clone();
            (moved.tile.x, moved.tile.y) = (moved.tile.x + REGION.x, moved.tile.y + REGION.y);
            assert_eq!(*one, moved);
            assert!(one.tile.x + one.tile.width <= REGION.x + REGION.width);
            assert!(one.tile.y + one.tile.height <= REGION.y + REGION.height);
        }
        assert_eq!(inside.selection, alone.selection);
        assert_eq!(inside.choice, alone.choice);
    });
}

#[test]
fn a_region_outside_the_map_is_refused_and_declared_sizes_shrink_with_it() {
    let case = &cases(1024, 300.0)[3];
    let (view, light) = (level_view(0.2, f64::INFINITY), sun(toward(50.0, 40.0)));
    let request = PlanRequest::new(case, &view, &light, SceneBounds::default());
    let refused = [(0, 0, 0, 8), (0, 0, 8, 0), (1000, 0, 25, 100), (0, 1024, 8, 8), (u32::MAX, 0, 8, 8)];
    for (x, y, width, height) in refused {
        let region = MapRegion { x, y, width, height };
        let error = PlanRequest { region: Some(region), ..request }.plan().unwrap_err();
        assert_eq!(error, PlanError::Region { region, width: 1024, height: 1024 });
    }
    assert!(PlanRequest { region: Some(REGION), ..request }.plan().is_ok());
    assert!(Chooser::default().plan_of(&PlanRequest { region: Some(REGION), ..request }).is_ok());

    let sizes = Value::Sizes(vec![(512, 512), (512, 512)]);
    let splits = Word::with("parallel_split", [("splits", Value::Count(2)), ("sizes", sizes)]);
    let sized = LightCase::builder("Sized").technique(splits).shadow_distance_metres(100.0);
    let sized = sized.map_size_texels(1024, 512).build().unwrap();
    let region = MapRegion { x: 512, y: 256, width: 512, height: 256 };
    let plan = PlanRequest { case: &sized, region: Some(region), ..request }.plan().unwrap();
    let tiles: Vec<_> = plan.facets.iter().map(|facet| (facet.tile.width, facet.tile.height)).collect();
    assert_eq!(tiles, [(256, 256), (256, 256)]);
}

/// Texel and stored depth of a world point in a facet, and the facet's cell.
fn seen(plan: &ShadowPlan, point_world: DVec3) -> Option<(u32, DVec3)> {
    let point = (point_world - plan.eye_world).extend(1.0);
    let cell = plan.selection.cell(point);
    let facet = plan.facet(cell)?;
    let rows = &facet.rows;
    let w = rows.w.dot(point);
    let y = rows.remap.y(rows.y.dot(point) / w);
    let (u, v) = facet.tile.texel_from_ndc(rows.x.dot(point) / w, y);
    (w > 0.0).then_some((facet.first_cell(), DVec3::new(u, v, rows.z.dot(point) / w)))
}

/// Points that a view sees, evenly in the logarithm of depth.
fn visible(view: &View, random: &mut Random, count: usize) -> Vec<DVec3> {
    let far = view.far_metres.min(2000.0);
    let logarithm = (far / view.near_metres).ln();
    let (width, height) = (f64::from(view.size_pixels.0), f64::from(view.size_pixels.1));
    (0..count)
        .map(|_| {
            let depth = view.near_metres * (logarithm * random.unit()).exp();
            let ray = view.ray_world(random.unit() * width, random.unit() * height);
            view.eye_world + ray * depth
        })
        .collect()
}

#[test]
fn a_rebased_plan_has_the_same_texels_depths_and_cells() {
    let mut compared = 0;
    for_each_request(&mut |request, random| {
        let margin = ViewMargin { turn_radians: 0.08, move_metres: 0.7 };
        let Ok(plan) = PlanRequest { margin, ..*request }.plan() else { return };
        let later = nearby(request.view, random, 0.08, 0.7);
        let rebased = plan.rebased(&later);
        assert_eq!(
            (rebased.eye_world, rebased.camera_from_world),
            (later.eye_world, later.camera_from_world)
        );
        let mut border = 0;
        for point in visible(&later, random, 50) {
            match (seen(&plan, point), seen(&rebased, point)) {
                (Some((one_cell, one)), Some((two_cell, two))) if one_cell == two_cell => {
                    let scale = DVec3::new(1024.0, 1024.0, 1.0) + one.abs();
                    let off = ((one - two) / scale).abs().max_element();
                    assert!(off < 1e-9, "{off} {one} {two} {}", request.case.name);
                    compared += 1;
                }
                (None, None) => {}
                _ => border += 1,
            }
        }
        assert!(border <= 1, "{border} {}", request.case.name);
    });
    assert!(compared > 5000, "{compared}");
}

#[test]
fn a_rebased_plan_shears_as_a_plan_of_its_own() {
    let case = &cases(1024, 300.0)[3];
    let view = level_view(0.2, 1000.0);
    let light = sun(toward(10.0, 3.0));
    let plan = plan(case, &view, &light, &SceneBounds::default()).unwrap();
    let mut random = Random::new(2);
    let later = nearby(&view, &mut random, 0.2, 1.0);
    let own = cssm_core::plan(case, &later, &light, &SceneBounds::default()).unwrap();
    assert!(own.shear != DVec2::ZERO && own.shear != plan.shear);
    assert!((plan.rebased(&later).shear - own.shear).length() < 1e-12);
}

/// A floor with posts, as triangles relative to the eye.
fn floor_with_posts(eye_world: DVec3) -> Vec<[DVec3; 3]> {
    let mut triangles = Vec::new();
    let mut quad = |a: DVec3, b: DVec3, c: DVec3, d: DVec3| {
        let [a, b, c, d] = [a, b, c, d].map(|corner| corner - eye_world);
        triangles.extend([[a, b, c], [a, c, d]]);
    };
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    quad(at(-300.0, -1.5, 50.0), at(300.0, -1.5, 50.0), at(300.0, -1.5, -400.0), at(-300.0, -1.5, -400.0));
    for step in 0..12 {
        let (x, z) = (f64::from(step % 4) * 3.0 - 5.0, -4.0 - f64::from(step) * 4.0);
        quad(at(x, -1.5, z), at(x + 1.8, -1.5, z), at(x + 1.8, 2.5, z), at(x, 2.5, z));
    }
    triangles
}

#[test]
fn capture_with_the_held_plan_and_resolve_with_the_rebased_one_agree() {
    for origin in [DVec3::ZERO, DVec3::new(7.0e6, -5.0e6, 6.0e6)] {
        let mut random = Random::new(9);
        let mut view = level_view(0.2, 400.0);
        view.eye_world += origin;
        let lamp = Light::omni(origin + DVec3::new(3.0, 6.0, -2.0), 60.0).unwrap();
        let suns = cases(1024, 300.0).into_iter().map(|case| (case, sun(toward(40.0, 120.0))));
        let lamps = local_cases(1024).into_iter().filter(|case| case.light == LightKind::Omni);
        for (case, light) in suns.chain(lamps.map(|case| (case, lamp))) {
            let margin = ViewMargin { turn_radians: 0.05, move_metres: 0.5 };
            let request = PlanRequest::new(&case, &view, &light, SceneBounds::default());
            let held = PlanRequest { margin, ..request }.plan().unwrap();
            let later = nearby(&view, &mut random, 0.05, 0.5);
            let rebased = held.rebased(&later);
            let local_eye = held.eye_world - origin;
            let map = capture(&held, &floor_with_posts(local_eye));
            let (mut differ, mut shadowed, mut all) = (0, 0, 0);
            for _ in 0..1500 {
                let (x, z) = (random.between(-12.0, 12.0), random.between(-50.0, -2.0));
                let point = origin + DVec3::new(x, -1.5, z);
                let one = resolve(&case, &held, &map, point - held.eye_world, DVec3::Y);
                let two = resolve(&case, &rebased, &map, point - rebased.eye_world, DVec3::Y);
                let same = (one.visibility - two.visibility).abs() < 1e-2;
                let same_cell = one.cell == two.cell;
                differ += usize::from(!same || !same_cell);
                shadowed += usize::from(two.visibility < 0.5);
                all += 1;
            }
            // Far from the origin a nanometre of the eye may move a point across a border.
            assert!(differ <= 2, "{differ} of {all}, {} at {origin}", case.name);
            assert!(shadowed > 40, "{shadowed} of {all}, {} at {origin}", case.name);
        }
    }
}

#[test]
fn a_plan_with_a_margin_covers_what_lies_in_it_and_nothing_else() {
    let (mut covered, mut lost) = (0, 0);
    for_each_request(&mut |request, random| {
        let margin = ViewMargin { turn_radians: 0.05, move_metres: 0.5 };
        let Ok(plan) = PlanRequest { margin, ..*request }.plan() else { return };
        assert!(plan.covers(request), "{} {:?}", request.case.name, request.light);
        for _ in 0..4 {
            let inner = nearby(request.view, random, 0.05, 0.5);
            let later = PlanRequest { view: &inner, ..*request };
            assert!(plan.covers(&later), "{} {:?}", request.case.name, request.light);
            assert!(plan.rebased(&inner).covers(&later));
            covered += 1;
        }
        // Far off the margin only what the light does not reach may be unseen.
        if request.case.light == LightKind::Directional {
            let outer = nearby(request.view, random, 0.4, 0.0);
            assert!(!plan.covers(&PlanRequest { view: &outer, ..*request }));
            let outer = nearby(request.view, random, 0.0, 60.0);
            lost += usize::from(!plan.covers(&PlanRequest { view: &outer, ..*request }));
        }
    });
    assert!(covered > 300 && lost > 60, "{covered} {lost}");
}

#[test]
fn another_light_region_or_scene_is_not_covered() {
    let case = LightCase::builder("Bounded").technique(Word::plain("standard")).scene_bounds(true);
    let case = case.map_size_texels(1024, 1024).build().unwrap();
    let view = level_view(0.2, f64::INFINITY);
    let light = sun(toward(50.0, 40.0));
    let around =
        |half: f64| SceneBounds::of(Some(BoundingBox { min: DVec3::splat(-half), max: DVec3::splat(half) }));
    let request = PlanRequest::new(&case, &view, &light, around(50.0));
    let plan = request.plan().unwrap();
    assert!(plan.covers(&request));
    assert!(plan.covers(&PlanRequest { bounds: around(40.0), ..request }));
    assert!(!plan.covers(&PlanRequest { bounds: around(60.0), ..request }));
    let turned = sun(toward(50.0, 40.001));
    assert!(!plan.covers(&PlanRequest { light: &turned, ..request }));
    assert!(!plan.covers(&PlanRequest { region: Some(REGION), ..request }));
    let whole = MapRegion { x: 0, y: 0, width: 1024, height: 1024 };
    assert!(plan.covers(&PlanRequest { region: Some(whole), ..request }));

    // What is fitted to volumes covers them alone.
    let over = [("over", Value::Word(Word::plain("visible")))];
    let fitted = LightCase::builder("Fitted").technique(Word::with("bounding_box", over)).scene_bounds(true);
    let fitted = fitted.map_size_texels(1024, 1024).build().unwrap();
    let volume =
        |x: f64| BoundingBox { min: DVec3::new(x, -2.0, -12.0), max: DVec3::new(x + 1.0, 0.0, -10.0) };
    let (near, far) = ([volume(0.0), volume(2.0)], [volume(0.0), volume(4.0)]);
    let request = PlanRequest { case: &fitted, volumes_world: &near, ..request };
    let plan = request.plan().unwrap();
    assert!(plan.covers(&request));
    assert!(plan.covers(&PlanRequest { volumes_world: &near[..1], ..request }));
    assert!(!plan.covers(&PlanRequest { volumes_world: &far, ..request }));
    assert!(!plan.covers(&PlanRequest { volumes_world: &[], ..request }));
}

#[test]
fn a_plan_cut_by_volumes_covers_views_nearby_that_see_no_others() {
    let light = sun(toward(50.0, 40.0));
    let view = level_view(0.2, 400.0);
    let volume = |x: f64, z: f64| BoundingBox {
        min: view.eye_world + DVec3::new(x, -2.0, z),
        max: view.eye_world + DVec3::new(x + 3.0, -1.0, z + 3.0),
    };
    let known = [volume(0.0, -9.0), volume(-8.0, -30.0), volume(5.0, -60.0)];
    let casters = BoundingBox { min: view.eye_world - 80.0, max: view.eye_world + 80.0 };
    let mut random = Random::new(3);
    for technique in ["camera_space", "parallel_split"] {
        let case = LightCase::builder("Fitted").technique(Word::plain(technique)).fit(Fit::Bounds);
        let case = case.shadow_distance_metres(300.0).map_size_texels(1024, 1024).build().unwrap();
        let margin = ViewMargin { turn_radians: 0.05, move_metres: 0.5 };
        let request = PlanRequest {
            volumes_world: &known,
            casters_world: Some(casters),
            ..PlanRequest::new(&case, &view, &light, SceneBounds::default())
        };
        let held = PlanRequest { margin, ..request }.plan().unwrap();
        for _ in 0..20 {
            let inner = nearby(&view, &mut random, 0.05, 0.5);
            let backwards = [known[2], known[0]];
            let later = PlanRequest { view: &inner, volumes_world: &backwards, ..request };
            assert!(held.covers(&later), "{technique}");

            // Every corner of the volumes that the view sees has a facet, and lies in its tile.
            let rebased = held.rebased(&inner);
            for volume in &known {
                let point = (volume.min + volume.max) * 0.5;
                let (_, at) = seen(&rebased, point).unwrap();
                assert!(at.x > 0.0 && at.y > 0.0 && at.x < 1024.0 && at.y < 1024.0, "{at}");
            }
        }
        let others = [known[0], volume(1.0, -12.0)];
        let wider = BoundingBox { max: casters.max + 1.0, ..casters };
        let smaller = BoundingBox { max: casters.max - 1.0, ..casters };
        assert!(!held.covers(&PlanRequest { volumes_world: &others, ..request }), "{technique}");
        assert!(!held.covers(&PlanRequest { volumes_world: &[], ..request }), "{technique}");
        assert!(!held.covers(&PlanRequest { casters_world: None, ..request }), "{technique}");
        assert!(!held.covers(&PlanRequest { casters_world: Some(wider), ..request }), "{technique}");
        assert!(held.covers(&PlanRequest { casters_world: Some(smaller), ..request }), "{technique}");
    }
}

#[test]
fn predicted_footprints_agree_with_the_choice_and_grow_outside_the_margin() {
    let mut compared = 0;
    for_each_request(&mut |request, _| {
        let Ok(plan) = request.plan() else { return };
        let clipped = plan.facets.iter().any(|facet| !facet.clip.is_empty());
        if !plan.choice.complete || clipped || request.case.dominant_plane.is_some() {
            return;
        }
        let far = request.case.shadow_distance_metres.unwrap_or(f64::INFINITY).min(request.view.far_metres);
        let p95 = plan.p95_pixels(&View { far_metres: far, ..*request.view });
        let predicted = plan.basis.p95_pixels;
        // Few samples of the view lie within a lamp's range.
        let limit = if request.case.light.is_local() { 0.5 } else { 0.15 };
        assert!((p95 / predicted - 1.0).abs() < limit, "{p95} {predicted} {}", request.case.name);
        compared += 1;
    });
    assert!(compared > 50, "{compared}");

    // A plan held for a view that has come nearer to the ground is worse than a fresh one.
    let case = &cases(1024, 300.0)[0];
    let (view, light) = (level_view(0.2, 100.0), sun(toward(50.0, 40.0)));
    let plan = PlanRequest::new(case, &view, &light, SceneBounds::default()).plan().unwrap();
    let zoomed = View { left: -0.1, right: 0.1, bottom: -0.1, top: 0.1, ..view };
    assert!(plan.p95_pixels(&zoomed) > 4.0 * plan.p95_pixels(&view));
}

#[test]
fn a_light_that_reaches_nothing_visible_has_a_plan_without_facets() {
    let view = level_view(0.2, 200.0);
    for case in local_cases(512).iter().filter(|case| case.light != LightKind::Directional) {
        let behind = DVec3::new(0.0, 0.0, 50.0);
        let light = match case.light {
            LightKind::Spot => Light::spot(behind, DVec3::Z, 0.5, 20.0).unwrap(),
            _ => Light::omni(behind, 20.0).unwrap(),
        };
        let request = PlanRequest::new(case, &view, &light, SceneBounds::default());
        let plan = request.plan().unwrap();
        assert!(plan.facets.is_empty() && plan.choice.complete, "{}", case.name);
        assert_eq!(plan.p95_pixels(&view), 0.0);
        assert!(plan.covers(&request));
        let shape = case.shape();
        assert_eq!(plan.selection.clone().padded(&shape), plan.selection);

        // Once it comes into view the plan covers it no longer.
        let turned = View { camera_from_world: DMat3::from_rotation_y(std::f64::consts::PI), ..view };
        assert!(!plan.covers(&PlanRequest { view: &turned, ..request }), "{}", case.name);
        assert!(!plan.rebased(&turned).covers(&PlanRequest { view: &turned, ..request }));

        // Everything is lit.
        let map = capture(&plan, &[]);
        assert_eq!(resolve(case, &plan, &map, DVec3::new(0.0, -1.0, -5.0), DVec3::Y).visibility, 1.0);
    }
}
