//! Losing the device: noticed without a callback, reported as a typed error, survived by a rebuild.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use cssm_core::View;
use cssm_core::case::DepthFormat;
use cssm_core::glam::{DAffine3, DVec3};
use cssm_runtime::{CasterInstance, Options, ServiceError, ShadowService, wgpu};
use cssm_tests::gpu::hand::{plan_from_above, table};
use cssm_tests::gpu::{Geometry, TestDevice, new_device};

fn draw(gpu: &TestDevice, service: &mut ShadowService) -> Result<Vec<f32>, ServiceError> {
    let eye = DVec3::new(3.0, 4.0, 5.0);
    let view = View::perspective(eye, eye - DVec3::Y, DVec3::X, 1.0, 0.1, 100.0, (64, 64)).unwrap();
    let plan = plan_from_above(&view, 16.0, 40.0, -10.0);
    let buffers = Geometry::cuboid([-1.0; 3], [1.0; 3]).upload(gpu);
    let mesh = service.add_mesh(&buffers.description())?;
    let world_from_object = DAffine3::from_translation(eye);
    let frame = service.prepare(&plan, &view, &[CasterInstance { mesh, world_from_object }])?;
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None)?;
    gpu.queue.submit([encoder.finish()]);
    service.read_map()
}

#[test]
fn a_lost_device_is_noticed_and_rebuilt() {
    let first = new_device(wgpu::Features::all());
    let table = table(DepthFormat::Depth32Float);
    let mut service = ShadowService::new(&first.device, &first.queue, &table, &Options::default()).unwrap();

    // The engine has a callback of its own, which the service must leave in place.
    let told = Arc::new(AtomicBool::new(false));
    let engine = Arc::clone(&told);
    first.device.set_device_lost_callback(move |_, _| engine.store(true, Ordering::SeqCst));

    let before = draw(&first, &mut service).unwrap();
    assert!(before.iter().any(|depth| *depth < 1.0));
    assert!(!service.device_lost());
    assert!(!service.device_lost(), "asking leaves the device healthy");
    let buffers = Geometry::cuboid([-1.0; 3], [1.0; 3]).upload(&first);
    let mesh = service.add_mesh(&buffers.description()).unwrap();
    let view = View::perspective(DVec3::ZERO, DVec3::NEG_Y, DVec3::X, 1.0, 0.1, 100.0, (64, 64)).unwrap();
    let plan = plan_from_above(&view, 16.0, 40.0, -10.0);
    let frame = service.prepare(&plan, &view, &[]).unwrap();

    // Lose it: everything that would upload or read says so, and nothing panics.
    first.device.destroy();
    assert!(service.device_lost());
    let casters = [CasterInstance { mesh, world_from_object: DAffine3::IDENTITY }];
    assert!(matches!(service.prepare(&plan, &view, &casters), Err(ServiceError::DeviceLost)));
    assert!(matches!(service.read_map(), Err(ServiceError::DeviceLost)));
    assert!(matches!(service.rebuild(&first.device, &first.queue), Err(ServiceError::DeviceLost)));
    let refused = ShadowService::new(&first.device, &first.queue, &table, &Options::default());
    assert!(matches!(refused, Err(ServiceError::DeviceLost)));
    let mut encoder = first.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    drop(encoder);
    let _ = first.device.poll(wgpu::PollType::wait_indefinitely());
    assert!(told.load(Ordering::SeqCst), "the engine's own callback was called");

    // Rebuild on another one: old handles are refused, new ones draw the same map.
    let second = new_device(wgpu::Features::all());
    service.rebuild(&second.device, &second.queue).unwrap();
    assert!(!service.device_lost());
    let mut encoder = second.device.create_command_encoder(&Default::default());
    assert!(matches!(service.capture(&mut encoder, &frame, None), Err(ServiceError::StaleFrame { .. })));
    assert!(matches!(
        service.prepare(&plan, &view, &casters),
        Err(ServiceError::UnknownMesh { instance: 0 })
    ));
    assert_eq!(draw(&second, &mut service).unwrap(), before);
}
