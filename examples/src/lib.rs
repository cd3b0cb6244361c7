//! Small programs to start from.
//!
//! * `quantised_vertices`: casters in an engine's own vertex format, far from the world's origin.
//! * `engine_casters`: the engine's own vertex functions place skinned, instanced and displaced casters, with holes.
//! * `material_function`: the engine's own material calls the generated visibility function, bound beside the engine's own
//!   bindings.
//! * `deferred_mask`: a deferred renderer gives its depth and gets a visibility mask.
//! * `many_lights`: a sun, a spot light and lamps share one map; only what changes is drawn again.
//! * `build_script_tables`: tables and SPIR-V for an engine that renders by itself; no graphics interface.
//!
//! Each runs without a window, prints what it shows and checks itself. What they share is here: a device, buffers, cameras,
//! scenes of boxes and pictures.

mod boxes;

pub use boxes::{BoxScene, Vertex};

use std::error::Error;
use std::path::PathBuf;

use cssm::View;
use cssm::core::glam::{DMat4, DVec3, DVec4};
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

    /// A bind group of uniform buffers, numbered in order and visible to both stages, and its layout.
    pub fn uniform_group(&self, buffers: &[&wgpu::Buffer]) -> (wgpu::BindGroupLayout, wgpu::BindGroup) {
        let entry = |binding: u32| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
            ty: wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Uniform,
                has_dynamic_offset: false,
                min_binding_size: None,
            },
            count: None,
        };
        let entries: Vec<_> = (0..buffers.len() as u32).map(entry).collect();
        let layout = self
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: None, entries: &entries });
        let entries: Vec<_> = (0..)
            .zip(buffers)
            .map(|(binding, buffer)| wgpu::BindGroupEntry { binding, resource: buffer.as_entire_binding() })
            .collect();
        let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &layout,
            entries: &entries,
        });
        (layout, group)
    }

    /// A pipeline of a camera pass with reversed-z depth: `[vertex, fragment]` of a module into targets of some formats.
    pub fn pipeline(
        &self,
        module: &wgpu::ShaderModule,
        [vertex, fragment]: [&str; 2],
        groups: &[Option<&wgpu::BindGroupLayout>],
        buffers: &[Option<wgpu::VertexBufferLayout>],
        topology: wgpu::PrimitiveTopology,
        formats: &[wgpu::TextureFormat],
    ) -> wgpu::RenderPipeline {
        let layout = self.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: None,
            bind_group_layouts: groups,
            immediate_size: 0,
        });
        let targets: Vec<_> = formats.iter().map(|format| Some((*format).into())).collect();
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(vertex),
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some(vertex),
                compilation_options: Default::default(),
                buffers,
            },
            primitive: wgpu::PrimitiveState { topology, ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: wgpu::TextureFormat::Depth32Float,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Greater),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: Default::default(),
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some(fragment),
                compilation_options: Default::default(),
                targets: &targets,
            }),
            multiview_mask: None,
            cache: None,
        })
    }

    /// Begins a camera pass: clears colour targets and depth, and keeps both.
    pub fn pass<'e>(
        &self,
        encoder: &'e mut wgpu::CommandEncoder,
        targets: &[(&wgpu::Texture, wgpu::Color)],
        depth: &wgpu::Texture,
    ) -> wgpu::RenderPass<'e> {
        let views: Vec<_> =
            targets.iter().map(|(target, _)| target.create_view(&Default::default())).collect();
        let attachment = |(view, (_, clear)): (_, &(&wgpu::Texture, wgpu::Color))| {
            let ops = wgpu::Operations { load: wgpu::LoadOp::Clear(*clear), store: wgpu::StoreOp::Store };
            Some(wgpu::RenderPassColorAttachment { view, depth_slice: None, resolve_target: None, ops })
        };
        let colours: Vec<_> = views.iter().zip(targets).map(attachment).collect();
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("camera"),
            color_attachments: &colours,
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &depth.create_view(&Default::default()),
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            ..Default::default()
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

/// What the engines' cameras tell their shaders: clip space from camera axes, camera axes from an object at `origin_world`,
/// and the unit vector `toward_light_world` in camera axes. Composed in f64 and rounded once.
pub fn camera_numbers(view: &View, origin_world: DVec3, toward_light_world: DVec3) -> Vec<f32> {
    let origin = view.camera_from_world * (origin_world - view.eye_world);
    let camera_from_object = DMat4::from_mat3_translation(view.camera_from_world, origin);
    let toward_light = (view.camera_from_world * toward_light_world).extend(0.0);
    let mut numbers = clip_from_camera(view).as_mat4().to_cols_array().to_vec();
    numbers.extend(camera_from_object.as_mat4().to_cols_array());
    numbers.extend(toward_light.as_vec4().to_array());
    numbers
}

/// The infinite reversed-z projection of a view, from camera axes.
fn clip_from_camera(view: &View) -> DMat4 {
    let (width, height) = (view.right - view.left, view.top - view.bottom);
    DMat4::from_cols(
        DVec4::new(2.0 / width, 0.0, 0.0, 0.0),
        DVec4::new(0.0, 2.0 / height, 0.0, 0.0),
        DVec4::new((view.right + view.left) / width, (view.top + view.bottom) / height, 0.0, -1.0),
        DVec4::new(0.0, 0.0, view.near_metres, 0.0),
    )
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
