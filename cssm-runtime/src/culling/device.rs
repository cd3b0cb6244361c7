//! The passes that cull, and the buffers of the frames that they cull for.

use std::sync::Arc;

use super::clusters::ClusterRecord;
use super::work::{CullingWork, ONE};
use super::{LANES, STORAGE_BUFFERS, suffices};
use crate::casters::BLOCK_CASTERS;
use crate::error::ServiceError;
use crate::scope::checked;

pub(super) const INSTANCES: &str = concat!(
    include_str!("../shaders/cull_shared.wgsl"),
    "\n",
    include_str!("../shaders/cull_instances.wgsl")
);
pub(super) const CLUSTERS: &str =
    concat!(include_str!("../shaders/cull_shared.wgsl"), "\n", include_str!("../shaders/cull_clusters.wgsl"));

/// Smallest buffer.
const MIN_BYTES: u64 = 1024;
/// Most workgroups that look for cut instances; each takes one after another.
const CLUSTER_WORKGROUPS: u64 = 1024;
/// Blocks of a workgroup.
const BLOCKS: u64 = LANES as u64 / BLOCK_CASTERS as u64;

/// The passes, and buffers that come back.
#[derive(Debug)]
pub(crate) struct GpuCulling {
    instances: Pass,
    clusters: Pass,
    /// Whether draws can be counted on the device.
    counts: bool,
    /// Largest storage buffer.
    limit: u64,
    workgroups: u64,
    pool: Pool,
    frames: Vec<Arc<CulledFrame>>,
}

/// One compute pass.
#[derive(Debug)]
struct Pass {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::ComputePipeline,
}

/// The clusters of all meshes on the device.
#[derive(Debug)]
struct Pool {
    buffer: wgpu::Buffer,
    /// Records that are there, and of which beginning.
    uploaded: usize,
    generation: u64,
}

/// What a frame is culled from and into.
#[derive(Debug)]
pub(crate) struct CulledFrame {
    inputs: Inputs,
    /// Rows of what is drawn.
    pub(crate) rows: wgpu::Buffer,
    /// Arguments and counters.
    pub(super) arguments: wgpu::Buffer,
    /// Arguments of draws of clusters.
    pub(super) cluster_arguments: wgpu::Buffer,
    /// Whether the number of draws of clusters is read on the device.
    counts: bool,
    cuts: wgpu::Buffer,
    groups: Option<[wgpu::BindGroup; 2]>,
    argument_bytes: u64,
    cluster_argument_bytes: u64,
    workgroups: [u32; 2],
}

/// What the CPU writes for a frame.
#[derive(Debug)]
struct Inputs {
    planes: wgpu::Buffer,
    candidates: wgpu::Buffer,
    blocks: wgpu::Buffer,
    draws: wgpu::Buffer,
    /// Arguments and counters as they are before culling, so that a frame can be captured more than once.
    arguments: wgpu::Buffer,
}

impl GpuCulling {
    /// The passes on a device; `None` where it lacks what [`super::culling_requirements`] asks for.
    pub(crate) fn new(device: &wgpu::Device) -> Result<Option<Self>, ServiceError> {
        let (features, limits) = (device.features(), device.limits());
        if !suffices(features, &limits) {
            return Ok(None);
        }
        let writable = |written: &'static [u32]| move |binding: u32| written.contains(&binding);
        let instances = Pass::new(device, "cull_instances", INSTANCES, writable(&[4, 5, 6]))?;
        let clusters = Pass::new(device, "cull_clusters", CLUSTERS, writable(&[4, 6]))?;
        let buffer = checked(device, "the clusters of meshes", || storage(device, MIN_BYTES))?;
        Ok(Some(Self {
            instances,
            clusters,
            counts: features.contains(wgpu::Features::MULTI_DRAW_INDIRECT_COUNT),
            limit: limits
                .max_storage_buffer_binding_size
                .min(limits.max_buffer_size)
                .min(u64::from(u32::MAX)),
            workgroups: u64::from(limits.max_compute_workgroups_per_dimension),
            pool: Pool { buffer, uploaded: 0, generation: 0 },
            frames: Vec::new(),
        }))
    }

