//! The generated function called from a material of the lab's own, as an engine would.

use cssm_core::case::{Axes, Bias};
use cssm_core::table::{CaseTable, GroupContent, ShaderKind};
use cssm_core::{LightCase, case};
use cssm_runtime::ShadowService;

use super::surface::Surface;
use super::{Gpu, GpuError, float_entry};

/// Format of visibility images.
pub(super) const VISIBILITY_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Float;

/// A pipeline that writes the function's result for every traced pixel.
#[derive(Debug)]
pub(super) struct FunctionPipeline {
    pipeline: wgpu::RenderPipeline,
    pixel_layout: wgpu::BindGroupLayout,
    pixel_group: u32,
    shadow_group: u32,
    axes: Axes,
}

impl FunctionPipeline {
    pub(super) fn new(
        gpu: &Gpu,
        case: &LightCase,
        table: &CaseTable,
        service: &ShadowService,
    ) -> Result<Self, GpuError> {
        let not_declared = || GpuError::NotDeclared { case: case.name.clone(), method: "function" };
        let shader = table.shader(ShaderKind::Function).ok_or_else(not_declared)?;
        let group = table.group(ShaderKind::Function, GroupContent::Shadow).ok_or_else(not_declared)?;
        let shadow_layout = service.shadow_bind_group_layout().ok_or_else(not_declared)?;
        let shadow_group = group.group;
        let pixel_group = u32::from(shadow_group == 0);
        let source = format!("{}\n{}", shader.wgsl, material(&case.prefix, pixel_group, reads_normal(case)));

        gpu.checked("the lab's material", || {
            let device = &gpu.device;
            let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some("lab material"),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            });
            let pixel_layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("lab pixels"),
                entries: &[float_entry(0), float_entry(1)],
            });
            let mut groups = vec![None; 1 + shadow_group.max(pixel_group) as usize];
            groups[shadow_group as usize] = Some(shadow_layout);
            groups[pixel_group as usize] = Some(&pixel_layout);
            let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("lab material"),
                bind_group_layouts: &groups,
                immediate_size: 0,
            });
            let pipeline = device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some("lab material"),
                layout: Some(&layout),
                vertex: wgpu::VertexState {
                    module: &module,
                    entry_point: Some("lab_cover_vertex"),
                    compilation_options: Default::default(),
                    buffers: &[],
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: None,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module: &module,
                    entry_point: Some("lab_material_fragment"),
                    compilation_options: Default::default(),
                    targets: &[Some(VISIBILITY_FORMAT.into())],
                }),
                multiview_mask: None,
                cache: None,
            });
            Self { pipeline, pixel_layout, pixel_group, shadow_group, axes: case.axes }
        })
    }

    /// Binds a surface.
    pub(super) fn bind(&self, gpu: &Gpu, surface: &Surface) -> Result<wgpu::BindGroup, GpuError> {
        let entry = |binding, view| wgpu::BindGroupEntry {
            binding,
            resource: wgpu::BindingResource::TextureView(view),
        };
        let vectors = surface.vectors(self.axes);
        gpu.checked("the lab's pixels", || {
            gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("lab pixels"),
                layout: &self.pixel_layout,
                entries: &[entry(0, &vectors.positions), entry(1, &vectors.normals)],
            })
        })
    }

    /// Records the pass over the whole target.
    pub(super) fn record(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        pixels: &wgpu::BindGroup,
        shadow: Option<&wgpu::BindGroup>,
        target: &wgpu::TextureView,
        timestamps: Option<wgpu::RenderPassTimestampWrites<'_>>,
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("lab material"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::WHITE),
                    store: wgpu::StoreOp::Store,
                },
            })],
            timestamp_writes: timestamps,
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(self.pixel_group, pixels, &[]);
        pass.set_bind_group(self.shadow_group, shadow, &[]);
        pass.draw(0..3, 0..1);
    }
}

/// Whether the generated function takes the geometric normal.
const fn reads_normal(case: &LightCase) -> bool {
    match case.bias {
        Bias::Slope { .. } | Bias::ReceiverPlane => true,
        Bias::None | Bias::Constant { .. } | Bias::WorldTexel { .. } => false,
    }
}

/// The method a case offers: the function if it declares one, else the mask.
pub(super) fn offers_function(case: &LightCase) -> bool {
    case.resolve.iter().any(|resolve| matches!(resolve, case::Resolve::Function { .. }))
}

/// Entry points that call the function of a prefix for every traced pixel.
fn material(prefix: &str, group: u32, reads_normal: bool) -> String {
    let normal = if reads_normal { ", textureLoad(lab_material_normals, texel, 0).xyz" } else { "" };
    format!(
        "
@group({group}) @binding(0) var lab_material_positions: texture_2d<f32>;
@group({group}) @binding(1) var lab_material_normals: texture_2d<f32>;

@vertex
fn lab_cover_vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {{
    let corner = vec2<f32>(vec2<u32>((index << 1u) & 2u, index & 2u));
    return vec4<f32>(2.0 * corner - 1.0, 0.0, 1.0);
}}

@fragment
fn lab_material_fragment(@builtin(position) place: vec4<f32>) -> @location(0) vec4<f32> {{
    let texel = vec2<i32>(place.xy);
    let position = textureLoad(lab_material_positions, texel, 0);
    if position.w == 0.0 {{
        return vec4<f32>(1.0);
    }}
    return vec4<f32>({prefix}_visibility(position.xyz{normal}), 0.0, 0.0, 1.0);
}}
"
    )
}
