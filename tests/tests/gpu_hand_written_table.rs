//! The service executes any table: shaders and plans made by hand, no generator, no technique.

use cssm_core::View;
use cssm_core::case::DepthFormat;
use cssm_core::facet::{Facet, Tile};
use cssm_core::glam::{DAffine3, DVec3, DVec4};
use cssm_core::table::ShaderKind;
use cssm_runtime::{CasterInstance, MaskInputs, Options, ServiceError, ShadowService, wgpu};
use cssm_tests::gpu::hand::{MAP_SIDE, facet_from_above, four_facet_table, plan_from_above, table};
use cssm_tests::gpu::{Geometry, TestDevice, exclusive, images};

/// Half the side of the square that the map covers, metres; a texel is half a metre.
const HALF: f64 = 16.0;
/// Height of depth 0 above the eye.
const TOP: f64 = 40.0;
/// Height of depth 1.
const BOTTOM: f64 = -10.0;

fn view(eye_world: DVec3) -> View {
    let (target, up) = (eye_world - DVec3::Y, DVec3::NEG_Z);
    View::perspective(eye_world, target, up, 1.2, 0.1, 1000.0, (64, 64)).unwrap()
}

fn service(gpu: &TestDevice, format: DepthFormat, options: &Options) -> ShadowService {
    ShadowService::new(&gpu.device, &gpu.queue, &table(format), options).unwrap()
}

/// Captures one geometry at a place in the world and reads the map.
fn captured(
    gpu: &TestDevice,
    service: &mut ShadowService,
    geometry: &Geometry,
    at: DAffine3,
    eye: DVec3,
) -> Vec<f32> {
    let buffers = geometry.upload(gpu);
    let mesh = service.add_mesh(&buffers.description()).unwrap();
    let view = view(eye);
    let plan = plan_from_above(&view, HALF, TOP, BOTTOM);
    let casters = [CasterInstance { mesh, world_from_object: at }];
    let frame = service.prepare(&plan, &view, &casters).unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    service.read_map().unwrap()
}

fn at(x: f64, y: f64, z: f64) -> DAffine3 {
    DAffine3::from_translation(DVec3::new(x, y, z))
}

/// Depth of a height above the eye.
fn depth(height: f64) -> f32 {
    ((TOP - height) / (TOP - BOTTOM)) as f32
}

#[test]
fn a_quad_covers_its_texels_at_its_depth() {
    let gpu = exclusive();
    for (format, tolerance) in [(DepthFormat::Depth32Float, 1e-6), (DepthFormat::Depth16Unorm, 1e-5)] {
        let mut service = service(&gpu, format, &Options::default());
        let quad = Geometry::quad([0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 8.0]);
        let map = captured(&gpu, &mut service, &quad, at(2.0, 5.0, -4.0), DVec3::ZERO);
        for (texel, stored) in map.iter().enumerate() {
            let (x, z) = (texel as u32 % MAP_SIDE, texel as u32 / MAP_SIDE);
            let covered = (36..44).contains(&x) && (24..40).contains(&z);
            let expected = if covered { depth(5.0) } else { 1.0 };
            assert!(
                (stored - expected).abs() <= tolerance,
                "{format:?} texel {x}, {z}: {stored} for {expected}"
            );
        }
    }
}

#[test]
fn world_positions_far_from_the_origin_lose_nothing() {
    let gpu = exclusive();
    let mut service = service(&gpu, DepthFormat::Depth32Float, &Options::default());
    let quad = Geometry::quad([0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 0.0, 8.0]);
    let near = captured(&gpu, &mut service, &quad, at(2.0, 5.0, -4.0), DVec3::ZERO);
    let eye = DVec3::new(5e6, -3e6, 7e6);
    let moved = DAffine3::from_translation(eye) * at(2.0, 5.0, -4.0);
    let far = captured(&gpu, &mut service, &quad, moved, eye);
    assert_eq!(near, far);
}

