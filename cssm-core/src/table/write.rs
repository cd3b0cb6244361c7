//! Rounds a plan once, into the bytes of the records: in the axes that the
//! shaders evaluate facets in.

use glam::{DMat3, DVec2, DVec3, DVec4};

use super::ground;
use super::{CaseTable, Meaning, Record, RecordKind};
use crate::case::Axes;
use crate::facet::Facet;
use crate::plan::ShadowPlan;
use crate::remap::{Curve, Remap};
use crate::view::View;

/// Where rows of an infinite horizon go straight on, metres.
const FARTHEST_HORIZON_METRES: f64 = 1e12;
/// Largest float below infinity: no distance reaches it.
const UNREACHED: f32 = f32::MAX;

/// Bytes of the record of kind [`RecordKind::Shadow`]; facets without receivers are zero.
pub fn write_shadow_record(table: &CaseTable, plan: &ShadowPlan) -> Vec<u8> {
    let mut bytes = zeroes(table, RecordKind::Shadow);
    write_shadow_record_to(table, plan, &mut bytes);
    bytes
}

/// [`write_shadow_record`] into memory that is there; nothing is written where the record does not fit.
pub fn write_shadow_record_to(table: &CaseTable, plan: &ShadowPlan, bytes: &mut [u8]) {
    let Some(record) = table.record(RecordKind::Shadow) else { return };
    let facet_record = table.record(RecordKind::Facet);
    let sign = plan.depth_order.sign();
    let turned = Turn::resolve(table, plan);
    let Some(bytes) = bytes.get_mut(..record.size_bytes as usize) else { return };
    bytes.fill(0);
    for field in record.fields.iter() {
        let offset = field.offset_bytes as usize;
        let stride = field.stride_bytes as usize;
        match field.meaning {
            Meaning::Borders => put_rows(bytes, offset, &plan.selection.borders, &turned),
            Meaning::Split => {
                put_rows(bytes, offset, plan.selection.split.as_slice(), &turned);
            }
            Meaning::Dominant => {
                put_rows(bytes, offset, plan.selection.dominant.as_slice().as_flattened(), &turned);
            }
            Meaning::Units => {
                for sector in 0..(table.halves * table.sectors) as usize {
                    let unit = plan.selection.units.get(sector).copied().unwrap_or(DVec4::W);
                    put_row(bytes, offset + sector * stride, turned.row(unit));
                }
            }
            Meaning::LightPosition => {
                let turn = Turn::unsheared(table, plan);
                put_row(bytes, offset, turn.direction(plan.light));
            }
            Meaning::Distances => put_rows(bytes, offset, &plan.selection.distances, &turned),
            Meaning::Thresholds => {
                let vectors = (table.bands as usize - 1).div_ceil(4);
                for sector in 0..(table.halves * table.sectors) as usize {
                    let limits = plan.selection.limits(sector);
                    for index in 0..vectors * 4 {
                        let limit =
                            limits.get(index).map_or(UNREACHED, |limit| (*limit as f32).min(UNREACHED));
                        put(bytes, offset + sector * stride * vectors + index * 4, limit);
                    }
                }
            }
            Meaning::TowardLight => put_row(bytes, offset, turned.direction(plan.light)),
            Meaning::Shear => {
                let (leading, rest) = shear_parts(plan.shear);
                put_row(bytes, offset, DVec4::new(leading.x, leading.y, rest.x, rest.y));
            }
            Meaning::PixelMetres => put_row(bytes, offset, turned.row(plan.pixel_metres)),
            Meaning::DepthSign => put(bytes, offset, sign as f32),
            Meaning::GroundPlanes => {
                let turn = Turn::unsheared(table, plan);
                for (index, plane) in plan.ground_planes().take(field.elements as usize).enumerate() {
                    put_row(bytes, offset + index * stride, turn.row(plane));
                }
            }
            Meaning::GroundTiles => ground::put_tiles(bytes, table, plan, field),
            Meaning::GroundEdges => ground::put_edges(bytes, table, plan, field),
            Meaning::Facets => {
                let Some(facet_record) = facet_record else { continue };
                let write = FacetWriter { record: facet_record, turned: &turned, sign };
                for (facet, cell) in
                    plan.facets.iter().flat_map(|facet| facet.cells.iter().map(move |cell| (facet, cell)))
                {
                    write.facet(bytes, offset + *cell as usize * stride, facet);
                }
            }
            _ => {}
        }
    }
}

