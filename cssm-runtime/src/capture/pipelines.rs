//! Capture pipelines: one for each vertex format in use, with and without alpha mask, for each depth order.

use cssm_core::case::Stretch;
use cssm_core::plan::DepthOrder;
use cssm_core::table::{CaseTable, GroupContent, ShaderKind};

use super::stretched::{MeshLayout, Stretched, fetches_by_itself};
use super::{INSTANCE_SLOT, POSITION_SLOT, UV_SLOT};
use crate::atlas::texture_format;
use crate::commands::{Drawing, PipelineHandle};
use crate::cull::InstanceRows;
use crate::depth_order::ByOrder;
use crate::error::ServiceError;
use crate::layout::{group_layout, incomplete, required_group, required_pass, shader_module};
use crate::scope::checked;

/// Capture pipelines, one for each vertex format and stride in use.
#[derive(Debug)]
pub(crate) struct CapturePipelines {
    opaque: CaptureProgram,
    tested: Option<TestedProgram>,
    unclipped_depth: bool,
    pipelines: Vec<(Option<VertexKey>, ByOrder<wgpu::RenderPipeline>)>,
    stretched: Option<Stretched>,
}

/// What distinguishes capture pipelines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct VertexKey {
    pub(crate) positions: Attribute,
    /// Texture coordinates, for casters with an alpha mask.
    pub(crate) uvs: Option<Attribute>,
}

/// A vertex attribute in a buffer of its own binding.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Attribute {
    pub(crate) format: wgpu::VertexFormat,
    pub(crate) stride_bytes: u32,
}

/// Module, entry points and layout of one capture shader.
#[derive(Debug)]
struct CaptureProgram {
    shader: ShaderKind,
    module: wgpu::ShaderModule,
    vertex: String,
    fragment: Option<String>,
    layout: wgpu::PipelineLayout,
}

/// The program for casters with an alpha mask.
#[derive(Debug)]
struct TestedProgram {
    program: CaptureProgram,
    mask: TestedLayout,
}

/// The bind group of alpha masks.
#[derive(Debug)]
struct TestedLayout {
    layout: wgpu::BindGroupLayout,
    group: u32,
}

