//! The rest of a facet once its tile is known: gutters, depth row, bias figures, caster planes.

use glam::{DVec2, DVec4};
use smallvec::SmallVec;

use super::casters;
use super::fitted::{Fitted, map_area};
use super::region::{self, Inset};
use super::window::{Frame, Sample};
use crate::case::{Bias, DepthFormat, Filter, LightCase};
use crate::depth::{COMPARED_SAMPLES, DepthNeeds, DepthRow, depth_rows};
use crate::facet::{Facet, FacetRows};
use crate::plan::{DepthOrder, PlanError};
use crate::polygon::Places;
use crate::technique::Situation;
use crate::view::View;

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

/// What remains of a facet: its depth.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Finished {
    /// Its depth row under each order.
    depths: [Option<DepthRow>; 2],
    /// Larger texel axis across the light in metres, per w.
    texel: f64,
    /// Samples of the view in it.
    seen: usize,
}

/// Fills in everything of a window's facet but the choice of its depth: camera space, its z row is the w row, and figures of
/// depth are those of one per metre.
pub(super) fn finish(
    (fitted, index): (&Fitted, usize),
    frame: &Frame<'_>,
    samples: &[Sample],
    depth: Depth<'_>,
    facet: &mut Facet,
) -> Result<Finished, PlanError> {
    // Keep gutters free.
    let situation = frame.situation;
    let (window, tile) = (&fitted.windows.list[index], fitted.tiles[index]);
    let draft = frame.facet(window);
    let reach = 0.5 * f64::from(situation.case.filter.texels_across());
    let corners = fitted.windows.outline(index);
    let mut outline = Places::new();
    let inset = region::inset((&window.rows, corners), &draft.region, (&tile, reach), &mut outline);
    let Inset { rows, clip, inner_texels } = inset.ok_or_else(|| map_area(situation).too_small(1))?;

    // Measure texels across the light, per w.
    let texels = TexelsPerW::measure(&rows, inner_texels, samples, situation.view);
    let extension = PLANE_EXTENSION_TEXELS.max(situation.case.filter.radius_texels() + 1);
    let margin =
        f64::from(extension) * texels.major + bias_metres_per_w(situation.case, &texels, &rows, samples);
    let receivers = frame.draft.receivers(draft);
    let width = texels.major * f64::from(tile.width.max(tile.height));
    let farthest = FARTHEST_PIXELS * situation.view.pixels_per_tangent() * width;
    let needs = DepthNeeds {
        light: situation.light,
        receivers,
        margin_metres_per_w: margin,
        headroom_per_w: headroom_per_w(situation.case, &texels),
        near_w: near_w(&rows, samples, situation),
        farthest_metres_per_w: farthest,
        orders: depth.orders,
        shear: depth.shear,
    };
    let depths = depth_rows(&rows, &needs, samples.iter().map(|sample| sample.point));

    let shape = situation.case.shape();
    facet.cells.clear();
    if draft.is_dominant() {
        facet.cells.push(shape.cells() - 1);
    }
    facet.cells.extend(draft.cells.iter().map(|cell| cell.index(shape.sectors, shape.bands)));
    copy(&draft.select, &mut facet.select);
    copy(&clip, &mut facet.clip);
    copy(receivers.vertices, &mut facet.receivers);
    casters::list_planes(&rows, &tile, receivers.planes, &outline, situation.light, &mut facet.casters);
    (facet.rows, facet.tile) = (rows, tile);
    (facet.depth_per_metre, facet.texel_metres_per_w) = (1.0, texels.major);
    facet.receiver_plane_depth = RECEIVER_PLANE_TEXELS * texels.minor;
    facet.rounding_depth = FLOAT_ROUNDING + 1.5 * situation.case.map.format.rounding();
    Ok(Finished { depths, texel: texels.major, seen: window.seen })
}

fn copy(from: &[DVec4], to: &mut Vec<DVec4>) {
    to.clear();
    to.extend_from_slice(from);
}

/// How plans may keep precision.
#[derive(Debug, Clone, Copy)]
pub(super) struct Depth<'a> {
    /// Which ends of stored depth may lie towards the light; two at most.
    pub(super) orders: &'a [DepthOrder],
    /// Shear of positions.
    pub(super) shear: DVec2,
}

