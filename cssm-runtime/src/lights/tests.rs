//! What a frame of many lights takes of the memory.

use allocation_counter::measure;
use cssm_core::glam::{DAffine3, DQuat, DVec3};
use cssm_core::table::CaseTable;
use cssm_core::{BoundingBox, Light, LightCase, View};

use super::{
    CaseHandle, EngineCaster, LightDescription, LightFrame, LightOptions, LightService, PreparedLights,
};
use crate::mesh::{CasterInstance, MeshDescription, MeshHandle};

/// A sun and a lamp that share a map.
fn cases() -> [(LightCase, CaseTable); 2] {
    let sun = LightCase::builder("Sun").map_size_texels(512, 512).bands(4, 100.0);
    let lamp = LightCase::builder("Lamp").map_size_texels(512, 512).light(cssm_core::case::LightKind::Omni);
    [sun, lamp].map(|case| {
        let case = case.build().unwrap();
        let table = cssm_codegen::generate(&case).unwrap().table;
        (case, table)
    })
}

/// A device, software or not.
fn device() -> (wgpu::Device, wgpu::Queue) {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::VULKAN;
    let instance = wgpu::Instance::new(descriptor);
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
    let adapter = adapter.expect("the tests need a Vulkan adapter");
    let description = wgpu::DeviceDescriptor { required_limits: adapter.limits(), ..Default::default() };
    pollster::block_on(adapter.request_device(&description)).unwrap()
}

/// A service with lights over a square of boxes.
fn service(device: &wgpu::Device, queue: &wgpu::Queue) -> (LightService, MeshHandle) {
    let cases = cases();
    let tables: Vec<_> = cases.iter().map(|(case, table)| (case, table)).collect();
    let mut service = LightService::new(device, queue, &tables, &LightOptions::default()).unwrap();
    let vertices = device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: 12 * 36,
        usage: wgpu::BufferUsages::VERTEX,
        mapped_at_creation: false,
    });
    let mesh = MeshDescription {
        vertices: &vertices,
        vertices_offset_bytes: 0,
        vertex_count: 36,
        stride_bytes: 12,
        position_offset_bytes: 0,
        position_format: wgpu::VertexFormat::Float32x3,
        indices: None,
        bounds_object: BoundingBox { min: DVec3::NEG_ONE, max: DVec3::ONE },
        clusters: &[],
        mask: None,
    };
    let mesh = service.add_mesh(&mesh).unwrap();
    let sun = Light::directional_travelling(DVec3::new(0.4, -1.0, -0.3)).unwrap();
    service.add_light(&LightDescription::new(CaseHandle(0), sun)).unwrap();
    for at in 0..6 {
        let place = DVec3::new(4.0 * f64::from(at) - 10.0, 3.0, -6.0);
        let lamp = LightDescription::new(CaseHandle(1), Light::omni(place, 9.0).unwrap());
        service.add_light(&LightDescription { max_side_texels: 128, ..lamp }).unwrap();
    }
    (service, mesh)
}

fn boxes(mesh: MeshHandle, count: u32, shift: f64) -> Vec<CasterInstance> {
    let place = |number: u32| {
        let (x, z) = (f64::from(number % 20) - 10.0 + shift, -f64::from(number / 20));
        DVec3::new(1.2 * x, 0.2, 1.2 * z)
    };
    (0..count)
        .map(|number| CasterInstance {
            mesh,
            world_from_object: DAffine3::from_scale_rotation_translation(
                DVec3::splat(0.2),
                DQuat::IDENTITY,
                place(number),
            ),
        })
        .collect()
}

fn view(x: f64) -> View {
    let eye = DVec3::new(x, 2.5, 6.0);
    View::perspective(eye, eye + DVec3::new(0.0, -0.3, -1.0), DVec3::Y, 1.0, 0.1, 200.0, (320, 180)).unwrap()
}

/// What the engine's two sets of memory in turn take in each frame, with casters that move.
fn allocations(eye: impl Fn(u32) -> f64, frames: u32) -> Vec<(u64, u32, u32)> {
    let (device, queue) = device();
    let (mut service, mesh) = service(&device, &queue);
    let still = boxes(mesh, 200, 0.0);
    let mut prepared = PreparedLights::new();
    (0..frames)
        .map(|number| {
            let moving = boxes(mesh, 20, 0.01 * f64::from(number));
            let view = view(eye(number));
            let everywhere = EngineCaster { light: None, bounds_world: None, revision: u64::from(number) };
            let frame = LightFrame {
                static_engine_casters: &[EngineCaster { revision: 0, ..everywhere }],
                dynamic_engine_casters: &[everywhere],
                ..LightFrame::new(&view, &still, &moving)
            };
            let mut next = std::mem::take(&mut service.scratch.next);
            let counted = measure(|| {
                service.decide(&frame, &mut next).unwrap();
            });
            let planned = next.report().planned;
            service.layers.keep_still_casters(&device).unwrap();
            service.upload(&frame, &mut next).unwrap();
            std::mem::swap(&mut next, &mut prepared);
            service.scratch.next = next;
            let mut encoder = device.create_command_encoder(&Default::default());
            let mut drawn = 0;
            service.capture_with(&mut encoder, &prepared, None, |_, _| drawn += 1).unwrap();
            queue.submit([encoder.finish()]);
            (counted.count_total, planned, drawn)
        })
        .collect()
}

#[test]
fn frames_of_a_still_view_take_no_memory_from_the_third_on() {
    let found = allocations(|_| 0.0, 8);
    assert!(found[0].0 > 0 && found[0].1 > 0, "{found:?}");
    assert!(
        found[2..].iter().all(|(count, planned, drawn)| (*count, *planned) == (0, 0) && *drawn > 0),
        "{found:?}"
    );
}
