//! Facets that share a tile: clip distances and discarding fragments both draw what the twin draws, visibility follows,
//! and a missing cut is caught.

use cssm_codegen::generate;
use cssm_core::case::{Bias, Casters, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::glam::DVec4;
use cssm_core::table::ShaderKind;
use cssm_core::{SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{Options, ServiceError, ShadowService, features_and_limits, wgpu};
use cssm_tests::gpu::depth_bracket::{DepthBracket, SLIVERS};
use cssm_tests::gpu::resolve::Visible;
use cssm_tests::gpu::score::Score;
use cssm_tests::gpu::stage::Stage;
use cssm_tests::gpu::yard::{Yard, views};
use cssm_tests::gpu::{dueling, exclusive};

const FRAGMENTS: Options = Options {
    mask_format: wgpu::TextureFormat::R8Unorm,
    material_stages: wgpu::ShaderStages::FRAGMENT,
    clamp_in_fragments: true,
    culling: cssm_runtime::Culling::Cpu,
};

fn case(filter: Filter) -> LightCase {
    LightCase::builder("Dueling")
        .configurations(&["four_plane"])
        .map_size_texels(512, 512)
        .filter(filter)
        .bias(Bias::ReceiverPlane)
        .resolve(&[
            Resolve::Mask { depth: MaskDepth::Linear, normal: MaskNormal::Texture },
            Resolve::Function { group: 2, first_binding: 0 },
        ])
        .build()
        .unwrap()
}

fn planned(case: &LightCase, view: &View, sun: usize) -> ShadowPlan {
    plan(case, view, &dueling::suns(view)[sun], &SceneBounds::default()).unwrap()
}

/// Whether facets share a tile; with the sun outside the view one plane may be better.
fn shares(plan: &ShadowPlan) -> bool {
    plan.facets.iter().any(|facet| !facet.clip.is_empty())
}

#[test]
fn clip_distances_and_discarding_draw_what_the_twin_draws() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let case = case(Filter::Gather2x2);
    let mut clipped = Stage::new(&gpu, &yard, &case, &Options::default());
    let mut discarding = Stage::new(&gpu, &yard, &case, &FRAGMENTS);
    assert_eq!(discarding.service.capture_shader(), ShaderKind::CaptureClamped);
    let needed = wgpu::Features::CLIP_DISTANCES | wgpu::Features::DEPTH_CLIP_CONTROL;
    if gpu.device.features().contains(needed) {
        assert_eq!(clipped.service.capture_shader(), ShaderKind::Capture);
    }
    let (mut outside, mut texels, mut covered, mut shared) = ([0, 0], 0, 0, 0);
    let (mut differing, mut surely_differing) = (0, 0);
    for view in &views((160, 90)) {
        for sun in 0..3 {
            let plan = planned(&case, view, sun);
            shared += usize::from(shares(&plan));
            let bracket = DepthBracket::new(&yard, &plan, case.map.format);
            let maps = [clipped.capture(&plan, view), discarding.capture(&plan, view)];
            for (map, outside) in maps.iter().zip(&mut outside) {
                *outside += bracket.violations(map);
            }
            let cleared = plan.depth_order.cleared();
            texels += maps[0].depths.len();
            covered += maps[0].depths.iter().filter(|depth| **depth != cleared).count();
            let differs = |texel: &usize| (maps[0].depths[*texel] - maps[1].depths[*texel]).abs() > 2e-6;
            for texel in (0..maps[0].depths.len()).filter(differs) {
                differing += 1;
                surely_differing += usize::from(bracket.is_sure(texel));
            }
        }
    }
    assert!(shared >= 6, "only {shared} plans share a tile");
    assert!(covered > texels / 10, "only {covered} of {texels} texels are covered");
    for (outside, what) in outside.into_iter().zip(["clip distances", "discarding"]) {
        assert!(outside as f64 <= SLIVERS * texels as f64, "{what}: {outside} of {texels} texels");
    }
    // The two ways may differ within 1/64 texel of an edge; few texels lie there.
    assert!(
        surely_differing as f64 <= SLIVERS * texels as f64,
        "{surely_differing} of {texels} texels differ"
    );
    assert!(differing * 2000 <= texels, "{differing} of {texels} texels differ");
}

#[test]
fn visibility_is_the_twins_across_the_diagonals() {
    let (gpu, yard) = (exclusive(), Yard::new());
    for filter in [Filter::None, Filter::Hardware2x2, Filter::Gather2x2] {
        let case = case(filter);
        for (number, view) in views((192, 108)).iter().enumerate() {
            let visible = Visible::new(view, &yard.triangles_from_eye(view));
            let options = if number == 1 { FRAGMENTS } else { Options::default() };
            let mut stage = Stage::new(&gpu, &yard, &case, &options);
            for sun in 0..3 {
                let drawn = stage.draw(planned(&case, view, sun), view, &visible);
                let mut score = Score::default();
                score.add(&case, &drawn, &visible);
                let what = format!("{filter:?}, view {number}, sun {sun}: {score:?}");
                assert!(score.judged > 8_000 && score.shadowed > 100, "{what}");
                assert!(score.mask_wrong * 2000 <= score.judged, "{what}");
                assert!(score.material_wrong * 2000 <= score.judged, "{what}");
            }
        }
    }
}

#[test]
fn wrong_cuts_are_caught() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let case = case(Filter::Gather2x2);
    let view = &views((160, 90))[0];
    let good = planned(&case, view, 1);
    assert!(shares(&good));
    let bracket = DepthBracket::new(&yard, &good, case.map.format);
    type Change = (&'static str, fn(&mut ShadowPlan));
    let changes: [Change; 3] = [
        ("no cuts", |plan| plan.facets.iter_mut().for_each(|facet| facet.clip.clear())),
        ("half of the cuts", |plan| plan.facets.iter_mut().for_each(|facet| facet.clip.truncate(1))),
        ("turned cuts", |plan| {
            plan.facets.iter_mut().flat_map(|facet| &mut facet.clip).for_each(|clip| *clip = -*clip);
        }),
    ];
    for options in [Options::default(), FRAGMENTS] {
        let mut stage = Stage::new(&gpu, &yard, &case, &options);
        let unchanged = bracket.violations(&stage.capture(&good, view));
        assert!(unchanged <= 5, "{unchanged} texels without a change");
        for (what, change) in changes {
            let mut plan = good.clone();
            change(&mut plan);
            let wrong = bracket.violations(&stage.capture(&plan, view));
            assert!(wrong > 100, "{what}: only {wrong} texels");
        }
    }
}

#[test]
fn cuts_that_do_not_belong_are_refused() {
    let gpu = exclusive();
    let (case, view) = (case(Filter::None), &views((160, 90))[0]);
    let table = generate(&case).unwrap().table;
    let needed = features_and_limits(&gpu.adapter, &table).unwrap();
    let offered = gpu.adapter.features() & wgpu::Features::CLIP_DISTANCES;
    assert_eq!(needed.features & wgpu::Features::CLIP_DISTANCES, offered);
    let rectangles = LightCase::builder("Columns").configurations(&["face_columns"]).build().unwrap();
    let needed = features_and_limits(&gpu.adapter, &generate(&rectangles).unwrap().table).unwrap();
    assert!(!needed.features.contains(wgpu::Features::CLIP_DISTANCES), "nothing is cut there");

    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let good = planned(&case, view, 0);
    service.prepare(&good, view, &[]).unwrap();
    let changes: [fn(&mut ShadowPlan); 3] = [
        |plan| plan.facets[0].clip = vec![DVec4::W; 3],
        |plan| plan.facets[0].clip = vec![DVec4::NAN],
        |plan| plan.facets[0].clip = vec![DVec4::X * 1e300],
    ];
    for (number, change) in changes.iter().enumerate() {
        let mut plan = good.clone();
        change(&mut plan);
        let refused = service.prepare(&plan, view, &[]);
        assert!(matches!(refused, Err(ServiceError::ForeignPlan { .. })), "change {number}: {refused:?}");
    }
}

#[test]
fn tested_casters_are_cut_as_well() {
    // The yard's meshes have no masks: an alpha-tested case must still draw them as the opaque one does.
    let (gpu, yard) = (exclusive(), Yard::new());
    let opaque = case(Filter::Gather2x2);
    let tested = LightCase { casters: Casters::AlphaTested, ..opaque.clone() };
    let view = &views((160, 90))[0];
    let plan = planned(&opaque, view, 0);
    for options in [Options::default(), FRAGMENTS] {
        let one = Stage::new(&gpu, &yard, &opaque, &options).capture(&plan, view);
        let other = Stage::new(&gpu, &yard, &tested, &options).capture(&plan, view);
        assert_eq!(one, other);
    }
}
