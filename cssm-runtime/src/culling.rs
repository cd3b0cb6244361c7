//! Culling on the device: facets' half-spaces against instances and clusters in compute, survivors as indirect draws.
//!
//! The CPU refuses blocks of casters, as it does when it culls alone ([`crate::CasterScene`]); what is left, the
//! *candidates*, it writes down once for each plan: `CullingWork`. On the device one thread tests the own box of each
//! candidate against the half-spaces that cut through its block. Instances that reach a facet whole become rows of one
//! draw; of those that are cut, [`crate::Cluster`] by cluster is tested, and each run of neighbours that reach is a draw.
//!
//! The shaders are fixed: they know half-spaces and boxes, no case. Boxes are tested in f32 in the axes and from the rows
//! that casters are drawn with, half-spaces are turned to those axes in f64, and what f32 cannot tell is drawn: the margin
//! is 2^-19 of the sum of the magnitudes of all terms of a test, at 100 m from the eye a fifth of a millimetre. So the
//! device never loses what the CPU draws. It does not draw gaps between clusters along, as the CPU does to save draws.

mod clusters;
mod device;
mod frame;
mod read;
mod work;

pub(crate) use device::GpuCulling;
pub(crate) use frame::CulledFrame;
pub(crate) use read::CulledWords;
pub(crate) use work::{CullingWork, LeftClusters};

use crate::requirements::Requirements;

/// Where casters are culled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Culling {
    /// On the CPU, while a frame is prepared.
    #[default]
    Cpu,
    /// On the device, while a frame is captured; on the CPU where the device lacks what [`culling_requirements`] asks for,
    /// or a frame exceeds its buffers. Casters that the shaders fetch by themselves ([`crate::Drawing::Both`],
    /// [`crate::Drawing::Fans`]) are always culled on the CPU.
    Gpu,
}

/// Storage buffers that a culling pass reads and writes.
const STORAGE_BUFFERS: u32 = 7;
/// Threads of a workgroup.
const LANES: u32 = 64;
/// Largest storage buffer, unless the engine asks for more: what WebGPU has everywhere.
const STORAGE_BYTES: u64 = 128 << 20;
/// Bytes that a workgroup shares.
const SHARED_BYTES: u32 = 1024;

/// Features and limits for [`Culling::Gpu`], to be requested with those of [`crate::features_and_limits`]; `None` where the
/// adapter cannot cull. [`wgpu::Features::MULTI_DRAW_INDIRECT_COUNT`] is asked for where it is offered: without it, and on
/// software devices, empty draws follow those of clusters.
pub fn culling_requirements(adapter: &wgpu::Adapter) -> Option<Requirements> {
    let offered = adapter.limits();
    let flags = adapter.get_downlevel_capabilities().flags;
    let needed = wgpu::DownlevelFlags::COMPUTE_SHADERS | wgpu::DownlevelFlags::INDIRECT_EXECUTION;
    if !flags.contains(needed) || !suffices(adapter.features(), &offered) {
        return None;
    }
    let lowest = wgpu::Limits::downlevel_webgl2_defaults().or_worse_values_from(&offered);
    let limits = wgpu::Limits {
        max_storage_buffers_per_shader_stage: STORAGE_BUFFERS,
        max_storage_buffer_binding_size: offered.max_storage_buffer_binding_size.min(STORAGE_BYTES),
        max_compute_workgroup_storage_size: SHARED_BYTES,
        max_compute_invocations_per_workgroup: LANES,
        max_compute_workgroup_size_x: LANES,
        max_compute_workgroup_size_y: 1,
        max_compute_workgroup_size_z: 1,
        max_compute_workgroups_per_dimension: offered.max_compute_workgroups_per_dimension.min(65_535),
        ..lowest
    };
    let useful = NEEDED.union(wgpu::Features::MULTI_DRAW_INDIRECT_COUNT);
    Some(Requirements { features: adapter.features() & useful, limits })
}

/// Without it all instances of an indirect draw would have to begin at row 0.
const NEEDED: wgpu::Features = wgpu::Features::INDIRECT_FIRST_INSTANCE;

/// Whether an adapter or a device has enough to cull.
fn suffices(features: wgpu::Features, limits: &wgpu::Limits) -> bool {
    features.contains(NEEDED)
        && limits.max_storage_buffers_per_shader_stage >= STORAGE_BUFFERS
        && limits.max_compute_workgroup_storage_size >= SHARED_BYTES
        && limits.max_compute_invocations_per_workgroup >= LANES
        && limits.max_compute_workgroup_size_x >= LANES
        && limits.max_compute_workgroups_per_dimension > 0
}

#[cfg(test)]
mod tests;
