//! Plans and tiles as the overlays' shaders read them: rows of four floats in a texture, which every device has.

use cssm_core::facet::Facet;
use cssm_core::glam::{DMat3, DVec3, DVec4};
use cssm_core::remap::Curve;
use cssm_core::{ShadowPlan, View};

use super::records::{
    FacetRows, FacetSettings, PlanRows, ROW_TEXELS, Record, TileRows, TileSettings, rows_of,
};
use super::{OverlayLook, OverlayTile, facet_colour};

/// What names no facet.
const NO_FACET: f32 = -1.0;
/// Thresholds of a row.
const LIMITS: usize = 4;
/// What names curves.
pub(super) const STRAIGHT: f64 = 0.0;
pub(super) const PERSPECTIVE: f64 = 1.0;
pub(super) const LOGARITHMIC: f64 = 2.0;

/// A uniform and rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Numbers {
    settings: Vec<u8>,
    rows: Vec<[f32; 4]>,
}

/// Rows that grow, in camera axes.
struct Rows {
    camera_from_world: DMat3,
    rows: Vec<[f32; 4]>,
}

impl Rows {
    /// Appends rows of a plan; returns where they begin, 0 for none.
    fn add<'r>(&mut self, rows: impl IntoIterator<Item = &'r DVec4>) -> u32 {
        let start = self.rows.len();
        for row in rows {
            let turned = self.turned(row);
            self.rows.push(turned);
        }
        if self.rows.len() > start { start as u32 } else { 0 }
    }

    /// Appends a record.
    fn push(&mut self, record: &impl Record) {
        self.rows.extend_from_slice(rows_of(record));
    }

    /// A row of a plan in camera axes.
    fn turned(&self, row: &DVec4) -> [f32; 4] {
        (self.camera_from_world * row.truncate()).extend(row.w).as_vec4().to_array()
    }

    /// Appends a facet.
    fn add_facet(&mut self, facet: &Facet) {
        let remap = &facet.rows.remap;
        let (curve, shift, figure) = match remap.curve {
            Curve::Straight => (STRAIGHT, remap.shift, 0.0),
            Curve::Perspective { push_back_metres } => (PERSPECTIVE, remap.shift, push_back_metres),
            // The logarithm of the reference is a part of the shift.
            Curve::Logarithmic { reference_metres, horizon_metres } => {
                let shift = remap.shift - remap.scale * reference_metres.ln();
                (LOGARITHMIC, shift, horizon_metres.min(f64::from(f32::MAX)))
            }
        };
        let tile = &facet.tile;
        let [red, green, blue] = facet_colour(facet.first_cell());
        self.push(&FacetRows {
            x: self.turned(&facet.rows.x),
            y: self.turned(&facet.rows.y),
            w: self.turned(&facet.rows.w),
            curve: [curve, remap.scale, shift, figure].map(|value| value as f32),
            tile: [tile.x, tile.y, tile.width, tile.height].map(|value| value as f32),
            colour: [red, green, blue, 1.0],
        });
    }
}