/// Bytes of the record of kind [`RecordKind::Capture`] for one facet of a plan.
pub fn write_capture_record(table: &CaseTable, plan: &ShadowPlan, facet: &Facet) -> Vec<u8> {
    let mut bytes = zeroes(table, RecordKind::Capture);
    write_capture_record_to(table, plan, facet, &mut bytes);
    bytes
}

/// [`write_capture_record`] into memory that is there; nothing is written where the record does not fit.
pub fn write_capture_record_to(table: &CaseTable, plan: &ShadowPlan, facet: &Facet, bytes: &mut [u8]) {
    let Some(record) = table.record(RecordKind::Capture) else { return };
    let Some(bytes) = bytes.get_mut(..record.size_bytes as usize) else { return };
    bytes.fill(0);
    FacetWriter { record, turned: &Turn::capture(plan), sign: 1.0 }.facet(bytes, 0, facet);
}

/// Bytes of the record of kind [`RecordKind::CasterMask`].
pub fn write_caster_mask_record(table: &CaseTable, alpha_cutoff: f32) -> Vec<u8> {
    let Some(record) = table.record(RecordKind::CasterMask) else { return Vec::new() };
    let mut bytes = vec![0; record.size_bytes as usize];
    for field in record.fields.iter().filter(|field| field.meaning == Meaning::AlphaCutoff) {
        put(&mut bytes, field.offset_bytes as usize, alpha_cutoff);
    }
    bytes
}

/// Bytes of the record of kind [`RecordKind::Mask`] for a view.
pub fn write_mask_record(table: &CaseTable, view: &View) -> Vec<u8> {
    let mut bytes = zeroes(table, RecordKind::Mask);
    write_mask_record_to(table, view, &mut bytes);
    bytes
}

/// [`write_mask_record`] into memory that is there; nothing is written where the record does not fit.
pub fn write_mask_record_to(table: &CaseTable, view: &View, bytes: &mut [u8]) {
    let Some(record) = table.record(RecordKind::Mask) else { return };
    let Some(bytes) = bytes.get_mut(..record.size_bytes as usize) else { return };
    bytes.fill(0);
    let to_axes = match table.axes {
        Axes::World => view.camera_from_world.transpose(),
        Axes::Camera => DMat3::IDENTITY,
    };
    let corner = DVec3::new(view.left, view.top, -1.0);
    let across = DVec3::X * (view.right - view.left);
    let down = DVec3::Y * (view.bottom - view.top);
    for field in record.fields.iter() {
        let offset = field.offset_bytes as usize;
        let mut direction = |ray: DVec3| put_row(bytes, offset, (to_axes * ray).extend(0.0));
        match field.meaning {
            Meaning::RayCorner => direction(corner),
            Meaning::RayAcross => direction(across),
            Meaning::RayDown => direction(down),
            Meaning::InverseDepth => put_inverse_depth(bytes, offset, view),
            _ => {}
        }
    }
}

/// Bytes of the record of kind [`RecordKind::Fit`] for a view.
pub fn write_fit_record(table: &CaseTable, view: &View) -> Vec<u8> {
    let Some(record) = table.record(RecordKind::Fit) else { return Vec::new() };
    let mut bytes = vec![0; record.size_bytes as usize];
    for field in record.fields.iter() {
        let offset = field.offset_bytes as usize;
        match field.meaning {
            Meaning::InverseDepth => put_inverse_depth(&mut bytes, offset, view),
            Meaning::PerNear => put(&mut bytes, offset, (1.0 / view.near_metres) as f32),
            _ => {}
        }
    }
    bytes
}

