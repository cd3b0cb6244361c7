//! Masks of planes on the device equal the f64 twin's, through the mask pass and the material function, in every facet and
//! kind of light; and nothing on a plane shadows it but what stands before it.

use cssm_core::case::{Bias, Casters, Filter, LightCase, LightKind, MaskDepth, MaskNormal, Resolve, Stretch};
use cssm_core::schema::{Value, Word};
use cssm_core::{View, plan};
use cssm_runtime::Options;
use cssm_tests::gpu::ground::{Masked, bounds};
use cssm_tests::gpu::resolve::Visible;
use cssm_tests::gpu::score::Score;
use cssm_tests::gpu::stage::{Drawn, Stage};
use cssm_tests::gpu::yard::{Yard, lights, views};
use cssm_tests::gpu::{TestDevice, exclusive};

/// Side of the image in pixels.
const SIZE: (u32, u32) = (160, 90);
/// View and light of each case.
const SITUATIONS: [(usize, usize); 8] = [(0, 0), (1, 1), (2, 2), (2, 1), (1, 1), (2, 2), (0, 0), (0, 0)];

fn filter(planes: u32) -> Filter {
    Filter::GroundMasks { planes, blur_metres: 0.4, reach_texels: 6 }
}

/// Cases that differ in facets, bending, bias, kind of light and the number of channels.
fn cases() -> Vec<LightCase> {
    let of = |light: LightKind, planes: u32, bias: Bias| {
        let normal = if bias.reads_normal() { MaskNormal::Texture } else { MaskNormal::Reconstructed };
        let mask = Resolve::Mask { depth: MaskDepth::Linear, normal };
        LightCase::builder("Masked")
            .light(light)
            .filter(filter(planes))
            .bias(bias)
            .casters(Casters::Opaque)
            .map_size_texels(512, 512)
            .resolve(&[mask, Resolve::Function { group: 2, first_binding: 0 }])
    };
    let sun = |planes: u32, bias: Bias| of(LightKind::Directional, planes, bias);
    let (plane, constant) = (Bias::ReceiverPlane, Bias::Constant { along_light_metres: 0.05 });
    let splits = Word::with("parallel_split", [("splits", Value::Count(4))]);
    let bent = Stretch::Exact { bound_texels: 0.25 };
    let cases = [
        sun(1, plane).shadow_distance_metres(150.0).technique(Word::plain("standard")),
        sun(2, constant).shadow_distance_metres(150.0).technique(splits),
        sun(3, plane).configurations(&["face_columns"]),
        sun(4, plane).configurations(&["four_plane", "one_plane"]),
        sun(1, plane).configurations(&["one_plane"]).distribution(Word::plain("perspective")).stretch(bent),
        of(LightKind::Omni, 2, plane).configurations(&["cube"]),
        of(LightKind::Spot, 1, constant),
        of(LightKind::Omni, 4, plane).configurations(&["eight_plane"]),
    ];
    cases.into_iter().map(|case| case.build().unwrap()).collect()
}

fn draw(
    gpu: &TestDevice,
    yard: &Yard,
    case: &LightCase,
    view: &View,
    turn: usize,
    visible: &Visible,
) -> Drawn {
    let plan = plan(case, view, &lights(case.light)[turn], &bounds(case.filter.ground_planes())).unwrap();
    Stage::new(gpu, yard, case, &Options::default()).draw(plan, view, visible)
}

#[test]
fn masks_of_planes_are_as_the_twin_makes_them() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let seen: Vec<_> =
        views(SIZE).iter().map(|view| (*view, Visible::new(view, &yard.triangles_from_eye(view)))).collect();
    let mut shared = 0;
    for (number, (case, (view, light))) in cases().into_iter().zip(SITUATIONS).enumerate() {
        let (view, visible) = &seen[view];
        let drawn = draw(&gpu, &yard, &case, view, light, visible);
        shared += usize::from(drawn.plan.facets.iter().any(|facet| !facet.clip.is_empty()));
        let found = Masked::of(&case, &drawn, visible);
        let what = format!("{number} {} {:?}: {found:?}", drawn.plan.configuration, case.light);
        println!("{what}");
        assert!(found.pixels > 3000 && found.soft > 100, "{what}");
        assert!(found.mask_wrong * 1000 <= found.pixels, "{what}");
        assert!(found.material_wrong * 1000 <= found.pixels, "{what}");

        // All other receivers compare depths.
        let mut score = Score::default();
        score.add(&case, &drawn, visible);
        assert!(score.mask_wrong * 500 <= score.judged, "{what} {score:?}");

        // A twin without masks disagrees.
        let gathered = LightCase { filter: Filter::Gather2x2, ..case.clone() };
        assert!(Masked::of(&gathered, &drawn, visible).mask_wrong > 50 + 5 * found.mask_wrong, "{what}");
    }
    assert!(shared >= 2, "{shared} plans with shared tiles");
}

#[test]
fn ground_without_casters_is_lit_everywhere() {
    let gpu = exclusive();
    let mut yard = Yard::new();
    yard.places.truncate(1);
    for (number, (case, (view, light))) in cases().into_iter().zip(SITUATIONS).enumerate() {
        let view = views(SIZE)[view];
        let visible = Visible::new(&view, &yard.triangles_from_eye(&view));
        let drawn = draw(&gpu, &yard, &case, &view, light, &visible);
        for image in [&drawn.mask, &drawn.material] {
            let image = image.as_ref().unwrap();
            let dark = visible.hits.iter().zip(image).filter(|(hit, lit)| hit.is_some() && **lit < 255);
            assert_eq!(dark.count(), 0, "{number} {}", drawn.plan.configuration);
        }
    }
}