/// The walk and the facets of a plan that is relative to the view's eye.
pub(super) fn facet_numbers(plan: &ShadowPlan, view: &View, look: &OverlayLook) -> Numbers {
    let selection = &plan.selection;
    let mut rows = Rows { camera_from_world: view.camera_from_world, rows: Vec::new() };
    let [near, front] = selection.dominant.unwrap_or([DVec4::ZERO; 2]);
    rows.push(&PlanRows {
        dominant: rows.turned(&near),
        dominant_front: rows.turned(&front),
        split: rows.turned(&selection.split.unwrap_or(DVec4::ZERO)),
    });
    let borders = rows.add(&selection.borders);
    let distances = rows.add(&selection.distances);
    let units = rows.add(&selection.units);
    let thresholds = rows.rows.len() as u32;
    for sector in 0..selection.distances.len() {
        rows.rows.extend(selection.limits(sector).chunks(LIMITS).map(|limits| {
            let limit = |at: usize| limits.get(at).map_or(f32::MAX, |limit| (*limit as f32).min(f32::MAX));
            std::array::from_fn(limit)
        }));
    }

    // Name the facet of each cell, then list the facets.
    let cells = rows.rows.len();
    let halves = 1 + u32::from(selection.split.is_some());
    let cell_count = halves * selection.sectors * selection.bands + u32::from(selection.dominant.is_some());
    rows.rows.extend((0..cell_count).map(|_| [NO_FACET; 4]));
    for (position, facet) in plan.facets.iter().enumerate() {
        for cell in &facet.cells {
            if let Some(owner) = rows.rows.get_mut(cells + *cell as usize) {
                owner[0] = position as f32;
            }
        }
    }
    let facets = rows.rows.len() as u32;
    plan.facets.iter().for_each(|facet| rows.add_facet(facet));

    // Rays through the corners of pixels, at depth 1.
    let ray = |x: f64, y: f64, z: f64| DVec3::new(x, y, z).extend(0.0).as_vec4().to_array();
    let (width, height) = (f64::from(view.size_pixels.0), f64::from(view.size_pixels.1));
    let far_inverse = 1.0 / view.far_metres;
    let settings = FacetSettings {
        ray_corner: ray(view.left, view.top, -1.0),
        ray_across: ray((view.right - view.left) / width, 0.0, 0.0),
        ray_down: ray(0.0, (view.bottom - view.top) / height, 0.0),
        inverse_depth: [1.0 / view.near_metres - far_inverse, far_inverse].map(|value| value as f32),
        opacity: look.opacity,
        checker_texels: look.checker_texels as f32,
        sectors: selection.sectors,
        bands: selection.bands,
        has_split: u32::from(selection.split.is_some()),
        has_dominant: u32::from(selection.dominant.is_some()),
        borders,
        distances,
        units,
        thresholds,
        threshold_rows: selection.bands.saturating_sub(1).div_ceil(LIMITS as u32),
        cells: cells as u32,
        cell_count,
        facets,
    };
    Numbers { settings: bytemuck::bytes_of(&settings).to_vec(), rows: rows.rows }
}

/// The tiles of a map of some size.
pub(super) fn tile_numbers(tiles: &[OverlayTile], map_texels: (u32, u32), outline_pixels: f32) -> Numbers {
    let map_texels = [map_texels.0 as f32, map_texels.1 as f32];
    let settings = TileSettings { map_texels, outline_pixels, unused_last: 0.0 };
    let mut rows = Vec::new();
    for OverlayTile { tile, colour: [red, green, blue] } in tiles {
        let rectangle = [tile.x, tile.y, tile.width, tile.height].map(|value| value as f32);
        rows.extend_from_slice(rows_of(&TileRows { rectangle, colour: [*red, *green, *blue, 1.0] }));
    }
    Numbers { settings: bytemuck::bytes_of(&settings).to_vec(), rows }
}

impl Numbers {
    /// Brings them to the device; to be called under an error scope.
    pub(super) fn upload(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
    ) -> (wgpu::Buffer, wgpu::TextureView) {
        let settings = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("cssm overlay"),
            size: self.settings.len() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&settings, 0, &self.settings);

        // Fill the last row of the texture.
        let height = self.rows.len().div_ceil(ROW_TEXELS).max(1);
        let mut rows = self.rows.clone();
        rows.resize(height * ROW_TEXELS, [0.0; 4]);
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("cssm overlay"),
            size: wgpu::Extent3d {
                width: ROW_TEXELS as u32,
                height: height as u32,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: wgpu::TextureFormat::Rgba32Float,
            usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some((ROW_TEXELS * size_of::<[f32; 4]>()) as u32),
            rows_per_image: None,
        };
        queue.write_texture(texture.as_image_copy(), bytemuck::cast_slice(&rows), layout, texture.size());
        (settings, texture.create_view(&wgpu::TextureViewDescriptor::default()))
    }
}