impl CapturePipelines {
    /// The programs that the table declares and the device can run.
    pub(crate) fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        clamp_in_fragments: bool,
        facet_layout: &wgpu::BindGroupLayout,
    ) -> Result<Self, ServiceError> {
        let unclipped_depth = runs_unclipped(device.features(), table) && !clamp_in_fragments;
        let (opaque, tested) = if unclipped_depth {
            (ShaderKind::Capture, ShaderKind::CaptureTested)
        } else {
            (ShaderKind::CaptureClamped, ShaderKind::CaptureTestedClamped)
        };
        if fetches_by_itself(table) {
            return Self::stretching(device, table, opaque, unclipped_depth, facet_layout);
        }
        let opaque = CaptureProgram::new(device, table, opaque, &[Some(facet_layout)])?;
        let tested = match table.pass(tested) {
            Some(_) => Some(TestedProgram::new(device, table, tested, facet_layout)?),
            None => None,
        };
        let mut pipelines = Self { opaque, tested, unclipped_depth, pipelines: Vec::new(), stretched: None };

        // Create the most common ones now, so that faulty shaders are refused here and not at the first mesh.
        let positions = Attribute { format: wgpu::VertexFormat::Float32x3, stride_bytes: 12 };
        pipelines.handle(device, table, VertexKey { positions, uvs: None })?;
        if pipelines.tested.is_some() {
            let uvs = Some(Attribute { format: wgpu::VertexFormat::Float32x2, stride_bytes: 8 });
            pipelines.handle(device, table, VertexKey { positions, uvs })?;
        }
        Ok(pipelines)
    }

    /// The programs of a table whose shaders fetch vertices by themselves: three pipelines, whatever the vertex formats.
    fn stretching(
        device: &wgpu::Device,
        table: &CaseTable,
        ordinary: ShaderKind,
        unclipped_depth: bool,
        facet_layout: &wgpu::BindGroupLayout,
    ) -> Result<Self, ServiceError> {
        let mut opaque = MeshLayout::new(device, table, ordinary)?;
        let groups = |mesh: &MeshLayout| (mesh.group as usize, mesh.layout.clone());
        let with_mesh = |(group, layout): (usize, wgpu::BindGroupLayout), mask: Option<&TestedLayout>| {
            let count = 1 + group.max(mask.map_or(0, |mask| mask.group as usize));
            let mut groups = vec![None; count];
            groups[0] = Some(facet_layout.clone());
            groups[group] = Some(layout);
            if let Some(mask) = mask {
                groups[mask.group as usize] = Some(mask.layout.clone());
            }
            groups
        };
        let program = |shader, groups: Vec<Option<wgpu::BindGroupLayout>>| {
            let groups: Vec<_> = groups.iter().map(Option::as_ref).collect();
            CaptureProgram::new(device, table, shader, &groups)
        };
        let ordinary = program(ordinary, with_mesh(groups(&opaque), None))?;
        let bent = program(ShaderKind::CaptureBent, with_mesh(groups(&opaque), None))?;
        let mut pipelines = Vec::new();
        let mut add = |program: &CaptureProgram, unclipped_depth: bool| {
            let create = |order| program.pipeline(device, table, None, order, unclipped_depth);
            let created = checked(device, "a capture pipeline", || ByOrder::new(table, create))?;
            pipelines.push((None, created));
            Ok::<_, ServiceError>(PipelineHandle(pipelines.len() as u32 - 1))
        };
        opaque.pipeline = add(&ordinary, unclipped_depth)?;
        let bound_texels = match table.stretch {
            Stretch::Exact { bound_texels } => bound_texels as f32,
            Stretch::None | Stretch::Vertex => 0.0,
        };
        opaque.drawing = Drawing::Both { fans: add(&bent, false)?, bound_texels };

        // Casters with a mask have a fragment stage in any case: one pipeline draws all their triangles.
        let shader = ShaderKind::CaptureBentTested;
        let (tested, tested_layout) = match table.pass(shader) {
            None => (None, None),
            Some(_) => {
                let mask = TestedLayout::new(device, table, shader)?;
                let mut layout = MeshLayout::new(device, table, shader)?;
                let program = program(shader, with_mesh(groups(&layout), Some(&mask)))?;
                layout.pipeline = add(&program, false)?;
                layout.drawing = Drawing::Fans;
                (Some(TestedProgram { program, mask }), Some(layout))
            }
        };
        let stretched = Some(Stretched { opaque, tested: tested_layout });
        Ok(Self { opaque: ordinary, tested, unclipped_depth, pipelines, stretched })
    }

    /// How meshes are bound whose vertices the shaders fetch by themselves; `None` where the pipeline fetches them.
    pub(crate) fn stretched(&self) -> Option<&Stretched> {
        self.stretched.as_ref()
    }

    /// Which of the two shaders for casters without a mask runs.
    pub(crate) fn shader(&self) -> ShaderKind {
        self.opaque.shader
    }

    /// Layout of the bind groups of alpha masks, if the case declares any.
    pub(crate) fn mask_layout(&self) -> Option<&wgpu::BindGroupLayout> {
        self.tested.as_ref().map(|tested| &tested.mask.layout)
    }

    /// Number of the bind group of alpha masks.
    pub(super) fn mask_group(&self) -> u32 {
        self.tested.as_ref().map_or(0, |tested| tested.mask.group)
    }

    /// The pipeline of a handle for a depth order.
    pub(super) fn pipeline(
        &self,
        handle: PipelineHandle,
        order: DepthOrder,
    ) -> Option<&wgpu::RenderPipeline> {
        self.pipelines.get(handle.0 as usize).map(|(_, pipelines)| pipelines.of(order))
    }

    /// The pipelines for a vertex format, created on first use.
    pub(crate) fn handle(
        &mut self,
        device: &wgpu::Device,
        table: &CaseTable,
        key: VertexKey,
    ) -> Result<PipelineHandle, ServiceError> {
        let known = self.pipelines.iter().position(|(known, _)| *known == Some(key));
        let index = match known {
            Some(index) => index,
            None => {
                let program = match key.uvs {
                    None => &self.opaque,
                    Some(_) => {
                        let tested = self.tested.as_ref();
                        &tested.ok_or_else(|| incomplete(table, "pass for casters with a mask"))?.program
                    }
                };
                let create = |order| program.pipeline(device, table, Some(key), order, self.unclipped_depth);
                let created = checked(device, "a capture pipeline", || ByOrder::new(table, create))?;
                self.pipelines.push((Some(key), created));
                self.pipelines.len() - 1
            }
        };
        Ok(PipelineHandle(index as u32))
    }
}

/// Whether a device leaves depth unclipped and cuts casters as far as a table needs.
pub(crate) fn runs_unclipped(features: wgpu::Features, table: &CaseTable) -> bool {
    let cuts = table.clips == 0 || features.contains(wgpu::Features::CLIP_DISTANCES);
    features.contains(wgpu::Features::DEPTH_CLIP_CONTROL) && cuts
}

