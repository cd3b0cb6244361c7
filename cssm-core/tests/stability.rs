//! Texels that stay where they are: lattices of texels for linear facets, lattices of views for all.

mod support;

use cssm_core::case::Stability;
use cssm_core::facet::Facet;
use cssm_core::glam::{DMat3, DVec2, DVec3};
use cssm_core::schema::{Value, Word};
use cssm_core::view::ViewLattice;
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use support::{Random, sun, toward};

const FAR: f64 = 200.0;

fn splits() -> Word {
    Word::with("parallel_split", [("splits", Value::Count(4))])
}

fn case(technique: Word, stability: Stability) -> LightCase {
    let case = LightCase::builder("Still").technique(technique).stability(stability);
    case.shadow_distance_metres(FAR).map_size_texels(1024, 1024).build().unwrap()
}

fn view_at(eye_world: DVec3, yaw_degrees: f64) -> View {
    let ahead = DMat3::from_rotation_y(yaw_degrees.to_radians()) * DVec3::new(0.3, -0.15, -1.0);
    let size = (1280, 720);
    View::perspective(eye_world, eye_world + ahead, DVec3::Y, 1.0, 0.2, f64::INFINITY, size).unwrap()
}

fn planned(case: &LightCase, view: &View, light: &Light) -> ShadowPlan {
    plan(case, view, light, &SceneBounds::default()).unwrap()
}

/// A world point in texels of a facet's tile.
fn texel(facet: &Facet, plan: &ShadowPlan, point_world: DVec3) -> DVec2 {
    let point = (point_world - plan.eye_world).extend(1.0);
    let w = facet.rows.w.dot(point);
    let y = facet.rows.remap.y(facet.rows.y.dot(point) / w);
    let (u, v) = facet.tile.texel_from_ndc(facet.rows.x.dot(point) / w, y);
    DVec2::new(u, v)
}

/// Largest distance, in texels, by which the facets' texels of a plan are off those of another, and the largest change of
/// their size.
fn off(one: &ShadowPlan, two: &ShadowPlan, around_world: DVec3) -> (f64, f64) {
    let (mut moved, mut scaled): (f64, f64) = (0.0, 0.0);
    for (before, after) in one.facets.iter().zip(&two.facets) {
        let points = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|step| around_world + step * 10.0);
        let shifts = points.map(|point| texel(after, two, point) - texel(before, one, point));
        let whole = |shift: DVec2| (shift - shift.round()).abs().max_element();
        moved = shifts.into_iter().map(whole).fold(moved, f64::max);
        scaled = shifts.into_iter().map(|shift| (shift - shifts[0]).length()).fold(scaled, f64::max);
    }
    (moved, scaled)
}

#[test]
fn snapped_facets_keep_their_lattice_while_the_camera_moves_and_turns() {
    let light = sun(toward(50.0, 30.0));
    for origin in [DVec3::ZERO, DVec3::new(3.0e6, 1.0e3, -5.0e6)] {
        for technique in [Word::plain("standard"), splits()] {
            let mut kept = [(0, 0); 2];
            for (mode, stability) in [Stability::Snapped, Stability::None].into_iter().enumerate() {
                let case = case(technique.clone(), stability);
                let mut before: Option<ShadowPlan> = None;
                for frame in 0..200 {
                    let frame = f64::from(frame);
                    let eye_world = origin + DVec3::new(0.013, 0.001, -0.021) * frame;
                    let view = view_at(eye_world, 0.05 * frame);
                    let now = planned(&case, &view, &light);
                    if let Some(before) = &before {
                        let (moved, scaled) = off(before, &now, eye_world);
                        let same = moved < 1e-3 && scaled < 1e-3;
                        kept[mode] = (kept[mode].0 + u32::from(same), kept[mode].1 + 1);
                    }
                    before = Some(now);
                }
            }
            // A size changes now and then, because the view turns; without the lattice nothing ever stays.
            let [snapped, free] = kept;
            assert!(snapped.0 * 10 >= snapped.1 * 9, "{snapped:?} {}", technique.name);
            assert_eq!(free.0, 0, "{}", technique.name);
        }
    }
}

#[test]
fn snapped_facets_hold_all_receivers_and_their_texels_are_hardly_larger() {
    let mut random = Random::new(4);
    for technique in [Word::plain("standard"), splits()] {
        let (snapped, free) =
            (case(technique.clone(), Stability::Snapped), case(technique.clone(), Stability::None));
        for _ in 0..40 {
            let view = view_at(random.direction() * 100.0, random.between(0.0, 360.0));
            let light = sun(toward(random.between(5.0, 80.0), random.between(0.0, 360.0)));
            let plan = planned(&snapped, &view, &light);
            for _ in 0..200 {
                let depth = random.between(0.2, FAR);
                let (x, y) = (random.between(0.0, 1280.0), random.between(0.0, 720.0));
                let point = view.ray_world(x, y) * depth;
                let facet = plan.facet(plan.selection.cell(point.extend(1.0))).unwrap();
                let at = texel(facet, &plan, view.eye_world + point);
                let tile = facet.tile;
                let inside = |value: f64, start: u32, side: u32| {
                    let (start, side, gutter) = (f64::from(start), f64::from(side), f64::from(tile.gutter));
                    value > start + gutter - 1e-6 && value < start + side - gutter + 1e-6
                };
                assert!(inside(at.x, tile.x, tile.width) && inside(at.y, tile.y, tile.height), "{at}");
            }
            // The axes are not the camera's, so that oblique views fit less tightly.
            let free = planned(&free, &view, &light).basis.p95_pixels;
            assert!(plan.basis.p95_pixels < 2.5 * free, "{} {free}", plan.basis.p95_pixels);
        }
    }
}

