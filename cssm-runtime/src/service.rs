//! The shadow service: from a table to pipelines, from plans to maps, from maps to visibility.

use std::sync::Arc;

use cssm_core::table::{CaseTable, ShaderKind};
use cssm_core::{ShadowPlan, View};

use crate::alpha_mask::BoundMask;
use crate::capture::{Attribute, Fetched, Stretched, StretchedMesh, VertexKey};
use crate::casters::CasterScene;
use crate::commands::{CommandScratch, FrameCommands, FrameStatistics};
use crate::culling::{CulledFrame, CulledWords, Culling, CullingWork};
use crate::error::ServiceError;
use crate::frame::PreparedFrame;
use crate::gpu::Gpu;
use crate::mesh::{CasterInstance, CheckedMesh, Mesh, MeshDescription, MeshError, MeshHandle};
use crate::read_back;
use crate::resolve::MaskInputs;
use crate::scope::checked;
use crate::upload::{Plans, check_plan, upload};

/// Choices of the engine that no declaration makes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Options {
    /// Format of the mask pass's target; a colour format that can be rendered to.
    pub mask_format: wgpu::TextureFormat,
    /// Stages of the engine's own pipelines that call the visibility function.
    pub material_stages: wgpu::ShaderStages,
    /// Clamps depth and cuts casters in a fragment shader even where the device can leave depth unclipped and has clip
    /// distances. Both ways draw equal maps; this one exists for devices without
    /// [`wgpu::Features::DEPTH_CLIP_CONTROL`] or [`wgpu::Features::CLIP_DISTANCES`] and can be forced for comparisons.
    pub clamp_in_fragments: bool,
    /// Where casters are culled.
    pub culling: Culling,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            mask_format: wgpu::TextureFormat::R8Unorm,
            material_stages: wgpu::ShaderStages::FRAGMENT,
            clamp_in_fragments: false,
            culling: Culling::Cpu,
        }
    }
}

/// Executes the tables of one light case on one device.
#[derive(Debug)]
pub struct ShadowService {
    table: CaseTable,
    options: Options,
    gpu: Gpu,
    meshes: Vec<MeshEntry>,
    /// What the device is to cull.
    leaving: Leaving,
    /// Memory for records.
    records: Vec<u8>,
}

/// Lists for culling on the device that keep their memory.
#[derive(Debug, Default)]
struct Leaving {
    casters: CasterScene,
    scratch: CommandScratch,
    work: CullingWork,
}

/// Commands, and what the device culls of them.
type Left = (FrameCommands, FrameStatistics, Option<Arc<CulledFrame>>);

#[derive(Debug, Default)]
struct MeshEntry {
    generation: u32,
    mesh: Option<Mesh>,
}

