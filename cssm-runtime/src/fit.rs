//! Depth measured on the GPU for plans that are fitted to it: recorded with a frame, read back without ever waiting.
//!
//! A ring of buffers goes round: a frame's numbers are copied to one, mapped once the frame is submitted, and read when the
//! mapping has come. Where all are still on their way the frame is not measured. What is read is as many frames old as
//! [`DepthHistogram::latency_frames`] says, and plans treat it so: they move texels by it and never leave a receiver
//! without.

use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

use cssm_core::View;
use cssm_core::fit::{DepthHistogram, WORDS};
use cssm_core::table::{
    BindGroup, BindingKind, CaseTable, GroupContent, RecordKind, Reduction, ShaderKind, write_fit_record,
};

use crate::error::ServiceError;
use crate::layout::{bind_group, group_layout, record_bytes, required_group, shader_module};
use crate::requirements::Requirements;
use crate::scope::checked;

/// Frames that may be on their way at once.
const RING: usize = 4;

/// A mapping that has not come.
const PENDING: u8 = 0;
/// A mapping that has come.
const MAPPED: u8 = 1;
/// A mapping that was refused, as by a lost device.
const FAILED: u8 = 2;

/// Threads of a workgroup, across and down.
const GROUP_SIDE: u32 = 16;
/// Shared memory of a workgroup: its own numbers, rounded up.
const SHARED_BYTES: u32 = 2048;
/// Largest number of workgroups across or down: four times as many pixels as textures have.
const WORKGROUPS: u32 = 1024;

/// Features and limits that [`DepthReduction`] needs, to be requested with those of
/// [`features_and_limits`](crate::features_and_limits); nothing where the adapter cannot measure depth. Plans are then
/// made without.
pub fn depth_reduction_requirements(adapter: &wgpu::Adapter) -> Option<Requirements> {
    let offered = adapter.limits();
    let flags = adapter.get_downlevel_capabilities().flags;
    if !flags.contains(wgpu::DownlevelFlags::COMPUTE_SHADERS) || !suffices(&offered) {
        return None;
    }
    let lowest = wgpu::Limits::downlevel_webgl2_defaults().or_worse_values_from(&offered);
    let limits = wgpu::Limits {
        max_storage_buffers_per_shader_stage: lowest.max_storage_buffers_per_shader_stage.max(1),
        max_storage_buffer_binding_size: lowest.max_storage_buffer_binding_size.max(4 * WORDS as u64),
        max_compute_workgroup_storage_size: SHARED_BYTES,
        max_compute_invocations_per_workgroup: GROUP_SIDE * GROUP_SIDE,
        max_compute_workgroup_size_x: GROUP_SIDE,
        max_compute_workgroup_size_y: GROUP_SIDE,
        max_compute_workgroup_size_z: 1,
        max_compute_workgroups_per_dimension: offered.max_compute_workgroups_per_dimension.min(WORKGROUPS),
        ..lowest
    };
    Some(Requirements { features: wgpu::Features::empty(), limits })
}

/// Whether an adapter or a device has enough to measure depth.
fn suffices(limits: &wgpu::Limits) -> bool {
    limits.max_storage_buffers_per_shader_stage > 0
        && limits.max_storage_buffer_binding_size >= 4 * WORDS as u64
        && limits.max_compute_workgroup_storage_size >= SHARED_BYTES
        && limits.max_compute_invocations_per_workgroup >= GROUP_SIDE * GROUP_SIDE
        && limits.max_compute_workgroup_size_x >= GROUP_SIDE
        && limits.max_compute_workgroup_size_y >= GROUP_SIDE
        && limits.max_compute_workgroups_per_dimension > 0
}

/// The reduction of one view's depth to a [`DepthHistogram`].
///
/// Each frame: [`Self::record`] after the engine's depth is drawn, [`Self::submitted`] once the encoder is, and
/// [`Self::newest`] before the next plan.
#[derive(Debug)]
pub struct DepthReduction {
    device: wgpu::Device,
    queue: wgpu::Queue,
    table: CaseTable,
    reduction: Reduction,
    pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    ring: Vec<Entry>,
    /// Frames recorded or skipped so far.
    frames: u64,
}

/// One frame's buffers.
#[derive(Debug)]
struct Entry {
    view_record: wgpu::Buffer,
    measured: wgpu::Buffer,
    read_back: wgpu::Buffer,
    state: State,
}