#[test]
fn facets_that_converge_are_fitted_as_without_snapping() {
    let view = view_at(DVec3::new(1.0, 2.0, 3.0), 20.0);
    let light = sun(toward(60.0, 100.0));
    let technique = || Word::plain("camera_space");
    let snapped = planned(&case(technique(), Stability::Snapped), &view, &light);
    let free = planned(&case(technique(), Stability::None), &view, &light);
    assert_eq!(snapped.facets, free.facets);
}

#[test]
fn quantised_plans_stay_the_same_between_lattice_views_and_serve_them_all() {
    let light = sun(toward(50.0, 30.0));
    for technique in [Word::plain("camera_space"), splits()] {
        let quantised = Stability::Quantised { move_metres: 0.5, turn_degrees: 2.0 };
        let case = case(technique.clone(), quantised);
        let (mut same, mut other) = (0, 0);
        let mut before: Option<ShadowPlan> = None;
        for frame in 0..300 {
            let frame = f64::from(frame);
            let eye_world = DVec3::new(0.01, 0.0, 0.013) * frame;
            let view = view_at(eye_world, 0.05 * frame);
            let now = planned(&case, &view, &light);
            assert_eq!(now.eye_world, view.eye_world);

            // Whatever the view sees has a facet and lies in its tile.
            for step in 0..60 {
                let (x, y) = (f64::from(step % 10) * 142.0, f64::from(step / 10) * 143.0);
                let point = view.ray_world(x, y) * (0.2 * f64::exp(f64::from(step % 7)));
                let facet = now.facet(now.selection.cell(point.extend(1.0))).unwrap();
                let at = texel(facet, &now, view.eye_world + point)
                    - DVec2::new(facet.tile.x.into(), facet.tile.y.into());
                let side = DVec2::new(facet.tile.width.into(), facet.tile.height.into());
                assert!(at.cmpge(DVec2::ZERO).all() && at.cmple(side).all(), "{at} {side}");
            }
            if let Some(before) = &before {
                let moved = before.rebased(&view);
                let off = moved.facets.len() != now.facets.len() || {
                    let pairs = moved.facets.iter().zip(&now.facets);
                    let rows = |facet: &Facet| [facet.rows.x, facet.rows.y, facet.rows.z, facet.rows.w];
                    let far = |(one, two): (&Facet, &Facet)| {
                        let pairs = rows(one).into_iter().zip(rows(two));
                        one.tile != two.tile
                            || pairs.into_iter().any(|(one, two)| (one - two).length() > 1e-9 * one.length())
                    };
                    pairs.into_iter().any(far)
                };
                if off { other += 1 } else { same += 1 }
            }
            before = Some(now);
        }
        assert!(same > 260 && other > 3, "{same} {other} {}", technique.name);
    }
}

#[test]
fn the_nearest_view_is_as_near_as_stated() {
    let angle = |one: DMat3, two: DMat3| {
        let turn = one * two.transpose();
        f64::acos((0.5 * (turn.x_axis.x + turn.y_axis.y + turn.z_axis.z - 1.0)).clamp(-1.0, 1.0))
    };
    let mut random = Random::new(8);
    for (pitch_metres, degrees) in [(0.25, 0.5), (3.0, 10.0), (0.0, 45.0)] {
        let lattice = ViewLattice { pitch_metres, pitch_radians: f64::to_radians(degrees) };
        let mut farthest: f64 = 0.0;
        for number in 0..4000 {
            let eye_world = random.direction() * random.between(0.0, 1e4);
            let ahead =
                if number % 5 == 0 { DVec3::Y + 0.01 * random.direction() } else { random.direction() };
            let (size, up) = ((640, 480), random.direction());
            let mut view =
                View::perspective(eye_world, eye_world + ahead, up, 1.0, 0.1, 100.0, size).unwrap();
            if number % 7 == 0 {
                view.camera_from_world =
                    DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0)) * view.camera_from_world;
            }
            let near = lattice.nearest(&view);
            let turned = angle(view.camera_from_world, near.camera_from_world);
            farthest = farthest.max(turned / lattice.farthest_turn_radians());
            assert!(turned <= lattice.farthest_turn_radians() + 1e-7, "{view:?}");
            assert!(eye_world.distance(near.eye_world) <= lattice.farthest_move_metres() + 1e-9);
            let handed = near.camera_from_world.determinant();
            assert!((handed - view.camera_from_world.determinant()).abs() < 1e-9);
            let again = lattice.nearest(&near);
            assert!(angle(near.camera_from_world, again.camera_from_world) < 1e-7, "{view:?}");
        }
        assert!(farthest > 0.8, "the bound is loose: {farthest}");
    }
    let still = ViewLattice { pitch_metres: 0.0, pitch_radians: 0.0 };
    let view = view_at(DVec3::ONE, 3.0);
    assert_eq!(still.nearest(&view), view);
}
