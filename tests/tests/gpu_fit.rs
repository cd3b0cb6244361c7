//! Depth measured on the device is what the CPU measures: pixels of every bin, their rectangles, the range; it comes late,
//! says so, and is never waited for.

use cssm_core::case::{Fit, MaskDepth, MaskNormal, Resolve};
use cssm_core::fit::DepthHistogram;
use cssm_core::glam::DVec3;
use cssm_core::table::CaseTable;
use cssm_core::{LightCase, View};
use cssm_runtime::{DepthReduction, depth_reduction_requirements, wgpu};
use cssm_tests::gpu::{TestDevice, new_device};

/// Neither side is a multiple of a workgroup's square.
const SIZE: (u32, u32) = (331, 177);

fn case(depth: MaskDepth, fit: Fit) -> LightCase {
    let mask = Resolve::Mask { depth, normal: MaskNormal::Reconstructed };
    LightCase::builder("Sun").fit(fit).resolve(&[mask]).build().unwrap()
}

fn table(depth: MaskDepth, fit: Fit) -> CaseTable {
    cssm_codegen::generate(&case(depth, fit)).unwrap().table
}

fn view(far: f64) -> View {
    View::perspective(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 1.0, 0.25, far, SIZE).unwrap()
}

/// A device that can measure depth.
fn device() -> TestDevice {
    let TestDevice { adapter, .. } = new_device(wgpu::Features::empty());
    let needed = depth_reduction_requirements(&adapter).expect("the adapter measures depth");
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        required_features: needed.features,
        required_limits: needed.limits,
        ..Default::default()
    }))
    .expect("the adapter refused what measuring depth asked for");
    TestDevice { adapter, device, queue }
}

/// Depths of a frame: a slope with steps, sky above, every octave somewhere.
fn metres(frame: u32) -> Vec<f32> {
    let pixel = |index: u32| {
        let (x, y) = (index % SIZE.0, index / SIZE.0);
        if y < 20 + frame { 0.0 } else { 0.25 + 0.037 * ((x * x + 31 * y + 7 * frame) % 90_001) as f32 }
    };
    (0..SIZE.0 * SIZE.1).map(pixel).collect()
}

fn texture(device: &wgpu::Device, format: wgpu::TextureFormat) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: SIZE.0, height: SIZE.1, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_DST
            | wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    })
}

fn upload(queue: &wgpu::Queue, texture: &wgpu::Texture, texels: &[f32]) {
    let bytes: Vec<u8> = texels.iter().flat_map(|texel| texel.to_le_bytes()).collect();
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * SIZE.0), rows_per_image: None };
    queue.write_texture(texture.as_image_copy(), &bytes, layout, texture.size());
}

/// Records and submits one frame; says whether it is measured.
fn frame(gpu: &TestDevice, reduction: &mut DepthReduction, depth: &wgpu::Texture, view: &View) -> bool {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let measured = reduction.record(&mut encoder, &depth.create_view(&Default::default()), view).unwrap();
    gpu.queue.submit([encoder.finish()]);
    reduction.submitted();
    measured
}

fn wait(gpu: &TestDevice) {
    gpu.device.poll(wgpu::PollType::wait_indefinitely()).unwrap();
}

#[test]
fn counts_rectangles_and_range_are_those_of_the_cpu() {
    let gpu = device();
    let table = table(MaskDepth::Linear, Fit::Histogram);
    let mut reduction = DepthReduction::new(&gpu.device, &gpu.queue, &table).unwrap().unwrap();
    let depth = texture(&gpu.device, wgpu::TextureFormat::R32Float);
    let view = view(f64::INFINITY);
    for number in 0..3 {
        upload(&gpu.queue, &depth, &metres(number));
        assert!(frame(&gpu, &mut reduction, &depth, &view));
        wait(&gpu);
        let found = reduction.newest().unwrap().unwrap();
        let expected = DepthHistogram { latency_frames: 1, ..DepthHistogram::measure(&view, metres(number)) };
        assert_eq!(found, expected);
    }
}

