//! The mask pass and the material function equal the f64 twin wherever the twin itself is sure: where moving the point
//! by 5e-3 of a texel, the accuracy promised for resolve coordinates, does not change its answer.

use cssm_core::case::{Bias, Filter, Kernel, LightCase, MaskDepth, MaskNormal, PcfSize, Resolve, Source};
use cssm_core::schema::{Value, Word};
use cssm_core::{SceneBounds, View, plan};
use cssm_runtime::Options;
use cssm_tests::gpu::resolve::Visible;
use cssm_tests::gpu::score::Score;
use cssm_tests::gpu::stage::{Drawn, Stage};
use cssm_tests::gpu::yard::{Yard, suns, views};
use cssm_tests::gpu::{TestDevice, exclusive};

/// Side of the image in pixels.
const SIZE: (u32, u32) = (192, 108);

fn case(technique: Word, filter: Filter, bias: Bias, depth: MaskDepth, normal: MaskNormal) -> LightCase {
    // Only a bias that reads normals may be given a texture of them.
    let normal = if bias.reads_normal() { normal } else { MaskNormal::Reconstructed };
    LightCase::builder("Resolved")
        .technique(technique)
        .map_size_texels(512, 512)
        .shadow_distance_metres(150.0)
        .filter(filter)
        .bias(bias)
        .resolve(&[Resolve::Mask { depth, normal }, Resolve::Function { group: 2, first_binding: 0 }])
        .prefix("dusk")
        .build()
        .unwrap()
}

fn draw(
    gpu: &TestDevice,
    yard: &Yard,
    case: &LightCase,
    view: &View,
    sun: usize,
    visible: &Visible,
) -> Drawn {
    let plan = plan(case, view, &suns()[sun], &SceneBounds::default()).unwrap();
    Stage::new(gpu, yard, case, &Options::default()).draw(plan, view, visible)
}

fn techniques() -> [Word; 3] {
    [
        Word::plain("standard"),
        Word::with("parallel_split", [("splits", Value::Count(4))]),
        Word::plain("camera_space"),
    ]
}

#[test]
fn every_filter_and_bias_resolves_as_the_twin_does() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let biases = [
        Bias::None,
        Bias::Constant { along_light_metres: 0.05 },
        Bias::Slope { texels: 1.5 },
        Bias::WorldTexel { a_metres: 0.02, b_texels: 1.0 },
        Bias::ReceiverPlane,
    ];
    let seen: Vec<_> =
        views(SIZE).iter().map(|view| (*view, Visible::new(view, &yard.triangles_from_eye(view)))).collect();
    for (number, bias) in biases.into_iter().enumerate() {
        for filter in [Filter::None, Filter::Hardware2x2, Filter::Gather2x2] {
            for (turn, technique) in techniques().into_iter().enumerate() {
                let depth = if number % 2 == 0 { MaskDepth::Linear } else { MaskDepth::ReversedZ };
                let case = case(technique, filter, bias, depth, MaskNormal::Texture);
                let mut score = Score::default();
                let (view, visible) = &seen[(number + turn) % seen.len()];
                let drawn = draw(&gpu, &yard, &case, view, turn, visible);
                score.add(&case, &drawn, visible);
                let what = format!("{} {filter:?} {bias:?}: {score:?}", case.technique.name);
                assert!(score.judged > 10_000 && score.shadowed > 100, "{what}");
                assert!(score.mask_wrong * 2000 <= score.judged, "{what}");
                assert!(score.material_wrong * 2000 <= score.judged, "{what}");
            }
        }
    }
}

/// Filters that read more than the four nearest texels; kernels of some two facets of a plan may span by different numbers of texels.
const WIDE: [Filter; 9] = [
    Filter::Pcf { size: PcfSize::Three, kernel: Kernel::Texels },
    Filter::Pcf { size: PcfSize::Seven, kernel: Kernel::Texels },
    Filter::Pcf { size: PcfSize::Five, kernel: Kernel::Metres(0.4) },
    Filter::Pcf { size: PcfSize::Three, kernel: Kernel::Pixels(2.0) },
    Filter::Pcf { size: PcfSize::Seven, kernel: Kernel::Pixels(6.0) },
    Filter::Pcss { source: Source::Angle(2.0), reach_texels: 5 },
    Filter::Pcss { source: Source::Angle(6.0), reach_texels: 8 },
    Filter::Evsm2 { exponent: 10.0, blur_texels: 2, bleeding: 0.1 },
    Filter::Evsm2 { exponent: 40.0, blur_texels: 3, bleeding: 0.2 },
];