#[test]
fn clamped_and_unclipped_captures_are_equal() {
    let gpu = exclusive();
    let mut unclipped = service(&gpu, DepthFormat::Depth32Float, &Options::default());
    let options = Options { clamp_in_fragments: true, ..Options::default() };
    let mut clamped = service(&gpu, DepthFormat::Depth32Float, &options);
    assert_eq!(clamped.capture_shader(), ShaderKind::CaptureClamped);

    // A tall wall reaches far above depth 0 and below depth 1, a tilted quad lies between.
    let mut casters = Geometry::quad([-8.0, -60.0, -9.3], [16.0, 0.0, 0.0], [0.0, 200.0, 1.7]);
    let tilted = Geometry::quad([-7.3, 1.0, 0.2], [11.1, 9.0, 0.0], [0.0, 30.0, 9.9]);
    casters.indices.extend(tilted.indices.iter().map(|index| index + casters.positions.len() as u32));
    casters.positions.extend(&tilted.positions);
    let one = captured(&gpu, &mut unclipped, &casters, DAffine3::IDENTITY, DVec3::ZERO);
    let other = captured(&gpu, &mut clamped, &casters, DAffine3::IDENTITY, DVec3::ZERO);

    let pancaked = one.iter().filter(|depth| **depth == 0.0).count();
    assert!(pancaked > 20, "the wall's upper end lands on depth 0: {pancaked}");
    for (texel, (one, other)) in one.iter().zip(&other).enumerate() {
        assert!((one - other).abs() <= 1e-6, "texel {texel}: {one} unclipped, {other} clamped");
    }
    if gpu.device.features().contains(wgpu::Features::DEPTH_CLIP_CONTROL) {
        assert_eq!(unclipped.capture_shader(), ShaderKind::Capture);
    }
}

#[test]
fn two_views_in_one_submission_keep_their_own_plans() {
    let gpu = exclusive();
    let mut service = service(&gpu, DepthFormat::Depth32Float, &Options::default());
    let buffers = Geometry::quad([-2.0, 5.0, -2.0], [4.0, 0.0, 0.0], [0.0, 0.0, 4.0]).upload(&gpu);
    let mesh = service.add_mesh(&buffers.description()).unwrap();

    // Prepare both views before either is recorded; the caster stands at another height in each.
    let eyes = [DVec3::ZERO, DVec3::new(100.0, 3.0, 0.0)];
    let views = eyes.map(view);
    let masks = views.map(|_| images::target(&gpu, (64, 64), wgpu::TextureFormat::R8Unorm));
    let frames: Vec<_> = views
        .iter()
        .zip([0.0, 6.0])
        .map(|(view, shift)| {
            let plan = plan_from_above(view, HALF, TOP, BOTTOM);
            let place = DAffine3::from_translation(view.eye_world + DVec3::X * shift);
            service.prepare(&plan, view, &[CasterInstance { mesh, world_from_object: place }]).unwrap()
        })
        .collect();
    assert_eq!(service.frame_slots(), 2);

    // Ground eight metres below the eye, seen from straight above.
    let ground = |ray: DVec3| (ray.y < 0.0).then(|| -8.0 / ray.y);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    for ((view, frame), mask) in views.iter().zip(&frames).zip(&masks) {
        let depths = images::float_texture(&gpu, (64, 64), &images::linear_depths(view, ground));
        let inputs = MaskInputs { depth: &depths.create_view(&Default::default()), normal: None };
        service.capture(&mut encoder, frame, None).unwrap();
        service.mask(&mut encoder, frame, &inputs, &mask.create_view(&Default::default()), None).unwrap();
    }
    drop(frames);

    // A third frame, prepared before the submission, must not take a slot that the encoder still needs.
    let plan = plan_from_above(&views[0], HALF, TOP, BOTTOM);
    drop(service.prepare(&plan, &views[0], &[]).unwrap());
    assert_eq!(service.frame_slots(), 3);
    gpu.queue.submit([encoder.finish()]);

    for ((view, mask), shift) in views.iter().zip(&masks).zip([0.0, 6.0]) {
        let lit = images::red(&gpu, mask);
        for (pixel, lit) in lit.iter().enumerate() {
            let ray = view.ray_world((pixel % 64) as f64 + 0.5, (pixel / 64) as f64 + 0.5);
            let point = ray * ground(ray).unwrap();
            let (x, z) = ((point.x - shift).abs(), point.z.abs());
            // Leave out pixels within a texel of the shadow's edge.
            if (x.max(z) - 2.0).abs() > 0.5 {
                assert_eq!(*lit, if x.max(z) < 2.0 { 0 } else { 255 }, "pixel {pixel} at {point}");
            }
        }
        assert!(lit.contains(&0));
    }

    // Everything is done: later frames reuse the slots.
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
    for _ in 0..5 {
        drop(service.prepare(&plan, &views[0], &[]).unwrap());
    }
    assert_eq!(service.frame_slots(), 3);
}

