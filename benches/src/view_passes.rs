//! The view's own passes, which every frame has with and without shadows: what is seen, then light on it.

mod geometry;
mod pipelines;

use cssm_core::View;
use cssm_core::glam::DVec3;
use cssm_lab::gpu::{Gpu, GpuError, Writes};
use cssm_lab::scene::Scene;

use geometry::Geometry;
use pipelines::Pipelines;

/// What is written of everything that is seen.
const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
const NORMAL_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
const COLOUR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Format of what reaches a pixel of the light, 1 where all of it does.
pub const LIT_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R8Unorm;

/// A view of a scene on a device.
#[derive(Debug)]
pub struct ViewPasses {
    geometry: Geometry,
    pipelines: Pipelines,
    groups: [wgpu::BindGroup; 2],
    /// Depth of what is seen, reversed: near / depth.
    pub depth: wgpu::TextureView,
    /// How much of the light reaches each pixel; masks write it.
    pub lit: wgpu::TextureView,
    normals: wgpu::TextureView,
    colours: wgpu::TextureView,
    image: wgpu::TextureView,
}

impl ViewPasses {
    /// Uploads a scene for a view.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn new(gpu: &Gpu, scene: &Scene, view: &View, toward_light: DVec3) -> Result<Self, GpuError> {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING;
        let target = |format, usage| {
            let texture = gpu.texture(view.size_pixels, format, usage)?;
            Ok::<_, GpuError>(texture.create_view(&wgpu::TextureViewDescriptor::default()))
        };
        let (depth, image) = (target(DEPTH_FORMAT, usage)?, target(COLOUR_FORMAT, usage)?);
        let (normals, colours) = (target(NORMAL_FORMAT, usage)?, target(COLOUR_FORMAT, usage)?);
        let lit = target(LIT_FORMAT, usage | wgpu::TextureUsages::COPY_SRC)?;
        let geometry = Geometry::new(gpu, scene, view, toward_light)?;
        let pipelines = Pipelines::new(gpu)?;
        let groups = gpu.checked("the view's bind groups", || {
            let record = wgpu::BindGroupEntry { binding: 0, resource: geometry.record.as_entire_binding() };
            let texture = |binding, view| wgpu::BindGroupEntry {
                binding,
                resource: wgpu::BindingResource::TextureView(view),
            };
            let group = |layout, entries: &[_]| {
                let label = Some("view");
                gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label, layout, entries })
            };
            let read = [record.clone(), texture(1, &normals), texture(2, &colours), texture(3, &lit)];
            [group(&pipelines.see_layout, &[record]), group(&pipelines.shade_layout, &read)]
        })?;
        Ok(Self { geometry, pipelines, groups, depth, lit, normals, colours, image })
    }

    /// Records depth, normals and colours of everything that is seen.
    pub fn see(&self, encoder: &mut wgpu::CommandEncoder, timestamps: Option<Writes<'_>>) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("see"),
            color_attachments: &[cleared(&self.normals), cleared(&self.colours)],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: timestamps,
            ..Default::default()
        });
        pass.set_pipeline(&self.pipelines.see);
        pass.set_bind_group(0, &self.groups[0], &[]);
        self.geometry.draw(&mut pass);
    }

    /// Records light on what is seen.
    pub fn shade(&self, encoder: &mut wgpu::CommandEncoder, timestamps: Option<Writes<'_>>) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("shade"),
            color_attachments: &[cleared(&self.image)],
            timestamp_writes: timestamps,
            ..Default::default()
        });
        pass.set_pipeline(&self.pipelines.shade);
        pass.set_bind_group(0, &self.groups[1], &[]);
        pass.draw(0..3, 0..1);
    }
}

/// A colour target that begins empty.
fn cleared(view: &wgpu::TextureView) -> Option<wgpu::RenderPassColorAttachment<'_>> {
    Some(wgpu::RenderPassColorAttachment {
        view,
        depth_slice: None,
        resolve_target: None,
        ops: wgpu::Operations {
            load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
            store: wgpu::StoreOp::Store,
        },
    })
}
