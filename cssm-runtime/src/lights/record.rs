//! The passes of a prepared frame.

use std::sync::Arc;

use super::LightService;
use super::description::LightHandle;
use super::engine::LightFacet;
use super::prepared::{LightCommands, PreparedLights, PreparedShadow};
use super::shadow::Fill;
use crate::capture::Records;
use crate::commands::FrameCommands;
use crate::culling::{CulledFrame, CulledWords};
use crate::error::ServiceError;
use crate::frame::{PreparedFrame, Slot};
use crate::mesh::Mesh;
use crate::resolve::MaskInputs;

impl LightService {
    /// Records the capture of all tiles that change: one render pass into the shared map, and one before it where static
    /// casters are drawn apart. Nothing is recorded where nothing changes.
    ///
    /// Prepare, capture and submit each frame in this order; what was prepared and not captured is prepared again.
    ///
    /// # Errors
    /// [`ServiceError::StaleFrame`] for a frame that is not the view's last, or draws meshes that were removed;
    /// [`ServiceError::EngineCasters`] for one with casters that only [`LightService::capture_with`] can draw.
    pub fn capture(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedLights,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
    ) -> Result<(), ServiceError> {
        if frame.in_use().iter().any(|shadow| !shadow.engine.is_empty()) {
            return Err(ServiceError::EngineCasters);
        }
        self.record(encoder, frame, timestamps, &mut |_, _| {})
    }

    /// Records the capture; `engine` draws casters of the engine's own.
    pub(super) fn record(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedLights,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
        engine: &mut dyn FnMut(&mut wgpu::RenderPass, LightFacet),
    ) -> Result<(), ServiceError> {
        self.check_frame(frame)?;
        self.check_meshes(frame)?;
        let (shadows, culled) = (frame.in_use(), frame.culled.as_deref());
        if let (Some(culling), Some(culled)) = (&self.culling, culled) {
            culling.record(encoder, culled);
        }

        // Draw static casters that are to be kept.
        let still = shadows.iter().any(|shadow| shadow.works.iter().any(|(.., work)| work.draw_still));
        if let Some(view) = self.layers.still_view().filter(|_| still) {
            let mut pass = depth_pass(encoder, "cssm capture of static casters", view, None);
            for (shadow, frame) in prepared(shadows) {
                for (_, tile, _) in shadow.works.iter().filter(|(.., work)| work.draw_still) {
                    self.layers.empty(&mut pass, tile, frame.depth_order);
                }
            }
            for (shadow, frame) in prepared(shadows) {
                self.draw(&mut pass, (shadow, frame), culled, &shadow.still, 0);
                self.draw_engine(&mut pass, (shadow, frame), true, engine);
            }
        }

        // Empty or restore the tiles of the shared map, then draw.
        if shadows.iter().any(|shadow| !shadow.works.is_empty()) {
            let mut pass = depth_pass(encoder, "cssm capture", &self.layers.main_view, timestamps);
            for (shadow, frame) in prepared(shadows) {
                for (_, tile, work) in &shadow.works {
                    match work.fill {
                        Fill::Draw => self.layers.empty(&mut pass, tile, frame.depth_order),
                        Fill::Restore => self.layers.restore(&mut pass, tile),
                    }
                }
            }
            for (shadow, frame) in prepared(shadows) {
                let first = shadow.still.rows.len();
                self.draw(&mut pass, (shadow, frame), culled, &shadow.fixed, first);
                let first = first + shadow.fixed.rows.len();
                self.draw(&mut pass, (shadow, frame), culled, &shadow.dynamic, first);
                self.draw_engine(&mut pass, (shadow, frame), false, engine);
            }
        }

        // Filter what changed.
        for (shadow, frame) in prepared(shadows).filter(|(shadow, _)| !shadow.works.is_empty()) {
            let served = self.cases.get(shadow.case);
            served.into_iter().for_each(|served| served.service.gpu().prefilter(encoder, &frame.slot));
        }
        keep_until_done(encoder, frame);
        self.remember(frame);
        Ok(())
    }

