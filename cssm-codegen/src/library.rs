//! The shader library: one file for each alternative of each slot, and which of them a case takes.

mod filter;

use cssm_core::case::{Bias, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::distribution::RemapKind;
use cssm_core::table::{CaseTable, ConstantKind, GroupContent, ShaderKind};

/// A file of the library.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct LibraryFile {
    /// File name without folder and extension.
    pub(crate) name: &'static str,
    /// Its text.
    pub(crate) source: &'static str,
}

macro_rules! library {
    ($($name:literal),* $(,)?) => {
        /// Every file; a module prints them in this order, leaves first.
        pub(crate) const LIBRARY: &[LibraryFile] = &[
            $(LibraryFile { name: $name, source: include_str!(concat!("shaders/", $name, ".wgsl")) }),*
        ];
    };
}

library![
    "remap_perspective_divisor",
    "remap_perspective",
    "remap_perspective_slope",
    "remap_perspective_inverse",
    "remap_logarithmic",
    "remap_logarithmic_slope",
    "remap_logarithmic_inverse",
    "caster",
    "caster_tile",
    "caster_tile_bent",
    "caster_clips",
    "caster_cut",
    "caster_mask",
    "caster_depth",
    "caster_placed",
    "capture",
    "capture_clipped",
    "capture_clamped",
    "capture_clamped_clipped",
    "capture_tested",
    "capture_tested_clipped",
    "capture_tested_clamped",
    "capture_tested_clamped_clipped",
    "stretch_bend",
    "stretch_perspective",
    "stretch_logarithmic",
    "stretch_mesh",
    "stretch_mesh_uv",
    "stretch_triangle",
    "stretch_ordinary",
    "stretch_weights",
    "stretch_chords",
    "stretch_fan",
    "stretch_cover",
    "capture_bent",
    "capture_bent_tested",
    "capture_bent_tested_clipped",
    "axes_plain",
    "axes_sheared",
    "axes_plain_normal",
    "axes_sheared_normal",
    "sector_walk",
    "half_walk",
    "select_sectors",
    "select_bands",
    "select_bands_scaled",
    "select_sectors_bands",
    "select_sectors_bands_scaled",
    "dominant_plane",
    "own_walked",
    "own_dominant",
    "own_dominant_only",
    "place",
    "place_pixels",
    "place_bent_flat",
    "place_bent_plane",
    "place_bent_pixels",
    "order_fixed",
    "order_chosen",
    "sampler_fixed",
    "sampler_chosen",
    "receiver_flat",
    "receiver_plane",
    "up_straight",
    "up_bent",
    "plane_gradient",
    "gradient_plain",
    "gradient_sheared",
    "texel_density",
    "kernel_room",
    "kernel_texels",
    "kernel_metres",
    "kernel_pixels",
    "kernel_light",
    "light_distance",
    "bias_none",
    "bias_constant",
    "bias_constant_local",
    "bias_world_texel",
    "bias_world_texel_local",
    "bias_slope",
    "bias_slope_local",
    "bias_receiver_plane",
    "bias_receiver_plane_local",
    "bias_receiver_plane_bound",
    "bias_receiver_plane_bound_local",
    "filter_none_flat",
    "filter_none_plane",
    "filter_hardware_flat",
    "filter_hardware_plane",
    "filter_gather_flat",
    "filter_gather_plane",
    "filter_overlap",
    "filter_box_flat",
    "filter_box_plane",
    "filter_pcf_fixed",
    "filter_pcf_varying",
    "filter_casters_flat",
    "filter_casters_plane",
    "filter_pcss",
    "moments_warp",
    "moments_tile",
    "prefilter_rows",
    "prefilter_columns",
    "filter_moments",
    "ground_corner",
    "ground_straight",
    "ground_bent",
    "ground_cut",
    "ground_planes",
    "ground_rows",
    "ground_columns",
    "prefilter_ground_rows",
    "prefilter_ground_rows_cut",
    "prefilter_ground_columns",
    "prefilter_ground_columns_cut",
    "filter_ground",
    "visibility_one_unbiased",
    "visibility_one_biased",
    "visibility_one_normal",
    "visibility_one_biased_local",
    "visibility_one_normal_local",
    "visibility_many_unbiased",
    "visibility_many_biased",
    "visibility_many_normal",
    "visibility_many_biased_local",
    "visibility_many_normal_local",
    "visibility_one_unbiased_wide",
    "visibility_one_biased_wide",
    "visibility_one_normal_wide",
    "visibility_one_biased_local_wide",
    "visibility_one_normal_local_wide",
    "visibility_many_unbiased_wide",
    "visibility_many_biased_wide",
    "visibility_many_normal_wide",
    "visibility_many_biased_local_wide",
    "visibility_many_normal_local_wide",
    "visibility_one_unbiased_masked",
    "visibility_one_biased_masked",
    "visibility_one_normal_masked",
    "visibility_one_biased_local_masked",
    "visibility_one_normal_local_masked",
    "visibility_many_unbiased_masked",
    "visibility_many_biased_masked",
    "visibility_many_normal_masked",
    "visibility_many_biased_local_masked",
    "visibility_many_normal_local_masked",
    "depth_reversed_z",
    "depth_linear",
    "view_ray",
    "reconstruct_normal",
    "mask_vertex",
    "mask_position",
    "mask_reconstructed",
    "mask_texture",
    "fit_reversed_z",
    "fit_linear",
    "fit_bin",
    "fit",
];

