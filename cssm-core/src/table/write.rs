//! Rounds a plan once, into the bytes of the records.

use glam::{DVec3, DVec4};

use super::{CaseTable, Meaning, Record, RecordKind};
use crate::facet::Facet;
use crate::plan::ShadowPlan;
use crate::view::View;

/// Largest float below infinity: no distance reaches it.
const UNREACHED: f32 = f32::MAX;

/// Bytes of the record of kind [`RecordKind::Shadow`]; facets without receivers are zero.
pub fn write_shadow_record(table: &CaseTable, plan: &ShadowPlan) -> Vec<u8> {
    let Some(record) = table.record(RecordKind::Shadow) else { return Vec::new() };
    let facet_record = table.record(RecordKind::Facet);
    let mut bytes = vec![0; record.size_bytes as usize];
    for field in record.fields.iter() {
        let offset = field.offset_bytes as usize;
        let stride = field.stride_bytes as usize;
        match field.meaning {
            Meaning::Borders => put_rows(&mut bytes, offset, &plan.selection.borders),
            Meaning::Distances => put_rows(&mut bytes, offset, &plan.selection.distances),
            Meaning::Thresholds => {
                let vectors = (table.bands as usize - 1).div_ceil(4);
                for sector in 0..table.sectors as usize {
                    let limits = plan.selection.thresholds.get(sector);
                    for index in 0..vectors * 4 {
                        let limit = limits.and_then(|limits| limits.get(index));
                        let limit = limit.map_or(UNREACHED, |limit| (*limit as f32).min(UNREACHED));
                        put(&mut bytes, offset + sector * stride * vectors + index * 4, limit);
                    }
                }
            }
            Meaning::TowardLight => put_row(&mut bytes, offset, plan.light),
            Meaning::Facets => {
                let Some(facet_record) = facet_record else { continue };
                for facet in &plan.facets {
                    write_facet(&mut bytes, offset + facet.index as usize * stride, facet_record, facet);
                }
            }
            _ => {}
        }
    }
    bytes
}

/// Bytes of the record of kind [`RecordKind::Capture`] for one facet.
pub fn write_capture_record(table: &CaseTable, facet: &Facet) -> Vec<u8> {
    let Some(record) = table.record(RecordKind::Capture) else { return Vec::new() };
    let mut bytes = vec![0; record.size_bytes as usize];
    write_facet(&mut bytes, 0, record, facet);
    bytes
}

/// Bytes of the record of kind [`RecordKind::Mask`] for a view.
pub fn write_mask_record(table: &CaseTable, view: &View) -> Vec<u8> {
    let Some(record) = table.record(RecordKind::Mask) else { return Vec::new() };
    let mut bytes = vec![0; record.size_bytes as usize];
    let (width, height) = (f64::from(view.size_pixels.0), f64::from(view.size_pixels.1));
    let corner = view.ray_world(0.0, 0.0);
    let across = view.ray_world(width, 0.0) - corner;
    let down = view.ray_world(0.0, height) - corner;
    for field in record.fields.iter() {
        let offset = field.offset_bytes as usize;
        let direction = |ray: DVec3| ray.extend(0.0);
        match field.meaning {
            Meaning::RayCorner => put_row(&mut bytes, offset, direction(corner)),
            Meaning::RayAcross => put_row(&mut bytes, offset, direction(across)),
            Meaning::RayDown => put_row(&mut bytes, offset, direction(down)),
            Meaning::InverseDepth => {
                let far_inverse = 1.0 / view.far_metres;
                put(&mut bytes, offset, (1.0 / view.near_metres - far_inverse) as f32);
                put(&mut bytes, offset + 4, far_inverse as f32);
            }
            _ => {}
        }
    }
    bytes
}

fn write_facet(bytes: &mut [u8], base: usize, record: &Record, facet: &Facet) {
    let tile = &facet.tile;
    let (x, y) = (f64::from(tile.x), f64::from(tile.y));
    let (width, height) = (f64::from(tile.width), f64::from(tile.height));
    for field in record.fields.iter() {
        let offset = base + field.offset_bytes as usize;
        match field.meaning {
            Meaning::RowX => put_row(bytes, offset, facet.rows.x),
            Meaning::RowY => put_row(bytes, offset, facet.rows.y),
            Meaning::RowZ => put_row(bytes, offset, facet.rows.z),
            Meaning::RowW => put_row(bytes, offset, facet.rows.w),
            Meaning::TexelFromNdc => {
                let transform = DVec4::new(0.5 * width, -0.5 * height, x + 0.5 * width, y + 0.5 * height);
                put_row(bytes, offset, transform);
            }
            Meaning::TexelLimits => {
                let (low, high) = tile.texel_limits();
                put_row(bytes, offset, DVec4::new(low.x, low.y, high.x, high.y));
            }
            Meaning::DepthPerMetre => put(bytes, offset, facet.depth_per_metre as f32),
            Meaning::TexelMetresPerW => put(bytes, offset, facet.texel_metres_per_w as f32),
            Meaning::ReceiverPlaneDepth => put(bytes, offset, facet.receiver_plane_depth as f32),
            _ => {}
        }
    }
}

fn put_rows(bytes: &mut [u8], offset: usize, rows: &[DVec4]) {
    for (index, row) in rows.iter().enumerate() {
        put_row(bytes, offset + 16 * index, *row);
    }
}

fn put_row(bytes: &mut [u8], offset: usize, row: DVec4) {
    for (index, value) in row.to_array().into_iter().enumerate() {
        put(bytes, offset + 4 * index, value as f32);
    }
}

fn put(bytes: &mut [u8], offset: usize, value: f32) {
    bytes[offset..offset + 4].copy_from_slice(&value.to_le_bytes());
}
