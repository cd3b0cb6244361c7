//! Seeing inside: which facet every pixel of a view reads, and what the tiles of a map hold.
//!
//! Both are passes for debugging, with fixed shaders: they take plans as data, whichever case and technique made them, and
//! leave nothing in shaders and tables where they are not used. Their memory is made for every call.

mod numbers;
mod records;

use cssm_core::case::MaskDepth;
use cssm_core::facet::{Facet, Tile};
use cssm_core::{ShadowPlan, View};

use crate::error::ServiceError;
use crate::lights::LightReport;
use crate::scope::checked;
use numbers::{LOGARITHMIC, Numbers, PERSPECTIVE, facet_numbers, tile_numbers};
use records::{FacetRows, FacetSettings, PlanRows, RowNames, TileRows, TileSettings, prelude};

/// The passes that show facets and tiles, on one device and for one kind of depth and target.
#[derive(Debug)]
pub struct Overlay {
    device: wgpu::Device,
    queue: wgpu::Queue,
    depth: MaskDepth,
    facets: ShownPass,
    tiles: ShownPass,
}

/// How facets are shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverlayLook {
    /// Share of what was in the picture that a facet's colour covers.
    pub opacity: f32,
    /// Side in texels of the squares of a checker that shows how large texels are; 0: no checker.
    pub checker_texels: u32,
}

/// A tile to be shown.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OverlayTile {
    /// Its rectangle of the map.
    pub tile: Tile,
    /// Colour of its outline, red, green and blue from 0 to 1.
    pub colour: [f32; 3],
}

/// A pipeline and what it binds.
#[derive(Debug)]
struct ShownPass {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
}

/// Width of outlines in pixels.
const OUTLINE_PIXELS: f32 = 1.0;
/// Bindings of the passes.
const DEPTH_BINDING: u32 = 2;
const LINEAR_DEPTH_BINDING: u32 = 3;

/// The colour of a facet, by the first of its cells: neighbouring numbers are told apart. Red, green and blue from 0 to 1.
pub fn facet_colour(first_cell: u32) -> [f32; 3] {
    let turn = (f64::from(first_cell) * 0.618_033_988_749_895).fract() * 6.0;
    let channel = |shift: f64| {
        let place = (turn + shift).rem_euclid(6.0);
        let level = (2.0 - (place - 3.0).abs()).clamp(0.0, 1.0);
        (1.0 - 0.75 * level) as f32
    };
    [channel(0.0), channel(2.0), channel(4.0)]
}

impl Default for OverlayLook {
    fn default() -> Self {
        Self { opacity: 0.5, checker_texels: 8 }
    }
}

impl OverlayTile {
    /// The tiles of a plan in the colours of their facets.
    pub fn of_plan(plan: &ShadowPlan) -> Vec<Self> {
        let shown = |facet: &Facet| Self { tile: facet.tile, colour: facet_colour(facet.first_cell()) };
        plan.facets.iter().map(shown).collect()
    }

    /// The tiles of all lights of a frame, each light in a colour of its own; those that were drawn again in the frame are
    /// as bright as can be, the others dimmed.
    pub fn of_report(report: &LightReport) -> Vec<Self> {
        let of_light = |(number, light): (u32, &crate::lights::LightStatistics)| {
            let colour = facet_colour(number);
            let shown = move |shown: &crate::lights::TileStatistics| Self {
                tile: shown.tile,
                colour: colour.map(|channel| if shown.redrawn { channel } else { 0.5 * channel }),
            };
            light.tiles.iter().map(shown).collect::<Vec<_>>()
        };
        (0..).zip(&report.lights).flat_map(of_light).collect()
    }
}

