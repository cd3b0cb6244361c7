//! Casters: geometry that stays in the engine's own buffers and vertex format.

mod error;

use cssm_core::BoundingBox;
use cssm_core::glam::DAffine3;

use crate::alpha_mask::{AlphaMask, BoundMask, check};
use crate::capture::StretchedMesh;
use crate::clusters::{self, Cluster, is_sound};
use crate::commands::{Drawing, MeshFacts, PipelineHandle};

pub use error::MeshError;

/// A triangle list in the engine's own buffers.
///
/// Positions are read in the format they are stored in. Whatever decodes them (the scale and origin of quantised
/// positions, a unit of centimetres) belongs into [`CasterInstance::world_from_object`], which is f64: `object`
/// space is what the vertex fetch yields, so for `Snorm16x4` it is the cube from -1 to 1.
#[derive(Debug, Clone)]
pub struct MeshDescription<'a> {
    /// Buffer with positions; needs [`wgpu::BufferUsages::VERTEX`], and [`wgpu::BufferUsages::STORAGE`] where the case
    /// stretches exactly.
    pub vertices: &'a wgpu::Buffer,
    /// Where the mesh's first vertex begins in the buffer.
    pub vertices_offset_bytes: u64,
    /// Number of vertices.
    pub vertex_count: u32,
    /// Distance between vertices.
    pub stride_bytes: u32,
    /// Where the position lies in a vertex.
    pub position_offset_bytes: u32,
    /// Format of the position: any float, normalised or packed format with three or more components.
    pub position_format: wgpu::VertexFormat,
    /// Indices; `None`: every three vertices are a triangle.
    pub indices: Option<IndexDescription<'a>>,
    /// Box around the positions in object space.
    pub bounds_object: BoundingBox,
    /// Ranges of the triangles that facets accept or refuse one by one, one after another over the whole mesh; empty: the
    /// mesh is accepted or refused whole. [`crate::cluster_triangles`] makes them; worth it from a few hundred triangles.
    pub clusters: &'a [Cluster],
    /// Holes; `None`: the triangles are whole.
    pub mask: Option<AlphaMask<'a>>,
}

/// Indices of a triangle list.
#[derive(Debug, Clone)]
pub struct IndexDescription<'a> {
    /// Buffer with indices; needs [`wgpu::BufferUsages::INDEX`], and [`wgpu::BufferUsages::STORAGE`] where the case
    /// stretches exactly.
    pub buffer: &'a wgpu::Buffer,
    /// Where the mesh's first index begins in the buffer.
    pub offset_bytes: u64,
    /// Number of indices.
    pub count: u32,
    /// Format of an index.
    pub format: wgpu::IndexFormat,
}

/// A mesh that the service draws into maps.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MeshHandle {
    pub(crate) index: u32,
    pub(crate) generation: u32,
}

impl MeshHandle {
    /// A handle of an engine that keeps its meshes and replays [`crate::FrameCommands`] by itself. A service takes only
    /// handles that it has given out.
    pub const fn new(index: u32, generation: u32) -> Self {
        Self { index, generation }
    }
}

/// One occurrence of a mesh in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CasterInstance {
    /// The mesh.
    pub mesh: MeshHandle,
    /// From the mesh's object space to world space, metres.
    pub world_from_object: DAffine3,
}

/// A mesh as the service keeps it.
#[derive(Debug, Clone)]
pub(crate) struct Mesh {
    vertices: wgpu::Buffer,
    vertices_range: std::ops::Range<u64>,
    indices: Option<BoundIndices>,
    mask: Option<BoundMask>,
    pipeline: PipelineHandle,
    stretched: Option<StretchedMesh>,
    corners: u32,
    bounds_object: BoundingBox,
    clusters: Vec<Cluster>,
}

/// A description whose buffers and numbers have been found sound.
#[derive(Debug)]
pub(crate) struct CheckedMesh {
    pub(crate) vertices_range: std::ops::Range<u64>,
    pub(crate) indices: Option<BoundIndices>,
    pub(crate) corners: u32,
    /// Where the texture coordinates of the mask lie.
    pub(crate) uvs_range: Option<std::ops::Range<u64>>,
}

impl Mesh {
    /// Binds the mesh's buffers; `slot` is the vertex buffer slot.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass, slot: u32) {
        if let Some(stretched) = &self.stretched {
            return stretched.bind(pass);
        }
        pass.set_vertex_buffer(slot, self.vertices.slice(self.vertices_range.clone()));
        if let Some((buffer, range, format)) = &self.indices {
            pass.set_index_buffer(buffer.slice(range.clone()), *format);
        }
    }

    /// Binds the indices from the start of their buffer, for draws of [`MeshFacts::first_index`].
    pub(crate) fn bind_all_indices(&self, pass: &mut wgpu::RenderPass) {
        if let Some((buffer, range, format)) = &self.indices {
            pass.set_index_buffer(buffer.slice(..range.end), *format);
        }
    }

    /// Number of the first index in its buffer.
    pub(crate) fn first_index(&self) -> u32 {
        let first = |(_, range, format): &BoundIndices| range.start / format.byte_size() as u64;
        self.indices.as_ref().map_or(0, |indices| first(indices) as u32)
    }

    /// The mesh's alpha mask.
    pub(crate) fn mask(&self) -> Option<&BoundMask> {
        self.mask.as_ref()
    }

    /// The same mesh, whose vertices the shaders fetch by themselves.
    pub(crate) fn fetched(self, stretched: StretchedMesh) -> Self {
        Self { pipeline: stretched.pipeline, stretched: Some(stretched), ..self }
    }

    /// A mesh of a checked description.
    pub(crate) fn new(
        description: &MeshDescription,
        checked: CheckedMesh,
        mask: Option<BoundMask>,
        pipeline: PipelineHandle,
    ) -> Self {
        Self {
            vertices: description.vertices.clone(),
            vertices_range: checked.vertices_range,
            indices: checked.indices,
            mask,
            pipeline,
            stretched: None,
            corners: checked.corners,
            bounds_object: description.bounds_object,
            clusters: description.clusters.to_vec(),
        }
    }

    /// What commands are built from.
    pub(crate) fn facts(&self) -> MeshFacts<'_> {
        MeshFacts {
            pipeline: self.pipeline,
            corners: self.corners,
            indexed: self.indices.is_some() && self.stretched.is_none(),
            first_index: self.first_index(),
            bounds_object: self.bounds_object,
            clusters: &self.clusters,
            drawing: self.stretched.as_ref().map_or(Drawing::Plain, |stretched| stretched.drawing),
        }
    }
}