    /// Uploads work into a frame's buffers; `None` where it exceeds them, so that the CPU has to cull.
    pub(crate) fn upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        work: &CullingWork,
    ) -> Result<Option<Arc<CulledFrame>>, ServiceError> {
        let workgroups = (work.blocks.len() as u64).div_ceil(BLOCKS).max(1);
        let shape = [workgroups.min(self.workgroups), workgroups.div_ceil(self.workgroups)];
        if shape[1] > self.workgroups || work.largest_bytes() > self.limit {
            return Ok(None);
        }
        checked(device, "the clusters of meshes", || self.pool.upload(device, queue, work, self.limit))?;

        // Take frames that nothing uses; the list holds the only reference to those.
        let free = self.frames.iter_mut().position(|frame| Arc::get_mut(frame).is_some());
        let number = match free {
            Some(number) => number,
            None => {
                let frame = checked(device, "buffers of culling", || CulledFrame::new(device, self.counts))?;
                self.frames.push(Arc::new(frame));
                self.frames.len() - 1
            }
        };
        let (instances, clusters, pool) = (&self.instances, &self.clusters, &self.pool);
        let shared = &mut self.frames[number];
        if let Some(frame) = Arc::get_mut(shared) {
            frame.workgroups = shape.map(|count| count as u32);
            checked(device, "the work of culling", || {
                frame.upload(device, queue, work, self.limit);
                frame.groups = Some([instances.bind(device, frame.of_instances()), {
                    clusters.bind(device, frame.of_clusters(&pool.buffer))
                }]);
            })?;
        }
        Ok(Some(Arc::clone(shared)))
    }

    /// Records the culling of a frame; to be captured in the same encoder, or a later one.
    pub(crate) fn record(&self, encoder: &mut wgpu::CommandEncoder, frame: &CulledFrame) {
        let Some([instances, clusters]) = &frame.groups else { return };

        // Begin with arguments of no instance.
        let (arguments, bytes) = (&frame.arguments, frame.argument_bytes);
        encoder.copy_buffer_to_buffer(&frame.inputs.arguments, 0, arguments, 0, bytes);
        if !self.counts && frame.cluster_argument_bytes > 0 {
            encoder.clear_buffer(&frame.cluster_arguments, 0, Some(frame.cluster_argument_bytes));
        }

        // Instances first, then the clusters of those that are cut.
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some("cssm culling"),
            timestamp_writes: None,
        });
        let [across, down] = frame.workgroups;
        pass.set_pipeline(&self.instances.pipeline);
        pass.set_bind_group(0, instances, &[]);
        pass.dispatch_workgroups(across, down, 1);
        if frame.cluster_argument_bytes > 0 {
            let workgroups = CLUSTER_WORKGROUPS.min(self.workgroups);
            pass.set_pipeline(&self.clusters.pipeline);
            pass.set_bind_group(0, clusters, &[]);
            pass.dispatch_workgroups(workgroups as u32, 1, 1);
        }
    }
}

