//! The buffers of the frames that are culled on the device, and the clusters of all meshes.

use super::STORAGE_BUFFERS;
use super::clusters::ClusterRecord;
use super::work::{CullingWork, ONE};

/// Smallest buffer.
const MIN_BYTES: u64 = 1024;
/// The clusters of all meshes on the device.
#[derive(Debug)]
pub(super) struct Pool {
    pub(super) buffer: wgpu::Buffer,
    /// Records that are there, and of which beginning.
    uploaded: usize,
    generation: u64,
}

/// What a frame is culled from and into.
#[derive(Debug)]
pub(crate) struct CulledFrame {
    pub(super) inputs: Inputs,
    /// Rows of what is drawn.
    pub(crate) rows: wgpu::Buffer,
    /// Arguments and counters.
    pub(super) arguments: wgpu::Buffer,
    /// Arguments of draws of clusters.
    pub(super) cluster_arguments: wgpu::Buffer,
    /// Whether the number of draws of clusters is read on the device.
    counts: bool,
    cuts: wgpu::Buffer,
    pub(super) groups: Option<[wgpu::BindGroup; 2]>,
    pub(super) argument_bytes: u64,
    pub(super) cluster_argument_bytes: u64,
    pub(super) workgroups: [u32; 2],
}

/// What the CPU writes for a frame.
#[derive(Debug)]
pub(super) struct Inputs {
    planes: wgpu::Buffer,
    candidates: wgpu::Buffer,
    blocks: wgpu::Buffer,
    draws: wgpu::Buffer,
    /// Arguments and counters as they are before culling, so that a frame can be captured more than once.
    pub(super) arguments: wgpu::Buffer,
}

impl Pool {
    /// No clusters; to be called under an error scope.
    pub(super) fn new(device: &wgpu::Device) -> Self {
        Self { buffer: storage(device, MIN_BYTES), uploaded: 0, generation: 0 }
    }

    /// Brings the records of work to the device; to be called under an error scope. What earlier frames bind is never
    /// overwritten.
    pub(super) fn upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        work: &CullingWork,
        limit: u64,
    ) {
        let records = &work.clusters.records;
        let bytes = size_of_val(records.as_slice()) as u64;
        let other = self.generation != work.clusters.generation || self.uploaded > records.len();
        if other || bytes > self.buffer.size() {
            self.buffer = storage(device, roomy(bytes.max(MIN_BYTES), limit));
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
    pub(super) fn new(device: &wgpu::Device, counts: bool) -> Self {
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
    pub(super) fn upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        work: &CullingWork,
        limit: u64,
    ) {
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

    /// Draws rows that culling has found; arguments begin at a word. Counted like clusters where that can be, which spares
    /// the check of uncounted arguments.
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
    pub(super) fn of_instances(&self) -> [&wgpu::Buffer; STORAGE_BUFFERS as usize] {
        let Inputs { planes, candidates, blocks, draws, .. } = &self.inputs;
        [planes, candidates, blocks, draws, &self.rows, &self.arguments, &self.cuts]
    }

    /// What the pass over clusters binds, in the order of its bindings.
    pub(super) fn of_clusters<'a>(
        &'a self,
        clusters: &'a wgpu::Buffer,
    ) -> [&'a wgpu::Buffer; STORAGE_BUFFERS as usize] {
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