impl ShadowService {
    /// Creates the map and the pipelines of a table that code generation has filled.
    ///
    /// # Errors
    /// Limits the device does not meet, shaders it refuses, a lost device.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        table: &CaseTable,
        options: &Options,
    ) -> Result<Self, ServiceError> {
        let gpu = Gpu::new(device, queue, table, options, None)?;
        Ok(Self {
            table: table.clone(),
            options: *options,
            gpu,
            meshes: Vec::new(),
            leaving: Leaving::default(),
            records: Vec::new(),
        })
    }

    /// The same, with the map in a texture that other tables share.
    pub(crate) fn sharing(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        table: &CaseTable,
        options: &Options,
        map: &wgpu::Texture,
    ) -> Result<Self, ServiceError> {
        let gpu = Gpu::new(device, queue, table, options, Some(map))?;
        let leaving = Leaving::default();
        Ok(Self {
            table: table.clone(),
            options: *options,
            gpu,
            meshes: Vec::new(),
            leaving,
            records: Vec::new(),
        })
    }

    /// The table, what executes it, and memory for records.
    pub(crate) fn parts_mut(&mut self) -> (&CaseTable, &mut Gpu, &mut Vec<u8>) {
        (&self.table, &mut self.gpu, &mut self.records)
    }

    /// What executes the table.
    pub(crate) fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// The table that the service executes.
    pub fn table(&self) -> &CaseTable {
        &self.table
    }

    /// Which capture shader runs: [`ShaderKind::Capture`] or, clamping per fragment, [`ShaderKind::CaptureClamped`].
    /// Casters with an alpha mask run its tested counterpart.
    pub fn capture_shader(&self) -> ShaderKind {
        self.gpu.capture.shader()
    }

    /// Registers a caster mesh. Its buffers and the texture of its mask stay the engine's; they are kept alive until
    /// the mesh is removed.
    ///
    /// # Errors
    /// A [`MeshError`], or a device that refuses the vertex format.
    pub fn add_mesh(&mut self, description: &MeshDescription) -> Result<MeshHandle, ServiceError> {
        // Check first, create the pipeline for a new vertex format and the mask's bind group after.
        let checked = CheckedMesh::new(description, &self.gpu.device)?;
        let mask = self.bind_mask(description, &checked)?;
        let key = VertexKey {
            positions: Attribute {
                format: description.position_format,
                stride_bytes: description.stride_bytes,
            },
            uvs: description
                .mask
                .as_ref()
                .map(|mask| Attribute { format: mask.format, stride_bytes: mask.stride_bytes }),
        };
        let mesh = match self.gpu.capture.stretched() {
            Some(stretched) => {
                let fetched = self.gpu.alive(self.fetched(stretched, description, &checked))?;
                Mesh::new(description, checked, mask, fetched.pipeline).fetched(fetched)
            }
            None => {
                let pipeline = self.gpu.capture.handle(&self.gpu.device, &self.table, key);
                Mesh::new(description, checked, mask, self.gpu.alive(pipeline)?)
            }
        };

        // Reuse a free entry.
        let free = self.meshes.iter().position(|entry| entry.mesh.is_none());
        let index = free.unwrap_or_else(|| {
            self.meshes.push(MeshEntry::default());
            self.meshes.len() - 1
        });
        let entry = &mut self.meshes[index];
        entry.mesh = Some(mesh);
        Ok(MeshHandle { index: index as u32, generation: entry.generation })
    }

    /// Forgets a mesh; returns whether it was known. Frames that draw it become stale.
    pub fn remove_mesh(&mut self, mesh: MeshHandle) -> bool {
        let known = self.mesh(mesh).is_some();
        if known && let Some(entry) = self.meshes.get_mut(mesh.index as usize) {
            *entry = MeshEntry { generation: entry.generation.wrapping_add(1), mesh: None };
        }
        known
    }

    /// Culls casters for every facet of a plan and uploads one view of one frame.
    ///
    /// Any number of frames may be prepared before anything is submitted: each has buffers of its own. No casters at
    /// all is a frame too, with everything lit. A failure leaves earlier frames untouched.
    ///
    /// # Errors
    /// Plans of another case, views of another eye or rotation, transforms that are not finite, unknown meshes, a lost device.
    pub fn prepare(
        &mut self,
        plan: &ShadowPlan,
        view: &View,
        instances: &[CasterInstance],
    ) -> Result<PreparedFrame, ServiceError> {
        check_plan(&self.table, plan, view)?;
        let (commands, statistics, culled) = match self.leave(plan, instances)? {
            Some(left) => left,
            None => {
                let (commands, statistics) = self.commands(plan, instances)?;
                (commands, statistics, None)
            }
        };
        let (table, records) = (&self.table, &mut self.records);
        let Gpu { device, queue, atlas, layouts, slots, identity, .. } = &mut self.gpu;
        let rows = commands.rows.len();
        let slot = slots.acquire(device, table, layouts, atlas, rows).and_then(|slot| {
            let plans = Plans { capture: plan, resolve: plan, view };
            let rows = [commands.rows.as_slice()];
            let write = || upload(queue, table, &layouts.uniforms, &slot, plans, &rows, records);
            checked(device, "a frame's upload", write)?;
            Ok(slot)
        });
        let service = Arc::clone(identity);
        let slot = self.gpu.alive(slot)?;
        Ok(PreparedFrame { service, slot, depth_order: plan.depth_order, commands, statistics, culled })
    }

    /// Where casters are culled: [`Culling::Gpu`] only if the options ask for it and the device can.
    pub fn culling(&self) -> Culling {
        if self.gpu.culling.is_some() { Culling::Gpu } else { Culling::Cpu }
    }

    /// What a frame draws, as a plain list; of a frame that is culled on the device, what culling has left when it was
    /// captured last. Blocks; see [`read_back::buffer_bytes`].
    ///
    /// # Errors
    /// A lost device.
    pub fn read_commands(&self, frame: &PreparedFrame) -> Result<FrameCommands, ServiceError> {
        self.check_frame(frame)?;
        match &frame.culled {
            None => Ok(frame.commands.clone()),
            Some(culled) => {
                let Gpu { device, queue, .. } = &self.gpu;
                let first_index = |mesh| self.mesh(mesh).map_or(0, Mesh::first_index);
                let words = self.gpu.alive(CulledWords::read(device, queue, culled))?;
                Ok(words.drawn(&frame.commands, first_index))
            }
        }
    }

    /// What [`ShadowService::prepare`] would draw, without uploading anything: culling alone, on the CPU.
    ///
    /// # Errors
    /// Transforms that are not finite, unknown meshes.
    pub fn commands(
        &self,
        plan: &ShadowPlan,
        instances: &[CasterInstance],
    ) -> Result<(FrameCommands, FrameStatistics), ServiceError> {
        FrameCommands::build(plan, instances, |mesh| self.mesh(mesh).map(Mesh::facts))
    }

    /// Records the capture: one render pass into the map, replacing what it held.
    ///
    /// The map is shared by all frames of the service: record each view's capture and what reads it before the next
    /// view's capture.
    ///
    /// # Errors
    /// [`ServiceError::StaleFrame`]; nothing is recorded then.
    pub fn capture(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedFrame,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
    ) -> Result<(), ServiceError> {
        self.check_frame(frame)?;
        if frame.commands.meshes().any(|mesh| self.mesh(mesh).is_none()) {
            return Err(ServiceError::StaleFrame { why: "it draws a mesh that was removed" });
        }
        let Gpu { capture, atlas, layouts, culling, .. } = &self.gpu;
        if let (Some(culling), Some(culled)) = (culling, &frame.culled) {
            culling.record(encoder, culled);
        }
        let stride = layouts.uniforms.facet_stride;
        let mesh = |mesh| self.mesh(mesh);
        capture.replay(encoder, &atlas.view, frame, stride, mesh, timestamps);
        self.gpu.prefilter(encoder, &frame.slot);
        keep_until_done(encoder, frame);
        Ok(())
    }

    /// Records the mask pass: visibility of every pixel of the view into `target`, 1 where lit.
    ///
    /// `target` and the inputs have the view's size. With reversed-z or linear depth the receiver's position is good
    /// to about 1e-6 of its depth; depth from near to far in [0, 1] would not be.
    ///
    /// # Errors
    /// [`ServiceError::NotDeclared`], [`ServiceError::StaleFrame`], [`ServiceError::MissingNormal`], textures of
    /// another kind than declared. Nothing is recorded then.
    pub fn mask(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedFrame,
        inputs: &MaskInputs,
        target: &wgpu::TextureView,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
    ) -> Result<(), ServiceError> {
        self.check_frame(frame)?;
        let Gpu { device, mask, layouts, .. } = &self.gpu;
        let not_declared = || ServiceError::NotDeclared { case: self.table.case.to_string(), what: "a mask" };
        let mask = mask.as_ref().ok_or_else(not_declared)?;
        let inputs = self.gpu.alive(mask.bind(device, &self.table, layouts, &frame.slot, inputs))?;
        mask.replay(encoder, &self.table, frame, &inputs, target, None, timestamps)?;
        keep_until_done(encoder, frame);
        Ok(())
    }

    /// Layout of [`PreparedFrame::shadow_bind_group`], for the engine's own pipeline layouts; `None` where the case
    /// declares no resolve interface.
    pub fn shadow_bind_group_layout(&self) -> Option<&wgpu::BindGroupLayout> {
        self.gpu.layouts.shadow.as_ref()
    }

    /// The map, for debug views; [`wgpu::TextureUsages::COPY_SRC`] is among its usages.
    pub fn map(&self) -> &wgpu::Texture {
        &self.gpu.atlas.texture
    }

    /// Stored depths of the map, row by row. Blocks; see [`read_back::texture_bytes`].
    ///
    /// # Errors
    /// A lost device.
    pub fn read_map(&self) -> Result<Vec<f32>, ServiceError> {
        let bytes = read_back::texture_bytes(&self.gpu.device, &self.gpu.queue, &self.gpu.atlas.texture);
        let bytes = self.gpu.alive(bytes)?;
        Ok(match self.gpu.atlas.texture.format() {
            wgpu::TextureFormat::Depth16Unorm => {
                let stored = bytes.chunks_exact(2).map(|texel| u16::from_le_bytes([texel[0], texel[1]]));
                stored.map(|texel| f32::from(texel) / f32::from(u16::MAX)).collect()
            }
            _ => bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect(),
        })
    }

    /// Number of frame buffers in use or waiting for reuse.
    pub fn frame_slots(&self) -> usize {
        self.gpu.slots.len()
    }

    /// Whether the device is lost. No callback of the device is touched: a mapping of four bytes tells, at once
    /// natively and one call later in browsers.
    pub fn device_lost(&self) -> bool {
        self.gpu.probe.device_lost(&self.gpu.device)
    }

    /// Starts over on another device, after a loss. Meshes and prepared frames of the old device are forgotten and
    /// their handles refused: add the meshes' new buffers again. On failure everything stays as it was.
    ///
    /// # Errors
    /// As [`ShadowService::new`].
    pub fn rebuild(&mut self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<(), ServiceError> {
        self.gpu = Gpu::new(device, queue, &self.table, &self.options, None)?;
        for entry in &mut self.meshes {
            *entry = MeshEntry { generation: entry.generation.wrapping_add(1), mesh: None };
        }
        Ok(())
    }

    /// Commands that leave casters to the device, and what it culls of them; `None` where it cannot.
    fn leave(
        &mut self,
        plan: &ShadowPlan,
        instances: &[CasterInstance],
    ) -> Result<Option<Left>, ServiceError> {
        let Some(culling) = &mut self.gpu.culling else { return Ok(None) };
        let Leaving { casters, scratch, work } = &mut self.leaving;
        let facts = |mesh| known(&self.meshes, mesh).map(Mesh::facts);
        casters.update(instances, facts)?;
        let (mut commands, mut statistics) = (FrameCommands::default(), FrameStatistics::default());
        work.clear();
        let facets = 0..plan.facets.len();
        culling.rebuild(&mut commands, plan, facets, casters, facts, scratch, &mut statistics, work)?;
        let culled = culling.upload(&self.gpu.device, &self.gpu.queue, work)?;
        Ok(Some((commands, statistics, culled)))
    }

    /// Binds the buffers of a mesh whose vertices the shaders fetch by themselves.
    fn fetched(
        &self,
        stretched: &Stretched,
        description: &MeshDescription,
        checked: &CheckedMesh,
    ) -> Result<StretchedMesh, ServiceError> {
        let positions = Fetched {
            buffer: description.vertices,
            range: checked.vertices_range.clone(),
            stride_bytes: description.stride_bytes,
            format: description.position_format,
        };
        let masked = description.mask.as_ref().zip(checked.uvs_range.clone());
        let uvs = masked.map(|(mask, range)| Fetched {
            buffer: mask.uvs,
            range,
            stride_bytes: mask.stride_bytes,
            format: mask.format,
        });
        let Gpu { device, .. } = &self.gpu;
        let indices = checked.indices.as_ref();
        stretched.mesh(device, &self.table, &positions, indices, uvs.as_ref(), checked.corners)
    }

    fn bind_mask(
        &self,
        description: &MeshDescription,
        checked: &CheckedMesh,
    ) -> Result<Option<BoundMask>, ServiceError> {
        let (Some(mask), Some(range)) = (&description.mask, &checked.uvs_range) else {
            return Ok(None);
        };
        let layout = self.gpu.capture.mask_layout().ok_or(MeshError::MaskNotDeclared)?;
        let bound = BoundMask::new(&self.gpu.device, &self.table, layout, mask, range.clone());
        self.gpu.alive(bound).map(Some)
    }

    pub(crate) fn mesh(&self, handle: MeshHandle) -> Option<&Mesh> {
        known(&self.meshes, handle)
    }

    pub(crate) fn check_frame(&self, frame: &PreparedFrame) -> Result<(), ServiceError> {
        if !Arc::ptr_eq(&frame.service, &self.gpu.identity) {
            return Err(ServiceError::StaleFrame { why: "another service or an earlier device prepared it" });
        }
        Ok(())
    }
}

fn known(meshes: &[MeshEntry], handle: MeshHandle) -> Option<&Mesh> {
    let entry = meshes.get(handle.index as usize)?;
    entry.mesh.as_ref().filter(|_| entry.generation == handle.generation)
}

/// Holds a frame's slot until the encoder's work is done, or the encoder is dropped.
pub(crate) fn keep_until_done(encoder: &wgpu::CommandEncoder, frame: &PreparedFrame) {
    let held = (Arc::clone(&frame.slot), frame.culled.clone());
    encoder.on_submitted_work_done(move || drop(held));
}