/// The files that a shader of a case is made of, in the order of the library, and the declarations that it is for.
pub(crate) fn pick(
    case: &LightCase,
    table: &CaseTable,
    shader: ShaderKind,
) -> (Vec<LibraryFile>, &'static [&'static str]) {
    let (names, roots): (_, &[_]) = match shader {
        ShaderKind::Capture => (capture(table, shader), &["capture_vertex"]),
        ShaderKind::CaptureClamped => {
            (capture(table, shader), &["capture_clamped_vertex", "capture_clamped_fragment"])
        }
        ShaderKind::CaptureTested => {
            (capture(table, shader), &["capture_tested_vertex", "capture_tested_fragment"])
        }
        ShaderKind::CaptureTestedClamped => {
            (capture(table, shader), &["capture_tested_clamped_vertex", "capture_tested_clamped_fragment"])
        }
        ShaderKind::CaptureBent => {
            (capture(table, shader), &["capture_bent_vertex", "capture_bent_fragment"])
        }
        ShaderKind::CaptureBentTested => {
            (capture(table, shader), &["capture_bent_tested_vertex", "capture_bent_tested_fragment"])
        }
        ShaderKind::PrefilterRows => {
            (filter::prefilter(case, table, shader), &["prefilter_rows_vertex", "prefilter_rows_fragment"])
        }
        ShaderKind::PrefilterColumns => (
            filter::prefilter(case, table, shader),
            &["prefilter_columns_vertex", "prefilter_columns_fragment"],
        ),
        ShaderKind::Mask => {
            let mut names = visibility(case, table);
            names.extend(mask(case));
            (names, &["mask_vertex", "mask_fragment"])
        }
        ShaderKind::Function => (visibility(case, table), &["visibility"]),
        ShaderKind::Fit => (fit(case), &["fit_measure"]),
    };
    let files = LIBRARY.iter().filter(|file| names.contains(&file.name)).copied().collect();
    (files, roots)
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
    LIBRARY.iter().filter(|file| names.contains(&file.name)).copied().collect()
}

/// Whether a capture shader clamps depth and cuts casters by itself, on every device.
pub(crate) fn is_clamped(shader: ShaderKind) -> bool {
    matches!(shader, ShaderKind::CaptureClamped | ShaderKind::CaptureTestedClamped)
}

/// Whether a capture shader leaves out the holes of an alpha mask.
pub(crate) fn is_tested(shader: ShaderKind) -> bool {
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

/// The file that tells which way depths compare.
fn order(table: &CaseTable) -> &'static str {
    if table.may_reverse_depth { "order_chosen" } else { "order_fixed" }
}

/// Files of a capture shader.
fn capture(table: &CaseTable, shader: ShaderKind) -> Vec<&'static str> {
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

/// What shaders need of a remap.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Remap {
    /// `remapped`: from one over distance to clip y.
    Value,
    /// `remap_slope`: the change of clip y.
    Slope,
    /// `unremapped`: back to one over distance.
    Inverse,
}

/// Files of a remap; none where rows are straight.
fn remap(kind: RemapKind, needs: &[Remap]) -> Vec<&'static str> {
    let file = |need: &Remap| match (kind, need) {
        (RemapKind::None, _) => None,
        (RemapKind::Perspective, Remap::Value) => Some("remap_perspective"),
        (RemapKind::Perspective, Remap::Slope) => Some("remap_perspective_slope"),
        (RemapKind::Perspective, Remap::Inverse) => Some("remap_perspective_inverse"),
        (RemapKind::Logarithmic, Remap::Value) => Some("remap_logarithmic"),
        (RemapKind::Logarithmic, Remap::Slope) => Some("remap_logarithmic_slope"),
        (RemapKind::Logarithmic, Remap::Inverse) => Some("remap_logarithmic_inverse"),
    };
    let divisor = (kind == RemapKind::Perspective).then_some("remap_perspective_divisor");
    divisor.into_iter().chain(needs.iter().filter_map(file)).collect()
}