    /// Records the mask pass of one light: visibility of every pixel of the view into `target`, 1 where lit and where the
    /// light does not reach.
    ///
    /// # Errors
    /// [`ServiceError::NotDeclared`], [`ServiceError::StaleFrame`], [`ServiceError::UnknownLight`] for a light that the
    /// frame does not hold, textures of another kind than declared. Nothing is recorded then.
    pub fn mask(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedLights,
        light: LightHandle,
        inputs: &MaskInputs,
        target: &wgpu::TextureView,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
    ) -> Result<(), ServiceError> {
        self.check_frame(frame)?;
        let shadow = frame.shadow(light);
        let Some((shadow, prepared)) = shadow.and_then(|shadow| Some((shadow, shadow.frame.as_ref()?)))
        else {
            // A light without shadows is lit everywhere.
            self.light(light).ok_or(ServiceError::UnknownLight)?;
            lit(encoder, target);
            return Ok(());
        };
        let served = self.cases.get(shadow.case).ok_or(ServiceError::UnknownLight)?;
        let (table, gpu) = (served.service.table(), served.service.gpu());
        let not_declared = || ServiceError::NotDeclared { case: table.case.to_string(), what: "a mask" };
        let mask = gpu.mask.as_ref().ok_or_else(not_declared)?;
        let bound = mask.bind(&gpu.device, table, &gpu.layouts, &prepared.slot, inputs);
        let inputs = gpu.alive(bound)?;
        mask.replay(encoder, table, prepared, &inputs, target, shadow.scissor, timestamps)?;
        keep_until_done(encoder, frame);
        Ok(())
    }

    /// What the tiles of every light draw in a frame, as plain lists; of what is culled on the device, what culling has
    /// left when the frame was captured last. Lights without shadows are left out. Blocks; see
    /// [`buffer_bytes`](crate::read_back::buffer_bytes).
    ///
    /// # Errors
    /// [`ServiceError::StaleFrame`], a lost device.
    pub fn read_commands(&self, frame: &PreparedLights) -> Result<Vec<LightCommands>, ServiceError> {
        self.check_frame(frame)?;
        let words = match &frame.culled {
            None => None,
            Some(culled) => Some(CulledWords::read(&self.device, &self.queue, culled)?),
        };
        let of_light = |shadow: &PreparedShadow| {
            let served = self.cases.get(shadow.case)?;
            let mesh = |mesh| self.meshes.mesh(&served.service, shadow.case, mesh);
            let first_index = |handle| mesh(handle).map_or(0, Mesh::first_index);
            let read = |commands: &FrameCommands| match &words {
                None => commands.clone(),
                Some(words) => words.drawn(commands, first_index),
            };
            let [still, fixed, dynamic] = [&shadow.still, &shadow.fixed, &shadow.dynamic].map(read);
            Some(LightCommands { light: shadow.light, still, fixed, dynamic })
        };
        Ok(frame.in_use().iter().filter_map(of_light).collect())
    }

    fn draw(
        &self,
        pass: &mut wgpu::RenderPass,
        (shadow, frame): (&PreparedShadow, &PreparedFrame),
        culled: Option<&CulledFrame>,
        commands: &FrameCommands,
        first_row: usize,
    ) {
        let Some(served) = self.cases.get(shadow.case) else { return };
        let gpu = served.service.gpu();
        let facet_stride = gpu.layouts.uniforms.facet_stride;
        let records = Records { slot: &frame.slot, facet_stride, order: frame.depth_order, culled };
        let mesh = |mesh| self.meshes.mesh(&served.service, shadow.case, mesh);
        gpu.capture.record(pass, commands, records, first_row, mesh);
    }

