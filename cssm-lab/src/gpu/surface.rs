//! Traced pixels on the device: what an engine's G-buffer would hold, rounded once.

use cssm_core::View;
use cssm_core::case::Axes;
use cssm_core::glam::DMat3;

use super::depth_input::reversed_z_texture;
use super::{Gpu, GpuError, whole};
use crate::truth::{Frame, Visible};

/// Positions, normals and depths of a traced frame.
#[derive(Debug)]
pub struct Surface {
    pub(super) size: (u32, u32),
    camera: SurfaceVectors,
    world: SurfaceVectors,
    /// Depth in metres, 0 in the sky.
    pub(super) linear_depths: wgpu::TextureView,
    /// Reversed-z depth of the view's own planes.
    pub(super) reversed_z: wgpu::TextureView,
}

/// What depends on the axes.
#[derive(Debug)]
pub(super) struct SurfaceVectors {
    /// Position relative to the eye in xyz; w is 1 on surfaces and 0 in the sky.
    pub(super) positions: wgpu::TextureView,
    /// Geometric normals.
    pub(super) normals: wgpu::TextureView,
}

impl Surface {
    /// Uploads a frame of a view.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn new(gpu: &Gpu, view: &View, frame: &Frame) -> Result<Self, GpuError> {
        let size = view.size_pixels;
        let one = |value: &dyn Fn(&Visible) -> f64| -> Vec<f32> {
            frame.pixels.iter().map(|pixel| pixel.as_ref().map_or(0.0, value) as f32).collect()
        };
        let depths = one(&|pixel| pixel.depth);
        let far_inverse = 1.0 / view.far_metres;
        let stored = one(&|pixel| (1.0 / pixel.depth - far_inverse) / (1.0 / view.near_metres - far_inverse));
        Ok(Self {
            size,
            camera: SurfaceVectors::new(gpu, size, frame, &view.camera_from_world)?,
            world: SurfaceVectors::new(gpu, size, frame, &DMat3::IDENTITY)?,
            linear_depths: whole(&gpu.float_texture(size, wgpu::TextureFormat::R32Float, &depths)?),
            reversed_z: whole(&reversed_z_texture(gpu, size, &stored)?),
        })
    }

    /// Positions and normals in the axes that a case declares.
    pub(super) const fn vectors(&self, axes: Axes) -> &SurfaceVectors {
        match axes {
            Axes::Camera => &self.camera,
            Axes::World => &self.world,
        }
    }
}

impl SurfaceVectors {
    /// Uploads a traced frame, which is in world axes, turned in f64.
    fn new(gpu: &Gpu, size: (u32, u32), frame: &Frame, from_world: &DMat3) -> Result<Self, GpuError> {
        let texture = |value: &dyn Fn(&Visible) -> [f64; 4]| {
            let texel =
                |pixel: &Option<Visible>| pixel.as_ref().map_or([0.0; 4], value).map(|value| value as f32);
            let values: Vec<f32> = frame.pixels.iter().flat_map(texel).collect();
            gpu.float_texture(size, wgpu::TextureFormat::Rgba32Float, &values)
        };
        let positions = texture(&|pixel| (*from_world * pixel.position).extend(1.0).to_array())?;
        let normals = texture(&|pixel| (*from_world * pixel.normal).extend(0.0).to_array())?;
        Ok(Self { positions: whole(&positions), normals: whole(&normals) })
    }
}
