//! The capture stage: the pass that replays a frame's commands.

mod engine;
mod pipelines;
mod stretched;

pub use engine::{CasterPipelineDescription, CasterPipelines, EngineFacet};
pub(crate) use pipelines::{Attribute, CapturePipelines, VertexKey};
pub(crate) use stretched::{Fetched, Stretched, StretchedMesh, fetches_by_itself, vertex_storage_buffers};

use cssm_core::facet::Tile;
use cssm_core::plan::DepthOrder;

use crate::commands::{Command, FrameCommands};
use crate::cull::InstanceRows;
use crate::culling::CulledFrame;
use crate::frame::{PreparedFrame, Slot};
use crate::mesh::{Mesh, MeshHandle};

/// Vertex buffer slot of the engine's positions.
const POSITION_SLOT: u32 = 0;
/// Vertex buffer slot of the instance rows.
const INSTANCE_SLOT: u32 = 1;
/// Vertex buffer slot of the texture coordinates of alpha masks.
const UV_SLOT: u32 = 2;

/// What draws read besides meshes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Records<'a> {
    pub(crate) slot: &'a Slot,
    /// Distance between the records of facets in bytes.
    pub(crate) facet_stride: u64,
    pub(crate) order: DepthOrder,
    /// What culling on the device has filled, for commands that leave draws to it.
    pub(crate) culled: Option<&'a CulledFrame>,
}

impl Records<'_> {
    /// Confines a pass to a facet's tile and binds its record, at its position in the plan's list.
    pub(crate) fn begin_facet(&self, pass: &mut wgpu::RenderPass, position: usize, tile: &Tile) {
        let offset = position as u64 * self.facet_stride;
        pass.set_bind_group(0, &self.slot.capture_group, &[offset as u32]);
        confine(pass, tile);
    }
}

/// Whose rows are bound.
#[derive(Clone, Copy, PartialEq, Eq)]
enum BoundRows {
    Written,
    Culled,
}

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
        let records = Records {
            slot: &frame.slot,
            facet_stride,
            order: frame.depth_order,
            culled: frame.culled.as_deref(),
        };
        self.record(&mut pass, &frame.commands, records, 0, meshes);
    }

    /// Records commands into a pass; their instance rows begin at `first_row` of the slot's.
    pub(crate) fn record<'m>(
        &self,
        pass: &mut wgpu::RenderPass,
        commands: &FrameCommands,
        records: Records<'_>,
        first_row: usize,
        meshes: impl Fn(MeshHandle) -> Option<&'m Mesh>,
    ) {
        if commands.commands.is_empty() {
            return;
        }
        let Records { slot, order, culled, .. } = records;
        let first_byte = first_row as u64 * InstanceRows::BYTES;
        let mut bound = None;
        let mut bind_rows = |pass: &mut wgpu::RenderPass, wanted: BoundRows| {
            if bound.replace(wanted) != Some(wanted) {
                let rows = match (wanted, culled) {
                    (BoundRows::Culled, Some(culled)) => culled.rows.slice(..),
                    _ => slot.instances.slice(first_byte..),
                };
                pass.set_vertex_buffer(INSTANCE_SLOT, rows);
            }
        };
        let mut mesh_here = None;
        for command in &commands.commands {
            match command {
                Command::Facet { facet, tile } => {
                    records.begin_facet(pass, facet.0 as usize, tile);
                }
                Command::Pipeline(handle) => {
                    if let Some(pipeline) = self.pipeline(*handle, order) {
                        pass.set_pipeline(pipeline);
                    }
                }
                Command::Mesh(handle) => {
                    mesh_here = meshes(*handle);
                    if let Some(mesh) = mesh_here {
                        mesh.bind(pass, POSITION_SLOT);
                        if let Some(mask) = mesh.mask() {
                            mask.bind(pass, UV_SLOT, self.mask_group());
                        }
                    }
                }
                Command::Draw { first, count, indexed: true, instances } => {
                    bind_rows(pass, BoundRows::Written);
                    pass.draw_indexed(*first..first + count, 0, instances.clone());
                }
                Command::Draw { first, count, indexed: false, instances } => {
                    bind_rows(pass, BoundRows::Written);
                    pass.draw(*first..first + count, instances.clone());
                }
                Command::DrawCulled { arguments, indexed } => {
                    if let (Some(culled), Some(mesh)) = (culled, mesh_here) {
                        bind_rows(pass, BoundRows::Culled);
                        mesh.bind_all_indices(pass);
                        culled.draw(pass, *arguments, *indexed);
                    }
                }
                Command::DrawCulledClusters { arguments, count, most, indexed } => {
                    if let (Some(culled), Some(mesh)) = (culled, mesh_here) {
                        bind_rows(pass, BoundRows::Culled);
                        mesh.bind_all_indices(pass);
                        culled.draw_clusters(pass, *arguments, *count, *most, *indexed);
                    }
                }
            }
        }
    }
}

/// Confines a pass to a tile.
pub(crate) fn confine(pass: &mut wgpu::RenderPass, tile: &Tile) {
    let [x, y, width, height] = [tile.x, tile.y, tile.width, tile.height];
    pass.set_viewport(x as f32, y as f32, width as f32, height as f32, 0.0, 1.0);
    pass.set_scissor_rect(x, y, width, height);
}
