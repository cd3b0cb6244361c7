//! Captures with the engine's own pipelines: shaders composed around its vertex function draw what it skins, instances or
//! displaces, from buffers that the service never sees.
//!
//! The service keeps what belongs to the map: layout and state of the pipelines, one pass, and for every facet its tile
//! and its record. What is drawn into a facet is the engine's.

use cssm_core::ShadowPlan;
use cssm_core::facet::Facet;
use cssm_core::plan::DepthOrder;
use cssm_core::table::{CasterShader, CasterTable, GroupContent, ShaderKind};

use super::confine;
use crate::atlas::texture_format;
use crate::depth_order::ByOrder;
use crate::error::ServiceError;
use crate::frame::PreparedFrame;
use crate::layout::required_group;
use crate::scope::checked;
use crate::service::{ShadowService, keep_until_done};

/// A facet that the engine draws its casters into: viewport, scissor and record are set.
#[derive(Debug, Clone, Copy)]
pub struct EngineFacet<'a> {
    /// Position in the plan's list.
    pub position: usize,
    /// The facet. Of its casters it takes those inside all half-spaces of [`Facet::casters`], world axes relative to the
    /// plan's eye; [`Facet::reached_by`] tests a box. Drawing others costs time and changes nothing.
    pub facet: &'a Facet,
    /// Which of [`CasterPipelines`] draws.
    pub depth_order: DepthOrder,
}

/// What pipelines of a caster entry are made of.
#[derive(Debug, Clone, Copy)]
pub struct CasterPipelineDescription<'a> {
    /// The composed shaders.
    pub casters: &'a CasterTable,
    /// Layouts of the engine's bind groups by number; the one of the facet's group is the service's and ignored here.
    pub bind_group_layouts: &'a [Option<&'a wgpu::BindGroupLayout>],
    /// The engine's vertex buffers, and one for the instance rows if [`CasterTable::space`] asks for them.
    pub buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
    /// How vertices form triangles.
    pub topology: wgpu::PrimitiveTopology,
    /// Index format of strips.
    pub strip_index_format: Option<wgpu::IndexFormat>,
}

/// Pipelines of a caster entry, one for each depth order that plans of the case may have.
#[derive(Debug, Clone)]
pub struct CasterPipelines(ByOrder<wgpu::RenderPipeline>);

impl CasterPipelines {
    /// The pipeline for a depth order.
    pub fn of(&self, order: DepthOrder) -> &wgpu::RenderPipeline {
        self.0.of(order)
    }
}

impl ShadowService {
    /// Records a capture that draws the frame's own casters, then calls `draw` for every facet of the plan: the engine
    /// draws its casters with its own pipelines, vertex buffers and bind groups.
    ///
    /// `draw` leaves viewport, scissor and the facet's bind group alone. Frames without casters of their own take one
    /// render pass, others two; timestamps span them.
    ///
    /// # Errors
    /// [`ServiceError::StaleFrame`], also where the frame was not prepared with `plan`; nothing is recorded then.
    pub fn capture_with(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedFrame,
        plan: &ShadowPlan,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
        mut draw: impl FnMut(&mut wgpu::RenderPass, EngineFacet),
    ) -> Result<(), ServiceError> {
        self.check_frame(frame)?;
        let prepared = frame.statistics.facets.iter().map(|facet| facet.facet);
        let planned = plan.facets.iter().map(Facet::first_cell);
        if !prepared.eq(planned) || frame.depth_order != plan.depth_order {
            return Err(ServiceError::StaleFrame { why: "another plan prepared it" });
        }

        // Let the service's own casters go first: their pass empties the map.
        let has_own = !frame.commands.commands.is_empty();
        let (first, last) = split(timestamps.as_ref(), has_own);
        if has_own {
            self.capture(encoder, frame, first)?;
        }
        let load = match has_own {
            true => wgpu::LoadOp::Load,
            false => wgpu::LoadOp::Clear(frame.depth_order.cleared() as f32),
        };
        let gpu = self.gpu();
        let group = required_group(self.table(), ShaderKind::Capture, GroupContent::CaptureFacet)?.group;
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("cssm capture of the engine's casters"),
            color_attachments: &[],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &gpu.atlas.view,
                depth_ops: Some(wgpu::Operations { load, store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            timestamp_writes: last,
            ..Default::default()
        });
        for (position, facet) in plan.facets.iter().enumerate() {
            let offset = position as u64 * gpu.layouts.uniforms.facet_stride;
            pass.set_bind_group(group, &frame.slot.capture_group, &[offset as u32]);
            confine(&mut pass, &facet.tile);
            draw(&mut pass, EngineFacet { position, facet, depth_order: plan.depth_order });
        }
        drop(pass);
        keep_until_done(encoder, frame);
        Ok(())
    }