/// Where a frame's numbers are.
#[derive(Debug)]
enum State {
    Free,
    /// In an encoder.
    Recorded(Frame),
    /// On their way, or here.
    Mapping(Frame, Arc<AtomicU8>),
}

/// What was measured.
#[derive(Debug, Clone, Copy)]
struct Frame {
    number: u64,
    view: View,
}

impl DepthReduction {
    /// The reduction of a case; nothing where its table has none, and on a device without the limits of
    /// [`depth_reduction_requirements`]: plans are then made without measured depth.
    ///
    /// # Errors
    /// A device that refuses the pipeline; a table without its shader.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        table: &CaseTable,
    ) -> Result<Option<Self>, ServiceError> {
        let Some(reduction) = table.reduction.as_ref().filter(|_| suffices(&device.limits())) else {
            return Ok(None);
        };
        let group = required_group(table, ShaderKind::Fit, GroupContent::Fit)?;
        let module = shader_module(device, table, ShaderKind::Fit)?;
        let layout = checked(device, "the layout of measured depth", || {
            group_layout(device, table, group, wgpu::ShaderStages::COMPUTE)
        })?;
        let pipeline = checked(device, "the pipeline that measures depth", || {
            let mut groups = vec![None; 1 + group.group as usize];
            groups[group.group as usize] = Some(&layout);
            let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("cssm fit"),
                bind_group_layouts: &groups,
                immediate_size: 0,
            });
            device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label: Some("cssm fit"),
                layout: Some(&layout),
                module: &module,
                entry_point: Some(&reduction.entry),
                compilation_options: Default::default(),
                cache: None,
            })
        })?;
        let ring = checked(device, "buffers of measured depth", || {
            (0..RING).map(|_| Entry::new(device, table, reduction)).collect()
        })?;
        Ok(Some(Self {
            device: device.clone(),
            queue: queue.clone(),
            table: table.clone(),
            reduction: reduction.clone(),
            pipeline,
            layout,
            ring,
            frames: 0,
        }))
    }

    /// Records the reduction of a view's depth, which the mask pass of the same case would take. Says whether this frame
    /// is measured: it is not while earlier ones are still on their way.
    ///
    /// # Errors
    /// [`ServiceError::Refused`] for a texture of another kind than the case declares, and whatever else the device
    /// refuses.
    pub fn record(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        depth: &wgpu::TextureView,
        view: &View,
    ) -> Result<bool, ServiceError> {
        let number = self.frames;
        self.frames += 1;
        let Some(entry) = self.ring.iter_mut().find(|entry| matches!(entry.state, State::Free)) else {
            return Ok(false);
        };

        // Rectangles are measured in the texture's own pixels.
        let size = depth.texture().size();
        let view = View { size_pixels: (size.width, size.height), ..*view };
        let group = required_group(&self.table, ShaderKind::Fit, GroupContent::Fit)?;
        let bound = checked(&self.device, "the depth to measure", || {
            entry.bind(&self.device, &self.layout, group, depth)
        })?;
        self.queue.write_buffer(&entry.view_record, 0, &write_fit_record(&self.table, &view));
        encoder.clear_buffer(&entry.measured, 0, None);
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("cssm fit"),
            timestamp_writes: None,
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(group.group, &bound, &[]);
        let squares = |pixels: u32| pixels.div_ceil(self.reduction.square_pixels);
        pass.dispatch_workgroups(squares(size.width), squares(size.height), 1);
        drop(pass);
        encoder.copy_buffer_to_buffer(&entry.measured, 0, &entry.read_back, 0, entry.read_back.size());
        entry.state = State::Recorded(Frame { number, view });
        Ok(true)
    }

    /// Asks for the numbers of every frame that was recorded; to be called once their encoders are submitted. Does not
    /// wait.
    pub fn submitted(&mut self) {
        for entry in &mut self.ring {
            if let State::Recorded(frame) = entry.state {
                let answer = Arc::new(AtomicU8::new(PENDING));
                entry.read_back.map_async(wgpu::MapMode::Read, .., told(&answer));
                entry.state = State::Mapping(frame, answer);
            }
        }
    }

    /// Has the numbers of what was recorded asked for when the encoder is submitted, in the place of [`Self::submitted`];
    /// what an encoder that is dropped has recorded is taken back by itself.
    pub(crate) fn read_on_submit(&mut self, encoder: &wgpu::CommandEncoder) {
        for entry in &mut self.ring {
            if let State::Recorded(frame) = entry.state {
                let answer = Arc::new(AtomicU8::new(PENDING));
                encoder.map_buffer_on_submit(&entry.read_back, wgpu::MapMode::Read, .., told(&answer));
                entry.state = State::Mapping(frame, answer);
            }
        }
    }

    /// Counts a frame in which nothing is recorded.
    pub(crate) fn pass_frame(&mut self) {
        self.frames += 1;
    }

    /// Takes back what was recorded in encoders that are dropped unsubmitted.
    pub fn dropped(&mut self) {
        for entry in &mut self.ring {
            if matches!(entry.state, State::Recorded(_)) {
                entry.state = State::Free;
            }
        }
    }

    /// The newest frame that has come since the last call, for the next frame's plan; nothing where none has. Lets the
    /// device look, which may run callbacks of the engine that are due, and does not wait.
    ///
    /// # Errors
    /// [`ServiceError::DeviceLost`].
    pub fn newest(&mut self) -> Result<Option<DepthHistogram>, ServiceError> {
        self.device.poll(wgpu::PollType::Poll).map_err(|_| ServiceError::DeviceLost)?;
        let mut newest: Option<(u64, DepthHistogram)> = None;
        for entry in &mut self.ring {
            let State::Mapping(frame, answer) = &mut entry.state else { continue };
            let dropped = Arc::get_mut(answer).is_some_and(|answer| *answer.get_mut() == PENDING);
            if dropped {
                entry.state = State::Free;
                continue;
            }
            let (frame, answer) = (*frame, answer.load(Ordering::Acquire));
            match answer {
                PENDING => continue,
                FAILED => return Err(ServiceError::DeviceLost),
                _ => {}
            }
            let words = entry.words();
            let newer = newest.as_ref().is_none_or(|(number, _)| frame.number > *number);
            if let (true, Some(words)) = (newer, words) {
                let latency = u32::try_from(self.frames - frame.number).unwrap_or(u32::MAX);
                let histogram = DepthHistogram::of_words(&frame.view, &words);
                newest = Some((frame.number, DepthHistogram { latency_frames: latency, ..histogram }));
            }
            entry.read_back.unmap();
            entry.state = State::Free;
        }
        Ok(newest.map(|(_, histogram)| histogram))
    }
}

