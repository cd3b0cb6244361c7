//! Prepared frames and the buffers behind them.
//!
//! Every prepared frame has a slot of its own: one uniform buffer for all its records and one vertex buffer for its
//! instance rows. A slot returns to the pool when nobody needs it any more: the frame is dropped **and** every
//! encoder that replayed it has been submitted and executed (or dropped). So two views prepared for one submission
//! never write into each other's buffers, whatever order the engine calls in.

use std::sync::Arc;

use cssm_core::plan::DepthOrder;
use cssm_core::table::{BindingKind, CaseTable, GroupContent, RecordKind, ShaderKind};

use crate::atlas::Atlas;
use crate::commands::{FrameCommands, FrameStatistics};
use crate::cull::InstanceRows;
use crate::culling::{CulledFrame, Culling};
use crate::depth_order::ByOrder;
use crate::error::ServiceError;
use crate::layout::{bind_group, record_bytes, required_group, shadow_group};
use crate::prefilter::{Prefilter, PrefilterGroups};
use crate::scope::checked;

/// One view of one frame, uploaded and ready to be captured and resolved.
///
/// Keep it until the commands that use it are submitted.
#[derive(Debug)]
pub struct PreparedFrame {
    pub(crate) service: Arc<()>,
    pub(crate) slot: Arc<Slot>,
    pub(crate) depth_order: DepthOrder,
    pub(crate) commands: FrameCommands,
    pub(crate) statistics: FrameStatistics,
    /// What the device culls for the frame.
    pub(crate) culled: Option<Arc<CulledFrame>>,
}

impl PreparedFrame {
    /// Where the frame's casters are culled. On the device, statistics count candidates;
    /// [`ShadowService::read_commands`](crate::ShadowService::read_commands) tells what it has drawn.
    pub fn culling(&self) -> Culling {
        if self.culled.is_some() { Culling::Gpu } else { Culling::Cpu }
    }

    /// Draws and triangles, in total and per facet.
    pub fn statistics(&self) -> &FrameStatistics {
        &self.statistics
    }

    /// The capture pass as a list.
    pub fn commands(&self) -> &FrameCommands {
        &self.commands
    }

    /// The plan, the map and the sampler for its depth order, for the engine's own pipelines; they take it at the group number that the
    /// case declares, with [`ShadowService::shadow_bind_group_layout`](crate::ShadowService::shadow_bind_group_layout).
    /// `None` where the case declares no resolve interface.
    pub fn shadow_bind_group(&self) -> Option<&wgpu::BindGroup> {
        self.slot.shadow_groups.as_ref().map(|groups| groups.of(self.depth_order))
    }
}

/// Where the records of a frame lie in its uniform buffer.
#[derive(Debug, Clone, Copy)]
pub(crate) struct UniformLayout {
    /// Distance between capture records.
    pub(crate) facet_stride: u64,
    pub(crate) shadow_offset: u64,
    pub(crate) mask_offset: u64,
    pub(crate) size: u64,
}

impl UniformLayout {
    pub(crate) fn new(table: &CaseTable, alignment: u32) -> Self {
        let align = |bytes: u64| bytes.next_multiple_of(u64::from(alignment.max(16)));
        let bytes = |kind| u64::from(record_bytes(table, kind));
        let facet_stride = align(bytes(RecordKind::Capture));
        let shadow_offset = facet_stride * u64::from(table.cells());
        let mask_offset = shadow_offset + align(bytes(RecordKind::Shadow));
        let size = mask_offset + align(bytes(RecordKind::Mask)).max(16);
        Self { facet_stride, shadow_offset, mask_offset, size }
    }
}

/// Layouts that slots bind by.
#[derive(Debug)]
pub(crate) struct SlotLayouts {
    pub(crate) capture: wgpu::BindGroupLayout,
    pub(crate) shadow: Option<wgpu::BindGroupLayout>,
    pub(crate) prefilter: Option<Prefilter>,
    pub(crate) uniforms: UniformLayout,
}

/// Buffers and bind groups of one frame.
#[derive(Debug)]
pub(crate) struct Slot {
    pub(crate) uniforms: wgpu::Buffer,
    pub(crate) instances: wgpu::Buffer,
    pub(crate) capture_group: wgpu::BindGroup,
    pub(crate) shadow_groups: Option<ByOrder<wgpu::BindGroup>>,
    pub(crate) prefilter_groups: Option<PrefilterGroups>,
}