impl CheckedMesh {
    /// Checks a description against its buffers and the device.
    pub(crate) fn new(description: &MeshDescription, device: &wgpu::Device) -> Result<Self, MeshError> {
        let vertices_range = vertex_range(description, &device.limits())?;
        let indices = description.indices.as_ref().map(index_range).transpose()?;

        // Count triangles and check the box.
        let corners = description.indices.as_ref().map_or(description.vertex_count, |indices| indices.count);
        if corners == 0 || description.vertex_count == 0 {
            return Err(MeshError::Empty);
        }
        if !corners.is_multiple_of(3) {
            return Err(MeshError::NotTriangles { corners });
        }
        if !is_sound(&description.bounds_object) {
            return Err(MeshError::Bounds);
        }
        clusters::check(description.clusters, corners)?;

        let uvs_range = description
            .mask
            .as_ref()
            .map(|mask| check(mask, device, description.vertex_count))
            .transpose()?;
        Ok(Self { vertices_range, indices, corners, uvs_range })
    }
}

/// Whether a vertex fetch yields at least three floats.
const fn is_position_format(format: wgpu::VertexFormat) -> bool {
    use wgpu::VertexFormat as Format;
    matches!(
        format,
        Format::Float32x3
            | Format::Float32x4
            | Format::Float16x4
            | Format::Snorm16x4
            | Format::Unorm16x4
            | Format::Snorm8x4
            | Format::Unorm8x4
            | Format::Unorm10_10_10_2
    )
}

fn vertex_range(
    description: &MeshDescription,
    limits: &wgpu::Limits,
) -> Result<std::ops::Range<u64>, MeshError> {
    const WHAT: &str = "vertices";
    if !is_position_format(description.position_format) {
        return Err(MeshError::Format(description.position_format));
    }
    let (stride, offset) = (description.stride_bytes, description.position_offset_bytes);
    let position_bytes = description.position_format.size();
    let fits = u64::from(offset) + position_bytes <= u64::from(stride);
    let limit = limits.max_vertex_buffer_array_stride;
    if !fits || !u64::from(stride).is_multiple_of(wgpu::VERTEX_ALIGNMENT) || stride > limit {
        return Err(MeshError::Stride { stride_bytes: stride, position_offset_bytes: offset, limit });
    }
    if description.vertex_count == 0 {
        return Err(MeshError::Empty);
    }

    // Bind from the first position to the end of the last one: the pipeline then reads positions at offset 0.
    let length = u64::from(description.vertex_count - 1) * u64::from(stride) + position_bytes;
    let start = description.vertices_offset_bytes.saturating_add(u64::from(offset));
    let end = start.saturating_add(length);
    if !start.is_multiple_of(wgpu::VERTEX_ALIGNMENT) {
        return Err(MeshError::Alignment {
            what: WHAT,
            offset_bytes: start,
            alignment: wgpu::VERTEX_ALIGNMENT,
        });
    }
    in_buffer(description.vertices, WHAT, wgpu::BufferUsages::VERTEX, end)?;
    Ok(start..end)
}

/// A buffer of indices, where they lie in it and how they are stored.
pub(crate) type BoundIndices = (wgpu::Buffer, std::ops::Range<u64>, wgpu::IndexFormat);

fn index_range(indices: &IndexDescription) -> Result<BoundIndices, MeshError> {
    const WHAT: &str = "indices";
    if indices.count == 0 {
        return Err(MeshError::Empty);
    }
    let size = indices.format.byte_size() as u64;
    if !indices.offset_bytes.is_multiple_of(size) {
        return Err(MeshError::Alignment { what: WHAT, offset_bytes: indices.offset_bytes, alignment: size });
    }
    let end = indices.offset_bytes.saturating_add(u64::from(indices.count) * size);
    in_buffer(indices.buffer, WHAT, wgpu::BufferUsages::INDEX, end)?;
    Ok((indices.buffer.clone(), indices.offset_bytes..end, indices.format))
}

/// Checks that a buffer has a usage and reaches to an end.
pub(crate) fn in_buffer(
    buffer: &wgpu::Buffer,
    what: &'static str,
    usage: wgpu::BufferUsages,
    end_bytes: u64,
) -> Result<(), MeshError> {
    if !buffer.usage().contains(usage) {
        return Err(MeshError::Usage { what, usage });
    }
    if end_bytes > buffer.size() {
        return Err(MeshError::OutOfRange { what, end_bytes, size_bytes: buffer.size() });
    }
    Ok(())
}
