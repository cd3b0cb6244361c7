//! Small programs to start from.
//!
//! * `quantised_vertices`: casters in an engine's own vertex format, far from the world's origin.
//! * `material_function`: the engine's own material calls the generated visibility function.
//! * `many_lights`: a sun, a spot light and lamps share one map; only what changes is drawn again.
//! * `build_script_tables`: tables and shaders for an engine that renders by itself; no graphics interface.
//!
//! Each runs without a window, prints what it shows and checks itself. What they share is here: a device, buffers
//! and pictures.

use std::error::Error;
use std::path::PathBuf;

use cssm::runtime::{Requirements, ServiceError, features_and_limits, read_back, wgpu};
use cssm::table::CaseTable;

/// A device that can run a table.
#[derive(Debug)]
pub struct Gpu {
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
}

impl Gpu {
    /// The first adapter's device, with what the service needs for `table`.
    ///
    /// # Errors
    /// No adapter, or one that cannot run the table.
    pub fn for_table(table: &CaseTable) -> Result<Self, Box<dyn Error>> {
        let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
        let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()))?;
        println!("adapter: {}", adapter.get_info().name);
        let Requirements { features, limits } = features_and_limits(&adapter, table)?;
        let descriptor = wgpu::DeviceDescriptor {
            required_features: features,
            required_limits: limits,
            ..Default::default()
        };
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor))?;
        Ok(Self { device, queue })
    }

    /// A buffer with contents.
    pub fn buffer<T: bytemuck::NoUninit>(&self, contents: &[T], usage: wgpu::BufferUsages) -> wgpu::Buffer {
        let bytes: &[u8] = bytemuck::cast_slice(contents);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: (bytes.len() as u64).next_multiple_of(wgpu::COPY_BUFFER_ALIGNMENT),
            usage: usage | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        self.queue.write_buffer(&buffer, 0, bytes);
        buffer
    }

    /// A texture.
    pub fn texture(
        &self,
        (width, height): (u32, u32),
        format: wgpu::TextureFormat,
        usage: wgpu::TextureUsages,
    ) -> wgpu::Texture {
        self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage,
            view_formats: &[],
        })
    }

    /// The bytes of a texture, after all submitted work.
    ///
    /// # Errors
    /// A lost device.
    pub fn read(&self, texture: &wgpu::Texture) -> Result<Vec<u8>, ServiceError> {
        read_back::texture_bytes(&self.device, &self.queue, texture)
    }
}

/// Writes a grey or RGBA picture to `target/examples-out/NAME.png` and says where it went.
///
/// # Errors
/// What the file system says.
pub fn write_picture(name: &str, (width, height): (u32, u32), bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    let folder = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| PathBuf::from("target"), PathBuf::from);
    let folder = folder.join("examples-out");
    std::fs::create_dir_all(&folder)?;
    let path = folder.join(name).with_extension("png");
    let mut encoder =
        png::Encoder::new(std::io::BufWriter::new(std::fs::File::create(&path)?), width, height);
    let grey = bytes.len() == width as usize * height as usize;
    encoder.set_color(if grey { png::ColorType::Grayscale } else { png::ColorType::Rgba });
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(bytes)?;
    println!("picture: {}", path.display());
    Ok(())
}
