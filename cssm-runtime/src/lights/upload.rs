//! Records and instance rows of all lights on their way to the device.

use std::sync::Arc;

use cssm_core::{ShadowPlan, View};

use super::description::LightFrame;
use super::prepared::{PreparedLights, PreparedShadow};
use super::scissor::scissor;
use super::{LightService, ServedCase};
use crate::commands::FrameCommands;
use crate::error::ServiceError;
use crate::frame::PreparedFrame;
use crate::gpu::Gpu;
use crate::scope::checked;
use crate::upload::{Plans, check_plan, upload};

impl LightService {
    /// Uploads what was listed, with records relative to the frame's eye.
    pub(super) fn upload(
        &mut self,
        frame: &LightFrame,
        next: &mut PreparedLights,
    ) -> Result<(), ServiceError> {
        let Self { lights, cases, device, queue, culling, scratch, .. } = self;
        for part in &mut next.shadows[..next.used] {
            let served = lights.get_mut(part.light.index as usize).and_then(|entry| entry.light.as_mut());
            let Some(served) = served else { continue };
            let mut shadows = served.shadows.iter_mut().filter(|shadow| shadow.view == frame.view_id);
            let held = shadows.find_map(|shadow| shadow.held.as_mut());
            let (Some(held), Some(case)) = (held, cases.get_mut(part.case)) else { continue };
            let (capture, resolve) = held.seen_from(frame.view);
            part.scissor = scissor(resolve, frame.view);
            part.frame = Some(uploaded(case, capture, resolve, frame.view, part)?);
        }
        if let Some(culling) = culling {
            next.culled = culling.upload(device, queue, &scratch.work)?;
        }
        Ok(())
    }
}

/// Uploads a light's records and instance rows.
fn uploaded(
    case: &mut ServedCase,
    capture: &ShadowPlan,
    resolve: &ShadowPlan,
    view: &View,
    part: &PreparedShadow,
) -> Result<PreparedFrame, ServiceError> {
    let (table, gpu, records) = case.service.parts_mut();
    check_plan(table, resolve, view)?;
    let rows = [part.still.rows.as_slice(), part.fixed.rows.as_slice(), part.dynamic.rows.as_slice()];
    let count = rows.iter().map(|rows| rows.len()).sum();
    let Gpu { device, queue, atlas, layouts, slots, identity, .. } = gpu;
    let slot = slots.acquire(device, table, layouts, atlas, count).and_then(|slot| {
        let plans = Plans { capture, resolve, view };
        let write = || upload(queue, table, &layouts.uniforms, &slot, plans, &rows, records);
        checked(device, "a light's upload", write)?;
        Ok(slot)
    });
    let service = Arc::clone(identity);
    let slot = gpu.alive(slot)?;
    Ok(PreparedFrame {
        service,
        slot,
        depth_order: capture.depth_order,
        commands: FrameCommands::default(),
        statistics: Default::default(),
        culled: None,
    })
}