    /// The pipelines of a caster entry.
    ///
    /// # Errors
    /// [`ServiceError::ForeignCasters`], shaders, layouts or buffers that the device refuses.
    pub fn caster_pipelines(
        &self,
        description: &CasterPipelineDescription,
    ) -> Result<CasterPipelines, ServiceError> {
        let (gpu, casters) = (self.gpu(), description.casters);
        let shader = self.caster_shader(casters)?;
        let facet = required_group(self.table(), ShaderKind::Capture, GroupContent::CaptureFacet)?.group;
        let label = format!("{} {}", self.table().prefix, casters.name);

        // Put the service's layout at its number among the engine's.
        let mut groups = description.bind_group_layouts.to_vec();
        groups.resize(groups.len().max(facet as usize + 1), None);
        groups[facet as usize] = Some(&gpu.layouts.capture);

        let pipelines = checked(&gpu.device, "the pipelines of a caster entry", || {
            let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(&label),
                source: wgpu::ShaderSource::Wgsl(shader.wgsl.as_ref().into()),
            });
            let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(&label),
                bind_group_layouts: &groups,
                immediate_size: 0,
            });
            ByOrder::new(self.table(), |order| {
                gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                    label: Some(&label),
                    layout: Some(&layout),
                    vertex: wgpu::VertexState {
                        module: &module,
                        entry_point: Some(&shader.vertex),
                        compilation_options: Default::default(),
                        buffers: description.buffers,
                    },
                    primitive: wgpu::PrimitiveState {
                        topology: description.topology,
                        strip_index_format: description.strip_index_format,
                        ..self.capture_primitive_state()
                    },
                    depth_stencil: Some(self.capture_depth_stencil_state(order)),
                    multisample: wgpu::MultisampleState::default(),
                    fragment: shader.fragment.as_ref().map(|entry| wgpu::FragmentState {
                        module: &module,
                        entry_point: Some(entry),
                        compilation_options: Default::default(),
                        targets: &[],
                    }),
                    multiview_mask: None,
                    cache: None,
                })
            })
        });
        Ok(CasterPipelines(gpu.alive(pipelines)?))
    }

    /// The module of a caster entry that this device runs: the one that leaves depth unclipped where it can. For engines
    /// that make pipelines by themselves, with the states and the layout below.
    ///
    /// # Errors
    /// [`ServiceError::ForeignCasters`] for shaders that were composed of another case.
    pub fn caster_shader<'c>(&self, casters: &'c CasterTable) -> Result<&'c CasterShader, ServiceError> {
        let foreign = |why| ServiceError::ForeignCasters {
            entry: casters.name.to_string(),
            case: self.table().case.to_string(),
            why,
        };
        if casters.fingerprint != self.table().fingerprint {
            return Err(foreign("they were composed of another declaration"));
        }
        let wanted = match self.capture_shader() {
            ShaderKind::Capture => [ShaderKind::Capture, ShaderKind::CaptureTested],
            _ => [ShaderKind::CaptureClamped, ShaderKind::CaptureTestedClamped],
        };
        let found = casters.shaders.iter().find(|shader| wanted.contains(&shader.kind));
        found.ok_or_else(|| foreign("they lack the module that this device runs"))
    }

    /// Layout of the facet's bind group, number 0, for the engine's own capture pipelines; its record has a dynamic
    /// offset.
    pub fn capture_bind_group_layout(&self) -> &wgpu::BindGroupLayout {
        &self.gpu().layouts.capture
    }

    /// How capture pipelines treat triangles: drawn from both sides, because which side faces the light says nothing
    /// about leaks, and with unclipped depth where the device has it.
    pub fn capture_primitive_state(&self) -> wgpu::PrimitiveState {
        wgpu::PrimitiveState {
            cull_mode: None,
            unclipped_depth: self.capture_shader() == ShaderKind::Capture,
            ..Default::default()
        }
    }

    /// How capture pipelines treat depth, for plans of one depth order.
    pub fn capture_depth_stencil_state(&self, order: DepthOrder) -> wgpu::DepthStencilState {
        wgpu::DepthStencilState {
            format: texture_format(self.table().map_format),
            depth_write_enabled: Some(true),
            depth_compare: Some(match order {
                DepthOrder::Standard => wgpu::CompareFunction::Less,
                DepthOrder::Reversed => wgpu::CompareFunction::Greater,
            }),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }
    }
}

/// Timestamps of the first pass and of the last, which may be one.
fn split<'q>(
    writes: Option<&wgpu::RenderPassTimestampWrites<'q>>,
    two_passes: bool,
) -> (Option<wgpu::RenderPassTimestampWrites<'q>>, Option<wgpu::RenderPassTimestampWrites<'q>>) {
    let Some(writes) = writes else { return (None, None) };
    let part = |begins: bool, ends: bool| {
        let writes = wgpu::RenderPassTimestampWrites {
            query_set: writes.query_set,
            beginning_of_pass_write_index: writes.beginning_of_pass_write_index.filter(|_| begins),
            end_of_pass_write_index: writes.end_of_pass_write_index.filter(|_| ends),
        };
        let writes_any =
            writes.beginning_of_pass_write_index.is_some() || writes.end_of_pass_write_index.is_some();
        writes_any.then_some(writes)
    };
    (part(true, false), part(!two_passes, true))
}