#[test]
fn reversed_depth_differs_by_rounding_alone() {
    let gpu = device();
    let table = table(MaskDepth::ReversedZ, Fit::DepthMinMax);
    let mut reduction = DepthReduction::new(&gpu.device, &gpu.queue, &table).unwrap().unwrap();
    let depth = texture(&gpu.device, wgpu::TextureFormat::Depth32Float);
    for far in [f64::INFINITY, 4000.0] {
        // Clear to one depth: bins away from borders are found exactly.
        for metres in [0.3_f64, 2.9, 177.0, 3000.0] {
            let view = view(far);
            let stored = (1.0 / metres - 1.0 / far) / (1.0 / view.near_metres - 1.0 / far);
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                    view: &depth.create_view(&Default::default()),
                    depth_ops: Some(wgpu::Operations {
                        load: wgpu::LoadOp::Clear(stored as f32),
                        store: wgpu::StoreOp::Store,
                    }),
                    stencil_ops: None,
                }),
                ..Default::default()
            });
            gpu.queue.submit([encoder.finish()]);
            assert!(frame(&gpu, &mut reduction, &depth, &view));
            wait(&gpu);
            let found = reduction.newest().unwrap().unwrap();
            let image = std::iter::repeat_n(metres as f32, (SIZE.0 * SIZE.1) as usize);
            let expected = DepthHistogram::measure(&view, image);
            assert_eq!(found.bins, expected.bins, "{metres} {far}");
            assert!(
                (found.nearest_metres / metres - 1.0).abs() < 1e-3
                    && found.nearest_metres == found.farthest_metres
            );
        }
    }
}

#[test]
fn frames_that_are_late_say_so_and_nobody_waits() {
    let gpu = device();
    let table = table(MaskDepth::Linear, Fit::Histogram);
    let mut reduction = DepthReduction::new(&gpu.device, &gpu.queue, &table).unwrap().unwrap();
    let depth = texture(&gpu.device, wgpu::TextureFormat::R32Float);
    let view = view(1000.0);
    assert_eq!(reduction.newest().unwrap(), None);

    // Nobody asks: the ring fills, later frames are skipped.
    let measured: Vec<bool> = (0..6)
        .map(|number| {
            upload(&gpu.queue, &depth, &metres(number));
            frame(&gpu, &mut reduction, &depth, &view)
        })
        .collect();
    assert_eq!(measured, [true, true, true, true, false, false]);

    // The newest of those that came is the fourth of six frames, for the plan of the seventh.
    wait(&gpu);
    let found = reduction.newest().unwrap().unwrap();
    assert_eq!(found.latency_frames, 3);
    assert_eq!(found.bins, DepthHistogram::measure(&view, metres(3)).bins);
    assert_eq!(reduction.newest().unwrap(), None);

    // An encoder that is dropped takes its frame along.
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let texture = depth.create_view(&Default::default());
    assert!(reduction.record(&mut encoder, &texture, &view).unwrap());
    drop(encoder);
    reduction.dropped();
    wait(&gpu);
    assert_eq!(reduction.newest().unwrap(), None);
    assert!(frame(&gpu, &mut reduction, &depth, &view));
}

#[test]
fn what_is_not_declared_or_not_possible_measures_nothing() {
    let gpu = device();
    for fit in [Fit::None, Fit::Bounds] {
        let table = table(MaskDepth::Linear, fit);
        assert!(
            table.reduction.is_none() && !table.shaders.iter().any(|shader| shader.wgsl.contains("@compute"))
        );
        assert!(DepthReduction::new(&gpu.device, &gpu.queue, &table).unwrap().is_none());
    }
    let least = new_device(wgpu::Features::empty());
    let table = table(MaskDepth::Linear, Fit::Histogram);
    assert!(DepthReduction::new(&least.device, &least.queue, &table).unwrap().is_none());

    // A depth texture where metres are declared is refused, not undefined.
    let mut reduction = DepthReduction::new(&gpu.device, &gpu.queue, &table).unwrap().unwrap();
    let wrong = texture(&gpu.device, wgpu::TextureFormat::Rgba8Uint).create_view(&Default::default());
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    assert!(reduction.record(&mut encoder, &wrong, &view(1000.0)).is_err());
}
