//! Alpha masks of casters: texture coordinates, a texture and the alpha below which the caster has a hole.

use cssm_core::table::{BindingKind, CaseTable, GroupContent, write_caster_mask_record};

use crate::error::ServiceError;
use crate::layout::bind_group;
use crate::mesh::{MeshError, in_buffer};
use crate::scope::checked;

/// The alpha channel of a texture that cuts holes into a mesh; only for cases with `casters: alpha_tested`.
///
/// Texture coordinates are read in the format they are stored in, one for each vertex of the mesh; the texture and
/// the sampler are the engine's own. A texel of the map is a hole where the sampled alpha is below the cutoff.
#[derive(Debug, Clone)]
pub struct AlphaMask<'a> {
    /// Buffer with texture coordinates, which may be the one with positions; needs [`wgpu::BufferUsages::VERTEX`],
    /// and [`wgpu::BufferUsages::STORAGE`] where the case stretches exactly.
    pub uvs: &'a wgpu::Buffer,
    /// Where the texture coordinates of the mesh's first vertex begin in the buffer.
    pub offset_bytes: u64,
    /// Distance between the texture coordinates of vertices.
    pub stride_bytes: u32,
    /// Format of the texture coordinates: any float, normalised or packed format with two or more components.
    pub format: wgpu::VertexFormat,
    /// Two-dimensional texture with an alpha channel that can be filtered; needs
    /// [`wgpu::TextureUsages::TEXTURE_BINDING`].
    pub texture: &'a wgpu::TextureView,
    /// How it is sampled; no comparison.
    pub sampler: &'a wgpu::Sampler,
    /// Alpha in [0, 1] below which the mesh has a hole.
    pub cutoff: f32,
}

/// An alpha mask as a mesh keeps it.
#[derive(Debug, Clone)]
pub(crate) struct BoundMask {
    uvs: wgpu::Buffer,
    range: std::ops::Range<u64>,
    group: wgpu::BindGroup,
}

impl BoundMask {
    /// Binds texture coordinates and texture.
    pub(crate) fn bind(&self, pass: &mut wgpu::RenderPass, slot: u32, group: u32) {
        pass.set_vertex_buffer(slot, self.uvs.slice(self.range.clone()));
        pass.set_bind_group(group, &self.group, &[]);
    }

    /// Creates the bind group of a mask that [`check`] has passed.
    pub(crate) fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        layout: &wgpu::BindGroupLayout,
        mask: &AlphaMask,
        range: std::ops::Range<u64>,
    ) -> Result<Self, ServiceError> {
        let record = write_caster_mask_record(table, mask.cutoff);
        let cutoff = checked(device, "the cutoff of an alpha mask", || {
            let buffer = device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("cssm alpha cutoff"),
                size: record.len() as u64,
                usage: wgpu::BufferUsages::UNIFORM,
                mapped_at_creation: true,
            });
            let filled = buffer.get_mapped_range_mut(..).map(|mut bytes| bytes.copy_from_slice(&record));
            buffer.unmap();
            filled.map(|()| buffer)
        })?;
        let cutoff = cutoff.map_err(|_| ServiceError::DeviceLost)?;
        let declared = table.groups.iter().find(|group| group.content == GroupContent::CasterMask);
        let declared = declared.ok_or(MeshError::MaskNotDeclared)?;

        // What the texture's own facts do not tell, such as the view's dimension, the device checks.
        let group = checked(device, "an alpha mask", || {
            bind_group(device, layout, declared, |kind| match kind {
                BindingKind::Uniform { .. } => Some(cutoff.as_entire_binding()),
                BindingKind::CasterMask => Some(wgpu::BindingResource::TextureView(mask.texture)),
                BindingKind::CasterMaskSampler => Some(wgpu::BindingResource::Sampler(mask.sampler)),
                _ => None,
            })
        });
        let group = group.map_err(|error| match error {
            ServiceError::Refused { reason, .. } => MeshError::MaskTexture { reason }.into(),
            other => other,
        })?;
        Ok(Self { uvs: mask.uvs.clone(), range, group })
    }
}

/// Checks a mask against its buffers, its texture and the device; where its texture coordinates lie.
pub(crate) fn check(
    mask: &AlphaMask,
    device: &wgpu::Device,
    vertex_count: u32,
) -> Result<std::ops::Range<u64>, MeshError> {
    const WHAT: &str = "texture coordinates";
    if !(0.0..=1.0).contains(&mask.cutoff) {
        return Err(MeshError::MaskCutoff(mask.cutoff));
    }
    if !is_uv_format(mask.format) {
        return Err(MeshError::MaskFormat(mask.format));
    }
    let (stride, bytes) = (mask.stride_bytes, mask.format.size());
    let limit = device.limits().max_vertex_buffer_array_stride;
    if u64::from(stride) < bytes
        || !u64::from(stride).is_multiple_of(wgpu::VERTEX_ALIGNMENT)
        || stride > limit
    {
        return Err(MeshError::MaskStride { stride_bytes: stride, format: mask.format, limit });
    }

    // Bind from the first coordinates to the end of the last ones.
    let start = mask.offset_bytes;
    if !start.is_multiple_of(wgpu::VERTEX_ALIGNMENT) {
        let alignment = wgpu::VERTEX_ALIGNMENT;
        return Err(MeshError::Alignment { what: WHAT, offset_bytes: start, alignment });
    }
    let length = u64::from(vertex_count.saturating_sub(1)) * u64::from(stride) + bytes;
    let end = start.saturating_add(length);
    in_buffer(mask.uvs, WHAT, wgpu::BufferUsages::VERTEX, end)?;

    // Read the texture's facts.
    let texture = mask.texture.texture();
    let filtered = wgpu::TextureSampleType::Float { filterable: true };
    let fault = if !texture.usage().contains(wgpu::TextureUsages::TEXTURE_BINDING) {
        Some("it lacks the usage TEXTURE_BINDING")
    } else if texture.dimension() != wgpu::TextureDimension::D2 || texture.sample_count() != 1 {
        Some("it is not a two-dimensional texture with one sample")
    } else if texture.format().sample_type(None, Some(device.features())) != Some(filtered) {
        Some("its format cannot be filtered as floats")
    } else if texture.format().components() < 4 {
        Some("its format has no alpha channel")
    } else {
        None
    };
    match fault {
        Some(fault) => Err(MeshError::MaskTexture { reason: fault.to_owned() }),
        None => Ok(start..end),
    }
}

/// Whether a vertex fetch yields at least two floats.
const fn is_uv_format(format: wgpu::VertexFormat) -> bool {
    use wgpu::VertexFormat as Format;
    matches!(
        format,
        Format::Float32x2
            | Format::Float32x3
            | Format::Float32x4
            | Format::Float16x2
            | Format::Float16x4
            | Format::Snorm16x2
            | Format::Snorm16x4
            | Format::Unorm16x2
            | Format::Unorm16x4
            | Format::Snorm8x2
            | Format::Snorm8x4
            | Format::Unorm8x2
            | Format::Unorm8x4
            | Format::Unorm10_10_10_2
    )
}
