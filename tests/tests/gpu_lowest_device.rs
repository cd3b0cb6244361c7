//! A device with WebGL2-class limits and no optional feature runs every shipped case, and alpha-tested ones, as the twin
//! does.

use cssm_codegen::dsl::parse_file;
use cssm_core::case::{Bias, Casters, FarKind, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::distribution::RemapKind;
use cssm_core::table::ShaderKind;
use cssm_core::{SceneBounds, plan};
use cssm_runtime::{Options, wgpu};
use cssm_tests::gpu::depth_bracket::{DepthBracket, SLIVERS};
use cssm_tests::gpu::resolve::Visible;
use cssm_tests::gpu::score::Score;
use cssm_tests::gpu::stage::Stage;
use cssm_tests::gpu::yard::{self, Yard, views};
use cssm_tests::gpu::{dueling, new_device};
use shaders_gen::shipped;

/// Largest map of such a device.
const SIDE: u32 = 2048;
/// Size of the image in pixels.
const SIZE: (u32, u32) = (128, 72);

fn cases() -> Vec<LightCase> {
    let shipped = |text: &&str| parse_file("case.cssm", text).expect("a shipped case");
    // Exact stretching fetches corners from storage, which such a device has none of; the yard has suns only.
    let runs = |case: &LightCase| !case.light.is_local() && case.remap() == RemapKind::None;
    let mut cases: Vec<_> = shipped::ALL.iter().flat_map(shipped).filter(runs).collect();
    let tested = LightCase::builder("Tested")
        .configurations(&["face_columns", "one_plane", "four_plane"])
        .map_size_texels(SIDE, SIDE)
        .bias(Bias::ReceiverPlane)
        .casters(Casters::AlphaTested)
        .resolve(&[
            Resolve::Mask { depth: MaskDepth::ReversedZ, normal: MaskNormal::Reconstructed },
            Resolve::Function { group: 2, first_binding: 0 },
        ]);
    cases.push(tested.build().expect("a valid case"));
    for case in &mut cases {
        (case.map.width, case.map.height) = (case.map.width.min(SIDE), case.map.height.min(SIDE));
    }
    cases
}

#[test]
fn every_case_runs_on_the_lowest_device() {
    let (gpu, yard) = (new_device(wgpu::Features::empty()), Yard::new());
    assert_eq!(gpu.device.features(), wgpu::Features::empty());
    assert_eq!(gpu.device.limits().max_texture_dimension_2d, SIDE);
    let views = views(SIZE);
    let seen: Vec<_> =
        views.iter().map(|view| (view, Visible::new(view, &yard.triangles_from_eye(view)))).collect();
    let cases = cases();
    assert!(cases.len() > 7);
    for case in &cases {
        let mut stage = Stage::new(&gpu, &yard, case, &Options::default());
        assert_eq!(stage.service.capture_shader(), ShaderKind::CaptureClamped);
        let mut score = Score::default();
        for (number, (view, visible)) in seen.iter().enumerate() {
            if case.far == FarKind::Finite && view.far_metres.is_infinite() {
                continue;
            }
            let receivers = case.scene_bounds.then(|| yard.bounds());
            let light = if number == 0 { yard::suns()[0] } else { dueling::suns(view)[number] };
            let plan = plan(case, view, &light, &SceneBounds::of(receivers)).unwrap();

            // The twin's bracket takes nine maps: one view of each case is enough.
            let bracket = (number == 1).then(|| DepthBracket::new(&yard, &plan, case.map.format));
            let drawn = stage.draw(plan, view, visible);
            if let Some(bracket) = bracket {
                let (outside, texels) = (bracket.violations(&drawn.map), drawn.map.depths.len());
                let limit = 1.0 + SLIVERS * texels as f64;
                assert!(outside as f64 <= limit, "{}: {outside} of {texels} texels", case.name);
            }
            score.add(case, &drawn, visible);
        }
        let what = format!("{} {:?}: {score:?}", case.name, case.configurations);
        assert!(score.judged > 10_000 && score.mask_judged > 5_000 && score.shadowed > 100, "{what}");
        assert!(score.mask_wrong * 1000 <= score.mask_judged, "{what}");
        assert!(score.material_wrong * 1000 <= score.judged, "{what}");
    }
}
