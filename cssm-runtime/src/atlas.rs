//! The map: one depth texture for all facets, and the samplers that read it.

use cssm_core::case::DepthFormat;
use cssm_core::plan::DepthOrder;
use cssm_core::table::{BindingKind, CaseTable, ShaderKind};

use crate::depth_order::ByOrder;

/// The depth texture that facets share.
#[derive(Debug)]
pub(crate) struct Atlas {
    pub(crate) texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
    comparison: ByOrder<wgpu::Sampler>,
    gather: wgpu::Sampler,
    /// What the prefilter writes, where a case has one.
    pub(crate) moments: Option<Moments>,
}

/// Moments of the map's depths.
#[derive(Debug)]
pub(crate) struct Moments {
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
        let moments = table.pass(ShaderKind::PrefilterRows).map(|_| Moments {
            rows: moment_texture(device, "cssm moment rows", table),
            blurred: moment_texture(device, "cssm moments", table),
        });
        Self { texture, view, comparison, gather, moments }
    }

    /// What to bind for the map or its moments.
    pub(crate) fn texture_resource(&self, kind: BindingKind) -> Option<wgpu::BindingResource<'_>> {
        let moments = self.moments.as_ref();
        let view = match kind {
            BindingKind::Map => Some(&self.view),
            BindingKind::MomentRows => moments.map(|moments| &moments.rows),
            BindingKind::Moments => moments.map(|moments| &moments.blurred),
            _ => None,
        };
        view.map(wgpu::BindingResource::TextureView)
    }

    /// What to bind for the map, its moments or one of its samplers.
    pub(crate) fn resource(&self, kind: BindingKind, order: DepthOrder) -> Option<wgpu::BindingResource<'_>> {
        match kind {
            BindingKind::ComparisonSampler => Some(wgpu::BindingResource::Sampler(self.comparison.of(order))),
            BindingKind::GatherSampler => Some(wgpu::BindingResource::Sampler(&self.gather)),
            _ => self.texture_resource(kind),
        }
    }
}

/// A texture of the map's size for mean and mean square.
fn moment_texture(device: &wgpu::Device, label: &str, table: &CaseTable) -> wgpu::TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width: table.map_width, height: table.map_height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: MOMENT_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}

/// Texel format of moments.
pub(crate) const MOMENT_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Float;

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