/// A record's bytes before anything is written.
fn zeroes(table: &CaseTable, kind: RecordKind) -> Vec<u8> {
    vec![0; table.record(kind).map_or(0, |record| record.size_bytes as usize)]
}

/// From stored reversed-z depth to one over depth.
fn put_inverse_depth(bytes: &mut [u8], offset: usize, view: &View) {
    let far_inverse = 1.0 / view.far_metres;
    put(bytes, offset, (1.0 / view.near_metres - far_inverse) as f32);
    put(bytes, offset + 4, far_inverse as f32);
}

/// From the world axes of plans to the axes of a record.
#[derive(Debug, Clone, Copy)]
struct Turn {
    /// Points and directions.
    points: DMat3,
    /// Rows: the inverse, transposed.
    rows: DMat3,
}

impl Turn {
    /// The axes that facets are evaluated in by the resolve shaders.
    fn resolve(table: &CaseTable, plan: &ShadowPlan) -> Self {
        if table.shears { Self::capture(plan) } else { Self::unsheared(table, plan) }
    }

    /// The case's axes.
    fn unsheared(table: &CaseTable, plan: &ShadowPlan) -> Self {
        match table.axes {
            Axes::World => Self { points: DMat3::IDENTITY, rows: DMat3::IDENTITY },
            Axes::Camera => Self { points: plan.camera_from_world, rows: plan.camera_from_world },
        }
    }

    /// The axes of capture records.
    fn capture(plan: &ShadowPlan) -> Self {
        let DVec2 { x, y } = plan.shear;
        let rows = DMat3::from_cols(DVec3::new(1.0, 0.0, -x), DVec3::new(0.0, 1.0, -y), DVec3::Z);
        Self { points: plan.capture_from_world(), rows: rows * plan.camera_from_world }
    }

    fn row(&self, row: DVec4) -> DVec4 {
        (self.rows * row.truncate()).extend(row.w)
    }

    fn direction(&self, direction: DVec4) -> DVec4 {
        (self.points * direction.truncate()).extend(direction.w)
    }
}

/// A shear in leading parts of twelve bits, whose products with twelve bits of a coordinate are exact in f32, and the
/// rest.
pub fn shear_parts(shear: DVec2) -> (DVec2, DVec2) {
    const LEADING_BITS: u32 = 0xffff_f000;
    let leading = |value: f64| f64::from(f32::from_bits((value as f32).to_bits() & LEADING_BITS));
    let leading = DVec2::new(leading(shear.x), leading(shear.y));
    (leading, shear - leading)
}

/// Writes the fields of facets.
struct FacetWriter<'a> {
    record: &'a Record,
    turned: &'a Turn,
    /// Turns the depth row so that it grows away from the light.
    sign: f64,
}

