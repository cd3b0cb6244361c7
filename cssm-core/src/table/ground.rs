//! Planes with masks of their own in the shadow record.

use super::describe::VECTORS_A_PLANE;
use super::write::put_row;
use super::{CaseTable, ConstantKind, ConstantValue, RecordField};
use crate::ground::{PlaneInTile, edges_in_tile};
use crate::plan::ShadowPlan;

/// Where planes lie in the tiles of a plan; zero where they are not lit and where a cell has no facet.
pub(super) fn put_tiles(bytes: &mut [u8], table: &CaseTable, plan: &ShadowPlan, field: &RecordField) {
    let cells = table.cells().max(1);
    let planes = field.elements / cells / VECTORS_A_PLANE;
    let chord_texels = match table.constant(ConstantKind::StretchBound).map(|constant| constant.value) {
        Some(ConstantValue::F32(texels)) => f64::from(texels),
        _ => 0.0,
    };
    for facet in &plan.facets {
        for (index, plane) in (0..planes).zip(plan.ground_planes()) {
            let sign = plan.depth_order.sign();
            let placed = PlaneInTile::of(plane, facet, plan.light, sign, chord_texels);
            let Some(PlaneInTile { depth, inverse_w, across, up }) = placed else { continue };
            for cell in facet.cells.iter().filter(|cell| **cell < cells) {
                let first = (cell * planes + index) * VECTORS_A_PLANE;
                for (vector, value) in (first..).zip([depth, inverse_w, across, up]) {
                    let offset = field.offset_bytes + vector * field.stride_bytes;
                    put_row(bytes, offset as usize, value.extend(0.0));
                }
            }
        }
    }
}

/// Edges of the facets of a plan in tiles that they share; all of a tile is inside where a facet has none.
pub(super) fn put_edges(bytes: &mut [u8], table: &CaseTable, plan: &ShadowPlan, field: &RecordField) {
    let cells = table.cells().max(1);
    let clips = field.elements / cells;
    for facet in &plan.facets {
        let edges = edges_in_tile(facet).chain(std::iter::repeat(glam::DVec3::Z));
        for (index, edge) in (0..clips).zip(edges) {
            for cell in facet.cells.iter().filter(|cell| **cell < cells) {
                let offset = field.offset_bytes + (cell * clips + index) * field.stride_bytes;
                put_row(bytes, offset as usize, edge.extend(0.0));
            }
        }
    }
}
