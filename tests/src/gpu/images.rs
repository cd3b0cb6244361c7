//! Images in and out.

use cssm_core::View;
use cssm_core::glam::DVec3;
use cssm_runtime::{read_back, wgpu};

use super::device::TestDevice;

/// A render target that can be read back.
pub fn target(gpu: &TestDevice, size: (u32, u32), format: wgpu::TextureFormat) -> wgpu::Texture {
    texture(
        gpu,
        size,
        format,
        wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
    )
}

/// A texture of `R32Float` with contents, to be sampled.
pub fn float_texture(gpu: &TestDevice, size: (u32, u32), values: &[f32]) -> wgpu::Texture {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    let texture = texture(gpu, size, wgpu::TextureFormat::R32Float, usage);
    let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
    gpu.queue.write_texture(
        texture.as_image_copy(),
        &bytes,
        wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(size.0 * 4),
            rows_per_image: None,
        },
        texture.size(),
    );
    texture
}

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
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}
