//! A device with exactly what `features_and_limits` asks for runs the case, with or without optional features.

use cssm_codegen::generate;
use cssm_core::case::{LightCase, Resolve};
use cssm_core::table::ShaderKind;
use cssm_core::{SceneBounds, plan};
use cssm_runtime::{Options, ShadowService, read_back, wgpu};
use cssm_tests::gpu::device::device_for;
use cssm_tests::gpu::yard::{Yard, suns, views};
use cssm_tests::gpu::{TestDevice, new_device};

fn case() -> LightCase {
    let resolve = [Resolve::Function { group: 3, first_binding: 0 }];
    LightCase::builder("Wide").map_size_texels(3000, 2100).resolve(&resolve).build().unwrap()
}

/// Nanoseconds or ticks at the beginning and the end of a pass.
fn timed(
    gpu: &TestDevice,
    record: impl FnOnce(&mut wgpu::CommandEncoder, wgpu::RenderPassTimestampWrites),
) -> [u64; 2] {
    let query_set = gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
        label: None,
        ty: wgpu::QueryType::Timestamp,
        count: 2,
    });
    let buffer = |usage| {
        gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: 16,
            usage,
            mapped_at_creation: false,
        })
    };
    let resolved = buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
    let mapped = buffer(wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let writes = wgpu::RenderPassTimestampWrites {
        query_set: &query_set,
        beginning_of_pass_write_index: Some(0),
        end_of_pass_write_index: Some(1),
    };
    record(&mut encoder, writes);
    encoder.resolve_query_set(&query_set, 0..2, &resolved, 0);
    encoder.copy_buffer_to_buffer(&resolved, 0, &mapped, 0, 16);
    gpu.queue.submit([encoder.finish()]);
    let bytes = read_back::mapped_bytes(&gpu.device, &mapped).unwrap();
    [0, 8].map(|start| u64::from_le_bytes(bytes[start..start + 8].try_into().unwrap()))
}

#[test]
fn the_lowest_device_captures_and_times_a_frame() {
    let table = generate(&case()).unwrap().table;
    let gpu = device_for(&table);
    assert_eq!(gpu.device.limits().max_texture_dimension_2d, 3000);
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let yard = Yard::new();
    let buffers = yard.upload(&gpu);
    let casters = yard.add_to(&mut service, &buffers).unwrap();
    let view = &views((320, 180))[0];
    let plan = plan(&case(), view, &suns()[0], &SceneBounds::default()).unwrap();
    let frame = service.prepare(&plan, view, &casters).unwrap();
    if gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY) {
        let [begin, end] =
            timed(&gpu, |encoder, writes| service.capture(encoder, &frame, Some(writes)).unwrap());
        assert!(end > begin, "the pass takes time: {begin} to {end}");
    }
    assert!(service.read_map().unwrap().iter().any(|depth| *depth < 1.0));
}

#[test]
fn a_device_without_optional_features_clamps_in_fragments() {
    let gpu = new_device(wgpu::Features::empty());
    let case = LightCase::builder("Narrow").map_size_texels(512, 512).build().unwrap();
    let table = generate(&case).unwrap().table;
    let service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    assert_eq!(service.capture_shader(), ShaderKind::CaptureClamped);
}

#[test]
fn facets_that_share_tiles_need_both_features() {
    let case = LightCase::builder("Narrow").configurations(&["four_plane"]).map_size_texels(512, 512);
    let table = generate(&case.build().unwrap()).unwrap().table;
    assert!(table.clips > 0);
    let (unclipped, clips) = (wgpu::Features::DEPTH_CLIP_CONTROL, wgpu::Features::CLIP_DISTANCES);
    for wanted in [unclipped, clips, unclipped | clips] {
        let gpu = new_device(wanted);
        let both = gpu.device.features().contains(unclipped | clips);
        let expected = if both { ShaderKind::Capture } else { ShaderKind::CaptureClamped };
        let service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
        assert_eq!(service.capture_shader(), expected, "{wanted:?}");
    }
}
