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
