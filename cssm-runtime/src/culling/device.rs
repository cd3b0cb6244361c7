//! The passes that cull, and the buffers of the frames that they cull for.

use std::sync::Arc;

use cssm_core::ShadowPlan;

use super::frame::{CulledFrame, Pool};
use super::work::CullingWork;
use super::{LANES, STORAGE_BUFFERS, suffices};
use crate::casters::{BLOCK_CASTERS, CasterScene};
use crate::commands::{CommandScratch, FrameCommands, FrameStatistics, MeshFacts};
use crate::error::ServiceError;
use crate::mesh::MeshHandle;
use crate::scope::checked;

pub(super) const INSTANCES: &str = concat!(
    include_str!("../shaders/cull_shared.wgsl"),
    "\n",
    include_str!("../shaders/cull_instances.wgsl")
);
pub(super) const CLUSTERS: &str =
    concat!(include_str!("../shaders/cull_shared.wgsl"), "\n", include_str!("../shaders/cull_clusters.wgsl"));

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
        let pool = checked(device, "the clusters of meshes", || Pool::new(device))?;
        Ok(Some(Self {
            instances,
            clusters,
            counts: counts_draws(device),
            limit: limits
                .max_storage_buffer_binding_size
                .min(limits.max_buffer_size)
                .min(u64::from(u32::MAX)),
            workgroups: u64::from(limits.max_compute_workgroups_per_dimension),
            pool,
            frames: Vec::new(),
        }))
    }

    /// Rebuilds a list of commands, and leaves to the device what it can cull; the CPU culls where the work would exceed the
    /// device's buffers.
    ///
    /// # Errors
    /// As [`FrameCommands::rebuild`]; the list is empty then, and the work as it was.
    #[expect(clippy::too_many_arguments, reason = "what is drawn, and the lists that keep their memory")]
    pub(crate) fn rebuild<'m>(
        &self,
        list: &mut FrameCommands,
        plan: &ShadowPlan,
        facets: impl Iterator<Item = usize> + Clone,
        casters: &CasterScene,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        scratch: &mut CommandScratch,
        statistics: &mut FrameStatistics,
        work: &mut CullingWork,
    ) -> Result<(), ServiceError> {
        let mark = work.mark();
        list.clear();
        statistics.clear();
        let appended = list.append_culled(plan, facets.clone(), casters, &facts, scratch, statistics, work);
        if appended.is_ok() && self.shape(work).is_some() {
            return Ok(());
        }
        work.take_back(&mark);
        list.clear();
        statistics.clear();
        appended?;
        list.rebuild(plan, facets, casters, facts, scratch, statistics)
    }

    /// Workgroups over the instances of work; `None` where the work exceeds the device.
    fn shape(&self, work: &CullingWork) -> Option<[u32; 2]> {
        let workgroups = (work.blocks.len() as u64).div_ceil(BLOCKS).max(1);
        let shape = [workgroups.min(self.workgroups), workgroups.div_ceil(self.workgroups)];
        let fits = shape[1] <= self.workgroups && work.largest_bytes() <= self.limit;
        fits.then_some(shape.map(|count| count as u32))
    }

    /// Uploads work into a frame's buffers; `None` where there is none that fits.
    pub(crate) fn upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        work: &CullingWork,
    ) -> Result<Option<Arc<CulledFrame>>, ServiceError> {
        let Some(shape) = self.shape(work).filter(|_| !work.is_empty()) else { return Ok(None) };
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
            frame.workgroups = shape;
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

/// Whether draws can be counted on the device. Lavapipe says so, but takes the count for later draws that are not counted.
fn counts_draws(device: &wgpu::Device) -> bool {
    let is_software = device.adapter_info().device_type == wgpu::DeviceType::Cpu;
    device.features().contains(wgpu::Features::MULTI_DRAW_INDIRECT_COUNT) && !is_software
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
