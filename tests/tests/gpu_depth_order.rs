//! Depth stored reversed: the same plan stored either way draws complementary maps and the same visibility, also when
//! frames of both orders share a submission.

use cssm_codegen::generate;
use cssm_core::case::{Bias, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::plan::DepthOrder;
use cssm_core::schema::Word;
use cssm_core::{SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{Options, ServiceError, ShadowService};
use cssm_tests::gpu::depth_bracket::{DepthBracket, SLIVERS};
use cssm_tests::gpu::exclusive;
use cssm_tests::gpu::resolve::Visible;
use cssm_tests::gpu::score::Score;
use cssm_tests::gpu::stage::Stage;
use cssm_tests::gpu::yard::{Yard, suns, views};

fn case(technique: &'static str, filter: Filter) -> LightCase {
    LightCase::builder("Ahead")
        .technique(Word::plain(technique))
        .map_size_texels(512, 512)
        .shadow_distance_metres(150.0)
        .filter(filter)
        .bias(Bias::ReceiverPlane)
        .resolve(&[
            Resolve::Mask { depth: MaskDepth::Linear, normal: MaskNormal::Texture },
            Resolve::Function { group: 2, first_binding: 0 },
        ])
        .build()
        .unwrap()
}

/// The plan of a sun ahead of the camera.
fn planned(case: &LightCase, view: &View) -> ShadowPlan {
    plan(case, view, &suns()[2], &SceneBounds::default()).unwrap()
}

/// The same plan with depth stored the other way round.
fn flipped(plan: &ShadowPlan) -> ShadowPlan {
    let mut plan = plan.clone();
    for facet in &mut plan.facets {
        facet.rows.z = facet.rows.w - facet.rows.z;
    }
    plan.depth_order = match plan.depth_order {
        DepthOrder::Standard => DepthOrder::Reversed,
        DepthOrder::Reversed => DepthOrder::Standard,
    };
    plan
}

#[test]
fn both_orders_draw_what_the_twin_draws() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let view = &views((192, 108))[0];
    let visible = Visible::new(view, &yard.triangles_from_eye(view));
    for filter in [Filter::None, Filter::Hardware2x2, Filter::Gather2x2] {
        let case = case("camera_space", filter);
        let first = planned(&case, view);
        let mut masks = Vec::new();
        for clamp_in_fragments in [false, true] {
            let options = Options { clamp_in_fragments, ..Options::default() };
            let mut stage = Stage::new(&gpu, &yard, &case, &options);
            let mut maps = Vec::new();
            for plan in [first.clone(), flipped(&first)] {
                let bracket = DepthBracket::new(&yard, &plan, case.map.format);
                let order = plan.depth_order;
                let drawn = stage.draw(plan, view, &visible);
                let outside = bracket.violations(&drawn.map);
                let limit = 1.0 + SLIVERS * drawn.map.depths.len() as f64;
                assert!(outside as f64 <= limit, "{filter:?} {order:?}: {outside} texels");
                let mut score = Score::default();
                score.add(&case, &drawn, &visible);
                let what = format!("{filter:?} {order:?}: {score:?}");
                assert!(score.judged > 10_000 && score.shadowed > 100, "{what}");
                assert!(score.mask_wrong * 2000 <= score.judged, "{what}");
                assert!(score.material_wrong * 2000 <= score.judged, "{what}");

                // Negative control: a bracket of the other order.
                if order == DepthOrder::Reversed {
                    let other = DepthBracket::new(&yard, &flipped(&drawn.plan), case.map.format);
                    assert!(other.violations(&drawn.map) > drawn.map.depths.len() / 10);
                }
                maps.push(drawn.map);
                masks.extend(drawn.mask);
            }
            let complement = |(one, other): (&f64, &f64)| (one + other - 1.0).abs();
            let worst = maps[0].depths.iter().zip(&maps[1].depths).map(complement).fold(0.0, f64::max);
            assert!(worst <= 1e-5, "{filter:?}: the maps differ by {worst}");
        }
        for mask in &masks[1..] {
            let differs = |(one, other): &(&u8, &u8)| one.abs_diff(**other) > 1;
            let differing = masks[0].iter().zip(mask).filter(differs).count();
            assert!(differing * 500 <= mask.len(), "{filter:?}: {differing} pixels differ");
        }
    }
}

#[test]
fn orders_mix_in_one_submission() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let view = &views((192, 108))[0];
    let visible = Visible::new(view, &yard.triangles_from_eye(view));
    let case = case("camera_space", Filter::Hardware2x2);
    let mut stage = Stage::new(&gpu, &yard, &case, &Options::default());
    let first = planned(&case, view);
    let other = flipped(&first);
    let alone: Vec<_> = [&first, &other].map(|plan| stage.masks_together(&[plan], view, &visible)).concat();
    assert!(alone[0].contains(&0) && alone[0].contains(&255));
    let together = stage.masks_together(&[&first, &other, &first], view, &visible);
    assert_eq!(together, [alone[0].clone(), alone[1].clone(), alone[0].clone()]);
}

#[test]
fn tables_that_never_reverse_refuse_reversed_plans() {
    let gpu = exclusive();
    let view = &views((192, 108))[0];
    let case = case("standard", Filter::None);
    let table = generate(&case).unwrap().table;
    assert!(!table.may_reverse_depth);
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let plan = planned(&case, view);
    assert_eq!(plan.depth_order, DepthOrder::Standard);
    service.prepare(&plan, view, &[]).unwrap();
    let refused = service.prepare(&flipped(&plan), view, &[]);
    assert!(matches!(refused, Err(ServiceError::ForeignPlan { .. })), "{refused:?}");
}
