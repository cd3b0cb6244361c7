use cssm_core::glam::DAffine3;

use super::*;
use crate::scene::{AlphaMask, Instance, Mesh, Scene};

fn scene(meshes: Vec<Mesh>, places: &[(usize, DVec3)]) -> Scene {
    let instances = places
        .iter()
        .map(|(mesh, place)| Instance {
            mesh: *mesh,
            world_from_object: DAffine3::from_translation(*place),
            colour: [0.5; 3],
        })
        .collect();
    Scene { name: "made".to_owned(), meshes, instances, views: Vec::new(), lamps: Vec::new() }
}

fn quad(size: f32) -> Mesh {
    Mesh {
        name: "quad".to_owned(),
        positions: vec![[-size, 0.0, -size], [-size, 0.0, size], [size, 0.0, size], [size, 0.0, -size]],
        indices: vec![0, 1, 2, 0, 2, 3],
        mask: None,
    }
}

fn view(eye: DVec3, target: DVec3) -> View {
    View::perspective(eye, target, DVec3::Y, 1.0, 0.1, f64::INFINITY, (64, 48)).unwrap()
}

fn light(x: f64, y: f64, z: f64) -> Light {
    Light::directional_travelling(DVec3::new(x, y, z)).unwrap()
}

/// A sheet one metre over the ground, seen from above and aside.
fn sheet_over_ground(offset: DVec3) -> (Tracer, View) {
    let scene = scene(vec![quad(50.0), quad(1.0)], &[(0, offset), (1, offset + DVec3::Y)]);
    (Tracer::new(&scene), view(offset + DVec3::new(0.0, 6.0, 6.0), offset))
}

#[test]
fn shadow_lies_where_geometry_says() {
    // Far from the origin too: coordinates of ten thousand kilometres still leave a shadow in its place.
    for offset in [DVec3::ZERO, DVec3::new(1e7, 0.0, -1e7)] {
        let (tracer, view) = sheet_over_ground(offset);
        let frame = Frame::trace(&tracer, &view, &light(1.0, -1.0, 0.0), &|_| {});
        let mut counts = [0, 0];
        for (_, pixel) in frame.visible() {
            let point = view.eye_world + pixel.position - offset;
            if point.y > 0.5 {
                assert!(pixel.lit, "the sheet's upper side is lit");
                continue;
            }
            // The sheet [-1, 1] at height 1 throws its shadow one metre along x.
            let inside = (point.x - 1.0).abs().max(point.z.abs());
            if (inside - 1.0).abs() > 1e-6 {
                assert_eq!(pixel.lit, inside > 1.0, "at {point}");
                counts[usize::from(pixel.lit)] += 1;
            }
        }
        assert!(counts.iter().all(|count| *count > 50), "{counts:?}");
    }
}

#[test]
fn shadow_rays_end_at_the_lamp_and_its_reach_is_known() {
    // A lamp half a metre below the sheet and one half a metre above it.
    let (tracer, view) = sheet_over_ground(DVec3::ZERO);
    let trace = |light: Light| Frame::trace(&tracer, &view, &light, &|_| {});
    let ground = |frame: &Frame| -> Vec<(DVec3, Visible)> {
        let points = frame.visible().map(|(_, pixel)| (view.eye_world + pixel.position, *pixel));
        points.filter(|(point, _)| point.y < 0.5).collect()
    };
    let below = ground(&trace(Light::omni(DVec3::Y * 0.5, f64::INFINITY).unwrap()));
    assert!(
        below.iter().all(|(_, pixel)| pixel.lit && pixel.reached),
        "a caster beyond a lamp throws no shadow"
    );

    // From above the sheet hides what lies within three metres of the middle.
    let above = ground(&trace(Light::omni(DVec3::Y * 1.5, f64::INFINITY).unwrap()));
    let mut counts = [0, 0];
    for (point, pixel) in above {
        let inside = point.x.abs().max(point.z.abs()) - 3.0;
        if inside.abs() > 1e-6 {
            assert_eq!(pixel.lit, inside > 0.0, "at {point}");
            assert!((pixel.light_metres - point.distance(DVec3::Y * 1.5)).abs() < 1e-9);
            assert!((pixel.cosine - 1.5 / pixel.light_metres).abs() < 1e-9);
            counts[usize::from(pixel.lit)] += 1;
        }
    }
    assert!(counts.iter().all(|count| *count > 50), "{counts:?}");

    // Beyond range and cone nothing is lit, and nothing faces the light.
    let near = ground(&trace(Light::omni(DVec3::Y * 0.5, 2.0).unwrap()));
    let cone = ground(&trace(Light::spot(DVec3::Y * 0.5, DVec3::NEG_Y, 1.0, f64::INFINITY).unwrap()));
    for (frame, reach) in [(near, 3.75_f64.sqrt()), (cone, 0.5 * 1_f64.tan())] {
        assert!(frame.iter().any(|(_, pixel)| pixel.reached));
        for (point, pixel) in frame {
            let distance = libm::hypot(point.x, point.z);
            if (distance - reach).abs() > 1e-6 {
                assert_eq!((pixel.reached, pixel.lit), (distance < reach, distance < reach), "at {point}");
                assert!(pixel.reached || !pixel.faces_light());
            }
        }
    }
}