impl Overlay {
    /// Creates the passes. `depth` is the kind of depth that pixels are placed by, as mask passes take it; `target` a colour
    /// format that can be blended.
    ///
    /// # Errors
    /// What the device refuses.
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        depth: MaskDepth,
        target: wgpu::TextureFormat,
    ) -> Result<Self, ServiceError> {
        let (binding, entry, sample_type) = match depth {
            MaskDepth::ReversedZ => (DEPTH_BINDING, "overlay_stored", wgpu::TextureSampleType::Depth),
            MaskDepth::Linear => (LINEAR_DEPTH_BINDING, "overlay_linear", UNFILTERED),
        };
        let blended = wgpu::ColorTargetState {
            format: target,
            blend: Some(wgpu::BlendState::ALPHA_BLENDING),
            write_mask: wgpu::ColorWrites::ALL,
        };
        let facets = checked(device, "the overlay of facets", || {
            let module = module(device, facet_shader());
            let layout = layout(device, (binding, sample_type));
            let pipeline = pipeline(device, &layout, &module, ["overlay_vertex", entry], blended.clone());
            ShownPass { layout, pipeline }
        })?;
        let tiles = checked(device, "the overlay of tiles", || {
            let module = module(device, tile_shader());
            let layout = layout(device, (DEPTH_BINDING, wgpu::TextureSampleType::Depth));
            let pipeline = pipeline(device, &layout, &module, ["tiles_vertex", "tiles_fragment"], blended);
            ShownPass { layout, pipeline }
        })?;
        Ok(Self { device: device.clone(), queue: queue.clone(), depth, facets, tiles })
    }

    /// Records a pass that colours every pixel of `target` by the facet whose shadows it reads ([`facet_colour`]), with
    /// black borders between facets. Pixels of the sky, and those that no facet serves and that are lit, stay as they are.
    ///
    /// The plan may be relative to another eye than the view's, as held plans are. `depth` and `target` have the view's
    /// size. Rows are rounded to f32 in camera axes: with the light in the view, texels far away blur.
    ///
    /// # Errors
    /// Textures of another kind than declared, and whatever else the device refuses.
    pub fn draw_facets(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        plan: &ShadowPlan,
        view: &View,
        depth: &wgpu::TextureView,
        target: &wgpu::TextureView,
        look: &OverlayLook,
    ) -> Result<(), ServiceError> {
        let numbers = facet_numbers(&plan.rebased(view), view, look);
        let binding = match self.depth {
            MaskDepth::ReversedZ => DEPTH_BINDING,
            MaskDepth::Linear => LINEAR_DEPTH_BINDING,
        };
        self.draw(encoder, &self.facets, &numbers, (binding, depth), target, None, 0..3, 1)
    }

    /// Records a pass that shows the tiles of a map, texel for texel, in a rectangle of `target`: x, y, width and height in
    /// pixels. Depths are grey between the nearest and the farthest of their tile; what is empty is dark.
    ///
    /// # Errors
    /// A map that cannot be sampled, and whatever else the device refuses.
    pub fn draw_tiles(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        map: &wgpu::Texture,
        tiles: &[OverlayTile],
        target: &wgpu::TextureView,
        place: [u32; 4],
    ) -> Result<(), ServiceError> {
        let count = tiles.len() as u32;
        if count == 0 {
            return Ok(());
        }
        let numbers = tile_numbers(tiles, (map.width(), map.height()), OUTLINE_PIXELS);
        let map = map.create_view(&wgpu::TextureViewDescriptor::default());
        self.draw(encoder, &self.tiles, &numbers, (DEPTH_BINDING, &map), target, Some(place), 0..6, count)
    }

    #[allow(clippy::too_many_arguments, reason = "what one pass reads, where it draws and how much")]
    fn draw(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        shown: &ShownPass,
        numbers: &Numbers,
        (binding, texture): (u32, &wgpu::TextureView),
        target: &wgpu::TextureView,
        place: Option<[u32; 4]>,
        corners: std::ops::Range<u32>,
        instances: u32,
    ) -> Result<(), ServiceError> {
        checked(&self.device, "an overlay", || {
            let (settings, rows) = numbers.upload(&self.device, &self.queue);
            let group = self.device.create_bind_group(&wgpu::BindGroupDescriptor {
                label: Some("cssm overlay"),
                layout: &shown.layout,
                entries: &[
                    wgpu::BindGroupEntry { binding: 0, resource: settings.as_entire_binding() },
                    wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&rows) },
                    wgpu::BindGroupEntry { binding, resource: wgpu::BindingResource::TextureView(texture) },
                ],
            });
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                label: Some("cssm overlay"),
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: target,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations { load: wgpu::LoadOp::Load, store: wgpu::StoreOp::Store },
                })],
                ..Default::default()
            });
            if let Some([x, y, width, height]) = place {
                pass.set_viewport(x as f32, y as f32, width as f32, height as f32, 0.0, 1.0);
            }
            pass.set_pipeline(&shown.pipeline);
            pass.set_bind_group(0, &group, &[]);
            pass.draw(corners, 0..instances);
        })
    }
}

/// The shader that colours pixels by their facets.
fn facet_shader() -> String {
    let rows = [RowNames::of::<PlanRows>("PLAN"), RowNames::of::<FacetRows>("FACET")];
    let curves = [("PERSPECTIVE", PERSPECTIVE), ("LOGARITHMIC", LOGARITHMIC)];
    prelude::<FacetSettings, 2>(rows, &curves) + include_str!("shaders/overlay_facets.wgsl")
}

/// The shader that shows tiles.
fn tile_shader() -> String {
    let rows = [RowNames::of::<TileRows>("TILE")];
    prelude::<TileSettings, 1>(rows, &[]) + include_str!("shaders/overlay_tiles.wgsl")
}

fn module(device: &wgpu::Device, text: String) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("cssm overlay"),
        source: wgpu::ShaderSource::Wgsl(text.into()),
    })
}

/// Floats that are fetched.
const UNFILTERED: wgpu::TextureSampleType = wgpu::TextureSampleType::Float { filterable: false };

/// Settings, numbers and a texture.
fn layout(
    device: &wgpu::Device,
    (binding, sample_type): (u32, wgpu::TextureSampleType),
) -> wgpu::BindGroupLayout {
    let texture = |binding, sample_type| wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Texture {
            sample_type,
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
        count: None,
    };
    let settings = wgpu::BindGroupLayoutEntry {
        binding: 0,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("cssm overlay"),
        entries: &[settings, texture(1, UNFILTERED), texture(binding, sample_type)],
    })
}

fn pipeline(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    module: &wgpu::ShaderModule,
    [vertex, fragment]: [&str; 2],
    target: wgpu::ColorTargetState,
) -> wgpu::RenderPipeline {
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("cssm overlay"),
        bind_group_layouts: &[Some(layout)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("cssm overlay"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module,
            entry_point: Some(vertex),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module,
            entry_point: Some(fragment),
            compilation_options: Default::default(),
            targets: &[Some(target)],
        }),
        multiview_mask: None,
        cache: None,
    })
}
