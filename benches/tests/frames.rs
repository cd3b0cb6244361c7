//! What is timed is a frame with the right shadows.

use cssm_benches::contender::Contender;
use cssm_benches::run::{Extent, opened_for};
use cssm_benches::situation::situations;
use cssm_benches::view_passes::ViewPasses;
use cssm_lab::gpu::{Gpu, SceneBuffers, Stopwatch};
use cssm_lab::progress::Progress;
use cssm_lab::scene::Scene;
use cssm_lab::truth::{Frame, Tracer};
use cssm_runtime::read_back;

const IMAGE_PIXELS: (u32, u32) = (160, 160);
const MAP_SIDE_TEXELS: u32 = 1280;

#[test]
fn masks_of_timed_frames_agree_with_ray_casting() {
    let scene = Scene::palm();
    let extent = Extent {
        image_pixels: IMAGE_PIXELS,
        map_sides_texels: &[MAP_SIDE_TEXELS],
        contenders: usize::MAX,
        runs: 1,
        warm_up_runs: 0,
        progress: Progress::Hidden,
    };
    let cases = opened_for(&scene, &extent).unwrap();
    let gpu = Gpu::open(&cases.iter().collect::<Vec<_>>(), IMAGE_PIXELS).unwrap();
    let stopwatch = Stopwatch::new(&gpu, 4).unwrap();
    let buffers = SceneBuffers::new(&gpu, &scene).unwrap();
    let tracer = Tracer::new(&scene);
    for situation in situations(&scene, IMAGE_PIXELS).unwrap() {
        let view = &situation.view;
        let truth = Frame::trace(&tracer, view, &situation.light, &|_| ());
        let toward_light = situation.light.toward_world(view.eye_world);
        let passes = ViewPasses::new(&gpu, &scene, view, toward_light).unwrap();
        for name in situation.cases {
            let contender =
                Contender::new(&gpu, &scene, &buffers, &situation, name, MAP_SIDE_TEXELS).unwrap();
            let times = contender.time(&gpu, &passes, &stopwatch).unwrap();
            assert!(
                times.capture > 0.0 && times.resolve > 0.0 && times.frame >= times.shadows(),
                "{times:?}"
            );

            let lit = read_back::texture_bytes(&gpu.device, &gpu.queue, passes.lit.texture()).unwrap();
            let (mut judged, mut shadowed, mut wrong) = (0, 0, 0);
            for (index, pixel) in truth.visible().filter(|(_, pixel)| pixel.faces_light()) {
                judged += 1;
                shadowed += usize::from(!pixel.lit);
                wrong += usize::from((lit[index] >= 128) != pixel.lit);
            }
            println!("{}, {name}: {shadowed} of {judged} shadowed, {wrong} wrong", situation.name);

            // A uniform map over the whole ground is coarse; every other one is not.
            let share = wrong as f64 / judged as f64;
            let most = if *name == "Standard" { 0.08 } else { 0.04 };
            assert!(shadowed * 30 > judged && share < most, "{name}: {share}");
        }
    }
}
