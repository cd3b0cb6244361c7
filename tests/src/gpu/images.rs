//! Images in and out.

use cssm_core::View;
use cssm_core::glam::DVec3;
use cssm_runtime::{read_back, wgpu};

use super::device::TestDevice;

/// A render target that can be read back.
pub fn target(gpu: &TestDevice, size: (u32, u32), format: wgpu::TextureFormat) -> wgpu::Texture {
    texture(gpu, size, format, wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC)
}

/// A texture of `R32Float` with contents, to be sampled.
pub fn float_texture(gpu: &TestDevice, size: (u32, u32), values: &[f32]) -> wgpu::Texture {
    filled(gpu, size, wgpu::TextureFormat::R32Float, values)
}

/// A texture of `Rgba32Float` with contents, to be sampled.
pub fn vector_texture(gpu: &TestDevice, size: (u32, u32), values: &[f32]) -> wgpu::Texture {
    filled(gpu, size, wgpu::TextureFormat::Rgba32Float, values)
}

/// A texture of `Rgba8Unorm` that is white where there is alpha, to be sampled.
pub fn alpha_texture(gpu: &TestDevice, size: (u32, u32), alpha: &[u8]) -> wgpu::Texture {
    let bytes: Vec<u8> = alpha.iter().flat_map(|alpha| [255, 255, 255, *alpha]).collect();
    uploaded(gpu, size, wgpu::TextureFormat::Rgba8Unorm, &bytes)
}

fn filled(gpu: &TestDevice, size: (u32, u32), format: wgpu::TextureFormat, values: &[f32]) -> wgpu::Texture {
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    uploaded(gpu, size, format, &bytes)
}

fn uploaded(gpu: &TestDevice, size: (u32, u32), format: wgpu::TextureFormat, bytes: &[u8]) -> wgpu::Texture {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let texture = texture(gpu, size, format, usage);
    let bytes_per_row = Some(bytes.len() as u32 / size.1);
    gpu.queue.write_texture(
        texture.as_image_copy(),
        bytes,
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image: None },
        texture.size(),
    );
    texture
}

/// A `Depth32Float` texture with contents, to be sampled: drawn, because depth textures take no uploads.
pub fn depth_texture(gpu: &TestDevice, size: (u32, u32), values: &[f32]) -> wgpu::Texture {
    let source = float_texture(gpu, size, values);
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::RENDER_ATTACHMENT;
    let depth = texture(gpu, size, wgpu::TextureFormat::Depth32Float, usage);
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: None,
        source: wgpu::ShaderSource::Wgsl(COPY_DEPTH.into()),
    });
    let layout = gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: None,
        entries: &[wgpu::BindGroupLayoutEntry {
            binding: 0,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty: wgpu::BindingType::Texture {
                sample_type: wgpu::TextureSampleType::Float { filterable: false },
                view_dimension: wgpu::TextureViewDimension::D2,
                multisampled: false,
            },
            count: None,
        }],
    });
    let pipeline_layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &[Some(&layout)],
        immediate_size: 0,
    });
    let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&pipeline_layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: wgpu::TextureFormat::Depth32Float,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Always),
            stencil: Default::default(),
            bias: Default::default(),
        }),
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: None,
            compilation_options: Default::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    });
    let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &layout,
        entries: &[wgpu::BindGroupEntry {
            binding: 0,
            resource: wgpu::BindingResource::TextureView(&source.create_view(&Default::default())),
        }],
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let view = depth.create_view(&Default::default());
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &view,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(0.0), store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        }),
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    pass.draw(0..3, 0..1);
    drop(pass);
    gpu.queue.submit([encoder.finish()]);
    depth
}

const COPY_DEPTH: &str = "
@group(0) @binding(0) var values: texture_2d<f32>;

@vertex
fn everywhere(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(select(-1.0, 3.0, corner == 2u), select(1.0, -3.0, corner == 1u), 0.0, 1.0);
}

@fragment
fn copy(@builtin(position) pixel: vec4<f32>) -> @builtin(frag_depth) f32 {
    return textureLoad(values, vec2<i32>(pixel.xy), 0).x;
}
";

/// Red of an `R8Unorm` texture.
///
/// # Panics
/// When reading back fails.
pub fn red(gpu: &TestDevice, texture: &wgpu::Texture) -> Vec<u8> {
    read_back::texture_bytes(&gpu.device, &gpu.queue, texture).expect("the texture has COPY_SRC usage")
}

/// Depth along the view axis at each pixel centre of a surface that a ray meets at `hit` (metres of depth); 0: sky.
pub fn linear_depths(view: &View, hit: impl Fn(DVec3) -> Option<f64>) -> Vec<f32> {
    let (width, height) = view.size_pixels;
    (0..width * height)
        .map(|pixel| {
            let ray = view.ray_world(f64::from(pixel % width) + 0.5, f64::from(pixel / width) + 0.5);
            hit(ray).map_or(0.0, |depth| depth as f32)
        })
        .collect()
}

fn texture(
    gpu: &TestDevice,
    (width, height): (u32, u32),
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
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
