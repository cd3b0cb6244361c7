use super::*;

const SIZE: (u32, u32) = (160, 90);

#[test]
fn every_scene_has_every_path_seen_and_unseen() {
    for scene in [Scene::palm(), Scene::pavilion()] {
        let tracer = Tracer::new(&scene);
        let seen = builtin(&scene, &tracer, SIZE).unwrap();
        let unseen = unseen(&scene, &tracer, SIZE).unwrap();
        let names = |paths: &[ViewPath]| paths.iter().map(|path| path.name.clone()).collect::<Vec<_>>();
        assert_eq!(
            names(&seen),
            ["walk", "drive", "flight", "dueling", "interior", "kilometre", "infinite", "orbit", "borders"]
        );
        assert_eq!(names(&seen), names(&unseen));
        for (one, other) in seen.iter().zip(&unseen) {
            for station in &one.stations {
                assert!(!other.stations.contains(station), "{} of {} is seen", one.name, scene.name);
            }
        }
    }
}

#[test]
fn a_moved_camera_moves_a_centimetre_or_turns_a_twentieth_of_a_degree() {
    let scene = Scene::palm();
    let (view, light) = scene.views[0].pictured(SIZE).unwrap();
    let station = Station { view, light };
    let step = station.moved(Motion::Step);
    assert!((step.view.eye_world.distance(view.eye_world) - 0.01).abs() < 1e-12);
    assert_eq!(step.view.camera_from_world, view.camera_from_world);
    let turn = station.moved(Motion::Turn);
    assert_eq!(turn.view.eye_world, view.eye_world);
    let cosine = turn.view.camera_from_world.row(2).dot(view.camera_from_world.row(2));
    assert!((libm::acos(cosine).to_degrees() - 0.05).abs() < 1e-6);
    // The camera turns to the right: what was ahead is now to the left.
    assert!((turn.view.camera_from_world * -view.camera_from_world.row(2)).x < 0.0);
}

#[test]
fn paths_are_thinned_evenly() {
    let scene = Scene::palm();
    let tracer = Tracer::new(&scene);
    let orbit = builtin(&scene, &tracer, SIZE).unwrap().remove(7);
    assert_eq!(orbit.stations.len(), 40);
    let few = orbit.clone().thinned(3);
    assert_eq!(few.stations, [orbit.stations[6], orbit.stations[20], orbit.stations[33]]);
    assert_eq!(orbit.clone().thinned(0).stations.len(), 40);
    assert_eq!(orbit.clone().thinned(99).stations.len(), 40);
}
