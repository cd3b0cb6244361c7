//! The shader library: one file for each alternative of each slot, and which of them a case takes.

use cssm_core::case::{Bias, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::table::{CaseTable, ShaderKind};

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
    "caster",
    "caster_tile",
    "caster_clips",
    "caster_cut",
    "caster_mask",
    "caster_depth",
    "capture",
    "capture_clipped",
    "capture_clamped",
    "capture_clamped_clipped",
    "capture_tested",
    "capture_tested_clipped",
    "capture_tested_clamped",
    "capture_tested_clamped_clipped",
    "axes_plain",
    "axes_sheared",
    "axes_plain_normal",
    "axes_sheared_normal",
    "sector_walk",
    "select_sectors",
    "select_bands",
    "select_sectors_bands",
    "place",
    "order_fixed",
    "order_chosen",
    "sampler_fixed",
    "sampler_chosen",
    "receiver_flat",
    "receiver_plane",
    "bias_none",
    "bias_constant",
    "bias_world_texel",
    "bias_slope",
    "bias_receiver_plane",
    "filter_none_flat",
    "filter_none_plane",
    "filter_hardware_flat",
    "filter_hardware_plane",
    "filter_gather_flat",
    "filter_gather_plane",
    "visibility_one_unbiased",
    "visibility_one_biased",
    "visibility_one_normal",
    "visibility_many_unbiased",
    "visibility_many_biased",
    "visibility_many_normal",
    "depth_reversed_z",
    "depth_linear",
    "view_ray",
    "reconstruct_normal",
    "mask_vertex",
    "mask_position",
    "mask_reconstructed",
    "mask_texture",
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
        ShaderKind::Mask => {
            let mut names = visibility(case, table);
            names.extend(mask(case));
            (names, &["mask_vertex", "mask_fragment"])
        }
        ShaderKind::Function => (visibility(case, table), &["visibility"]),
    };
    let files = LIBRARY.iter().filter(|file| names.contains(&file.name)).copied().collect();
    (files, roots)
}

/// Whether a capture shader clamps depth and cuts casters by itself, on every device.
pub(crate) fn is_clamped(shader: ShaderKind) -> bool {
    matches!(shader, ShaderKind::CaptureClamped | ShaderKind::CaptureTestedClamped)
}

/// Whether a capture shader leaves out the holes of an alpha mask.
pub(crate) fn is_tested(shader: ShaderKind) -> bool {
    matches!(shader, ShaderKind::CaptureTested | ShaderKind::CaptureTestedClamped)
}

/// Files of a capture shader.
fn capture(table: &CaseTable, shader: ShaderKind) -> Vec<&'static str> {
    let (clipped, clamped, tested) = (table.clips > 0, is_clamped(shader), is_tested(shader));
    let mut names = vec!["caster", "caster_tile"];
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

/// Files of the visibility function.
fn visibility(case: &LightCase, table: &CaseTable) -> Vec<&'static str> {
    let mut names = vec!["place"];

    // Find the facet.
    names.extend((table.sectors > 1).then_some("sector_walk"));
    names.extend(match (table.sectors > 1, table.bands > 1) {
        (false, false) => None,
        (true, false) => Some("select_sectors"),
        (false, true) => Some("select_bands"),
        (true, true) => Some("select_sectors_bands"),
    });

    // Bring the receiver to the axes of the facets.
    names.push(if table.shears { "axes_sheared" } else { "axes_plain" });
    if case.bias.reads_normal() {
        names.push(if table.shears { "axes_sheared_normal" } else { "axes_plain_normal" });
    }

    // Tell which way depths compare.
    names.push(if table.may_reverse_depth { "order_chosen" } else { "order_fixed" });
    if case.filter == Filter::Hardware2x2 {
        names.push(if table.may_reverse_depth { "sampler_chosen" } else { "sampler_fixed" });
    }

    // Find the reference and compare it.
    let plane = case.bias == Bias::ReceiverPlane;
    names.push(if plane { "receiver_plane" } else { "receiver_flat" });
    names.push(match case.bias {
        Bias::None => "bias_none",
        Bias::Constant { .. } => "bias_constant",
        Bias::WorldTexel { .. } => "bias_world_texel",
        Bias::Slope { .. } => "bias_slope",
        Bias::ReceiverPlane => "bias_receiver_plane",
    });
    names.push(match (case.filter, plane) {
        (Filter::None, false) => "filter_none_flat",
        (Filter::None, true) => "filter_none_plane",
        (Filter::Hardware2x2, false) => "filter_hardware_flat",
        (Filter::Hardware2x2, true) => "filter_hardware_plane",
        (Filter::Gather2x2, false) => "filter_gather_flat",
        (Filter::Gather2x2, true) => "filter_gather_plane",
    });

    // Join them.
    names.push(match (table.facets() > 1, case.bias) {
        (false, Bias::None) => "visibility_one_unbiased",
        (false, Bias::Constant { .. } | Bias::WorldTexel { .. }) => "visibility_one_biased",
        (false, Bias::Slope { .. } | Bias::ReceiverPlane) => "visibility_one_normal",
        (true, Bias::None) => "visibility_many_unbiased",
        (true, Bias::Constant { .. } | Bias::WorldTexel { .. }) => "visibility_many_biased",
        (true, Bias::Slope { .. } | Bias::ReceiverPlane) => "visibility_many_normal",
    });
    names
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
