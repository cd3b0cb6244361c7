//! The rest of a facet once its tile is known: gutters, depth row, bias figures, caster planes.

use glam::{DVec2, DVec3};

use super::fitted::map_area;
use super::window::Window;
use super::{casters, region};
use crate::case::{Bias, DepthFormat, Filter, LightCase};
use crate::depth::{DepthNeeds, depth_row};
use crate::facet::{Facet, FacetRows, Tile};
use crate::footprint::quantile;
use crate::homography::{Gradients, singular_values};
use crate::plan::{DepthOrder, PlanError};
use crate::technique::Situation;

/// Depth rounding of f32 rows, interpolation and storage of a float map, in units of depth.
const FLOAT_ROUNDING: f64 = 3e-7;
/// Part of the smaller texel axis by which an exact receiver plane is lowered.
const RECEIVER_PLANE_TEXELS: f64 = 0.5;
/// Larger texel axes kept free before and behind the receivers at least, so that reference planes extended to
/// neighbouring texels do not clamp.
const PLANE_EXTENSION_TEXELS: u32 = 2;
/// Receivers so deep that the whole facet spans less than 1 / this many pixels at their depth need no depth of their own:
/// they lie that close to the light's own direction, or its opposite, as seen from the eye.
const FARTHEST_PIXELS: f64 = 2.0;
/// Nearest receivers of a local light, in median distances, in a float map: depth is 1 / distance, which floats hold at
/// any scale.
const NEAR_SHARE_FLOAT: f64 = 1e-6;
/// The same in a map of 16-bit integers, whose steps are even in 1 / distance.
const NEAR_SHARE_UNORM: f64 = 0.02;
/// Tangent of the steepest surface that keeps room for a slope bias.
const STEEPEST_SLOPE: f64 = 20.0;

/// How a plan keeps precision.
#[derive(Debug, Clone, Copy)]
pub(super) struct DepthRules {
    /// Which end of stored depth lies towards the light.
    pub(super) order: DepthOrder,
    /// Shear of positions.
    pub(super) shear: DVec2,
}

/// Finishes a facet in camera space; also says how far rounding moves its depth, in float steps and texels.
pub(super) fn finish(
    window: &Window<'_>,
    tile: Tile,
    cells: Vec<u32>,
    rules: DepthRules,
    situation: &Situation<'_>,
) -> Result<(Facet, f64), PlanError> {
    // Keep gutters free.
    let inset = region::inset(&window.rows, &window.draft.region, &tile);
    let (mut rows, clip) = inset.ok_or_else(|| map_area(situation).too_small(1))?;

    // Measure texels across the light, per w.
    let texels = TexelsPerW::measure(&rows, &tile, &window.samples);
    let extension = PLANE_EXTENSION_TEXELS.max(situation.case.filter.radius_texels() + 1);
    let margin = f64::from(extension) * texels.major + bias_metres_per_w(situation.case, &texels, window);
    let receivers = &window.draft.receivers;
    let width = texels.major * f64::from(tile.width.max(tile.height));
    let farthest = FARTHEST_PIXELS * situation.view.pixels_per_tangent() * width;
    let needs = DepthNeeds {
        light: situation.light,
        receivers,
        samples: &window.samples,
        margin_metres_per_w: margin,
        headroom_per_w: headroom_per_w(situation.case, &texels),
        near_w: near_w(&rows, window, situation),
        farthest_metres_per_w: farthest,
        order: rules.order,
        shear: rules.shear,
    };
    let depth = depth_row(&rows, &needs).ok_or(PlanError::Degenerate {
        facet: cells.first().copied().unwrap_or(0),
        why: "its receivers have no extent along the light",
    })?;
    rows.z = depth.row;
    let rounding = FLOAT_ROUNDING + 1.5 * situation.case.map.format.rounding();

    let facet = Facet {
        cells,
        rows,
        select: window.draft.select.clone(),
        clip,
        casters: casters::planes(&rows, &tile, receivers, situation.light),
        receivers: receivers.vertices.clone(),
        tile,
        depth_per_metre: depth.depth_per_metre,
        texel_metres_per_w: texels.major,
        receiver_plane_depth: RECEIVER_PLANE_TEXELS * texels.minor * depth.depth_per_metre,
        rounding_depth: rounding,
    };
    Ok((facet, depth.rounding / texels.major.max(f64::MIN_POSITIVE)))
}

/// Smallest w of receivers of a local light, in w of the median receiver, by what a map format can tell apart.
fn near_w(rows: &FacetRows, window: &Window<'_>, situation: &Situation<'_>) -> Option<f64> {
    if situation.light.w == 0.0 {
        return None;
    }
    let mut reached: Vec<f64> = window.samples.iter().map(|point| rows.w.dot(point.extend(1.0))).collect();
    reached.retain(|w| *w > 0.0);
    reached.sort_by(f64::total_cmp);
    let share = match situation.case.map.format {
        DepthFormat::Depth32Float => NEAR_SHARE_FLOAT,
        DepthFormat::Depth16Unorm => NEAR_SHARE_UNORM,
    };
    (!reached.is_empty()).then(|| quantile(&reached, 0.5) * share)
}

/// Median texel axes across the light in metres, divided by w.
struct TexelsPerW {
    major: f64,
    minor: f64,
}

impl TexelsPerW {
    fn measure(rows: &FacetRows, tile: &Tile, samples: &[DVec3]) -> Self {
        let (mut majors, mut minors) = (Vec::new(), Vec::new());
        for point in samples {
            let gradients = Gradients::at(rows, *point);
            let (across, up) = gradients.across_light();
            let (across, up) = (across * (2.0 / f64::from(tile.width)), up * (2.0 / f64::from(tile.height)));
            let (major, minor) = singular_values(across, up);
            if major.is_finite() && gradients.w > 0.0 {
                majors.push(major / gradients.w);
                minors.push(minor / gradients.w);
            }
        }
        let median = |mut values: Vec<f64>| {
            values.sort_by(f64::total_cmp);
            if values.is_empty() { 0.0 } else { quantile(&values, 0.5) }
        };
        Self { major: median(majors), minor: median(minors) }
    }
}

/// Depth kept before the receivers for the casters of soft shadows: those beyond throw edges as wide as the widest kernel
/// wherever they are, so that casters at the near end of depth may share it.
fn headroom_per_w(case: &LightCase, texels: &TexelsPerW) -> f64 {
    match case.filter {
        Filter::Pcss { source, reach_texels } => f64::from(reach_texels) * texels.major / source.radius(),
        _ => 0.0,
    }
}

/// Largest bias of the case in metres along the light, per w.
fn bias_metres_per_w(case: &LightCase, texels: &TexelsPerW, window: &Window<'_>) -> f64 {
    let constant = |metres: f64| {
        let smallest_w = window.samples.iter().map(|point| window.rows.w.dot(point.extend(1.0)));
        metres / smallest_w.fold(f64::INFINITY, f64::min)
    };
    match case.bias {
        Bias::None | Bias::ReceiverPlane => texels.minor,
        Bias::Constant { along_light_metres } => constant(along_light_metres),
        Bias::Slope { texels: scale } => scale * texels.major * STEEPEST_SLOPE,
        Bias::WorldTexel { a_metres, b_texels } => constant(a_metres) + b_texels * texels.major,
    }
}
