//! Alpha masks of a scene's meshes on the device.

use cssm_runtime::AlphaMask;

use super::{Gpu, GpuError, whole};
use crate::scene;

const UV_BYTES: u32 = 8;

/// Texture coordinates and texture of one mesh.
#[derive(Debug)]
pub(super) struct MaskBuffers {
    uvs: wgpu::Buffer,
    texture: wgpu::TextureView,
    sampler: wgpu::Sampler,
    cutoff: f32,
}

impl MaskBuffers {
    /// Uploads a mask; nearest texel and repeated, as the ray tracer reads it.
    pub(super) fn new(gpu: &Gpu, mask: &scene::AlphaMask) -> Result<Self, GpuError> {
        let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
        let size = (mask.width, mask.height);
        let texture = gpu.texture(size, wgpu::TextureFormat::Rgba8Unorm, usage)?;
        gpu.checked("an alpha mask", || {
            let texels: Vec<u8> = mask.alpha.iter().flat_map(|alpha| [255, 255, 255, *alpha]).collect();
            gpu.queue.write_texture(
                texture.as_image_copy(),
                &texels,
                wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(4 * mask.width),
                    rows_per_image: None,
                },
                texture.size(),
            );
            let uvs: &[u8] = bytemuck::cast_slice(&mask.uvs);
            let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("scene texture coordinates"),
                size: (uvs.len() as u64).max(u64::from(UV_BYTES)),
                usage: wgpu::BufferUsages::VERTEX
                    | wgpu::BufferUsages::STORAGE
                    | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            });
            gpu.queue.write_buffer(&buffer, 0, uvs);
            let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("scene alpha mask"),
                address_mode_u: wgpu::AddressMode::Repeat,
                address_mode_v: wgpu::AddressMode::Repeat,
                ..Default::default()
            });
            Self { uvs: buffer, texture: whole(&texture), sampler, cutoff: mask.cutoff }
        })
    }

    /// The mask as the service takes it.
    pub(super) const fn description(&self) -> AlphaMask<'_> {
        AlphaMask {
            uvs: &self.uvs,
            offset_bytes: 0,
            stride_bytes: UV_BYTES,
            format: wgpu::VertexFormat::Float32x2,
            texture: &self.texture,
            sampler: &self.sampler,
            cutoff: self.cutoff,
        }
    }
}
