//! What a case needs of a device, known before there is one.

use cssm_core::distribution::RemapKind;
use cssm_core::table::{
    BindingKind, CaseTable, ConstantKind, ConstantValue, FieldType, Meaning, Record, RecordField, RecordKind,
};

use crate::capture::vertex_storage_buffers;
use crate::error::ServiceError;
use crate::layout::incomplete;

/// Features and limits to request a device with.
#[derive(Debug, Clone, PartialEq)]
pub struct Requirements {
    /// Optional features of the adapter that the service uses: [`wgpu::Features::DEPTH_CLIP_CONTROL`] saves a fragment
    /// shader in the capture pass, together with [`wgpu::Features::CLIP_DISTANCES`] where facets share tiles;
    /// [`wgpu::Features::TIMESTAMP_QUERY`] times passes. Add the engine's own.
    pub features: wgpu::Features,
    /// The lowest limits that suffice. Merge them with the engine's own by
    /// [`wgpu::Limits::or_better_values_from`].
    pub limits: wgpu::Limits,
}

/// Features the service uses for every case where they are offered.
const USEFUL: wgpu::Features = wgpu::Features::DEPTH_CLIP_CONTROL.union(wgpu::Features::TIMESTAMP_QUERY);

/// Largest buffer of a mesh that shaders fetch from, unless the engine asks for more: what WebGPU has everywhere.
const MESH_BYTES: u64 = 128 << 20;

/// Features and limits that a case needs, to be requested with the engine's own.
///
/// # Errors
/// What the adapter cannot offer: a map or a record that is too large, a bind group number out of reach, comparison
/// samplers, storage buffers in vertex shaders.
pub fn features_and_limits(adapter: &wgpu::Adapter, table: &CaseTable) -> Result<Requirements, ServiceError> {
    let offered = adapter.limits();
    check_limits(&offered, table)?;
    let compares = bindings(table).any(|kind| kind == BindingKind::ComparisonSampler);
    let flags = adapter.get_downlevel_capabilities().flags;
    if compares && !flags.contains(wgpu::DownlevelFlags::COMPARISON_SAMPLERS) {
        return Err(ServiceError::NoComparisonSampler);
    }

    let storage_buffers = vertex_storage_buffers(table);
    if storage_buffers > 0 && !flags.contains(wgpu::DownlevelFlags::VERTEX_STORAGE) {
        let case = table.case.to_string();
        return Err(ServiceError::NoVertexStorage { case, needed: storage_buffers, offered: 0 });
    }

    // Start from what every adapter has and raise what the case exceeds.
    let lowest = wgpu::Limits::downlevel_webgl2_defaults().or_worse_values_from(&offered);
    let side = table.map_width.max(table.map_height);
    let record = table.records.iter().map(|record| u64::from(record.size_bytes)).max().unwrap_or(0);
    let groups = table.groups.iter().map(|group| group.group + 1).max().unwrap_or(0);
    let limits = wgpu::Limits {
        max_texture_dimension_2d: lowest.max_texture_dimension_2d.max(side),
        max_uniform_buffer_binding_size: lowest.max_uniform_buffer_binding_size.max(record),
        max_bind_groups: lowest.max_bind_groups.max(groups),
        max_storage_buffers_per_shader_stage: lowest
            .max_storage_buffers_per_shader_stage
            .max(storage_buffers),
        max_storage_buffer_binding_size: match storage_buffers {
            0 => lowest.max_storage_buffer_binding_size,
            _ => offered.max_storage_buffer_binding_size.min(MESH_BYTES),
        },
        ..lowest
    };
    let mut useful = USEFUL;
    useful.set(wgpu::Features::CLIP_DISTANCES, table.clips > 0);
    Ok(Requirements { features: adapter.features() & useful, limits })
}

/// Compares a case with the limits of an adapter or a device.
pub(crate) fn check_limits(offered: &wgpu::Limits, table: &CaseTable) -> Result<(), ServiceError> {
    let (width, height, limit) = (table.map_width, table.map_height, offered.max_texture_dimension_2d);
    if width.max(height) > limit {
        return Err(ServiceError::MapTooLarge { width, height, limit });
    }
    let limit = offered.max_uniform_buffer_binding_size;
    if let Some(record) = table.records.iter().find(|record| u64::from(record.size_bytes) > limit) {
        let (record, bytes) = (record.name.to_string(), record.size_bytes);
        return Err(ServiceError::RecordTooLarge { record, bytes, limit });
    }
    let limit = offered.max_bind_groups;
    if let Some(group) = table.groups.iter().find(|group| group.group >= limit) {
        return Err(ServiceError::GroupTooLarge { group: group.group, limit });
    }
    let (needed, offered) = (vertex_storage_buffers(table), offered.max_storage_buffers_per_shader_stage);
    if needed > offered {
        return Err(ServiceError::NoVertexStorage { case: table.case.to_string(), needed, offered });
    }
    Ok(())
}

/// Checks that records hold their fields and arrays have the lengths that the selection needs, so that writing a
/// plan that fits the table stays inside them. Generated tables always pass.
pub(crate) fn check_records(table: &CaseTable) -> Result<(), ServiceError> {
    let facet_bytes = table.record(RecordKind::Facet).map_or(0, |record| record.size_bytes);
    let (sectors, bands) = (table.halves.saturating_mul(table.sectors), table.bands);
    let planes = match table.constant(ConstantKind::GroundPlanes).map(|constant| constant.value) {
        Some(ConstantValue::U32(planes)) => planes,
        _ => 0,
    };
    let fits = |record: &Record, field: &RecordField| {
        let (size, elements) = match field.meaning {
            Meaning::Facets => (facet_bytes, table.cells()),
            Meaning::Borders | Meaning::Distances | Meaning::Units => (16, sectors),
            Meaning::Dominant => (16, 2),
            Meaning::Remap if table.remap == RemapKind::Logarithmic => (16, 2),
            Meaning::GroundPlanes => (16, planes),
            Meaning::GroundTiles => (16, table.cells().saturating_mul(planes).saturating_mul(4)),
            Meaning::GroundEdges => (16, table.cells().saturating_mul(table.clips)),
            Meaning::Clips => (16, table.clips),
            Meaning::Thresholds => (16, sectors.saturating_mul(bands.saturating_sub(1).div_ceil(4))),
            _ => (field_bytes(field.ty), 0),
        };
        let end = u64::from(field.offset_bytes)
            + u64::from(field.stride_bytes.max(size)) * u64::from(elements.max(1));
        elements == field.elements
            && (elements == 0 || field.stride_bytes >= size)
            && end <= u64::from(record.size_bytes)
    };
    let records = &table.records;
    let sound = records.iter().all(|record| record.fields.iter().all(|field| fits(record, field)));
    if sound && sectors > 0 && bands > 0 { Ok(()) } else { Err(incomplete(table, "sound record layout")) }
}

const fn field_bytes(ty: FieldType) -> u32 {
    match ty {
        FieldType::F32 => 4,
        FieldType::Vec2 => 8,
        FieldType::Vec4 | FieldType::Facet => 16,
    }
}

fn bindings(table: &CaseTable) -> impl Iterator<Item = BindingKind> + '_ {
    table.groups.iter().flat_map(|group| group.bindings.iter().map(|binding| binding.kind))
}
