//! Clusters of meshes as the device reads them, one mesh after another.

use cssm_core::BoundingBox;
use cssm_core::glam::DVec3;

use crate::commands::MeshFacts;
use crate::mesh::MeshHandle;

/// A box around a box of f64.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct OuterBox {
    pub(super) centre: [f32; 3],
    pub(super) half: [f32; 3],
}

impl OuterBox {
    /// Rounds outward.
    pub(super) fn new(bounds: &BoundingBox) -> Self {
        let centre = ((bounds.min + bounds.max) * 0.5).as_vec3();
        let shift = centre.as_dvec3();
        let half = (bounds.max - shift).max(shift - bounds.min).max(DVec3::ZERO);
        Self { centre: centre.to_array(), half: half.to_array().map(rounded_up) }
    }
}

/// The smallest f32 that is not below a number.
fn rounded_up(value: f64) -> f32 {
    let nearest = value as f32;
    if f64::from(nearest) < value { nearest.next_up() } else { nearest }
}

/// A cluster in the layout of the shaders.
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(super) struct ClusterRecord {
    pub(super) centre: [f32; 3],
    pub(super) first: u32,
    pub(super) half: [f32; 3],
    pub(super) end: u32,
}

const _: () = assert!(size_of::<ClusterRecord>() == 32);

/// All clusters that were asked for so far.
#[derive(Debug, Clone, Default)]
pub(super) struct ClusterPool {
    pub(super) records: Vec<ClusterRecord>,
    /// By the mesh's place in the service's list: its generation and its range of the records.
    meshes: Vec<Option<(MeshHandle, u32, u32)>>,
    /// Records of meshes that are no more.
    dead: usize,
    /// Counts how often the records were begun anew.
    pub(super) generation: u64,
}

impl ClusterPool {
    /// Forgets all meshes once half of the records are of meshes that are no more.
    pub(super) fn tidy(&mut self) {
        if self.dead > self.records.len() / 2 {
            self.records.clear();
            self.meshes.clear();
            self.dead = 0;
            self.generation += 1;
        }
    }

    /// Where the clusters of a mesh begin; they are appended when it is asked for first.
    pub(super) fn first(&mut self, mesh: MeshHandle, facts: &MeshFacts) -> u32 {
        let (clusters, base) = (facts.clusters, if facts.indexed { facts.first_index } else { 0 });
        let index = mesh.index as usize;
        if self.meshes.len() <= index {
            self.meshes.resize(index + 1, None);
        }
        match self.meshes[index] {
            Some((known, first, _)) if known == mesh => return first,
            Some((_, _, count)) => self.dead += count as usize,
            None => {}
        }
        let first = self.records.len() as u32;
        self.records.extend(clusters.iter().map(|cluster| {
            let OuterBox { centre, half } = OuterBox::new(&cluster.bounds_object);
            let first = base.saturating_add(cluster.first);
            ClusterRecord { centre, first, half, end: first.saturating_add(cluster.count) }
        }));
        self.meshes[index] = Some((mesh, first, clusters.len() as u32));
        first
    }
}