#[test]
fn casters_that_reach_no_facet_are_not_drawn() {
    let gpu = exclusive();
    let mut service = service(&gpu, DepthFormat::Depth32Float, &Options::default());
    let buffers = Geometry::cuboid([-1.0; 3], [1.0; 3]).upload(&gpu);
    let mesh = service.add_mesh(&buffers.description()).unwrap();
    let view = view(DVec3::ZERO);
    let plan = plan_from_above(&view, HALF, TOP, BOTTOM);
    let place = |x: f64| CasterInstance { mesh, world_from_object: at(x, 0.0, 0.0) };

    let frame =
        service.prepare(&plan, &view, &[place(0.0), place(18.0), place(16.9), place(-400.0)]).unwrap();
    let statistics = frame.statistics();
    assert_eq!(
        (statistics.casters, statistics.draws, statistics.instances, statistics.triangles),
        (4, 1, 2, 24)
    );

    // Without casters the map is clear: everything is lit.
    let empty = service.prepare(&plan, &view, &[]).unwrap();
    assert_eq!(empty.statistics().draws, 0);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    service.capture(&mut encoder, &empty, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    assert!(service.read_map().unwrap().iter().all(|depth| *depth == 1.0));
}

#[test]
fn each_facet_draws_into_its_own_tile_only() {
    let gpu = exclusive();
    let table = four_facet_table();
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let buffers = Geometry::quad([-99.0, 0.0, -99.0], [198.0, 0.0, 0.0], [0.0, 0.0, 198.0]).upload(&gpu);
    let mesh = service.add_mesh(&buffers.description()).unwrap();

    // Three of four facets, each with another depth row; facet 2 has no receivers.
    let view = view(DVec3::ZERO);
    let mut plan = plan_from_above(&view, HALF, TOP, BOTTOM);
    plan.selection.distances = vec![DVec4::X];
    plan.selection.thresholds = vec![1.0, 2.0, 3.0];
    plan.selection.bands = 4;
    plan.facets = [(0, 3, 5, 20, 30), (1, 23, 0, 41, 7), (3, 24, 8, 1, 56)]
        .into_iter()
        .zip([10.0, 20.0, 30.0])
        .map(|((index, x, y, width, height), top)| {
            let tile = Tile { x, y, width, height, gutter: 0 };
            Facet { cells: vec![index], ..facet_from_above(tile, HALF, top, -10.0) }
        })
        .collect();
    let frame =
        service.prepare(&plan, &view, &[CasterInstance { mesh, world_from_object: DAffine3::IDENTITY }]);
    let frame = frame.unwrap();
    assert_eq!(frame.statistics().facets.iter().map(|facet| facet.facet).collect::<Vec<_>>(), [0, 1, 3]);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    gpu.queue.submit([encoder.finish()]);

    for (texel, stored) in service.read_map().unwrap().into_iter().enumerate() {
        let (x, y) = (texel as u32 % MAP_SIDE, texel as u32 / MAP_SIDE);
        let inside = |tile: &Tile| {
            (tile.x..tile.x + tile.width).contains(&x) && (tile.y..tile.y + tile.height).contains(&y)
        };
        let facet = plan.facets.iter().position(|facet| inside(&facet.tile));
        let expected = facet.map_or(1.0, |facet| [0.5, 2.0 / 3.0, 0.75][facet]);
        assert!((stored - expected).abs() < 1e-6, "texel {x}, {y}: {stored} for {expected}");
    }
}

#[test]
fn frames_of_another_service_are_refused() {
    let gpu = exclusive();
    let mut one = service(&gpu, DepthFormat::Depth32Float, &Options::default());
    let other = service(&gpu, DepthFormat::Depth32Float, &Options::default());
    let view = view(DVec3::ZERO);
    let frame = one.prepare(&plan_from_above(&view, HALF, TOP, BOTTOM), &view, &[]).unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    assert!(matches!(other.capture(&mut encoder, &frame, None), Err(ServiceError::StaleFrame { .. })));
    one.capture(&mut encoder, &frame, None).unwrap();
}
