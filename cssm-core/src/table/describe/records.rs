//! The records of a case.

use super::layout::Layout;
use super::{Names, bends_exactly};
use crate::case::{Bias, LightCase, MaskDepth};
use crate::distribution::RemapKind;
use crate::facet::FacetShape;
use crate::table::{FieldType, Meaning, Record, RecordKind};

pub(super) fn facet_record(names: &Names, case: &LightCase) -> Record {
    let mut layout = Layout::new();
    push_rows(&mut layout);
    layout.push("texel_from_ndc", Meaning::TexelFromNdc, FieldType::Vec4);
    layout.push("texel_limits", Meaning::TexelLimits, FieldType::Vec4);
    let biased_by_metres =
        matches!(case.bias, Bias::Constant { .. } | Bias::Slope { .. } | Bias::WorldTexel { .. });
    if biased_by_metres || case.filter.measures_depth() {
        layout.push("depth_per_metre", Meaning::DepthPerMetre, FieldType::F32);
    }
    match case.bias {
        Bias::None | Bias::Constant { .. } => {}
        Bias::Slope { .. } | Bias::WorldTexel { .. } => {
            layout.push("texel_metres_per_w", Meaning::TexelMetresPerW, FieldType::F32);
        }
        Bias::ReceiverPlane => {
            layout.push("receiver_plane_depth", Meaning::ReceiverPlaneDepth, FieldType::F32);
            if case.light.is_local() {
                layout.push("rounding_depth", Meaning::RoundingDepth, FieldType::F32);
            }
        }
    }
    push_remap(&mut layout, case);
    layout.record(RecordKind::Facet, names.ty(RecordKind::Facet.name()))
}

pub(super) fn shadow_record(names: &Names, case: &LightCase, facet_bytes: u32) -> Record {
    let shape = case.shape();
    let mut layout = Layout::new();
    let rings = shape.halves * shape.sectors;
    if shape.dominant {
        layout.push_array("dominant", Meaning::Dominant, FieldType::Vec4, 2, 16);
    }
    if shape.halves > 1 {
        layout.push("split", Meaning::Split, FieldType::Vec4);
    }
    if shape.sectors > 1 {
        layout.push_array("borders", Meaning::Borders, FieldType::Vec4, rings, 16);
    }
    if shape.bands > 1 {
        layout.push_array("distances", Meaning::Distances, FieldType::Vec4, rings, 16);
        if case.scales_thresholds() {
            layout.push_array("units", Meaning::Units, FieldType::Vec4, rings, 16);
        }
        let vectors = rings * threshold_vectors(shape);
        layout.push_array("thresholds", Meaning::Thresholds, FieldType::Vec4, vectors, 16);
    }
    if case.light.is_local() && case.bias != Bias::None {
        layout.push("light_position", Meaning::LightPosition, FieldType::Vec4);
    }
    if matches!(case.bias, Bias::Slope { .. }) && !case.light.is_local() {
        layout.push("toward_light", Meaning::TowardLight, FieldType::Vec4);
    }
    if case.shears() {
        layout.push("shear", Meaning::Shear, FieldType::Vec4);
    }
    if case.filter.measures_pixels() {
        layout.push("pixel_metres", Meaning::PixelMetres, FieldType::Vec4);
    }
    if case.may_reverse_depth() {
        layout.push("depth_sign", Meaning::DepthSign, FieldType::F32);
    }
    let (planes, cells) = (case.filter.ground_planes(), shape.cells());
    if planes > 0 {
        layout.push_array("ground_planes", Meaning::GroundPlanes, FieldType::Vec4, planes, 16);
        let vectors = cells * planes * VECTORS_A_PLANE;
        layout.push_array("ground_tiles", Meaning::GroundTiles, FieldType::Vec4, vectors, 16);
    }
    if planes > 0 && shape.clips > 0 {
        let vectors = cells * shape.clips;
        layout.push_array("ground_edges", Meaning::GroundEdges, FieldType::Vec4, vectors, 16);
    }
    layout.push_array("facets", Meaning::Facets, FieldType::Facet, shape.cells(), facet_bytes);
    layout.record(RecordKind::Shadow, names.ty(RecordKind::Shadow.name()))
}

pub(super) fn capture_record(names: &Names, case: &LightCase) -> Record {
    let shape = case.shape();
    let mut layout = Layout::new();
    push_rows(&mut layout);
    push_remap(&mut layout, case);
    if case.remap() != RemapKind::None {
        layout.push("tile_size", Meaning::TileSize, FieldType::Vec2);
    }
    if bends_exactly(case) {
        layout.push("stretch_tile", Meaning::StretchTile, FieldType::Vec4);
    }
    if shape.clips > 0 {
        layout.push_array("clips", Meaning::Clips, FieldType::Vec4, shape.clips, 16);
    }
    layout.record(RecordKind::Capture, names.ty(RecordKind::Capture.name()))
}

pub(super) fn caster_mask_record(names: &Names) -> Record {
    let mut layout = Layout::new();
    layout.push("alpha_cutoff", Meaning::AlphaCutoff, FieldType::F32);
    layout.record(RecordKind::CasterMask, names.ty(RecordKind::CasterMask.name()))
}

pub(super) fn mask_record(names: &Names, depth: MaskDepth) -> Record {
    let mut layout = Layout::new();
    layout.push("ray_corner", Meaning::RayCorner, FieldType::Vec4);
    layout.push("ray_across", Meaning::RayAcross, FieldType::Vec4);
    layout.push("ray_down", Meaning::RayDown, FieldType::Vec4);
    if depth == MaskDepth::ReversedZ {
        layout.push("inverse_depth", Meaning::InverseDepth, FieldType::Vec2);
    }
    layout.record(RecordKind::Mask, names.ty(RecordKind::Mask.name()))
}

pub(super) fn fit_record(names: &Names, depth: MaskDepth) -> Record {
    let mut layout = Layout::new();
    if depth == MaskDepth::ReversedZ {
        layout.push("inverse_depth", Meaning::InverseDepth, FieldType::Vec2);
    }
    layout.push("per_near", Meaning::PerNear, FieldType::F32);
    layout.record(RecordKind::Fit, names.ty(RecordKind::Fit.name()))
}

/// Vectors that tell where a plane lies in a tile.
pub(in crate::table) const VECTORS_A_PLANE: u32 = 4;

/// Vectors of four thresholds in each sector.
pub(super) fn threshold_vectors(shape: FacetShape) -> u32 {
    shape.bands.saturating_sub(1).div_ceil(4)
}

fn push_rows(layout: &mut Layout) {
    layout.push("row_x", Meaning::RowX, FieldType::Vec4);
    layout.push("row_y", Meaning::RowY, FieldType::Vec4);
    layout.push("row_z", Meaning::RowZ, FieldType::Vec4);
    layout.push("row_w", Meaning::RowW, FieldType::Vec4);
}

fn push_remap(layout: &mut Layout, case: &LightCase) {
    match case.remap() {
        RemapKind::None => {}
        RemapKind::Perspective => layout.push("remap", Meaning::Remap, FieldType::Vec4),
        RemapKind::Logarithmic => layout.push_array("remap", Meaning::Remap, FieldType::Vec4, 2, 16),
    }
}