/// Slots that come back.
#[derive(Debug, Default)]
pub(crate) struct SlotPool {
    slots: Vec<Arc<Slot>>,
}

/// Smallest instance buffer: 64 rows.
const MIN_INSTANCE_BYTES: u64 = 64 * InstanceRows::BYTES;

impl SlotPool {
    /// A slot that nothing uses, with room for a number of instance rows.
    pub(crate) fn acquire(
        &mut self,
        device: &wgpu::Device,
        table: &CaseTable,
        layouts: &SlotLayouts,
        atlas: &Atlas,
        rows: usize,
    ) -> Result<Arc<Slot>, ServiceError> {
        // Size instance buffers in powers of two, so that growing scenes settle.
        let limit = device.limits().max_buffer_size;
        let needed = (rows as u64).checked_mul(InstanceRows::BYTES).filter(|bytes| *bytes <= limit);
        let needed = needed.ok_or(ServiceError::TooManyInstances { rows })?;
        let size = needed.max(MIN_INSTANCE_BYTES).next_power_of_two().min(limit).max(needed);

        // Take a free slot, large ones first; the pool holds the only reference to a free one.
        self.slots.sort_unstable_by_key(|slot| std::cmp::Reverse(slot.instances.size()));
        for slot in &mut self.slots {
            let Some(free) = Arc::get_mut(slot) else { continue };
            if free.instances.size() < needed {
                free.instances = checked(device, "an instance buffer", || instance_buffer(device, size))?;
            }
            return Ok(Arc::clone(slot));
        }

        // Or add one.
        let slot = Arc::new(Slot::new(device, table, layouts, atlas, size)?);
        self.slots.push(Arc::clone(&slot));
        Ok(slot)
    }

    /// Number of slots, free or in use.
    pub(crate) fn len(&self) -> usize {
        self.slots.len()
    }
}

impl Slot {
    fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        layouts: &SlotLayouts,
        atlas: &Atlas,
        instance_bytes: u64,
    ) -> Result<Self, ServiceError> {
        let capture = required_group(table, ShaderKind::Capture, GroupContent::CaptureFacet)?;
        let uniforms = checked(device, "a frame's uniform buffer", || {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("cssm frame uniforms"),
                size: layouts.uniforms.size,
                usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        })?;
        let instances = checked(device, "an instance buffer", || instance_buffer(device, instance_bytes))?;
        let capture_group = checked(device, "a capture bind group", || {
            bind_group(device, &layouts.capture, capture, |kind| match kind {
                BindingKind::Uniform { record, .. } => Some(uniform(&uniforms, table, record, 0)),
                _ => None,
            })
        })?;
        let shadow_groups = match (shadow_group(table), &layouts.shadow) {
            (Some(group), Some(layout)) => {
                let bind = |order| {
                    bind_group(device, layout, group, |kind| match kind {
                        BindingKind::Uniform { record, .. } => {
                            Some(uniform(&uniforms, table, record, layouts.uniforms.shadow_offset))
                        }
                        _ => atlas.resource(kind, order),
                    })
                };
                Some(checked(device, "a shadow bind group", || ByOrder::new(table, bind))?)
            }
            _ => None,
        };
        let bind = |prefilter: &Prefilter| {
            prefilter.bind(device, table, atlas, (&uniforms, layouts.uniforms.shadow_offset))
        };
        let prefilter_groups = layouts.prefilter.as_ref().map(bind).transpose()?;
        Ok(Self { uniforms, instances, capture_group, shadow_groups, prefilter_groups })
    }
}

/// A record of a frame's uniform buffer as a binding.
pub(crate) fn uniform<'a>(
    buffer: &'a wgpu::Buffer,
    table: &CaseTable,
    record: RecordKind,
    offset: u64,
) -> wgpu::BindingResource<'a> {
    let size = wgpu::BufferSize::new(u64::from(record_bytes(table, record)));
    wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer, offset, size })
}

fn instance_buffer(device: &wgpu::Device, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("cssm instance rows"),
        size,
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}