/// What a mapping calls; nobody else holds the answer then.
fn told(answer: &Arc<AtomicU8>) -> impl FnOnce(Result<(), wgpu::BufferAsyncError>) + Send + 'static {
    let answer = Arc::clone(answer);
    move |result| answer.store(if result.is_ok() { MAPPED } else { FAILED }, Ordering::Release)
}

impl Entry {
    fn new(device: &wgpu::Device, table: &CaseTable, reduction: &Reduction) -> Self {
        let buffer = |label, size, usage| {
            device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size,
                usage,
                mapped_at_creation: false,
            })
        };
        let bytes = 4 * u64::from(reduction.words);
        let view_bytes = u64::from(record_bytes(table, RecordKind::Fit));
        use wgpu::BufferUsages as Usages;
        Self {
            view_record: buffer("cssm fit view", view_bytes, Usages::UNIFORM | Usages::COPY_DST),
            measured: buffer("cssm fit", bytes, Usages::STORAGE | Usages::COPY_SRC | Usages::COPY_DST),
            read_back: buffer("cssm fit read-back", bytes, Usages::MAP_READ | Usages::COPY_DST),
            state: State::Free,
        }
    }

    fn bind(
        &self,
        device: &wgpu::Device,
        layout: &wgpu::BindGroupLayout,
        group: &BindGroup,
        depth: &wgpu::TextureView,
    ) -> wgpu::BindGroup {
        bind_group(device, layout, group, |kind| match kind {
            BindingKind::Uniform { .. } => Some(self.view_record.as_entire_binding()),
            BindingKind::SceneDepth | BindingKind::SceneLinearDepth => {
                Some(wgpu::BindingResource::TextureView(depth))
            }
            BindingKind::Measured => Some(self.measured.as_entire_binding()),
            _ => None,
        })
    }

    /// The numbers of a mapped buffer.
    fn words(&self) -> Option<Vec<u32>> {
        let bytes = self.read_back.get_mapped_range(..).ok()?;
        Some(
            bytes
                .chunks_exact(4)
                .map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]]))
                .collect(),
        )
    }
}
