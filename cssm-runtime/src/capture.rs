//! The capture stage: the pass that replays a frame's commands.

mod pipelines;
mod stretched;

pub(crate) use pipelines::{Attribute, CapturePipelines, VertexKey};
pub(crate) use stretched::{Fetched, Stretched, StretchedMesh, fetches_by_itself, vertex_storage_buffers};

use crate::commands::Command;
use crate::frame::PreparedFrame;
use crate::mesh::{Mesh, MeshHandle};

/// Vertex buffer slot of the engine's positions.
const POSITION_SLOT: u32 = 0;
/// Vertex buffer slot of the instance rows.
const INSTANCE_SLOT: u32 = 1;
/// Vertex buffer slot of the texture coordinates of alpha masks.
const UV_SLOT: u32 = 2;

impl CapturePipelines {
    /// Records the one render pass of a frame.
    pub(crate) fn replay<'m>(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        map: &wgpu::TextureView,
        frame: &PreparedFrame,
        facet_stride: u64,
        meshes: impl Fn(MeshHandle) -> Option<&'m Mesh>,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("cssm capture"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: map,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(frame.depth_order.cleared() as f32),
                    store: wgpu::StoreOp::Store,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: timestamps,
            ..Default::default()
        });
        if frame.commands.commands.is_empty() {
            return;
        }
        pass.set_vertex_buffer(INSTANCE_SLOT, frame.slot.instances.slice(..));
        for command in &frame.commands.commands {
            match command {
                Command::Facet { facet, tile } => {
                    let offset = u64::from(facet.0) * facet_stride;
                    pass.set_bind_group(0, &frame.slot.capture_group, &[offset as u32]);
                    pass.set_viewport(
                        tile.x as f32,
                        tile.y as f32,
                        tile.width as f32,
                        tile.height as f32,
                        0.0,
                        1.0,
                    );
                    pass.set_scissor_rect(tile.x, tile.y, tile.width, tile.height);
                }
                Command::Pipeline(handle) => {
                    if let Some(pipeline) = self.pipeline(*handle, frame.depth_order) {
                        pass.set_pipeline(pipeline);
                    }
                }
                Command::Mesh(handle) => {
                    if let Some(mesh) = meshes(*handle) {
                        mesh.bind(&mut pass, POSITION_SLOT);
                        if let Some(mask) = mesh.mask() {
                            mask.bind(&mut pass, UV_SLOT, self.mask_group());
                        }
                    }
                }
                Command::Draw { first, count, indexed: true, instances } => {
                    pass.draw_indexed(*first..first + count, 0, instances.clone());
                }
                Command::Draw { first, count, indexed: false, instances } => {
                    pass.draw(*first..first + count, instances.clone());
                }
            }
        }
    }
}
