//! Bind group layouts and bindings, from the table's words to wgpu's.

use std::num::NonZeroU64;

use cssm_core::table::{
    BindGroup, Binding, BindingKind, CaseTable, GroupContent, Pass, RecordKind, ShaderKind,
};

use crate::error::ServiceError;

/// The layout of a table's group; visible to `stages`.
pub(crate) fn group_layout(
    device: &wgpu::Device,
    table: &CaseTable,
    group: &BindGroup,
    stages: wgpu::ShaderStages,
) -> wgpu::BindGroupLayout {
    let entries = group_entries(table, group, stages);
    let label = format!("{} {}", table.prefix, group.content.label());
    device
        .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(&label), entries: &entries })
}

/// The entries of that layout.
pub(crate) fn group_entries(
    table: &CaseTable,
    group: &BindGroup,
    stages: wgpu::ShaderStages,
) -> Vec<wgpu::BindGroupLayoutEntry> {
    let entry = |binding: &Binding| wgpu::BindGroupLayoutEntry {
        binding: binding.binding,
        visibility: stages,
        ty: binding_type(table, binding.kind),
        count: None,
    };
    group.bindings.iter().map(entry).collect()
}

/// A bind group of a table's group; `resource` finds what to bind.
pub(crate) fn bind_group<'a>(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    group: &BindGroup,
    resource: impl Fn(BindingKind) -> Option<wgpu::BindingResource<'a>>,
) -> wgpu::BindGroup {
    let entries: Vec<_> = group
        .bindings
        .iter()
        .filter_map(|binding| {
            Some(wgpu::BindGroupEntry { binding: binding.binding, resource: resource(binding.kind)? })
        })
        .collect();
    let label = Some(group.content.label());
    device.create_bind_group(&wgpu::BindGroupDescriptor { label, layout, entries: &entries })
}

/// The group that holds the plan and the map, whichever shader uses it: equal contents have equal layouts.
pub(crate) fn shadow_group(table: &CaseTable) -> Option<&BindGroup> {
    table.groups.iter().find(|group| group.content == GroupContent::Shadow)
}

/// A group that the table must have.
pub(crate) fn required_group(
    table: &CaseTable,
    shader: ShaderKind,
    content: GroupContent,
) -> Result<&BindGroup, ServiceError> {
    table.group(shader, content).ok_or_else(|| incomplete(table, "bind group of a pass"))
}

/// A pass that the table must have.
pub(crate) fn required_pass(table: &CaseTable, shader: ShaderKind) -> Result<&Pass, ServiceError> {
    table.pass(shader).ok_or_else(|| incomplete(table, "capture pass"))
}

/// The module of a shader that the table must have.
pub(crate) fn shader_module(
    device: &wgpu::Device,
    table: &CaseTable,
    shader: ShaderKind,
) -> Result<wgpu::ShaderModule, ServiceError> {
    let generated = table.shader(shader).ok_or_else(|| incomplete(table, "shader"))?;
    let label = format!("{} {}", table.prefix, shader.name());
    crate::scope::checked(device, "a shader module", || {
        device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some(&label),
            source: wgpu::ShaderSource::Wgsl(generated.wgsl.as_ref().into()),
        })
    })
}

/// The pipeline of a pass that writes one image, triangles without vertex buffers.
pub(crate) fn image_pipeline(
    device: &wgpu::Device,
    label: &str,
    groups: &[Option<&wgpu::BindGroupLayout>],
    module: &wgpu::ShaderModule,
    pass: &Pass,
    target: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some(label),
        bind_group_layouts: groups,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(label),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(&pass.vertex),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: pass.fragment.as_deref(),
            compilation_options: Default::default(),
            targets: &[Some(target.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// Bytes of a record; zero where the case has none.
pub(crate) fn record_bytes(table: &CaseTable, kind: RecordKind) -> u32 {
    table.record(kind).map_or(0, |record| record.size_bytes)
}

pub(crate) fn incomplete(table: &CaseTable, what: &'static str) -> ServiceError {
    ServiceError::IncompleteTable { case: table.case.to_string(), what }
}

/// Bytes of [`BindingKind::MeshLayout`]: eight numbers.
const MESH_LAYOUT_BYTES: u64 = 32;

fn binding_type(table: &CaseTable, kind: BindingKind) -> wgpu::BindingType {
    let texture = |sample_type| wgpu::BindingType::Texture {
        sample_type,
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    match kind {
        BindingKind::Uniform { record, dynamic_offset } => wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: dynamic_offset,
            min_binding_size: NonZeroU64::new(u64::from(record_bytes(table, record))),
        },
        BindingKind::MeshLayout => wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: NonZeroU64::new(MESH_LAYOUT_BYTES),
        },
        BindingKind::MeshPositions | BindingKind::MeshIndices | BindingKind::MeshUvs => {
            wgpu::BindingType::Buffer {
                ty: wgpu::BufferBindingType::Storage { read_only: true },
                has_dynamic_offset: false,
                min_binding_size: None,
            }
        }
        BindingKind::Measured => wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only: false },
            has_dynamic_offset: false,
            min_binding_size: NonZeroU64::new(4 * cssm_core::fit::WORDS as u64),
        },
        BindingKind::Map | BindingKind::SceneDepth => texture(wgpu::TextureSampleType::Depth),
        BindingKind::SceneLinearDepth
        | BindingKind::SceneNormal
        | BindingKind::MomentRows
        | BindingKind::GroundRows
        | BindingKind::Moments => texture(wgpu::TextureSampleType::Float { filterable: false }),
        BindingKind::CasterMask | BindingKind::GroundMasks => {
            texture(wgpu::TextureSampleType::Float { filterable: true })
        }
        BindingKind::CasterMaskSampler | BindingKind::GroundSampler => {
            wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)
        }
        BindingKind::ComparisonSampler => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Comparison),
        BindingKind::GatherSampler => wgpu::BindingType::Sampler(wgpu::SamplerBindingType::NonFiltering),
    }
}

/// Debug labels.
trait Label {
    fn label(self) -> &'static str;
}

impl Label for GroupContent {
    fn label(self) -> &'static str {
        match self {
            Self::CaptureFacet => "capture facet",
            Self::CasterMesh => "caster mesh",
            Self::CasterMask => "caster mask",
            Self::Prefilter => "prefilter",
            Self::MaskInput => "mask input",
            Self::Shadow => "shadow",
            Self::Fit => "fit",
        }
    }
}