#[test]
fn both_sides_of_a_sheet_cast_and_are_seen() {
    let mut flipped = quad(1.0);
    flipped.indices = vec![0, 2, 1, 0, 3, 2];
    let scene = scene(vec![quad(50.0), flipped], &[(0, DVec3::ZERO), (1, DVec3::Y)]);
    let tracer = Tracer::new(&scene);
    let frame =
        Frame::trace(&tracer, &view(DVec3::new(0.0, 6.0, 6.0), DVec3::ZERO), &light(0.0, -1.0, 0.0), &|_| {});
    assert!(frame.visible().any(|(_, pixel)| pixel.instance == 1 && pixel.lit));
    assert!(frame.visible().any(|(_, pixel)| pixel.instance == 0 && !pixel.lit));
    assert!(frame.visible().all(|(_, pixel)| pixel.normal.dot(pixel.position) < 0.0));
}

/// A sheet of four squares one metre over the ground, two of which are holes: those where x and z have one sign.
fn checked_sheet_over_ground() -> Scene {
    let mask = AlphaMask {
        uvs: vec![[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]],
        width: 2,
        height: 2,
        alpha: vec![10, 255, 255, 10],
        cutoff: 0.5,
    };
    let sheet = Mesh { mask: Some(mask), ..quad(1.0) };
    scene(vec![quad(50.0), sheet], &[(0, DVec3::ZERO), (1, DVec3::Y)])
}

#[test]
fn holes_neither_cast_nor_are_seen() {
    let masked = checked_sheet_over_ground();
    let mut whole = masked.clone();
    whole.meshes[1].mask = None;
    let view = view(DVec3::new(0.0, 6.0, 6.0), DVec3::ZERO);
    let traced = |scene: &Scene| Frame::trace(&Tracer::new(scene), &view, &light(1.0, -1.0, 0.0), &|_| {});
    let hole = |x: f64, z: f64| x.abs() < 1.0 && z.abs() < 1.0 && (x > 0.0) == (z > 0.0);

    let mut seen = [0, 0];
    for (_, pixel) in traced(&masked).visible() {
        let point = view.eye_world + pixel.position;
        if pixel.instance == 1 {
            assert!(!hole(point.x, point.z), "the hole at {point} is seen");
            seen[1] += 1;
            continue;
        }
        // The shadow lies one metre along x; what is over a hole is lit.
        let (x, z) = (point.x - 1.0, point.z);
        let clear = (x.abs() - 1.0).abs().min((z.abs() - 1.0).abs()).min(x.abs()).min(z.abs()) > 1e-6;
        if clear {
            assert_eq!(pixel.lit, x.abs() > 1.0 || z.abs() > 1.0 || hole(x, z), "at {point}");
            seen[0] += usize::from(!pixel.lit);
        }
    }
    assert!(seen.iter().all(|count| *count > 25), "{seen:?}");

    // Without its mask the sheet shows and casts twice as much.
    let whole = traced(&whole);
    let shadowed = whole.visible().filter(|(_, pixel)| pixel.instance == 0 && !pixel.lit).count();
    let sheet = whole.visible().filter(|(_, pixel)| pixel.instance == 1).count();
    assert!(2 * shadowed > 3 * seen[0] && 2 * sheet > 3 * seen[1], "{shadowed} {sheet} against {seen:?}");
}

