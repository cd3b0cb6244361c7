//! The map: one depth texture for all facets, and the samplers that read it.

use cssm_core::case::DepthFormat;
use cssm_core::plan::DepthOrder;
use cssm_core::table::{BindingKind, CaseTable, ConstantKind, ConstantValue, ShaderKind};

use crate::depth_order::ByOrder;

/// The depth texture that facets share.
#[derive(Debug)]
pub(crate) struct Atlas {
    pub(crate) texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
    comparison: ByOrder<wgpu::Sampler>,
    gather: wgpu::Sampler,
    linear: wgpu::Sampler,
    /// What the prefilter writes, where a case has one.
    pub(crate) prefiltered: Option<Prefiltered>,
}

/// Moments of the map's depths, or masks of planes.
#[derive(Debug)]
pub(crate) struct Prefiltered {
    /// Blurred along rows alone.
    pub(crate) rows: wgpu::TextureView,
    /// Blurred.
    pub(crate) blurred: wgpu::TextureView,
}

impl Atlas {
    /// The map in a texture of its own, or in one that other tables of equal maps share; to be called under an error
    /// scope.
    pub(crate) fn new(device: &wgpu::Device, table: &CaseTable, shared: Option<&wgpu::Texture>) -> Self {
        let texture = shared.cloned().unwrap_or_else(|| own_texture(device, table));
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        let comparison = ByOrder::new(table, |order| {
            let compare = match order {
                DepthOrder::Standard => wgpu::CompareFunction::LessEqual,
                DepthOrder::Reversed => wgpu::CompareFunction::GreaterEqual,
            };
            device.create_sampler(&wgpu::SamplerDescriptor {
                label: Some("cssm comparison"),
                mag_filter: wgpu::FilterMode::Linear,
                min_filter: wgpu::FilterMode::Linear,
                compare: Some(compare),
                ..Default::default()
            })
        });
        let gather = device
            .create_sampler(&wgpu::SamplerDescriptor { label: Some("cssm gather"), ..Default::default() });
        let linear = device.create_sampler(&wgpu::SamplerDescriptor {
            label: Some("cssm linear"),
            mag_filter: wgpu::FilterMode::Linear,
            min_filter: wgpu::FilterMode::Linear,
            ..Default::default()
        });
        let prefiltered = table.pass(ShaderKind::PrefilterRows).map(|_| Prefiltered {
            rows: prefiltered_texture(device, "cssm prefiltered rows", table),
            blurred: prefiltered_texture(device, "cssm prefiltered", table),
        });
        Self { texture, view, comparison, gather, linear, prefiltered }
    }

    /// What to bind for the map or what the prefilter made of it.
    pub(crate) fn texture_resource(&self, kind: BindingKind) -> Option<wgpu::BindingResource<'_>> {
        let prefiltered = self.prefiltered.as_ref();
        let view = match kind {
            BindingKind::Map => Some(&self.view),
            BindingKind::MomentRows | BindingKind::GroundRows => prefiltered.map(|images| &images.rows),
            BindingKind::Moments | BindingKind::GroundMasks => prefiltered.map(|images| &images.blurred),
            _ => None,
        };
        view.map(wgpu::BindingResource::TextureView)
    }

    /// What to bind for the map, what the prefilter made of it, or one of its samplers.
    pub(crate) fn resource(&self, kind: BindingKind, order: DepthOrder) -> Option<wgpu::BindingResource<'_>> {
        match kind {
            BindingKind::ComparisonSampler => Some(wgpu::BindingResource::Sampler(self.comparison.of(order))),
            BindingKind::GatherSampler => Some(wgpu::BindingResource::Sampler(&self.gather)),
            BindingKind::GroundSampler => Some(wgpu::BindingResource::Sampler(&self.linear)),
            _ => self.texture_resource(kind),
        }
    }
}

/// A texture of the map's size for what the prefilter writes.
fn prefiltered_texture(device: &wgpu::Device, label: &str, table: &CaseTable) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: table.map_width, height: table.map_height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: prefiltered_format(table),
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// Texel format of what the prefilter writes: mean and mean square, or a channel for each plane.
pub(crate) fn prefiltered_format(table: &CaseTable) -> wgpu::TextureFormat {
    match table.constant(ConstantKind::GroundPlanes).map(|constant| constant.value) {
        None => wgpu::TextureFormat::Rg32Float,
        Some(ConstantValue::U32(1)) => wgpu::TextureFormat::R8Unorm,
        Some(ConstantValue::U32(2)) => wgpu::TextureFormat::Rg8Unorm,
        Some(_) => wgpu::TextureFormat::Rgba8Unorm,
    }
}

fn own_texture(device: &wgpu::Device, table: &CaseTable) -> wgpu::Texture {
    let label = format!("{} map", table.prefix);
    depth_texture(device, &label, texture_format(table.map_format), table.map_width, table.map_height)
}

/// A depth texture to draw into, to read and to copy from.
pub(crate) fn depth_texture(
    device: &wgpu::Device,
    label: &str,
    format: wgpu::TextureFormat,
    width: u32,
    height: u32,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT
            | wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

/// The texture format of a declared one.
pub(crate) const fn texture_format(format: DepthFormat) -> wgpu::TextureFormat {
    match format {
        DepthFormat::Depth32Float => wgpu::TextureFormat::Depth32Float,
        DepthFormat::Depth16Unorm => wgpu::TextureFormat::Depth16Unorm,
    }
}