#[test]
fn wide_filters_resolve_as_the_twins_do() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let seen: Vec<_> =
        views(SIZE).iter().map(|view| (*view, Visible::new(view, &yard.triangles_from_eye(view)))).collect();
    let biases = [Bias::ReceiverPlane, Bias::Constant { along_light_metres: 0.05 }];
    for (number, filter) in WIDE.into_iter().enumerate() {
        for (turn, technique) in techniques().into_iter().enumerate() {
            let bias = biases[(number + turn) % biases.len()];
            let case = case(technique, filter, bias, MaskDepth::Linear, MaskNormal::Texture);
            let (view, visible) = &seen[(number + turn) % seen.len()];
            let drawn = draw(&gpu, &yard, &case, view, turn, visible);
            let judged = |filter: Filter| {
                let mut score = Score::default();
                score.add(&LightCase { filter, ..case.clone() }, &drawn, visible);
                score
            };
            let score = judged(filter);
            let what = format!("{} {filter:?} {bias:?}: {score:?}", case.technique.name);
            assert!(score.judged > 10_000 && score.shadowed > 50, "{what}");
            assert!(score.mask_wrong * 2000 <= score.judged, "{what}");
            assert!(score.material_wrong * 2000 <= score.judged, "{what}");

            // A twin with another kernel disagrees.
            assert!(judged(Filter::Gather2x2).mask_wrong > 20 + 5 * score.mask_wrong, "{what}");
        }
    }
}

#[test]
fn reconstructed_normals_resolve_as_true_ones_do() {
    let (gpu, yard) = (exclusive(), Yard::new());
    for depth in [MaskDepth::Linear, MaskDepth::ReversedZ] {
        for (number, view) in views(SIZE).iter().enumerate() {
            let visible = Visible::new(view, &yard.triangles_from_eye(view));
            let technique = Word::plain("camera_space");
            let case =
                case(technique, Filter::Gather2x2, Bias::ReceiverPlane, depth, MaskNormal::Reconstructed);
            let drawn = draw(&gpu, &yard, &case, view, number, &visible);
            let mut score = Score::default();
            score.add(&case, &drawn, &visible);
            assert!(score.mask_judged > 8000 && score.shadowed > 100, "{score:?}");
            assert!(score.mask_wrong * 1000 <= score.mask_judged, "{depth:?} view {number}: {score:?}");
        }
    }
}

#[test]
fn wrong_maps_and_biases_are_caught() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let view = &views(SIZE)[0];
    let visible = Visible::new(view, &yard.triangles_from_eye(view));
    let case = case(
        Word::plain("camera_space"),
        Filter::Gather2x2,
        Bias::ReceiverPlane,
        MaskDepth::Linear,
        MaskNormal::Texture,
    );
    let score = |change: &dyn Fn(&mut Drawn)| {
        let mut drawn = draw(&gpu, &yard, &case, view, 0, &visible);
        change(&mut drawn);
        let mut score = Score::default();
        score.add(&case, &drawn, &visible);
        score.mask_wrong
    };
    let unchanged = score(&|_| {});
    type Change<'a> = (&'a str, &'a dyn Fn(&mut Drawn));
    let changes: [Change; 4] = [
        ("a map shifted by a texel", &|drawn| drawn.map.depths.rotate_right(1)),
        ("a map that is all lit", &|drawn| drawn.map.depths.fill(1.0)),
        ("a bias of ten texels", &|drawn| {
            drawn.plan.facets.iter_mut().for_each(|facet| facet.receiver_plane_depth *= 20.0);
        }),
        ("no bias at all", &|drawn| {
            drawn.plan.facets.iter_mut().for_each(|facet| facet.receiver_plane_depth *= -1.0);
        }),
    ];
    for (what, change) in changes {
        let wrong = score(change);
        assert!(wrong > 20 + 5 * unchanged, "{what} changes only {wrong} pixels ({unchanged} unchanged)");
    }
}

#[test]
fn culling_removes_nothing_visible() {
    // The twin's map of all casters and the device's map of culled ones resolve every visible pixel alike.
    let (gpu, yard) = (exclusive(), Yard::new());
    for technique in techniques() {
        let normal = MaskNormal::Texture;
        let case = case(technique, Filter::None, Bias::ReceiverPlane, MaskDepth::Linear, normal);
        for (number, view) in views(SIZE).iter().enumerate() {
            let triangles = yard.triangles_from_eye(view);
            let visible = Visible::new(view, &triangles);
            let mut drawn = draw(&gpu, &yard, &case, view, number, &visible);
            drawn.map = cssm_core::twin::capture(&drawn.plan, &triangles);
            let mut score = Score::default();
            score.add(&case, &drawn, &visible);
            let what = format!("{} view {number}: {score:?}", case.technique.name);
            // Texels on caster edges may differ between rasterisers.
            assert!(score.mask_wrong * 500 <= score.judged, "{what}");
        }
    }
}
