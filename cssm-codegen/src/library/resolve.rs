//! Files of the resolve stage: the visibility function and the mask pass around it.

use cssm_core::case::{Bias, Filter, LightCase, MaskDepth, MaskNormal, Resolve};
use cssm_core::distribution::RemapKind;
use cssm_core::table::{CaseTable, ConstantKind};

use super::remap::{Remap, remap};
use super::{filter, join, order};

/// Files that the visibility function calls; [`super::join`] is the function itself.
pub(super) fn files(case: &LightCase, table: &CaseTable) -> Vec<&'static str> {
    let plane = case.bias == Bias::ReceiverPlane;
    let local = join::reads_light(case, table);
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
    names
}

/// Files of the mask pass beside the visibility function.
pub(super) fn mask(case: &LightCase) -> Vec<&'static str> {
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