#[test]
fn hierarchy_agrees_with_trying_every_triangle() {
    let scene = Scene::palm();
    let tracer = Tracer::new(&scene);
    let spot = scene.views[0];
    let view =
        View::perspective(spot.eye_world, spot.target_world, DVec3::Y, 1.0, 0.1, f64::INFINITY, (24, 16))
            .unwrap();
    let mut stack = Vec::new();
    for (index, direction) in [DVec3::new(0.4, 0.8, 0.3), DVec3::Y, DVec3::X].into_iter().enumerate() {
        for pixel in 0..24 * 16 {
            let ray = view.ray_world(f64::from(pixel % 24) + 0.5, f64::from(pixel / 24) + 0.5);
            let found = tracer.nearest(view.eye_world, ray, 0.1, f64::INFINITY, &mut stack);
            let tried = tracer.nearest_tried(view.eye_world, ray, 0.1);
            assert_eq!(found.map(|hit| hit.distance), tried.map(|hit| hit.distance));
            let Some(hit) = found else { continue };
            let point = view.eye_world + ray * hit.distance;
            for end in [f64::INFINITY, 3.0] {
                let (toward, within) = (direction.normalize(), 1e-9..end);
                let blocked = tracer.blocked(point, toward, within.clone(), hit.triangle, &mut stack);
                let tried = tracer.blocked_tried(point, toward, within, hit.triangle);
                assert_eq!(blocked, tried, "light {index}, pixel {pixel}, up to {end}");
            }
        }
    }
}

#[test]
fn axis_aligned_rays_meet_flat_boxes() {
    // The light runs exactly along an axis, in the planes of box sides, through flat boxes.
    let (tracer, view) = sheet_over_ground(DVec3::ZERO);
    let frame = Frame::trace(&tracer, &view, &light(0.0, -1.0, 0.0), &|_| {});
    assert!(frame.visible().filter(|(_, pixel)| !pixel.lit).count() > 10);
}

#[test]
fn empty_scenes_are_sky() {
    let tracer = Tracer::new(&scene(Vec::new(), &[]));
    let frame = Frame::trace(&tracer, &view(DVec3::X, DVec3::ZERO), &light(0.0, -1.0, 0.0), &|_| {});
    assert_eq!(frame.visible().count(), 0);
}

#[test]
fn city_is_traced_in_seconds() {
    let start = std::time::Instant::now();
    let scene = Scene::city();
    let tracer = Tracer::new(&scene);
    let built = start.elapsed();
    let spot = scene.views[0];
    let view =
        View::perspective(spot.eye_world, spot.target_world, DVec3::Y, 1.0, 0.1, f64::INFINITY, (640, 360))
            .unwrap();
    let light = Light::directional_travelling(spot.light_travels).unwrap();
    let frame = Frame::trace(&tracer, &view, &light, &|_| {});
    println!(
        "{} triangles: built in {built:?}, with 640 x 360 pixels {:?}",
        tracer.triangles(),
        start.elapsed()
    );
    let shadowed = frame.visible().filter(|(_, pixel)| !pixel.lit).count();
    assert!(shadowed > 640 * 360 / 20 && frame.visible().count() > 640 * 360 / 2, "{shadowed}");
}

#[test]
fn rays_along_the_sides_of_boxes_pass_through_no_seam() {
    // Two sheets meet in the plane that the rays run in.
    let places = [(0, DVec3::new(-1.0, 1.0, 0.0)), (0, DVec3::new(1.0, 1.0, 0.0))];
    let tracer = Tracer::new(&scene(vec![quad(1.0)], &places));
    let mut stack = Vec::new();
    for z in [-0.7, 0.0, 0.3] {
        for direction in [DVec3::NEG_Y, DVec3::new(0.0, -1.0, 0.1)] {
            let hit = tracer.nearest(DVec3::new(0.0, 3.0, z), direction, 0.0, f64::INFINITY, &mut stack);
            assert_eq!(hit.map(|hit| hit.distance), Some(2.0), "{direction} at z {z}");
        }
    }
}
