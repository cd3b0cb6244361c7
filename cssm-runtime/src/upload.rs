//! A plan into a frame's buffers, rounded once.

use cssm_core::ShadowPlan;
use cssm_core::View;
use cssm_core::plan::DepthOrder;
use cssm_core::table::{CaseTable, write_capture_record_to, write_mask_record_to, write_shadow_record_to};

use crate::cull::InstanceRows;
use crate::error::ServiceError;
use crate::frame::{Slot, UniformLayout};

/// Checks that a plan can be written into a table's records and drawn into its map.
pub(crate) fn check_plan(table: &CaseTable, plan: &ShadowPlan, view: &View) -> Result<(), ServiceError> {
    let foreign = |why| Err(ServiceError::ForeignPlan { case: table.case.to_string(), why });
    if plan.map_size_texels != (table.map_width, table.map_height) {
        return foreign("its map has another size");
    }
    if plan.depth_order == DepthOrder::Reversed && !table.may_reverse_depth {
        return foreign("it stores depth reversed");
    }
    if plan.facets.iter().flat_map(|facet| &facet.cells).any(|cell| *cell >= table.cells()) {
        return foreign("it has more facets");
    }
    if !plan.facets.is_sorted_by(|one, other| one.first_cell() < other.first_cell()) {
        return foreign("its facets are not in ascending order");
    }

    // The selection must fill the table's arrays and no more.
    let selection = &plan.selection;
    let rows = |count: usize, used: bool| count as u32 == if used { table.halves * table.sectors } else { 0 };
    if !rows(selection.borders.len(), table.sectors > 1)
        || !rows(selection.distances.len(), table.bands > 1)
        || !rows(selection.units.len(), table.scales_thresholds)
        || selection.split.is_some() != (table.halves > 1)
        || selection.dominant.is_some() != table.dominant
        || selection.bands != table.bands
        || selection.thresholds.len() as u32 != selection.distances.len() as u32 * (table.bands - 1)
    {
        return foreign("its selection has another shape");
    }

    // Tiles must lie in the map and rows must survive the rounding.
    for facet in &plan.facets {
        let tile = &facet.tile;
        let right = tile.x.checked_add(tile.width).is_some_and(|right| right <= table.map_width);
        let bottom = tile.y.checked_add(tile.height).is_some_and(|bottom| bottom <= table.map_height);
        if !right || !bottom || tile.width == 0 || tile.height == 0 {
            return foreign("a tile leaves its map");
        }
        if facet.clip.len() > table.clips as usize {
            return foreign("a facet cuts casters with more half-spaces");
        }
        let rows = [facet.rows.x, facet.rows.y, facet.rows.z, facet.rows.w];
        if rows.iter().chain(&facet.clip).any(|row| !row.as_vec4().is_finite()) {
            return foreign("a facet's rows are not finite in f32");
        }
    }
    if !plan.shear.is_finite() {
        return foreign("its shear is not finite");
    }
    if view.eye_world != plan.eye_world || view.camera_from_world != plan.camera_from_world {
        return Err(ServiceError::ForeignView);
    }
    Ok(())
}

/// Writes all records and instance rows of a frame; to be called under an error scope. Capture records come from the
/// plan that casters are drawn by, the others from the same facets relative to the view; `bytes` keeps its memory.
pub(crate) fn upload(
    queue: &wgpu::Queue,
    table: &CaseTable,
    layout: &UniformLayout,
    slot: &Slot,
    plans: Plans<'_>,
    rows: &[&[InstanceRows]],
    bytes: &mut Vec<u8>,
) {
    bytes.clear();
    bytes.resize(layout.size as usize, 0);
    for (position, facet) in plans.capture.facets.iter().enumerate() {
        let place = from(bytes, position as u64 * layout.facet_stride);
        write_capture_record_to(table, plans.capture, facet, place);
    }
    write_shadow_record_to(table, plans.resolve, from(bytes, layout.shadow_offset));
    write_mask_record_to(table, plans.view, from(bytes, layout.mask_offset));
    queue.write_buffer(&slot.uniforms, 0, bytes);
    let mut offset = 0;
    for rows in rows.iter().filter(|rows| !rows.is_empty()) {
        queue.write_buffer(&slot.instances, offset, bytemuck::cast_slice(rows));
        offset += rows.len() as u64 * InstanceRows::BYTES;
    }
}

/// What follows an offset.
fn from(bytes: &mut [u8], offset: u64) -> &mut [u8] {
    bytes.get_mut(offset as usize..).unwrap_or_default()
}

/// One plan, or the same facets relative to two eyes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plans<'a> {
    pub(crate) capture: &'a ShadowPlan,
    pub(crate) resolve: &'a ShadowPlan,
    /// The view that the second eye is of.
    pub(crate) view: &'a View,
}