impl FacetWriter<'_> {
    fn facet(&self, bytes: &mut [u8], base: usize, facet: &Facet) {
        let tile = &facet.tile;
        let (x, y) = (f64::from(tile.x), f64::from(tile.y));
        let (width, height) = (f64::from(tile.width), f64::from(tile.height));
        // A local light's part depends on the receiver; elsewhere both are one constant.
        let splits = self.record.fields.iter().any(|field| field.meaning == Meaning::RoundingDepth);
        let rounding = if splits { 0.0 } else { facet.rounding_depth };
        for field in self.record.fields.iter() {
            let offset = base + field.offset_bytes as usize;
            let mut row = |row: DVec4| put_row(bytes, offset, self.turned.row(row));
            match field.meaning {
                Meaning::RowX => row(facet.rows.x),
                Meaning::RowY => row(facet.rows.y),
                Meaning::RowZ => row(facet.rows.z * self.sign),
                Meaning::RowW => row(facet.rows.w),
                Meaning::Clips => {
                    for index in 0..field.elements as usize {
                        let clip = facet.clip.get(index).copied().unwrap_or(DVec4::W);
                        let offset = offset + index * field.stride_bytes as usize;
                        put_row(bytes, offset, self.turned.row(clip));
                    }
                }
                Meaning::TexelFromNdc => {
                    let transform = DVec4::new(0.5 * width, -0.5 * height, x + 0.5 * width, y + 0.5 * height);
                    put_row(bytes, offset, transform);
                }
                Meaning::TexelLimits => {
                    let (low, high) = tile.texel_limits();
                    put_row(bytes, offset, DVec4::new(low.x, low.y, high.x, high.y));
                }
                Meaning::TileSize => {
                    put(bytes, offset, tile.width as f32);
                    put(bytes, offset + 4, tile.height as f32);
                }
                Meaning::StretchTile => {
                    let (one, two) = (facet.rows.remap.k(-1.0), facet.rows.remap.k(1.0));
                    put_row(bytes, offset, DVec4::new(one.min(two), one.max(two), x, y));
                }
                Meaning::Remap => {
                    let vectors = field.elements.max(1) as usize;
                    for (index, vector) in remap_vectors(&facet.rows.remap, vectors).into_iter().enumerate() {
                        put_row(bytes, offset + 16 * index, vector);
                    }
                }
                Meaning::DepthPerMetre => put(bytes, offset, facet.depth_per_metre as f32),
                Meaning::TexelMetresPerW => put(bytes, offset, facet.texel_metres_per_w as f32),
                Meaning::ReceiverPlaneDepth => {
                    put(bytes, offset, (facet.receiver_plane_depth + rounding) as f32);
                }
                Meaning::RoundingDepth => put(bytes, offset, facet.rounding_depth as f32),
                _ => {}
            }
        }
    }
}

/// A remap as [`Meaning::Remap`] spells it, in one vector for perspectives and two for logarithms.
fn remap_vectors(remap: &Remap, vectors: usize) -> Vec<DVec4> {
    let Remap { curve, scale, shift } = *remap;
    match (curve, vectors) {
        (Curve::Perspective { push_back_metres }, 1) => vec![DVec4::new(shift, scale, push_back_metres, 0.0)],
        (_, 1) => vec![DVec4::new(shift, scale, 0.0, 0.0)],
        (Curve::Logarithmic { reference_metres, horizon_metres }, _) => {
            // No receiver lies beyond an infinite horizon, but corners of casters may: no logarithm reaches them.
            let horizon_metres = horizon_metres.min(FARTHEST_HORIZON_METRES);
            let curve = Curve::Logarithmic { reference_metres, horizon_metres };
            let within = DVec4::new(shift, -scale, reference_metres, 0.0);
            let at_infinity = Remap { curve, ..*remap }.y(0.0);
            vec![within, DVec4::new(1.0 / horizon_metres, at_infinity, -scale * horizon_metres, 0.0)]
        }
        // A row that is not bent lies beyond the horizon everywhere.
        (_, _) => vec![DVec4::Z, DVec4::new(f64::from(f32::MAX), shift, scale, 0.0)],
    }
}

fn put_rows(bytes: &mut [u8], offset: usize, rows: &[DVec4], turned: &Turn) {
    for (index, row) in rows.iter().enumerate() {
        put_row(bytes, offset + 16 * index, turned.row(*row));
    }
}

pub(super) fn put_row(bytes: &mut [u8], offset: usize, row: DVec4) {
    for (index, value) in row.to_array().into_iter().enumerate() {
        put(bytes, offset + 4 * index, value as f32);
    }
}

fn put(bytes: &mut [u8], offset: usize, value: f32) {
    bytes[offset..offset + 4].copy_from_slice(&value.to_le_bytes());
}
