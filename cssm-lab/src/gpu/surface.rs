//! Traced pixels on the device: what an engine's G-buffer would hold, rounded once.

use cssm_core::View;

use super::depth_input::reversed_z_texture;
use super::{Gpu, GpuError, whole};
use crate::truth::{Frame, Visible};

/// Positions, normals and depths of a traced frame.
#[derive(Debug)]
pub struct Surface {
    pub(super) size: (u32, u32),
    /// Position relative to the eye in xyz; w is 1 on surfaces and 0 in the sky.
    pub(super) positions: wgpu::TextureView,
    /// Geometric normals.
    pub(super) normals: wgpu::TextureView,
    /// Depth in metres, 0 in the sky.
    pub(super) linear_depths: wgpu::TextureView,
    /// Reversed-z depth of the view's own planes.
    pub(super) reversed_z: wgpu::TextureView,
}

impl Surface {
    /// Uploads a frame of a view.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn new(gpu: &Gpu, view: &View, frame: &Frame) -> Result<Self, GpuError> {
        let size = view.size_pixels;
        let four = |value: &dyn Fn(&Visible) -> [f64; 4]| -> Vec<f32> {
            let texel =
                |pixel: &Option<Visible>| pixel.as_ref().map_or([0.0; 4], value).map(|value| value as f32);
            frame.pixels.iter().flat_map(texel).collect()
        };
        let one = |value: &dyn Fn(&Visible) -> f64| -> Vec<f32> {
            frame.pixels.iter().map(|pixel| pixel.as_ref().map_or(0.0, value) as f32).collect()
        };
        let positions = four(&|pixel| pixel.position.extend(1.0).to_array());
        let normals = four(&|pixel| pixel.normal.extend(0.0).to_array());
        let depths = one(&|pixel| pixel.depth);
        let far_inverse = 1.0 / view.far_metres;
        let stored = one(&|pixel| (1.0 / pixel.depth - far_inverse) / (1.0 / view.near_metres - far_inverse));

        let float = |values: &[f32], format| gpu.float_texture(size, format, values);
        Ok(Self {
            size,
            positions: whole(&float(&positions, wgpu::TextureFormat::Rgba32Float)?),
            normals: whole(&float(&normals, wgpu::TextureFormat::Rgba32Float)?),
            linear_depths: whole(&float(&depths, wgpu::TextureFormat::R32Float)?),
            reversed_z: whole(&reversed_z_texture(gpu, size, &stored)?),
        })
    }
}