impl Pass {
    fn new(
        device: &wgpu::Device,
        entry: &'static str,
        source: &'static str,
        is_written: impl Fn(u32) -> bool,
    ) -> Result<Self, ServiceError> {
        let entries: Vec<_> = (0..STORAGE_BUFFERS)
            .map(|binding| wgpu::BindGroupLayoutEntry {
                binding,
                visibility: wgpu::ShaderStages::COMPUTE,
                ty: wgpu::BindingType::Buffer {
                    ty: wgpu::BufferBindingType::Storage { read_only: !is_written(binding) },
                    has_dynamic_offset: false,
                    min_binding_size: None,
                },
                count: None,
            })
            .collect();
        checked(device, "a culling pass", || {
            let label = Some(entry);
            let layout = device
                .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label, entries: &entries });
            let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label,
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
            let pipeline = device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
                label,
                layout: Some(&device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                    label,
                    bind_group_layouts: &[Some(&layout)],
                    immediate_size: 0,
                })),
                module: &module,
                entry_point: Some(entry),
                compilation_options: Default::default(),
                cache: None,
            });
            Self { layout, pipeline }
        })
    }

    fn bind(
        &self,
        device: &wgpu::Device,
        buffers: [&wgpu::Buffer; STORAGE_BUFFERS as usize],
    ) -> wgpu::BindGroup {
        let mut binding = 0..;
        let entries = buffers.map(|buffer| wgpu::BindGroupEntry {
            binding: binding.next().unwrap_or(0),
            resource: buffer.as_entire_binding(),
        });
        let (label, layout) = (Some("cssm culling"), &self.layout);
        device.create_bind_group(&wgpu::BindGroupDescriptor { label, layout, entries: &entries })
    }
}

impl Pool {
    /// Brings the records of work to the device; to be called under an error scope.
    fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, work: &CullingWork, limit: u64) {
        let records = &work.clusters.records;
        let bytes = size_of_val(records.as_slice()) as u64;
        if bytes > self.buffer.size() {
            self.buffer = storage(device, roomy(bytes, limit));
            self.uploaded = 0;
        }
        if self.generation != work.clusters.generation || self.uploaded > records.len() {
            (self.generation, self.uploaded) = (work.clusters.generation, 0);
        }
        let offset = (self.uploaded * size_of::<ClusterRecord>()) as u64;
        if let Some(fresh) = records.get(self.uploaded..).filter(|fresh| !fresh.is_empty()) {
            queue.write_buffer(&self.buffer, offset, bytemuck::cast_slice(fresh));
        }
        self.uploaded = records.len();
    }
}

impl CulledFrame {
    /// Small buffers; to be called under an error scope.
    fn new(device: &wgpu::Device, counts: bool) -> Self {
        let [planes, candidates, blocks, draws, cuts] = std::array::from_fn(|_| storage(device, MIN_BYTES));
        let arguments = buffer(device, MIN_BYTES, INITIAL);
        Self {
            inputs: Inputs { planes, candidates, blocks, draws, arguments },
            rows: buffer(device, MIN_BYTES, ROWS),
            arguments: buffer(device, MIN_BYTES, ARGUMENTS),
            cluster_arguments: buffer(device, MIN_BYTES, ARGUMENTS),
            counts,
            cuts,
            groups: None,
            argument_bytes: 0,
            cluster_argument_bytes: 0,
            workgroups: [0; 2],
        }
    }

