//! Casters whose triangles are seen as a whole: the device fetches their vertices from storage buffers, because what bent
//! rows make of a triangle takes all three of its corners.

use std::ops::Range;

use cssm_core::table::{BindingKind, CaseTable, GroupContent, ShaderKind};

use crate::commands::{Drawing, PipelineHandle};
use crate::error::ServiceError;
use crate::layout::{bind_group, group_layout, incomplete, required_group};
use crate::mesh::{BoundIndices, MeshError, in_buffer};
use crate::scope::checked;

/// Whether a table's casters are fetched by the shaders.
pub(crate) fn fetches_by_itself(table: &CaseTable) -> bool {
    table.groups.iter().any(|group| group.content == GroupContent::CasterMesh)
}

/// Storage buffers that the vertex stage of a table needs.
pub(crate) fn vertex_storage_buffers(table: &CaseTable) -> u32 {
    let is_storage = |kind: BindingKind| {
        matches!(kind, BindingKind::MeshPositions | BindingKind::MeshIndices | BindingKind::MeshUvs)
    };
    let count = |bindings: &[cssm_core::table::Binding]| {
        bindings.iter().filter(|binding| is_storage(binding.kind)).count() as u32
    };
    table.groups.iter().map(|group| count(&group.bindings)).max().unwrap_or(0)
}

/// Layouts of the buffers of casters, and the pipelines that read them.
#[derive(Debug)]
pub(crate) struct Stretched {
    pub(super) opaque: MeshLayout,
    pub(super) tested: Option<MeshLayout>,
}

/// Layout of the buffers of a caster, and how such casters are drawn.
#[derive(Debug)]
pub(crate) struct MeshLayout {
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) group: u32,
    pub(super) pipeline: PipelineHandle,
    pub(super) drawing: Drawing,
}

impl MeshLayout {
    /// The layout of a shader's group; `pipeline` and `drawing` follow once there are pipelines.
    pub(super) fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        shader: ShaderKind,
    ) -> Result<Self, ServiceError> {
        let group = required_group(table, shader, GroupContent::CasterMesh)?;
        let layout = checked(device, "the bind group layout of meshes", || {
            group_layout(device, table, group, wgpu::ShaderStages::VERTEX)
        })?;
        Ok(Self { layout, group: group.group, pipeline: PipelineHandle(0), drawing: Drawing::Plain })
    }
}

/// Where vertices lie in a buffer.
#[derive(Debug, Clone)]
pub(crate) struct Fetched<'a> {
    pub(crate) buffer: &'a wgpu::Buffer,
    /// From the first to the end of the last, bytes.
    pub(crate) range: Range<u64>,
    pub(crate) stride_bytes: u32,
    pub(crate) format: wgpu::VertexFormat,
}

/// The buffers of a caster as one bind group.
#[derive(Debug, Clone)]
pub(crate) struct StretchedMesh {
    group: wgpu::BindGroup,
    number: u32,
    pub(crate) pipeline: PipelineHandle,
    pub(crate) drawing: Drawing,
}

impl StretchedMesh {
    /// Binds the mesh for the draws that follow.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass) {
        pass.set_bind_group(self.number, &self.group, &[]);
    }
}

