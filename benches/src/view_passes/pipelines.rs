//! Pipelines of the view's own passes.

use cssm_lab::gpu::{Gpu, GpuError};

use super::geometry::{INSTANCE_BYTES, VERTEX_BYTES};
use super::{COLOUR_FORMAT, DEPTH_FORMAT, NORMAL_FORMAT};

const SHADERS: &str = include_str!("../shaders/view.wgsl");

const VERTEX_ATTRIBUTES: [wgpu::VertexAttribute; 1] = wgpu::vertex_attr_array![0 => Float32x3];
const INSTANCE_ATTRIBUTES: [wgpu::VertexAttribute; 4] =
    wgpu::vertex_attr_array![1 => Float32x4, 2 => Float32x4, 3 => Float32x4, 4 => Float32x4];

/// Both pipelines and the layouts of their groups.
#[derive(Debug)]
pub(super) struct Pipelines {
    pub(super) see: wgpu::RenderPipeline,
    pub(super) shade: wgpu::RenderPipeline,
    pub(super) see_layout: wgpu::BindGroupLayout,
    pub(super) shade_layout: wgpu::BindGroupLayout,
}

impl Pipelines {
    pub(super) fn new(gpu: &Gpu) -> Result<Self, GpuError> {
        gpu.checked("the view's pipelines", || {
            let shaders = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("view"),
                source: wgpu::ShaderSource::Wgsl(SHADERS.into()),
            });
            let see_layout = layout(gpu, &[record_entry()]);
            let entries = [record_entry(), texture_entry(1), texture_entry(2), texture_entry(3)];
            let shade_layout = layout(gpu, &entries);
            Self {
                see: see(gpu, &shaders, &see_layout),
                shade: shade(gpu, &shaders, &shade_layout),
                see_layout,
                shade_layout,
            }
        })
    }
}

fn see(gpu: &Gpu, shaders: &wgpu::ShaderModule, group: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
    let buffer = |array_stride, step_mode, attributes| {
        Some(wgpu::VertexBufferLayout { array_stride, step_mode, attributes })
    };
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("see"),
        layout: Some(&pipeline_layout(gpu, group)),
        vertex: wgpu::VertexState {
            module: shaders,
            entry_point: Some("view_vertex"),
            compilation_options: Default::default(),
            buffers: &[
                buffer(VERTEX_BYTES, wgpu::VertexStepMode::Vertex, &VERTEX_ATTRIBUTES),
                buffer(INSTANCE_BYTES, wgpu::VertexStepMode::Instance, &INSTANCE_ATTRIBUTES),
            ],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format: DEPTH_FORMAT,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Greater),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: shaders,
            entry_point: Some("view_fragment"),
            compilation_options: Default::default(),
            targets: &[Some(NORMAL_FORMAT.into()), Some(COLOUR_FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn shade(gpu: &Gpu, shaders: &wgpu::ShaderModule, group: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("shade"),
        layout: Some(&pipeline_layout(gpu, group)),
        vertex: wgpu::VertexState {
            module: shaders,
            entry_point: Some("shade_vertex"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: shaders,
            entry_point: Some("shade_fragment"),
            compilation_options: Default::default(),
            targets: &[Some(COLOUR_FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn layout(gpu: &Gpu, entries: &[wgpu::BindGroupLayoutEntry]) -> wgpu::BindGroupLayout {
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("view"), entries })
}

fn pipeline_layout(gpu: &Gpu, group: &wgpu::BindGroupLayout) -> wgpu::PipelineLayout {
    gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("view"),
        bind_group_layouts: &[Some(group)],
        immediate_size: 0,
    })
}

const fn record_entry() -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding: 0,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

const fn texture_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: false },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    }
}