impl TestedProgram {
    fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        shader: ShaderKind,
        facet_layout: &wgpu::BindGroupLayout,
    ) -> Result<Self, ServiceError> {
        let facet = required_group(table, shader, GroupContent::CaptureFacet)?.group;
        let mask = TestedLayout::new(device, table, shader)?;
        let mut groups = vec![None; 1 + facet.max(mask.group) as usize];
        groups[facet as usize] = Some(facet_layout);
        groups[mask.group as usize] = Some(&mask.layout);
        let program = CaptureProgram::new(device, table, shader, &groups)?;
        Ok(Self { program, mask })
    }
}

impl TestedLayout {
    fn new(device: &wgpu::Device, table: &CaseTable, shader: ShaderKind) -> Result<Self, ServiceError> {
        let mask = required_group(table, shader, GroupContent::CasterMask)?;
        let layout = checked(device, "the bind group layout of alpha masks", || {
            group_layout(device, table, mask, wgpu::ShaderStages::FRAGMENT)
        })?;
        Ok(Self { layout, group: mask.group })
    }
}

impl CaptureProgram {
    fn new(
        device: &wgpu::Device,
        table: &CaseTable,
        shader: ShaderKind,
        groups: &[Option<&wgpu::BindGroupLayout>],
    ) -> Result<Self, ServiceError> {
        let pass = required_pass(table, shader)?;
        let module = shader_module(device, table, shader)?;
        let layout = checked(device, "the capture pipeline layout", || {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("cssm capture"),
                bind_group_layouts: groups,
                immediate_size: 0,
            })
        })?;
        Ok(Self {
            shader,
            module,
            vertex: pass.vertex.to_string(),
            fragment: pass.fragment.as_ref().map(ToString::to_string),
            layout,
        })
    }

    fn pipeline(
        &self,
        device: &wgpu::Device,
        table: &CaseTable,
        key: Option<VertexKey>,
        order: DepthOrder,
        unclipped_depth: bool,
    ) -> wgpu::RenderPipeline {
        let row = |location: u32| wgpu::VertexAttribute {
            format: wgpu::VertexFormat::Float32x4,
            offset: u64::from(location - 1) * 16,
            shader_location: location,
        };
        let first = |attribute: Attribute, location: u32| {
            [wgpu::VertexAttribute { format: attribute.format, offset: 0, shader_location: location }]
        };
        let positions = key.map(|key| (key.positions, first(key.positions, 0)));
        let uvs = key.and_then(|key| key.uvs).map(|uvs| (uvs, first(uvs, 4)));
        let instance_attributes = [row(1), row(2), row(3)];

        // Buffers in the order of their slots.
        let mut buffers = [None, None, None];
        buffers[POSITION_SLOT as usize] =
            positions.as_ref().map(|(attribute, attributes)| vertex_buffer(attribute, attributes));
        buffers[INSTANCE_SLOT as usize] = Some(wgpu::VertexBufferLayout {
            array_stride: InstanceRows::BYTES,
            step_mode: wgpu::VertexStepMode::Instance,
            attributes: &instance_attributes,
        });
        buffers[UV_SLOT as usize] =
            uvs.as_ref().map(|(attribute, attributes)| vertex_buffer(attribute, attributes));
        let used = if uvs.is_some() { buffers.len() } else { UV_SLOT as usize };

        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some("cssm capture"),
            layout: Some(&self.layout),
            vertex: wgpu::VertexState {
                module: &self.module,
                entry_point: Some(&self.vertex),
                compilation_options: Default::default(),
                buffers: &buffers[..used],
            },
            // Casters are drawn from both sides: which side faces the light says nothing about leaks.
            primitive: wgpu::PrimitiveState { cull_mode: None, unclipped_depth, ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: texture_format(table.map_format),
                depth_write_enabled: Some(true),
                depth_compare: Some(match order {
                    DepthOrder::Standard => wgpu::CompareFunction::Less,
                    DepthOrder::Reversed => wgpu::CompareFunction::Greater,
                }),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState::default(),
            fragment: self.fragment.as_ref().map(|entry| wgpu::FragmentState {
                module: &self.module,
                entry_point: Some(entry),
                compilation_options: Default::default(),
                targets: &[],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

/// The layout of a vertex buffer that holds one attribute.
fn vertex_buffer<'a>(
    attribute: &Attribute,
    attributes: &'a [wgpu::VertexAttribute],
) -> wgpu::VertexBufferLayout<'a> {
    wgpu::VertexBufferLayout {
        array_stride: u64::from(attribute.stride_bytes),
        step_mode: wgpu::VertexStepMode::Vertex,
        attributes,
    }
}