impl Finished {
    /// How far rounding moves depth under an order: the logarithm of texels, times the view's samples. `None` where the
    /// order has no depth row.
    pub(super) fn moved(&self, order: usize) -> Option<f64> {
        let depth = self.depths.get(order).copied().flatten()?;
        let moved = depth.rounding / self.texel.max(f64::MIN_POSITIVE);
        Some(self.seen as f64 * libm::log(moved.max(f64::MIN_POSITIVE)))
    }

    /// Gives its facet the depth of an order.
    pub(super) fn store(&self, order: usize, facet: &mut Facet) -> Result<(), PlanError> {
        let depth = self.depths.get(order).copied().flatten();
        let depth = depth.ok_or(PlanError::Degenerate {
            facet: facet.first_cell(),
            why: "its receivers have no extent along the light",
        })?;
        facet.rows.z = depth.row;
        facet.depth_per_metre = depth.depth_per_metre;
        facet.receiver_plane_depth *= depth.depth_per_metre;
        Ok(())
    }
}

/// Smallest w of receivers of a local light, in w of the median receiver, by what a map format can tell apart.
fn near_w(rows: &FacetRows, samples: &[Sample], situation: &Situation<'_>) -> Option<f64> {
    if situation.light.w == 0.0 {
        return None;
    }
    let reached = samples.iter().map(|sample| rows.w.dot(sample.point.extend(1.0)));
    let mut reached: SmallVec<[f64; COMPARED_SAMPLES]> = reached.filter(|w| *w > 0.0).collect();
    let share = match situation.case.map.format {
        DepthFormat::Depth32Float => NEAR_SHARE_FLOAT,
        DepthFormat::Depth16Unorm => NEAR_SHARE_UNORM,
    };
    (!reached.is_empty()).then(|| median(&mut reached) * share)
}

/// Median texel axes across the light in metres, divided by w.
struct TexelsPerW {
    major: f64,
    minor: f64,
}

impl TexelsPerW {
    /// Axes at samples, evenly picked where there are many, of texels that so many would fill the window of.
    fn measure(rows: &FacetRows, inner_texels: DVec2, samples: &[Sample], view: &View) -> Self {
        let mut majors: SmallVec<[f64; COMPARED_SAMPLES]> = SmallVec::new();
        let mut minors: SmallVec<[f64; COMPARED_SAMPLES]> = SmallVec::new();
        let step = samples.len().div_ceil(COMPARED_SAMPLES).max(1);
        let per_texel = 1.0 / inner_texels;
        for Sample { point, gram } in samples.iter().step_by(step) {
            let w = rows.w.dot(point.extend(1.0));
            let (major, minor) = gram.axes_pixels(per_texel.x, per_texel.y);
            let metres_per_w = -point.z / (view.pixels_per_tangent() * w);
            if major.is_finite() && w > 0.0 {
                majors.push(major * metres_per_w);
                minors.push(minor * metres_per_w);
            }
        }
        Self { major: median(&mut majors), minor: median(&mut minors) }
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

/// The middle value, between the two in the middle where their number is even; 0 where there is none.
fn median(values: &mut [f64]) -> f64 {
    let middle = values.len() / 2;
    let is_even = values.len().is_multiple_of(2);
    if values.is_empty() {
        return 0.0;
    }
    let (lower, above, _) = values.select_nth_unstable_by(middle, f64::total_cmp);
    let below = lower.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if is_even { 0.5 * (below + *above) } else { *above }
}

/// Largest bias of the case in metres along the light, per w.
fn bias_metres_per_w(case: &LightCase, texels: &TexelsPerW, rows: &FacetRows, samples: &[Sample]) -> f64 {
    let constant = |metres: f64| {
        let smallest_w = samples.iter().map(|sample| rows.w.dot(sample.point.extend(1.0)));
        metres / smallest_w.fold(f64::INFINITY, f64::min)
    };
    match case.bias {
        Bias::None | Bias::ReceiverPlane => texels.minor,
        Bias::Constant { along_light_metres } => constant(along_light_metres),
        Bias::Slope { texels: scale } => scale * texels.major * STEEPEST_SLOPE,
        Bias::WorldTexel { a_metres, b_texels } => constant(a_metres) + b_texels * texels.major,
    }
}
