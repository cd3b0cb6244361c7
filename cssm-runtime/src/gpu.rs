//! Everything of the service that dies with the device.

use std::sync::Arc;

use cssm_core::table::{CaseTable, GroupContent, ShaderKind};

use crate::atlas::Atlas;
use crate::capture::{CapturePipelines, fetches_by_itself};
use crate::culling::{Culling, GpuCulling};
use crate::error::ServiceError;
use crate::frame::{Slot, SlotLayouts, SlotPool, UniformLayout};
use crate::health::HealthProbe;
use crate::layout::{group_layout, required_group, shadow_group};
use crate::prefilter::Prefilter;
use crate::requirements::{check_limits, check_records};
use crate::resolve::MaskPipeline;
use crate::scope::checked;
use crate::service::Options;

/// A table's objects on one device.
#[derive(Debug)]
pub(crate) struct Gpu {
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
    pub(crate) atlas: Atlas,
    pub(crate) layouts: SlotLayouts,
    pub(crate) capture: CapturePipelines,
    pub(crate) mask: Option<MaskPipeline>,
    pub(crate) slots: SlotPool,
    /// Where the options ask for it and the device can.
    pub(crate) culling: Option<GpuCulling>,
    pub(crate) probe: HealthProbe,
    /// Tells frames of this device and service from all others.
    pub(crate) identity: Arc<()>,
}

impl Gpu {
    /// Creates the pipelines of a table, and the map unless it shares one.
    pub(crate) fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        table: &CaseTable,
        options: &Options,
        shared_map: Option<&wgpu::Texture>,
    ) -> Result<Self, ServiceError> {
        let limits = device.limits();
        check_records(table)?;
        check_limits(&limits, table)?;
        let probe = checked(device, "a health probe", || HealthProbe::new(device))?;
        if probe.device_lost(device) {
            return Err(ServiceError::DeviceLost);
        }

        // Create layouts first: slots and pipelines share them.
        let capture_group = required_group(table, ShaderKind::Capture, GroupContent::CaptureFacet)?;
        let (capture, shadow) = checked(device, "bind group layouts", || {
            let stages = options.material_stages | wgpu::ShaderStages::FRAGMENT;
            let shadow = shadow_group(table).map(|group| group_layout(device, table, group, stages));
            let mut capture_stages = wgpu::ShaderStages::VERTEX;
            capture_stages.set(wgpu::ShaderStages::FRAGMENT, fetches_by_itself(table));
            (group_layout(device, table, capture_group, capture_stages), shadow)
        })?;
        let uniforms = UniformLayout::new(table, limits.min_uniform_buffer_offset_alignment);
        let prefilter = Prefilter::new(device, table)?;
        let layouts = SlotLayouts { capture, shadow, prefilter, uniforms };

        let atlas = checked(device, "the map", || Atlas::new(device, table, shared_map))?;
        let capture = CapturePipelines::new(device, table, options.clamp_in_fragments, &layouts.capture)?;
        let mask = MaskPipeline::new(device, table, &layouts, options.mask_format)?;
        let gpu = Self {
            device: device.clone(),
            queue: queue.clone(),
            atlas,
            layouts,
            capture,
            mask,
            slots: SlotPool::default(),
            culling: match options.culling {
                Culling::Cpu => None,
                Culling::Gpu => GpuCulling::new(device)?,
            },
            probe,
            identity: Arc::new(()),
        };
        if gpu.probe.device_lost(device) { Err(ServiceError::DeviceLost) } else { Ok(gpu) }
    }

    /// Records the prefilter over the tiles of a frame that was just captured, where the case has one.
    pub(crate) fn prefilter(&self, encoder: &mut wgpu::CommandEncoder, slot: &Slot) {
        let parts = (&self.layouts.prefilter, &self.atlas.prefiltered, &slot.prefilter_groups);
        if let (Some(prefilter), Some(images), Some(groups)) = parts {
            prefilter.replay(encoder, images, groups);
        }
    }

    /// A lost device accepts some calls, refuses others for odd reasons and does nothing: ask it before believing.
    pub(crate) fn alive<T>(&self, outcome: Result<T, ServiceError>) -> Result<T, ServiceError> {
        if self.probe.device_lost(&self.device) { Err(ServiceError::DeviceLost) } else { outcome }
    }
}
