//! The mask pass and the material function equal the f64 twin wherever the twin itself is sure: where moving the point
//! by 5e-3 of a texel, the accuracy promised for resolve coordinates, does not change its answer.

use cssm_codegen::generate;
use cssm_core::case::{Bias, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::glam::DVec3;
use cssm_core::homography::Gradients;
use cssm_core::schema::{Value, Word};
use cssm_core::twin::{DepthMap, resolve};
use cssm_core::{SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{MaskInputs, Options, ShadowService, wgpu};
use cssm_tests::gpu::resolve::{Material, Visible};
use cssm_tests::gpu::yard::{Yard, suns, views};
use cssm_tests::gpu::{TestDevice, exclusive, images};

/// Accuracy of resolve coordinates, texels.
const TEXEL_TOLERANCE: f64 = 5e-3;
/// Accuracy of the compared depth.
const DEPTH_TOLERANCE: f64 = 2e-6;
/// Accuracy of positions from f32 depth and rays, relative to the distance.
const POSITION_TOLERANCE: f64 = 5e-7;
/// Rounding of an 8-bit mask and of the 8-bit weights that filtering hardware blends with.
const MASK_TOLERANCE: f64 = 0.5 / 255.0 + 1.0 / 256.0;
/// Side of the image in pixels.
const SIZE: (u32, u32) = (192, 108);

fn case(technique: Word, filter: Filter, bias: Bias, depth: MaskDepth, normal: MaskNormal) -> LightCase {
    // Only a bias that reads normals may be given a texture of them.
    let normal = if reads_normal(bias) { normal } else { MaskNormal::Reconstructed };
    LightCase::builder("Resolved")
        .technique(technique)
        .map_size_texels(512, 512)
        .shadow_distance_metres(150.0)
        .filter(filter)
        .bias(bias)
        .resolve(&[Resolve::Mask { depth, normal }, Resolve::Function { group: 2 }])
        .prefix("dusk")
        .build()
        .unwrap()
}

fn reads_normal(bias: Bias) -> bool {
    matches!(bias, Bias::ReceiverPlane | Bias::Slope { .. })
}

/// Smallest and largest visibility that the twin finds within the promised accuracy of a point.
fn bracket(case: &LightCase, plan: &ShadowPlan, map: &DepthMap, point: DVec3, normal: DVec3) -> (f64, f64) {
    let centre = resolve(case, plan, map, point, normal);
    let (mut low, mut high) = (centre.visibility, centre.visibility);
    let Some(facet) = plan.facet(centre.facet) else { return (low, high) };

    // Step along the receiver's plane by the tolerance in both texel axes, and along the light in depth.
    let light = plan.light.truncate();
    let across = normal.any_orthonormal_vector();
    let texel_metres = facet.texel_metres_per_w * Gradients::at(&facet.rows, point).w;
    let tilt = 1.0 / normal.dot(light).abs().max(0.01);
    let depth_metres = DEPTH_TOLERANCE * Gradients::at(&facet.rows, point).w / facet.depth_per_metre;
    let along = light * (depth_metres + POSITION_TOLERANCE * point.length() * tilt);
    for (one, two) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.0, 0.0)] {
        for depth in [-1.0, 1.0] {
            let step = (across * one + normal.cross(across) * two) * (TEXEL_TOLERANCE * texel_metres * tilt);
            let near = resolve(case, plan, map, point + step + along * depth, normal);
            low = low.min(near.visibility);
            high = high.max(near.visibility);
        }
    }
    (low, high)
}

/// Everything one case draws for one view.
struct Drawn {
    plan: ShadowPlan,
    map: DepthMap,
    mask: Vec<u8>,
    material: Vec<u8>,
}

fn draw(
    gpu: &TestDevice,
    yard: &Yard,
    case: &LightCase,
    view: &View,
    sun: usize,
    visible: &Visible,
) -> Drawn {
    let table = generate(case).unwrap().table;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let buffers = yard.upload(gpu);
    let casters = yard.add_to(&mut service, &buffers).unwrap();
    let plan = plan(case, view, &suns()[sun], &SceneBounds::default()).unwrap();
    let frame = service.prepare(&plan, view, &casters).unwrap();

    // The engine's depth and normals.
    let depth = match case.resolve[0] {
        Resolve::Mask { depth: MaskDepth::ReversedZ, .. } => {
            images::depth_texture(gpu, SIZE, &visible.reversed_depths(view))
        }
        _ => images::float_texture(gpu, SIZE, &visible.linear_depths()),
    };
    let normals = images::vector_texture(gpu, SIZE, &visible.normals()).create_view(&Default::default());
    let positions: Vec<f32> = (visible.rays.iter().zip(&visible.hits))
        .flat_map(|(ray, hit)| {
            let point = (*ray * hit.map_or(0.0, |hit| hit.along)).as_vec3();
            [point.x, point.y, point.z, if hit.is_some() { 1.0 } else { 0.0 }]
        })
        .collect();
    let positions = images::vector_texture(gpu, SIZE, &positions).create_view(&Default::default());

    // The mask pass and the engine's own material in one submission.
    let [mask, lit] = [(); 2].map(|()| images::target(gpu, SIZE, wgpu::TextureFormat::R8Unorm));
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    let inputs = MaskInputs { depth: &depth.create_view(&Default::default()), normal: Some(&normals) };
    service.mask(&mut encoder, &frame, &inputs, &mask.create_view(&Default::default()), None).unwrap();
    let arguments = if reads_normal(case.bias) { "position.xyz, normal" } else { "position.xyz" };
    let material = Material::new(gpu, &table, &service, arguments);
    let target = lit.create_view(&Default::default());
    material.draw(gpu, &mut encoder, &frame, &positions, &normals, &target);
    gpu.queue.submit([encoder.finish()]);

    let (width, height) = plan.map_size_texels;
    let depths = service.read_map().unwrap().into_iter().map(f64::from).collect();
    let map = DepthMap { width, height, depths };
    Drawn { plan, map, mask: images::red(gpu, &mask), material: images::red(gpu, &lit) }
}

