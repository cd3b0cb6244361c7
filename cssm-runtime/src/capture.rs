//! The capture stage: pipelines for the engine's vertex formats, and the pass that replays a frame's commands.

use cssm_core::table::{CaseTable, ShaderKind};

use crate::atlas::texture_format;
use crate::commands::{Command, PipelineHandle};
use crate::cull::InstanceRows;
use crate::error::ServiceError;
use crate::frame::PreparedFrame;
use crate::layout::{incomplete, required_pass, shader_module};
use crate::mesh::{Mesh, MeshHandle};
use crate::scope::checked;

/// Vertex buffer slot of the engine's positions.
const POSITION_SLOT: u32 = 0;
/// Vertex buffer slot of the instance rows.
const INSTANCE_SLOT: u32 = 1;
/// What the map holds where no caster is: the far end of depth.
const CLEAR_DEPTH: f32 = 1.0;

/// Capture pipelines, one for each vertex format and stride in use.
#[derive(Debug)]
pub(crate) struct CapturePipelines {
    shader: ShaderKind,
    module: wgpu::ShaderModule,
    vertex: String,
    fragment: Option<String>,
    layout: wgpu::PipelineLayout,
    format: wgpu::TextureFormat,
    pipelines: Vec<(VertexKey, wgpu::RenderPipeline)>,
}

/// What distinguishes capture pipelines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct VertexKey {
    pub(crate) format: wgpu::VertexFormat,
    pub(crate) stride_bytes: u32,
}

impl CapturePipelines {
    pub(crate) fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        shader: ShaderKind,
        group_layout: &wgpu::BindGroupLayout,
    ) -> Result<Self, ServiceError> {
        let pass = required_pass(table, shader)?;
        let module = shader_module(device, table, shader)?;
        let layout = checked(device, "the capture pipeline layout", || {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("cssm capture"),
                bind_group_layouts: &[Some(group_layout)],
                immediate_size: 0,
            })
        })?;
        let mut pipelines = Self {
            shader,
            module,
            vertex: pass.vertex.to_string(),
            fragment: pass.fragment.as_ref().map(ToString::to_string),
            layout,
            format: texture_format(table.map_format),
            pipelines: Vec::new(),
        };

        // Create the most common one now, so that faulty shaders are refused here and not at the first mesh.
        pipelines.handle(device, VertexKey { format: wgpu::VertexFormat::Float32x3, stride_bytes: 12 })?;
        Ok(pipelines)
    }

    /// Which of the two capture shaders runs.
    pub(crate) fn shader(&self) -> ShaderKind {
        self.shader
    }

    /// The pipeline for a vertex format, created on first use.
    pub(crate) fn handle(
        &mut self,
        device: &wgpu::Device,
        key: VertexKey,
    ) -> Result<PipelineHandle, ServiceError> {
        let known = self.pipelines.iter().position(|(known, _)| *known == key);
        let index = match known {
            Some(index) => index,
            None => {
                let pipeline = checked(device, "a capture pipeline", || self.create(device, key))?;
                self.pipelines.push((key, pipeline));
                self.pipelines.len() - 1
            }
        };
        Ok(PipelineHandle(index as u32))
    }

    fn create(&self, device: &wgpu::Device, key: VertexKey) -> wgpu::RenderPipeline {
        let row = |location: u32| wgpu::VertexAttribute {
            format: wgpu::VertexFormat::Float32x4,
            offset: u64::from(location - 1) * 16,
            shader_location: location,
        };
        let positions = wgpu::VertexBufferLayout {
            array_stride: u64::from(key.stride_bytes),
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &[wgpu::VertexAttribute { format: key.format, offset: 0, shader_location: 0 }],
        };
        let rows = wgpu::VertexBufferLayout {
            array_stride: InstanceRows::BYTES,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &[row(1), row(2), row(3)],
        };
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("cssm capture"),
            layout: Some(&self.layout),
            vertex: wgpu::VertexState {
                module: &self.module,
                entry_point: Some(&self.vertex),
                compilation_options: Default::default(),
                buffers: &[Some(positions), Some(rows)],
            },
            // Casters are drawn from both sides: which side faces the light says nothing about leaks.
            primitive: wgpu::PrimitiveState {
                cull_mode: None,
                unclipped_depth: self.shader == ShaderKind::Capture,
                ..Default::default()
            },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: self.format,
                depth_write_enabled: Some(true),
                depth_compare: Some(wgpu::CompareFunction::Less),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState::default(),
            fragment: self.fragment.as_ref().map(|entry| wgpu::FragmentState {
                module: &self.module,
                entry_point: Some(entry),
                compilation_options: Default::default(),
                targets: &[],
            }),
            multiview_mask: None,
            cache: None,
        })
    }

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
                    load: wgpu::LoadOp::Clear(CLEAR_DEPTH),
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
                    if let Some((_, pipeline)) = self.pipelines.get(handle.0 as usize) {
                        pass.set_pipeline(pipeline);
                    }
                }
                Command::Mesh(handle) => {
                    if let Some(mesh) = meshes(*handle) {
                        mesh.bind(&mut pass, POSITION_SLOT);
                    }
                }
                Command::Draw { corners, indexed: true, instances } => {
                    pass.draw_indexed(0..*corners, 0, instances.clone());
                }
                Command::Draw { corners, indexed: false, instances } => {
                    pass.draw(0..*corners, instances.clone());
                }
            }
        }
    }
}

/// Which capture shader a device can run.
pub(crate) fn capture_shader(
    device: &wgpu::Device,
    table: &CaseTable,
    clamped: bool,
) -> Result<ShaderKind, ServiceError> {
    let unclipped = device.features().contains(wgpu::Features::DEPTH_CLIP_CONTROL);
    let preferred = if unclipped && !clamped { ShaderKind::Capture } else { ShaderKind::CaptureClamped };
    table.pass(preferred).map(|pass| pass.shader).ok_or_else(|| incomplete(table, "capture pass"))
}
