//! The scenes' lamps stand where their names say, and show something worth judging.

use cssm_core::glam::DVec3;
use cssm_core::light::LightPosition;
use cssm_core::{Light, View};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::sight::{Sight, StageOptions};
use cssm_lab::truth::Tracer;

const SIZE: (u32, u32) = (320, 180);

fn position(view: &View, light: &Light) -> LightPosition {
    let world = light.homogeneous(view.eye_world);
    LightPosition::of(view, (view.camera_from_world * world.truncate()).extend(world.w))
}

/// Distance to the nearest surface along some directions.
fn clearance(tracer: &Tracer, point: DVec3) -> f64 {
    let mut stack = Vec::new();
    let directions = (0..400_u32).map(|index| {
        let (turn, height) = (f64::from(index) * 2.399_963, f64::from(index) / 200.0 - 0.9975);
        DVec3::new(turn.cos(), 0.0, turn.sin()) * (1.0 - height * height).sqrt() + DVec3::Y * height
    });
    let hits = directions.filter_map(|way| tracer.nearest(point, way, 0.0, f64::INFINITY, &mut stack));
    hits.map(|hit| hit.distance).fold(f64::INFINITY, f64::min)
}

#[test]
fn lamps_stand_where_their_names_say() {
    for scene in [Scene::palm(), Scene::city(), Scene::pavilion(), Scene::forest()] {
        let tracer = Tracer::new(&scene);
        for lamp in &scene.lamps {
            let (view, light) = lamp.pictured(SIZE).unwrap();
            let (Light::Omni { position_world, .. } | Light::Spot { position_world, .. }) = light else {
                panic!("{} is no lamp", lamp.name)
            };
            let place = position(&view, &light);
            let sees_eye = light.reaches(view.eye_world);
            let right = match lamp.name {
                "omni-in-view" => place == LightPosition::InView,
                "omni-beside" => place == LightPosition::BesideView,
                "omni-outside" => place == LightPosition::General,
                "omni-behind" => place == LightPosition::Dueling,
                "omni-at-eye" => place == LightPosition::AtEye,
                "omni-at-wall" => {
                    let wall = clearance(&tracer, position_world);
                    (0.01..0.055).contains(&wall)
                }
                "spot-dueling" => sees_eye && place == LightPosition::InView,
                "spot-aside" => !sees_eye,
                "spot-ahead" => position_world.distance(view.eye_world) < 3.0,
                _ => false,
            };
            assert!(right, "{} on {}: {place:?}", lamp.name, scene.name);

            let options = StageOptions { supersample: false, progress: Progress::Hidden };
            let sight = Sight::trace(&scene, &tracer, view, light, options).unwrap();
            let facing = sight.frame.visible().filter(|(_, pixel)| pixel.faces_light());
            let (lit, shadowed): (Vec<_>, Vec<_>) = facing.partition(|(_, pixel)| pixel.lit);
            println!("{} on {}: {} lit, {} shadowed", lamp.name, scene.name, lit.len(), shadowed.len());
            assert!(lit.len() > 1000 && shadowed.len() > 50, "{} on {}", lamp.name, scene.name);
        }
    }
}