/// Files of the visibility function.
fn visibility(case: &LightCase, table: &CaseTable) -> Vec<&'static str> {
    let plane = case.bias == Bias::ReceiverPlane;
    let local = table.local_light && case.bias != Bias::None;
    let bent = table.remap != RemapKind::None;
    let measures = case.filter.measures_texels();
    let mut names = walk(table);

    // Bring the receiver to the axes of the facets.
    names.push(if table.shears { "axes_sheared" } else { "axes_plain" });
    if plane || case.bias.reads_normal() && !local {
        names.push(if table.shears { "axes_sheared_normal" } else { "axes_plain_normal" });
    }

    // Place it in its facet.
    names.push(match (bent, plane || measures, case.filter.measures_pixels()) {
        (false, _, false) => "place",
        (false, _, true) => "place_pixels",
        (true, false, _) => "place_bent_flat",
        (true, true, false) => "place_bent_plane",
        (true, true, true) => "place_bent_pixels",
    });
    names.extend(remap(
        table.remap,
        if plane || measures { &[Remap::Value, Remap::Slope] } else { &[Remap::Value] },
    ));

    // Tell which way depths compare.
    names.push(order(table));
    if case.filter == Filter::Hardware2x2 {
        names.push(if table.may_reverse_depth { "sampler_chosen" } else { "sampler_fixed" });
    }

    // Find the reference and compare it.
    names.push(if plane { "receiver_plane" } else { "receiver_flat" });
    names.extend(plane.then_some("plane_gradient"));
    names.extend((plane || measures).then_some(if bent { "up_bent" } else { "up_straight" }));
    names.extend(local.then_some("light_distance"));
    names.push(bias(case, table));
    names.extend(filter::files(case, table, plane));

    // Join them.
    let many = table.cells() > 1;
    if case.filter.is_wide() {
        names.push(filter::joined_wide(case, many, local));
        return names;
    }
    if case.filter.ground_planes() > 0 {
        names.push(filter::joined_masked(case, many, local));
        return names;
    }
    names.push(match (many, case.bias.reads_normal(), local) {
        (false, _, _) if case.bias == Bias::None => "visibility_one_unbiased",
        (true, _, _) if case.bias == Bias::None => "visibility_many_unbiased",
        (false, false, false) => "visibility_one_biased",
        (false, false, true) => "visibility_one_biased_local",
        (false, true, false) => "visibility_one_normal",
        (false, true, true) => "visibility_one_normal_local",
        (true, false, false) => "visibility_many_biased",
        (true, false, true) => "visibility_many_biased_local",
        (true, true, false) => "visibility_many_normal",
        (true, true, true) => "visibility_many_normal_local",
    });
    names
}

/// Files that find the facet of a receiver; none for a single facet.
fn walk(table: &CaseTable) -> Vec<&'static str> {
    let (sectors, bands) = (table.sectors > 1, table.bands > 1);
    let mut names = Vec::new();
    if sectors {
        names.push(if table.halves > 1 { "half_walk" } else { "sector_walk" });
    }
    names.extend(match (sectors, bands, table.scales_thresholds) {
        (false, false, _) => None,
        (true, false, _) => Some("select_sectors"),
        (false, true, false) => Some("select_bands"),
        (false, true, true) => Some("select_bands_scaled"),
        (true, true, false) => Some("select_sectors_bands"),
        (true, true, true) => Some("select_sectors_bands_scaled"),
    });
    if table.dominant {
        names.push("dominant_plane");
    }
    names.extend(match (table.dominant, sectors || bands) {
        (false, false) => None,
        (false, true) => Some("own_walked"),
        (true, false) => Some("own_dominant_only"),
        (true, true) => Some("own_dominant"),
    });
    names
}

/// The file of the bias.
fn bias(case: &LightCase, table: &CaseTable) -> &'static str {
    let bound = table.constant(ConstantKind::StretchBound).is_some();
    match (case.bias, table.local_light) {
        (Bias::None, _) => "bias_none",
        (Bias::Constant { .. }, false) => "bias_constant",
        (Bias::Constant { .. }, true) => "bias_constant_local",
        (Bias::WorldTexel { .. }, false) => "bias_world_texel",
        (Bias::WorldTexel { .. }, true) => "bias_world_texel_local",
        (Bias::Slope { .. }, false) => "bias_slope",
        (Bias::Slope { .. }, true) => "bias_slope_local",
        (Bias::ReceiverPlane, false) if bound => "bias_receiver_plane_bound",
        (Bias::ReceiverPlane, true) if bound => "bias_receiver_plane_bound_local",
        (Bias::ReceiverPlane, false) => "bias_receiver_plane",
        (Bias::ReceiverPlane, true) => "bias_receiver_plane_local",
    }
}

/// Files of the reduction of depth.
fn fit(case: &LightCase) -> Vec<&'static str> {
    let linear = case
        .resolve
        .iter()
        .any(|interface| matches!(interface, Resolve::Mask { depth: MaskDepth::Linear, .. }));
    vec![if linear { "fit_linear" } else { "fit_reversed_z" }, "fit_bin", "fit"]
}

/// Files of the mask pass beside the visibility function.
fn mask(case: &LightCase) -> Vec<&'static str> {
    let mut names = vec!["mask_vertex", "view_ray"];
    for interface in &case.resolve {
        let Resolve::Mask { depth, normal } = *interface else {
            continue;
        };
        names.push(match depth {
            MaskDepth::ReversedZ => "depth_reversed_z",
            MaskDepth::Linear => "depth_linear",
        });
        match (case.bias.reads_normal(), normal) {
            (false, _) => names.push("mask_position"),
            (true, MaskNormal::Reconstructed) => names.extend(["reconstruct_normal", "mask_reconstructed"]),
            (true, MaskNormal::Texture) => names.push("mask_texture"),
        }
    }
    names
}

#[cfg(test)]
mod tests;