impl Stretched {
    /// Binds the buffers of a mesh; `uvs` are those of its alpha mask.
    pub(crate) fn mesh(
        &self,
        device: &wgpu::Device,
        table: &CaseTable,
        positions: &Fetched,
        indices: Option<&BoundIndices>,
        uvs: Option<&Fetched>,
        corners: u32,
    ) -> Result<StretchedMesh, ServiceError> {
        let layout = match uvs {
            None => &self.opaque,
            Some(_) => self.tested.as_ref().ok_or(MeshError::MaskNotDeclared)?,
        };
        // A fan has four corners for each of the mesh's.
        if corners.checked_mul(4).is_none() {
            return Err(MeshError::TooManyCorners { corners }.into());
        }

        // Bind from an aligned offset and count from there.
        let limits = device.limits();
        let positions_part = Part::new(positions.buffer, "vertices", &positions.range, &limits)?;
        let (index_buffer, index_part, index_kind) = match indices {
            None => (positions.buffer, positions_part.clone(), 0),
            Some((buffer, range, format)) => {
                let part = Part::new(buffer, "indices", range, &limits)?;
                (buffer, part, if *format == wgpu::IndexFormat::Uint16 { 1 } else { 2 })
            }
        };
        let uvs_part = match uvs {
            None => None,
            Some(uvs) => Some((uvs, Part::new(uvs.buffer, "texture coordinates", &uvs.range, &limits)?)),
        };
        let index_bytes = if index_kind == 1 { 2 } else { 4 };
        let (uv_first, uv_stride, uv_format) = match &uvs_part {
            None => (0, 0, 0),
            Some((uvs, part)) => (part.skipped / 4, u64::from(uvs.stride_bytes / 4), code(uvs.format)?),
        };
        let numbers = [
            positions_part.skipped / 4,
            u64::from(positions.stride_bytes / 4),
            index_part.skipped / index_bytes,
            index_kind,
            u64::from(code(positions.format)?),
            uv_first,
            uv_stride,
            u64::from(uv_format),
        ];

        // Every number is below an alignment or a stride.
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| (*number as u32).to_le_bytes()).collect();
        let layout_buffer = filled_buffer(device, &bytes)?;
        let declared = table.groups.iter().find(|group| {
            group.content == GroupContent::CasterMesh
                && group.bindings.iter().any(|binding| binding.kind == BindingKind::MeshUvs) == uvs.is_some()
        });
        let declared = declared.ok_or_else(|| incomplete(table, "bind group of meshes"))?;
        let group = checked(device, "the buffers of a mesh", || {
            bind_group(device, &layout.layout, declared, |kind| match kind {
                BindingKind::MeshLayout => Some(layout_buffer.as_entire_binding()),
                BindingKind::MeshPositions => Some(positions_part.resource(positions.buffer)),
                BindingKind::MeshIndices => Some(index_part.resource(index_buffer)),
                BindingKind::MeshUvs => uvs_part.as_ref().map(|(uvs, part)| part.resource(uvs.buffer)),
                _ => None,
            })
        })?;
        Ok(StretchedMesh { group, number: layout.group, pipeline: layout.pipeline, drawing: layout.drawing })
    }
}

/// A part of a buffer that begins where bindings may begin.
#[derive(Debug, Clone)]
struct Part {
    offset: u64,
    size: u64,
    /// Bytes of the part before what it was made for.
    skipped: u64,
}

impl Part {
    fn new(
        buffer: &wgpu::Buffer,
        what: &'static str,
        range: &Range<u64>,
        limits: &wgpu::Limits,
    ) -> Result<Self, MeshError> {
        let alignment = u64::from(limits.min_storage_buffer_offset_alignment.max(4));
        let offset = range.start - range.start % alignment;
        let end = range.end.next_multiple_of(4);
        in_buffer(buffer, what, wgpu::BufferUsages::STORAGE, end)?;
        let (size, limit) = (end - offset, limits.max_storage_buffer_binding_size);
        if size > limit {
            return Err(MeshError::TooLarge { what, bytes: size, limit });
        }
        Ok(Self { offset, size, skipped: range.start - offset })
    }

    fn resource<'a>(&self, buffer: &'a wgpu::Buffer) -> wgpu::BindingResource<'a> {
        let size = wgpu::BufferSize::new(self.size);
        wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer, offset: self.offset, size })
    }
}

/// How [`BindingKind::MeshLayout`] spells a format.
fn code(format: wgpu::VertexFormat) -> Result<u32, MeshError> {
    use wgpu::VertexFormat as Format;
    match format {
        Format::Float32x2 | Format::Float32x3 | Format::Float32x4 => Ok(0),
        Format::Float16x2 | Format::Float16x4 => Ok(1),
        Format::Snorm16x2 | Format::Snorm16x4 => Ok(2),
        Format::Unorm16x2 | Format::Unorm16x4 => Ok(3),
        Format::Snorm8x2 | Format::Snorm8x4 => Ok(4),
        Format::Unorm8x2 | Format::Unorm8x4 => Ok(5),
        Format::Unorm10_10_10_2 => Ok(6),
        other => Err(MeshError::Format(other)),
    }
}

fn filled_buffer(device: &wgpu::Device, bytes: &[u8]) -> Result<wgpu::Buffer, ServiceError> {
    let filled = checked(device, "the layout of a mesh", || {
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("cssm mesh layout"),
            size: bytes.len() as u64,
            usage: wgpu::BufferUsages::UNIFORM,
            mapped_at_creation: true,
        });
        let filled = buffer.get_mapped_range_mut(..).map(|mut mapped| mapped.copy_from_slice(bytes));
        buffer.unmap();
        filled.map(|()| buffer)
    })?;
    filled.map_err(|_| ServiceError::DeviceLost)
}
