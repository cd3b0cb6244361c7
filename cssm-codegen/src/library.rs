//! The shader library: one file for each alternative of each slot, and which of them a case takes.

use cssm_core::case::{Bias, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::table::ShaderKind;

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
    "capture",
    "capture_clamped",
    "sector_walk",
    "select_sectors",
    "select_bands",
    "select_sectors_bands",
    "place",
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
pub(crate) fn pick(case: &LightCase, shader: ShaderKind) -> (Vec<LibraryFile>, &'static [&'static str]) {
    let mut names = Vec::new();
    let roots: &[&str] = match shader {
        ShaderKind::Capture => {
            names.push("capture");
            &["capture_vertex"]
        }
        ShaderKind::CaptureClamped => {
            names.push("capture_clamped");
            &["capture_clamped_vertex", "capture_clamped_fragment"]
        }
        ShaderKind::Mask => {
            names.extend(visibility(case));
            names.extend(mask(case));
            &["mask_vertex", "mask_fragment"]
        }
        ShaderKind::Function => {
            names.extend(visibility(case));
            &["visibility"]
        }
    };
    let files = LIBRARY.iter().filter(|file| names.contains(&file.name)).copied().collect();
    (files, roots)
}

/// Files of the visibility function.
fn visibility(case: &LightCase) -> Vec<&'static str> {
    let shape = case.shape();
    let mut names = vec!["place"];

    // Find the facet.
    names.extend((shape.sectors > 1).then_some("sector_walk"));
    names.extend(match (shape.sectors > 1, shape.bands > 1) {
        (false, false) => None,
        (true, false) => Some("select_sectors"),
        (false, true) => Some("select_bands"),
        (true, true) => Some("select_sectors_bands"),
    });

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
    names.push(match (shape.facets() > 1, case.bias) {
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
