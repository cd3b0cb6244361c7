//! The lab's device, and the passes it adds to the shadow service's.
//!
//! [`CaseRunner`] lets the service capture a scene and then asks for the visibility of traced pixels: through the
//! generated function, as an engine's material would, or through the mask pass.

mod alpha_mask;
mod depth_input;
mod function;
mod geometry;
mod lights;
mod runner;
mod stopwatch;
mod surface;

pub use geometry::SceneBuffers;
pub use lights::LightRunner;
pub use runner::{CaseRunner, ResolveMethod};
pub use stopwatch::{PassTimes, RecordPass, SequenceTimes, Stopwatch, Writes};
pub use surface::Surface;

use cssm_core::LightCase;
use cssm_core::case::Casters;
use cssm_core::table::CaseTable;
use cssm_runtime::{ClusterError, ServiceError, culling_requirements, features_and_limits};

/// A device with what a list of cases needs.
#[derive(Debug)]
pub struct Gpu {
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
}

/// What the lab's own use of the device may meet.
#[derive(Debug, thiserror::Error)]
pub enum GpuError {
    /// No adapter.
    #[error(
        "no graphics adapter was found ({0}); install a Vulkan driver, such as Debian's mesa-vulkan-drivers and libvulkan1"
    )]
    NoAdapter(#[from] wgpu::RequestAdapterError),
    /// No device.
    #[error("the adapter gives no device: {0}; close other programs that use it or update its driver")]
    NoDevice(#[from] wgpu::RequestDeviceError),
    /// The image is larger than a texture may be.
    #[error(
        "an image of {width} x {height} pixels exceeds the adapter's limit of {limit} a side; ask for a smaller --size"
    )]
    ImageTooLarge {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// The limit.
        limit: u32,
    },
    /// The device refused something of the lab's own.
    #[error(
        "the device refused {what}: {reason}; update the driver, or report the declaration that leads here"
    )]
    Refused {
        /// What was to be created.
        what: &'static str,
        /// The device's words.
        reason: String,
    },
    /// The case does not declare the interface.
    #[error(
        "case {case} does not declare resolve: {method}; add it to the declaration or choose another --resolve"
    )]
    NotDeclared {
        /// The case.
        case: String,
        /// What was asked for.
        method: &'static str,
    },
    /// The scene holds more vertices than one buffer.
    #[error("the scene's geometry does not fit one buffer; thin it out")]
    SceneTooLarge,
    /// A mesh's triangles cannot be put into clusters.
    #[error(transparent)]
    Clusters(#[from] ClusterError),
    /// The service refused.
    #[error(transparent)]
    Service(#[from] ServiceError),
}

impl Gpu {
    /// Opens the first adapter with the features and limits that all of the cases need, for images of a size.
    ///
    /// # Errors
    /// A [`GpuError`] that names what is missing.
    pub fn open(cases: &[&LightCase], (width, height): (u32, u32)) -> Result<Self, GpuError> {
        let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
        descriptor.backends = wgpu::Backends::PRIMARY;
        let instance = wgpu::Instance::new(descriptor);
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions {
            power_preference: wgpu::PowerPreference::HighPerformance,
            ..Default::default()
        }))?;
        let limit = adapter.limits().max_texture_dimension_2d;
        if width.max(height) > limit {
            return Err(GpuError::ImageTooLarge { width, height, limit });
        }

        // Merge what the cases need with what the lab does.
        let offered = adapter.limits();
        let lowest = wgpu::Limits::downlevel_webgl2_defaults().or_worse_values_from(&offered);
        let mut limits = wgpu::Limits {
            max_texture_dimension_2d: width.max(height).max(lowest.max_texture_dimension_2d),
            max_buffer_size: offered.max_buffer_size,
            ..lowest
        };
        let mut features = wgpu::Features::empty();
        for case in cases {
            // A scene with cutouts has its casters tested, whatever the case declares.
            let case = &LightCase { casters: Casters::AlphaTested, ..(*case).clone() };
            let needed = features_and_limits(&adapter, &CaseTable::describe(case))?;
            limits = limits.or_better_values_from(&needed.limits);
            features |= needed.features;
        }
        // Casters may be culled on the device where it can.
        if let Some(culling) = culling_requirements(&adapter) {
            limits = limits.or_better_values_from(&culling.limits);
            features |= culling.features;
        }
        let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
            label: Some("cssm lab"),
            required_features: features,
            required_limits: limits,
            ..Default::default()
        }))?;
        Ok(Self { device, queue, info: adapter.get_info() })
    }

    /// Name, backend and driver of the adapter, for reports.
    pub fn adapter(&self) -> String {
        let wgpu::AdapterInfo { name, backend, driver, driver_info, .. } = &self.info;
        format!("{name} ({backend:?}, {driver} {driver_info})")
    }

    /// Whether the adapter is a program that runs on the CPU.
    pub fn is_software(&self) -> bool {
        self.info.device_type == wgpu::DeviceType::Cpu
    }

    /// Whether passes can be timed on the device.
    pub fn has_timestamps(&self) -> bool {
        self.device.features().contains(wgpu::Features::TIMESTAMP_QUERY)
    }

    /// Runs `create`; whatever the device refuses inside becomes an error.
    ///
    /// # Errors
    /// [`GpuError::Refused`] with the device's words.
    pub fn checked<T>(&self, what: &'static str, create: impl FnOnce() -> T) -> Result<T, GpuError> {
        let memory = self.device.push_error_scope(wgpu::ErrorFilter::OutOfMemory);
        let validation = self.device.push_error_scope(wgpu::ErrorFilter::Validation);
        let created = create();
        let errors = [pollster::block_on(validation.pop()), pollster::block_on(memory.pop())];
        match errors.into_iter().flatten().next() {
            None => Ok(created),
            Some(error) => Err(GpuError::Refused { what, reason: error.to_string() }),
        }
    }

    /// A texture of the size of an image.
    ///
    /// # Errors
    /// When the device refuses it.
    pub fn texture(
        &self,
        (width, height): (u32, u32),
        format: wgpu::TextureFormat,
        usage: wgpu::TextureUsages,
    ) -> Result<wgpu::Texture, GpuError> {
        self.checked("an image", || {
            self.device.create_texture(&wgpu::TextureDescriptor {
                label: Some("cssm lab"),
                size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
                mip_level_count: 1,
                sample_count: 1,
                dimension: wgpu::TextureDimension::D2,
                format,
                usage,
                view_formats: &[],
            })
        })
    }

    /// A texture of floats with contents, to be read by shaders.
    fn float_texture(
        &self,
        size: (u32, u32),
        format: wgpu::TextureFormat,
        values: &[f32],
    ) -> Result<wgpu::Texture, GpuError> {
        let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let texture = self.texture(size, format, usage)?;
        self.checked("an image's contents", || {
            self.queue.write_texture(
                texture.as_image_copy(),
                bytemuck::cast_slice(values),
                wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(size.0 * format.block_copy_size(None).unwrap_or(4)),
                    rows_per_image: None,
                },
                texture.size(),
            );
        })?;
        Ok(texture)
    }
}

/// A view of a whole texture.
fn whole(texture: &wgpu::Texture) -> wgpu::TextureView {
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// A layout entry for a texture of floats that fragments read.
const fn float_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: false },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}