    /// Makes room for work and uploads it; to be called under an error scope.
    fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, work: &CullingWork, limit: u64) {
        let Inputs { planes, candidates, blocks, draws, arguments } = &mut self.inputs;
        let write = |target: &mut wgpu::Buffer, bytes: &[u8]| {
            grow(device, target, bytes.len() as u64, limit);
            if !bytes.is_empty() {
                queue.write_buffer(target, 0, bytes);
            }
        };
        write(planes, bytemuck::cast_slice(&work.planes));
        write(candidates, bytemuck::cast_slice(&work.candidates));
        write(blocks, bytemuck::cast_slice(&work.blocks));
        write(draws, bytemuck::cast_slice(&work.draws));
        write(arguments, bytemuck::cast_slice(&work.arguments));
        if !work.arguments.is_empty() {
            queue.write_buffer(arguments, 0, bytemuck::cast_slice(&work.head()));
        }

        self.argument_bytes = size_of_val(work.arguments.as_slice()) as u64;
        self.cluster_argument_bytes = work.cluster_argument_bytes();
        grow(device, &mut self.rows, work.row_bytes(), limit);
        grow(device, &mut self.arguments, self.argument_bytes, limit);
        grow(device, &mut self.cluster_arguments, self.cluster_argument_bytes, limit);
        grow(device, &mut self.cuts, work.cut_bytes(), limit);
    }

    /// Draws rows that culling has found; arguments begin at a word. Counted like clusters where that can be: lavapipe
    /// takes the count of the last counted draw for later ones that are not.
    pub(crate) fn draw(&self, pass: &mut wgpu::RenderPass, arguments: u32, indexed: bool) {
        let (draws, offset) = (&self.arguments, 4 * u64::from(arguments));
        let at = 4 * u64::from(ONE);
        match (indexed, self.counts) {
            (true, true) => pass.multi_draw_indexed_indirect_count(draws, offset, draws, at, 1),
            (false, true) => pass.multi_draw_indirect_count(draws, offset, draws, at, 1),
            (true, false) => pass.draw_indexed_indirect(draws, offset),
            (false, false) => pass.draw_indirect(draws, offset),
        }
    }

    /// Draws clusters that culling has found; arguments begin at a word, `count` is the word of their number.
    pub(crate) fn draw_clusters(
        &self,
        pass: &mut wgpu::RenderPass,
        arguments: u32,
        count: u32,
        most: u32,
        indexed: bool,
    ) {
        let (draws, counts) = (&self.cluster_arguments, &self.arguments);
        let (offset, at) = (4 * u64::from(arguments), 4 * u64::from(count));
        match (indexed, self.counts) {
            (true, true) => pass.multi_draw_indexed_indirect_count(draws, offset, counts, at, most),
            (false, true) => pass.multi_draw_indirect_count(draws, offset, counts, at, most),
            (true, false) => pass.multi_draw_indexed_indirect(draws, offset, most),
            (false, false) => pass.multi_draw_indirect(draws, offset, most),
        }
    }

    /// What the pass over instances binds, in the order of its bindings.
    fn of_instances(&self) -> [&wgpu::Buffer; STORAGE_BUFFERS as usize] {
        let Inputs { planes, candidates, blocks, draws, .. } = &self.inputs;
        [planes, candidates, blocks, draws, &self.rows, &self.arguments, &self.cuts]
    }

    /// What the pass over clusters binds, in the order of its bindings.
    fn of_clusters<'a>(&'a self, clusters: &'a wgpu::Buffer) -> [&'a wgpu::Buffer; STORAGE_BUFFERS as usize] {
        let Inputs { planes, draws, .. } = &self.inputs;
        [planes, clusters, draws, &self.rows, &self.arguments, &self.cuts, &self.cluster_arguments]
    }
}

/// Usages of rows, of arguments, and of what arguments begin with.
const ROWS: wgpu::BufferUsages =
    wgpu::BufferUsages::STORAGE.union(wgpu::BufferUsages::VERTEX).union(wgpu::BufferUsages::COPY_SRC);
const ARGUMENTS: wgpu::BufferUsages = wgpu::BufferUsages::STORAGE
    .union(wgpu::BufferUsages::INDIRECT)
    .union(wgpu::BufferUsages::COPY_DST)
    .union(wgpu::BufferUsages::COPY_SRC);
const INITIAL: wgpu::BufferUsages = wgpu::BufferUsages::COPY_DST.union(wgpu::BufferUsages::COPY_SRC);

fn storage(device: &wgpu::Device, size: u64) -> wgpu::Buffer {
    buffer(device, size, wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST)
}

fn buffer(device: &wgpu::Device, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("cssm culling"),
        size,
        usage,
        mapped_at_creation: false,
    })
}

/// Replaces a buffer that is too small.
fn grow(device: &wgpu::Device, target: &mut wgpu::Buffer, needed: u64, limit: u64) {
    if needed > target.size() {
        *target = buffer(device, roomy(needed, limit), target.usage());
    }
}

/// A size in powers of two, so that growing scenes settle.
fn roomy(needed: u64, limit: u64) -> u64 {
    needed.next_power_of_two().min(limit).max(needed).next_multiple_of(4)
}
