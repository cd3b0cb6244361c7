//! Files of the capture stage, whole and around an engine's own functions.

use cssm_core::distribution::RemapKind;
use cssm_core::table::{CaseTable, GroupContent, ShaderKind};

use super::remap::{Remap, remap};
use super::{LibraryFile, in_order};

/// Files of a capture shader.
pub(super) fn files(table: &CaseTable, shader: ShaderKind) -> Vec<&'static str> {
    let (clipped, clamped, tested) = (table.clips > 0, is_clamped(shader), is_tested(shader));
    if is_bent(shader) {
        return bent(table, shader);
    }
    let mut names = match bends_exactly(table) {
        true => ordinary(table),
        false => std::iter::once("caster").chain(tile_position(table)).collect(),
    };
    names.extend(clipped.then_some("caster_clips"));
    names.extend((clipped && clamped).then_some("caster_cut"));
    names.extend(tested.then_some("caster_mask"));
    names.extend(clamped.then_some("caster_depth"));
    names.push(match (tested, clamped, clipped) {
        (false, false, false) => "capture",
        (false, false, true) => "capture_clipped",
        (false, true, false) => "capture_clamped",
        (false, true, true) => "capture_clamped_clipped",
        (true, false, false) => "capture_tested",
        (true, false, true) => "capture_tested_clipped",
        (true, true, false) => "capture_tested_clamped",
        (true, true, true) => "capture_tested_clamped_clipped",
    });
    names
}

/// The files of a capture module around an engine's own functions, in the order of the library; what calls the engine is
/// generated. `tested`: the engine tells holes; `has_rows`: rows take its positions to the capture's axes.
pub(crate) fn caster_entry(
    table: &CaseTable,
    clamped: bool,
    tested: bool,
    has_rows: bool,
) -> Vec<LibraryFile> {
    let clipped = table.clips > 0;
    let mut names = tile_position(table);
    names.extend(has_rows.then_some("caster_placed"));
    names.extend(clipped.then_some("caster_clips"));
    names.extend((clipped && clamped).then_some("caster_cut"));
    names.extend(clamped.then_some("caster_depth"));
    if !tested {
        names.push(match (clamped, clipped) {
            (false, false) => "capture",
            (false, true) => "capture_clipped",
            (true, false) => "capture_clamped",
            (true, true) => "capture_clamped_clipped",
        });
    }
    in_order(&names)
}

/// Whether a capture shader clamps depth and cuts casters by itself, on every device.
fn is_clamped(shader: ShaderKind) -> bool {
    matches!(shader, ShaderKind::CaptureClamped | ShaderKind::CaptureTestedClamped)
}

/// Whether a capture shader leaves out the holes of an alpha mask.
fn is_tested(shader: ShaderKind) -> bool {
    matches!(shader, ShaderKind::CaptureTested | ShaderKind::CaptureTestedClamped)
}

/// Whether a capture shader decides triangles texel by texel.
fn is_bent(shader: ShaderKind) -> bool {
    matches!(shader, ShaderKind::CaptureBent | ShaderKind::CaptureBentTested)
}

/// Whether a table's casters are told apart by how far rows bend their edges.
fn bends_exactly(table: &CaseTable) -> bool {
    table.group(ShaderKind::CaptureBent, GroupContent::CasterMesh).is_some()
}

/// Files of casters whose straight edges are close enough to bent ones.
fn ordinary(table: &CaseTable) -> Vec<&'static str> {
    let mut names = remap(table.remap, &[Remap::Value, Remap::Slope]);
    names.extend(["stretch_bend", bending(table), "stretch_mesh", "stretch_triangle", "stretch_ordinary"]);
    names
}

/// Files of a shader that decides triangles texel by texel.
fn bent(table: &CaseTable, shader: ShaderKind) -> Vec<&'static str> {
    let mut names = remap(table.remap, &[Remap::Value, Remap::Slope, Remap::Inverse]);
    names.extend(["stretch_bend", bending(table), "stretch_mesh", "stretch_triangle"]);
    names.extend(["stretch_weights", "stretch_chords", "stretch_fan", "stretch_cover"]);
    match (shader == ShaderKind::CaptureBentTested, table.clips > 0) {
        (false, _) => names.push("capture_bent"),
        (true, false) => names.extend(["stretch_mesh_uv", "caster_mask", "capture_bent_tested"]),
        (true, true) => {
            names.extend(["stretch_mesh_uv", "caster_mask", "caster_clips", "caster_cut"]);
            names.push("capture_bent_tested_clipped");
        }
    }
    names
}

/// The file that tells how edges bend.
fn bending(table: &CaseTable) -> &'static str {
    match table.remap {
        RemapKind::Logarithmic => "stretch_logarithmic",
        RemapKind::None | RemapKind::Perspective => "stretch_perspective",
    }
}

/// Files that place a corner in a tile.
fn tile_position(table: &CaseTable) -> Vec<&'static str> {
    let mut names = remap(table.remap, &[Remap::Value, Remap::Slope, Remap::Inverse]);
    names.push(if names.is_empty() { "caster_tile" } else { "caster_tile_bent" });
    names
}
