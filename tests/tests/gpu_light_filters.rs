//! Many lights in one map under filters of every kind: each as good as alone, also where only some tiles are filtered
//! anew.

use cssm_core::case::{Filter, Kernel, LightKind, PcfSize, Source};
use cssm_lab::gpu::{Gpu, SceneBuffers, Surface};
use cssm_lab::lights::{Bench, Host, Town};
use cssm_lab::scene::Scene;
use cssm_lab::truth::{Frame, Tracer};
use cssm_runtime::lights::LightOptions;

const SIZE: (u32, u32) = (320, 180);
const MAP_SIDE: u32 = 2048;
/// Lights that are judged.
const JUDGED: usize = 6;

#[test]
fn wide_filters_are_as_good_in_company_as_alone() {
    let scene = Scene::city();
    let mut town = Town::new(&scene, SIZE, MAP_SIDE).unwrap();
    for case in &mut town.cases {
        case.filter = match case.light {
            LightKind::Directional => Filter::Evsm2 { exponent: 20.0, blur_texels: 2, bleeding: 0.1 },
            LightKind::Spot => Filter::Pcf { size: PcfSize::Five, kernel: Kernel::Metres(0.05) },
            LightKind::Omni => Filter::Pcss { source: Source::Radius(0.05), reach_texels: 4 },
        };
    }
    let gpu = Gpu::open(&town.cases.iter().collect::<Vec<_>>(), SIZE).unwrap();
    let buffers = SceneBuffers::new(&gpu, &scene).unwrap();
    let tracer = Tracer::new(&scene);
    let mut host = Host::new(&gpu, &town, &buffers, &LightOptions::default()).unwrap();

    // Cars drive, so that tiles are restored and filtered anew one by one; then they are back.
    for cars in [0, 1, 2, 0] {
        host.frame(&town.view, cars).unwrap();
    }
    let frame = Frame::trace(&tracer, &town.view, &town.lights[0].light, &|_| ());
    let surface = Surface::new(&gpu, &town.view, &frame).unwrap();
    let bench = Bench {
        gpu: &gpu,
        scene: &scene,
        tracer: &tracer,
        buffers: &buffers,
        frame: &frame,
        view: town.view,
        surface: &surface,
    };
    let report = host.runner.report().clone();
    let with_texels = (0..town.lights.len()).filter(|light| report.lights[*light].region.is_some());
    let mut kinds = Vec::new();
    let mut pixels = 0;
    for light in with_texels.take(JUDGED) {
        let planted = &town.lights[light];
        let case = &town.cases[town.case(light).0 as usize];
        let found =
            bench.judge(&host.runner, host.handles[light], &planted.name, case, planted.light).unwrap();
        println!("{} {found:?}", case.filter.name());
        pixels += found.judged_pixels;
        kinds.push(case.filter.name());
        assert!(found.excess() <= 1e-3, "{} {found:?}", case.filter.name());
    }
    assert!(pixels > 10_000 && kinds.contains(&"evsm_2"), "{pixels} {kinds:?}");
}