    fn check_frame(&self, frame: &PreparedLights) -> Result<(), ServiceError> {
        let stale = |why| Err(ServiceError::StaleFrame { why });
        if !frame.identity.as_ref().is_some_and(|identity| Arc::ptr_eq(identity, &self.identity)) {
            return stale("another service or an earlier device prepared it");
        }
        let is_of_case = |shadow: &PreparedShadow| {
            let served = self.cases.get(shadow.case);
            let prepared = shadow.frame.as_ref();
            let identity = |frame: &PreparedFrame| {
                served.is_some_and(|served| Arc::ptr_eq(&frame.service, &served.service.gpu().identity))
            };
            prepared.is_none_or(identity)
        };
        if !frame.in_use().iter().all(is_of_case) {
            return stale("a case was replaced since");
        }
        Ok(())
    }

    /// Refuses frames whose tiles were meant for another state of the map.
    fn check_meshes(&self, frame: &PreparedLights) -> Result<(), ServiceError> {
        let stale = |why| Err(ServiceError::StaleFrame { why });
        if frame.number != self.last_number(frame) {
            return stale("the view was prepared again since");
        }
        let knows = |shadow: &PreparedShadow| {
            let Some(served) = self.cases.get(shadow.case) else { return false };
            let lists = [&shadow.still, &shadow.fixed, &shadow.dynamic];
            let mut meshes = lists.into_iter().flat_map(|list| list.meshes());
            meshes.all(|mesh| self.meshes.mesh(&served.service, shadow.case, mesh).is_some())
        };
        if frame.in_use().iter().all(knows) { Ok(()) } else { stale("it draws a mesh that was removed") }
    }

    fn last_number(&self, frame: &PreparedLights) -> u64 {
        self.views.iter().find(|view| view.id == frame.view).map_or(0, |view| view.prepared)
    }

    /// Remembers what the tiles of a captured frame show.
    fn remember(&mut self, frame: &PreparedLights) {
        for part in frame.in_use() {
            let Some(entry) = self.lights.get_mut(part.light.index as usize) else { continue };
            let Some(served) = entry.light.as_mut().filter(|_| entry.generation == part.light.generation)
            else {
                continue;
            };
            let mut shadows = served.shadows.iter_mut().filter(|shadow| shadow.view == frame.view);
            let held = shadows.find_map(|shadow| shadow.held.as_mut());
            let Some(held) = held.filter(|held| held.serial == part.serial) else { continue };
            for (position, _, work) in &part.works {
                if let Some(state) = held.tiles.get_mut(*position) {
                    state.drawn(*work);
                }
            }
        }
    }
}

/// The shadows that have records.
fn prepared(shadows: &[PreparedShadow]) -> impl Iterator<Item = (&PreparedShadow, &PreparedFrame)> {
    shadows.iter().filter_map(|shadow| Some((shadow, shadow.frame.as_ref()?)))
}

/// A pass that keeps what a depth texture holds.
fn depth_pass<'e>(
    encoder: &'e mut wgpu::CommandEncoder,
    label: &str,
    view: &wgpu::TextureView,
    timestamps: Option<wgpu::RenderPassTimestampWrites>,
) -> wgpu::RenderPass<'e> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some(label),
        color_attachments: &[],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store }),
            stencil_ops: None,
        }),
        timestamp_writes: timestamps,
        ..Default::default()
    })
}

/// Clears a mask to lit.
fn lit(encoder: &mut wgpu::CommandEncoder, target: &wgpu::TextureView) {
    let _pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("cssm lit mask"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: target,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::WHITE),
                store: wgpu::StoreOp::Store,
            },
        })],
        ..Default::default()
    });
}

/// Holds a frame's slots until the encoder's work is done, or the encoder is dropped.
fn keep_until_done(encoder: &wgpu::CommandEncoder, frame: &PreparedLights) {
    let slots: Vec<Arc<Slot>> = prepared(frame.in_use()).map(|(_, frame)| Arc::clone(&frame.slot)).collect();
    let held = (slots, frame.culled.clone());
    encoder.on_submitted_work_done(move || drop(held));
}
