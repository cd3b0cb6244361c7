//! The one depth texture of all shadows, and a second one with the casters that stay.
//!
//! A depth texture can only be cleared or copied whole, so tiles are emptied and restored by a triangle that fills the
//! viewport. The second texture exists from the first moment on that a shadow has both: a plan that outlives a frame and
//! casters that move.

use cssm_core::facet::Tile;
use cssm_core::plan::DepthOrder;

use crate::atlas::depth_texture;
use crate::capture::confine;
use crate::error::ServiceError;
use crate::scope::checked;

/// Both textures and what prepares their tiles.
#[derive(Debug)]
pub(super) struct Layers {
    pub(super) main: wgpu::Texture,
    pub(super) main_view: wgpu::TextureView,
    still: Option<Still>,
    module: wgpu::ShaderModule,
    empty: [wgpu::RenderPipeline; 2],
}

/// Casters that stay.
#[derive(Debug)]
struct Still {
    view: wgpu::TextureView,
    group: wgpu::BindGroup,
    restore: wgpu::RenderPipeline,
}

impl Layers {
    /// The shared texture.
    pub(super) fn new(
        device: &wgpu::Device,
        format: wgpu::TextureFormat,
        width: u32,
        height: u32,
    ) -> Result<Self, ServiceError> {
        let main = checked(device, "the shared map", || {
            depth_texture(device, "cssm shared map", format, width, height)
        })?;
        let module = checked(device, "the shader of tiles", || {
            device.create_shader_module(wgpu::include_wgsl!("tiles.wgsl"))
        })?;
        let empty = checked(device, "the pipelines that empty tiles", || {
            let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("cssm empty tiles"),
                bind_group_layouts: &[],
                immediate_size: 0,
            });
            ["empty_standard", "empty_reversed"]
                .map(|vertex| fill(device, &layout, &module, format, vertex, None))
        })?;
        let main_view = main.create_view(&wgpu::TextureViewDescriptor::default());
        Ok(Self { main, main_view, still: None, module, empty })
    }

    /// Makes sure that there is a texture for casters that stay.
    pub(super) fn keep_still_casters(&mut self, device: &wgpu::Device) -> Result<(), ServiceError> {
        if self.still.is_some() {
            return Ok(());
        }
        let (format, width, height) = (self.main.format(), self.main.width(), self.main.height());
        self.still = Some(checked(device, "the map of casters that stay", || {
            let texture = depth_texture(device, "cssm still casters", format, width, height);
            let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
            let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("cssm still casters"),
                entries: &[wgpu::BindGroupLayoutEntry {
                    binding: 0,
                    visibility: wgpu::ShaderStages::FRAGMENT,
                    ty: wgpu::BindingType::Texture {
                        sample_type: wgpu::TextureSampleType::Depth,
                        view_dimension: wgpu::TextureViewDimension::D2,
                        multisampled: false,
                    },
                    count: None,
                }],
            });
            let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("cssm still casters"),
                layout: &layout,
                entries: &[wgpu::BindGroupEntry {
                    binding: 0,
                    resource: wgpu::BindingResource::TextureView(&view),
                }],
            });
            let pipeline_layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some("cssm restore tiles"),
                bind_group_layouts: &[Some(&layout)],
                immediate_size: 0,
            });
            let restore =
                fill(device, &pipeline_layout, &self.module, format, "empty_standard", Some("still"));
            Still { view, group, restore }
        })?);
        Ok(())
    }

    /// The texture of casters that stay, if there is one.
    pub(super) fn still_view(&self) -> Option<&wgpu::TextureView> {
        self.still.as_ref().map(|still| &still.view)
    }

    /// Empties a tile of the pass's texture.
    pub(super) fn empty(&self, pass: &mut wgpu::RenderPass, tile: &Tile, order: DepthOrder) {
        let [standard, reversed] = &self.empty;
        pass.set_pipeline(match order {
            DepthOrder::Standard => standard,
            DepthOrder::Reversed => reversed,
        });
        draw(pass, tile);
    }

    /// Brings the casters that stay into a tile of the shared texture.
    pub(super) fn restore(&self, pass: &mut wgpu::RenderPass, tile: &Tile) {
        let Some(still) = &self.still else { return };
        pass.set_pipeline(&still.restore);
        pass.set_bind_group(0, &still.group, &[]);
        draw(pass, tile);
    }
}

fn draw(pass: &mut wgpu::RenderPass, tile: &Tile) {
    confine(pass, tile);
    pass.draw(0..3, 0..1);
}

/// A pipeline that writes depth over the whole viewport, whatever was there.
fn fill(
    device: &wgpu::Device,
    layout: &wgpu::PipelineLayout,
    module: &wgpu::ShaderModule,
    format: wgpu::TextureFormat,
    vertex: &str,
    fragment: Option<&str>,
) -> wgpu::RenderPipeline {
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("cssm tiles"),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: Some(wgpu::DepthStencilState {
            format,
            depth_write_enabled: Some(true),
            depth_compare: Some(wgpu::CompareFunction::Always),
            stencil: wgpu::StencilState::default(),
            bias: wgpu::DepthBiasState::default(),
        }),
        multisample: wgpu::MultisampleState::default(),
        fragment: fragment.map(|entry| wgpu::FragmentState {
            module,
            entry_point: Some(entry),
            compilation_options: Default::default(),
            targets: &[],
        }),
        multiview_mask: None,
        cache: None,
    })
}
