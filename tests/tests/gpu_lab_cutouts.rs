//! A scene with an alpha mask in the lab: the ray caster and the device see the same holes, in either axes.

use std::path::Path;

use cssm_core::case::{Axes, Casters, LightCase};
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::{Light, View};
use cssm_lab::case_file::pick_case;
use cssm_lab::gpu::{Gpu, ResolveMethod};
use cssm_lab::progress::Progress;
use cssm_lab::scene::{AlphaMask, Instance, Mesh, Scene};
use cssm_lab::stage::{Stage, StageOptions};
use cssm_lab::truth::Tracer;

const SIZE: (u32, u32) = (320, 180);
/// Where the scene lies.
const ORIGIN: DVec3 = DVec3::new(3.1e5, 20.0, -7.7e5);

fn case(axes: Axes) -> LightCase {
    let text =
        "pub case Sun { map: { size: 1024 x 1024 }, resolve: [mask, function { group: 0 }], prefix: sun }";
    LightCase { axes, ..pick_case(Path::new("sun.cssm"), text, None).unwrap() }
}

fn quad(name: &str, corners: [[f32; 3]; 4], mask: Option<AlphaMask>) -> Mesh {
    Mesh { name: name.into(), positions: corners.to_vec(), indices: vec![0, 1, 2, 0, 2, 3], mask }
}

/// Bare ground below a level grille that is repeated twice along each side.
fn scene() -> Scene {
    let (ground, wide) = (30.0, 3.0);
    let level = |half: f32, y: f32| [[-half, y, half], [half, y, half], [half, y, -half], [-half, y, -half]];
    let alpha = (0..16_u8).map(|texel| if (texel % 4 + texel / 4) % 2 == 0 { 255 } else { 0 }).collect();
    let uvs = vec![[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
    let mask = AlphaMask { uvs, width: 4, height: 4, alpha, cutoff: 0.5 };
    let instance =
        |mesh| Instance { mesh, world_from_object: DAffine3::from_translation(ORIGIN), colour: [0.5; 3] };
    Scene {
        name: "grille".into(),
        meshes: vec![quad("ground", level(ground, 0.0), None), quad("grille", level(wide, 4.0), Some(mask))],
        instances: vec![instance(0), instance(1)],
        views: Vec::new(),
        lamps: Vec::new(),
    }
}

#[test]
fn the_lab_draws_the_holes_it_traces() {
    let scene = scene();
    let eye = ORIGIN + DVec3::new(1.0, 6.0, 9.0);
    let view = View::perspective(eye, ORIGIN, DVec3::Y, 1.0, 0.2, f64::INFINITY, SIZE).unwrap();
    let light = Light::directional_travelling(DVec3::new(0.3, -1.0, 0.2)).unwrap();
    let gpu = Gpu::open(&[&case(Axes::Camera), &case(Axes::World)], SIZE).unwrap();
    let options = StageOptions { supersample: false, progress: Progress::Hidden };
    let stage = Stage::new(&gpu, &scene, &Tracer::new(&scene), view, light, options).unwrap();
    for axes in [Axes::Camera, Axes::World] {
        for method in [ResolveMethod::Function, ResolveMethod::Mask] {
            let case = case(axes);
            assert_eq!(case.casters, Casters::Opaque);
            let attempt = stage.attempt(&case, method).unwrap();
            assert_eq!(attempt.case.casters, Casters::AlphaTested);
            let score = attempt.outcome().unwrap().score;
            let what = format!("{axes:?} {method:?}: {score:?}");
            assert!(score.shadowed > 0.02 && score.true_edge_pixels > 500, "{what}");
            assert!(score.leak.interior + score.acne.interior <= 5e-5, "{what}");
            assert!(score.mismatch < 0.02, "{what}");
        }
    }

    // Negative control: a grille without holes is far from the truth.
    let mut whole = scene.clone();
    whole.meshes[1].mask = None;
    let closed = Stage::new(&gpu, &whole, &Tracer::new(&scene), view, light, options).unwrap();
    let score =
        closed.attempt(&case(Axes::Camera), ResolveMethod::Function).unwrap().outcome().unwrap().score;
    assert!(score.mismatch > 0.02, "{score:?}");
}