/// How two renderings fare against the twin.
#[derive(Debug, Default)]
struct Score {
    judged: usize,
    shadowed: usize,
    mask_wrong: usize,
    material_wrong: usize,
    worst: f64,
}

impl Score {
    fn add(&mut self, case: &LightCase, drawn: &Drawn, visible: &Visible, judge: impl Fn(usize) -> bool) {
        for pixel in (0..visible.hits.len()).filter(|pixel| judge(*pixel)) {
            let Some(hit) = visible.hits[pixel] else { continue };
            let point = visible.rays[pixel] * hit.along;
            let (low, high) = bracket(case, &drawn.plan, &drawn.map, point, hit.normal);
            let outside = |value: u8| {
                let value = f64::from(value) / 255.0;
                (low - value).max(value - high).max(0.0)
            };
            let (mask, material) = (outside(drawn.mask[pixel]), outside(drawn.material[pixel]));
            self.judged += 1;
            self.shadowed += usize::from(high < 0.5);
            self.mask_wrong += usize::from(mask > MASK_TOLERANCE);
            self.material_wrong += usize::from(material > MASK_TOLERANCE);
            self.worst = self.worst.max(mask.max(material));
        }
    }
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
    let seen: Vec<_> = views(SIZE)
        .iter()
        .map(|view| (*view, Visible::new(view, &yard.triangles_from_eye(view.eye_world))))
        .collect();
    for (number, bias) in biases.into_iter().enumerate() {
        for filter in [Filter::None, Filter::Hardware2x2, Filter::Gather2x2] {
            for (turn, technique) in techniques().into_iter().enumerate() {
                let depth = if number % 2 == 0 { MaskDepth::Linear } else { MaskDepth::ReversedZ };
                let case = case(technique, filter, bias, depth, MaskNormal::Texture);
                let mut score = Score::default();
                let (view, visible) = &seen[(number + turn) % seen.len()];
                let drawn = draw(&gpu, &yard, &case, view, turn, visible);
                score.add(&case, &drawn, visible, |_| true);
                let what = format!("{} {filter:?} {bias:?}: {score:?}", case.technique.name);
                assert!(score.judged > 10_000 && score.shadowed > 100, "{what}");
                assert!(score.mask_wrong * 2000 <= score.judged, "{what}");
                assert!(score.material_wrong * 2000 <= score.judged, "{what}");
            }
        }
    }
}

#[test]
fn reconstructed_normals_resolve_as_true_ones_do() {
    let (gpu, yard) = (exclusive(), Yard::new());
    for depth in [MaskDepth::Linear, MaskDepth::ReversedZ] {
        for (number, view) in views(SIZE).iter().enumerate() {
            let visible = Visible::new(view, &yard.triangles_from_eye(view.eye_world));
            let technique = Word::plain("camera_space");
            let case =
                case(technique, Filter::Gather2x2, Bias::ReceiverPlane, depth, MaskNormal::Reconstructed);
            let drawn = draw(&gpu, &yard, &case, view, number, &visible);
            let mut score = Score::default();
            score.add(&case, &drawn, &visible, |pixel| visible.on_one_plane(pixel, 2));
            assert!(score.judged > 8000 && score.shadowed > 100, "{score:?}");
            assert!(score.mask_wrong * 1000 <= score.judged, "{depth:?} view {number}: {score:?}");
        }
    }
}

#[test]
fn wrong_maps_and_biases_are_caught() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let view = &views(SIZE)[0];
    let visible = Visible::new(view, &yard.triangles_from_eye(view.eye_world));
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
        score.add(&case, &drawn, &visible, |_| true);
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
            let triangles = yard.triangles_from_eye(view.eye_world);
            let visible = Visible::new(view, &triangles);
            let mut drawn = draw(&gpu, &yard, &case, view, number, &visible);
            drawn.map = cssm_core::twin::capture(&drawn.plan, &triangles);
            let mut score = Score::default();
            score.add(&case, &drawn, &visible, |_| true);
            let what = format!("{} view {number}: {score:?}", case.technique.name);
            // Texels on caster edges may differ between rasterisers.
            assert!(score.mask_wrong * 500 <= score.judged, "{what}");
        }
    }
}
