//! A mesh's description with handles of its own to the engine's buffers, for executors that are made later.

use cssm_core::BoundingBox;

use crate::alpha_mask::AlphaMask;
use crate::clusters::Cluster;
use crate::mesh::{IndexDescription, MeshDescription};

/// A mesh's description that borrows nothing.
#[derive(Debug)]
pub(super) struct StoredMesh {
    vertices: wgpu::Buffer,
    vertices_offset_bytes: u64,
    vertex_count: u32,
    stride_bytes: u32,
    position_offset_bytes: u32,
    position_format: wgpu::VertexFormat,
    indices: Option<StoredIndices>,
    bounds_object: BoundingBox,
    clusters: Vec<Cluster>,
    mask: Option<StoredMask>,
}

#[derive(Debug)]
struct StoredIndices {
    buffer: wgpu::Buffer,
    offset_bytes: u64,
    count: u32,
    format: wgpu::IndexFormat,
}

#[derive(Debug)]
struct StoredMask {
    uvs: wgpu::Buffer,
    offset_bytes: u64,
    stride_bytes: u32,
    format: wgpu::VertexFormat,
    texture: wgpu::TextureView,
    sampler: wgpu::Sampler,
    cutoff: f32,
}

impl StoredMesh {
    /// Remembers a description.
    pub(super) fn new(description: &MeshDescription) -> Self {
        let MeshDescription {
            vertices,
            vertices_offset_bytes,
            vertex_count,
            stride_bytes,
            position_offset_bytes,
            position_format,
            indices,
            bounds_object,
            clusters,
            mask,
        } = description;
        Self {
            vertices: (*vertices).clone(),
            vertices_offset_bytes: *vertices_offset_bytes,
            vertex_count: *vertex_count,
            stride_bytes: *stride_bytes,
            position_offset_bytes: *position_offset_bytes,
            position_format: *position_format,
            indices: indices.as_ref().map(|indices| StoredIndices {
                buffer: indices.buffer.clone(),
                offset_bytes: indices.offset_bytes,
                count: indices.count,
                format: indices.format,
            }),
            bounds_object: *bounds_object,
            clusters: clusters.to_vec(),
            mask: mask.as_ref().map(|mask| StoredMask {
                uvs: mask.uvs.clone(),
                offset_bytes: mask.offset_bytes,
                stride_bytes: mask.stride_bytes,
                format: mask.format,
                texture: mask.texture.clone(),
                sampler: mask.sampler.clone(),
                cutoff: mask.cutoff,
            }),
        }
    }

    /// The description as it was given.
    pub(super) fn description(&self) -> MeshDescription<'_> {
        MeshDescription {
            vertices: &self.vertices,
            vertices_offset_bytes: self.vertices_offset_bytes,
            vertex_count: self.vertex_count,
            stride_bytes: self.stride_bytes,
            position_offset_bytes: self.position_offset_bytes,
            position_format: self.position_format,
            indices: self.indices.as_ref().map(|indices| IndexDescription {
                buffer: &indices.buffer,
                offset_bytes: indices.offset_bytes,
                count: indices.count,
                format: indices.format,
            }),
            bounds_object: self.bounds_object,
            clusters: &self.clusters,
            mask: self.mask.as_ref().map(|mask| AlphaMask {
                uvs: &mask.uvs,
                offset_bytes: mask.offset_bytes,
                stride_bytes: mask.stride_bytes,
                format: mask.format,
                texture: &mask.texture,
                sampler: &mask.sampler,
                cutoff: mask.cutoff,
            }),
        }
    }
}
