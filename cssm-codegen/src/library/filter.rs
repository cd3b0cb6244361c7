//! Files of filters: those in the resolve stage, and the prefilter's.

use cssm_core::case::{Filter, Kernel, LightCase};
use cssm_core::table::{CaseTable, ShaderKind};

use super::order;
use super::remap::{Remap, remap};

/// Files of the filter and its kernel.
pub(super) fn files(case: &LightCase, table: &CaseTable, plane: bool) -> Vec<&'static str> {
    let own: &[_] = match (case.filter, plane) {
        (Filter::None, false) => return vec!["filter_none_flat"],
        (Filter::None, true) => return vec!["filter_none_plane"],
        (Filter::Hardware2x2, false) => return vec!["filter_hardware_flat"],
        (Filter::Hardware2x2, true) => return vec!["filter_hardware_plane"],
        (Filter::Gather2x2, false) => return vec!["filter_gather_flat"],
        (Filter::Gather2x2, true) => return vec!["filter_gather_plane"],
        (Filter::GroundMasks { .. }, false) => return vec!["filter_gather_flat", "filter_ground"],
        (Filter::GroundMasks { .. }, true) => return vec!["filter_gather_plane", "filter_ground"],
        (Filter::Evsm2 { .. }, _) => return vec!["moments_warp", "filter_moments"],
        (Filter::Pcf { kernel: Kernel::Texels, .. }, _) => &["kernel_texels", "filter_pcf_fixed"],
        (Filter::Pcf { kernel: Kernel::Metres(_), .. }, _) => &["kernel_metres", "filter_pcf_varying"],
        (Filter::Pcf { kernel: Kernel::Pixels(_), .. }, _) => &["kernel_pixels", "filter_pcf_varying"],
        (Filter::Pcss { .. }, false) => &["kernel_light", "filter_casters_flat", "filter_pcss"],
        (Filter::Pcss { .. }, true) => &["kernel_light", "filter_casters_plane", "filter_pcss"],
    };
    let mut names = own.to_vec();
    names.extend([
        "kernel_room",
        "filter_overlap",
        if plane { "filter_box_plane" } else { "filter_box_flat" },
    ]);
    if case.filter.measures_texels() {
        names.extend(["texel_density", if table.shears { "gradient_sheared" } else { "gradient_plain" }]);
    }
    names
}

/// Files of a pass of the prefilter.
pub(super) fn prefilter(case: &LightCase, table: &CaseTable, shader: ShaderKind) -> Vec<&'static str> {
    if case.filter.ground_planes() > 0 {
        return ground(table, shader);
    }
    if shader == ShaderKind::PrefilterColumns {
        return vec!["moments_tile", "prefilter_columns"];
    }
    vec!["moments_tile", "moments_warp", order(table), "prefilter_rows"]
}

/// Files of a pass that makes masks of planes.
fn ground(table: &CaseTable, shader: ShaderKind) -> Vec<&'static str> {
    let mut names = remap(table.remap, &[Remap::Slope, Remap::Inverse]);
    names.push(if names.is_empty() { "ground_straight" } else { "ground_bent" });
    names.extend(["ground_corner", "ground_planes"]);
    let cut = table.clips > 0;
    names.extend(cut.then_some("ground_cut"));
    names.extend(match (shader, cut) {
        (ShaderKind::PrefilterColumns, false) => ["ground_columns", "prefilter_ground_columns"],
        (ShaderKind::PrefilterColumns, true) => ["ground_columns", "prefilter_ground_columns_cut"],
        (_, false) => ["ground_rows", "prefilter_ground_rows"],
        (_, true) => ["ground_rows", "prefilter_ground_rows_cut"],
    });
    if shader == ShaderKind::PrefilterRows {
        names.push(order(table));
    }
    names
}
