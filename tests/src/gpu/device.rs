//! The device.

use std::sync::{Mutex, MutexGuard, OnceLock, PoisonError};

use cssm_core::table::CaseTable;
use cssm_runtime::{culling_requirements, features_and_limits, wgpu};

/// A device and where it came from.
#[derive(Debug)]
pub struct TestDevice {
    /// Its adapter.
    pub adapter: wgpu::Adapter,
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
}

/// The process's one device, for one test at a time.
///
/// # Panics
/// When there is no Vulkan adapter: the tests need one, software or not.
pub fn exclusive() -> MutexGuard<'static, TestDevice> {
    static DEVICE: OnceLock<Mutex<TestDevice>> = OnceLock::new();
    let device = DEVICE.get_or_init(|| Mutex::new(new_device(wgpu::Features::all())));
    // A failed test poisons the lock, not the device.
    device.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A new device with those of the service's useful features that `wanted` holds, and the lowest limits that every
/// test case needs, storage buffers as far as the adapter has them.
///
/// # Panics
/// When there is no Vulkan adapter or it refuses the device.
pub fn new_device(wanted: wgpu::Features) -> TestDevice {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::VULKAN;
    let instance = wgpu::Instance::new(descriptor);
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))
        .expect("the GPU tests need a Vulkan adapter; install mesa-vulkan-drivers and libvulkan1");
    let offered = adapter.limits();
    let required_limits = wgpu::Limits {
        // Exact stretching fetches vertices from storage buffers.
        max_storage_buffers_per_shader_stage: offered.max_storage_buffers_per_shader_stage.min(4),
        max_storage_buffer_binding_size: offered.max_storage_buffer_binding_size.min(1 << 27),
        ..wgpu::Limits::downlevel_webgl2_defaults()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("cssm tests"),
        required_features: adapter.features()
            & wanted
            & (wgpu::Features::DEPTH_CLIP_CONTROL
                | wgpu::Features::CLIP_DISTANCES
                | wgpu::Features::TIMESTAMP_QUERY),
        required_limits,
        ..Default::default()
    }))
    .expect("the adapter refused a device with the lowest limits");
    TestDevice { adapter, device, queue }
}

/// A new device with exactly what the service asks for a table.
///
/// # Panics
/// When there is no Vulkan adapter or it refuses the device.
pub fn device_for(table: &CaseTable) -> TestDevice {
    let TestDevice { adapter, .. } = new_device(wgpu::Features::empty());
    let needed = features_and_limits(&adapter, table).expect("the adapter runs every test case");
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("cssm tests"),
        required_features: needed.features,
        required_limits: needed.limits,
        ..Default::default()
    }))
    .expect("the adapter refused what features_and_limits asked for");
    TestDevice { adapter, device, queue }
}

/// A new device that also has what culling on the device takes.
///
/// # Panics
/// When there is no Vulkan adapter, or it cannot cull.
pub fn culling_device(table: &CaseTable) -> TestDevice {
    let TestDevice { adapter, .. } = new_device(wgpu::Features::empty());
    let needed = features_and_limits(&adapter, table).expect("the adapter runs every test case");
    let culling = culling_requirements(&adapter).expect("the adapter culls");
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("cssm tests"),
        required_features: needed.features | culling.features,
        required_limits: needed.limits.or_better_values_from(&culling.limits),
        ..Default::default()
    }))
    .expect("the adapter refused what culling asked for");
    TestDevice { adapter, device, queue }
}
