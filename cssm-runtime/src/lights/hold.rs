//! Plans that outlive their frame: made for a view that is a little wider than the present one.

use cssm_core::case::Fit;
use cssm_core::case::Stability;
use cssm_core::glam::DVec3;
use cssm_core::plan::{PlanRequest, Planner, ViewMargin};
use cssm_core::{PlanError, ShadowPlan, View};

use super::shadow::{FARTHEST_REACH, Held};

/// Multiple of the motion below which a margin is not worth its texels.
const NEAREST_REACH: f64 = 2.0;
/// How much larger the predicted footprint of a plan with a margin may be when it is made.
const MARGIN_COST: f64 = 1.05;
/// How much larger it may become before the plan is given up.
const HOLD_COST: f64 = 1.1;
/// Share of the pixels at other depths than a plan was fitted to, beyond which it is given up.
const SHIFTED_SHARE: f64 = 0.2;
/// Octaves by which the range of visible depth may differ from the one that a plan was fitted to.
const SHIFTED_OCTAVES: f64 = 0.5;
/// Growth of the reach with every plan, so that a margin is tried again some time after it was given up.
const REACH_GROWTH: f64 = 1.15;

/// How far a view has moved since the last frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Motion {
    turn_radians: f64,
    move_metres: f64,
}

impl Motion {
    /// The motion from one view to the next; `None` where the image changed as well.
    pub(super) fn between(previous: &View, view: &View) -> Option<Self> {
        let image =
            |view: &View| (view.left, view.right, view.bottom, view.top, view.near_metres, view.far_metres);
        if image(previous) != image(view) || previous.size_pixels != view.size_pixels {
            return None;
        }
        let turn = view.camera_from_world * previous.camera_from_world.transpose();
        let axis = DVec3::new(
            turn.y_axis.z - turn.z_axis.y,
            turn.z_axis.x - turn.x_axis.z,
            turn.x_axis.y - turn.y_axis.x,
        );
        let trace = turn.x_axis.x + turn.y_axis.y + turn.z_axis.z;
        Some(Self {
            turn_radians: (0.5 * axis.length()).atan2(0.5 * (trace - 1.0)),
            move_metres: view.eye_world.distance(previous.eye_world),
        })
    }

    fn is_none(&self) -> bool {
        self.turn_radians < 1e-12 && self.move_metres == 0.0
    }
}

/// Whether a shadow needs another plan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Need {
    /// What it has will do.
    Nothing,
    /// Another would be better, but what it has covers the view.
    Better,
    /// Receivers of the view are not covered.
    Another,
}

/// Whether a held plan serves a request.
pub(super) fn need(held: Option<&mut Held>, request: &PlanRequest, hold: bool) -> Need {
    let Some(held) = held else { return Need::Another };
    if Some(held.plan.region) != request.region {
        return Need::Another;
    }
    let may_hold = hold || held.is_of(request.view);
    if !may_hold || !held.covers(request) {
        return Need::Another;
    }
    let cost = held.pixels(request.view) / held.best_pixels;
    let is_behind = held.light != *request.light || cost > HOLD_COST || has_shifted(held, request);
    if is_behind { Need::Better } else { Need::Nothing }
}

/// Whether pixels are at other depths than those that a plan was fitted to, or are known of for the first time.
fn has_shifted(held: &Held, request: &PlanRequest) -> bool {
    let fit = request.case.fit;
    let Some(depth) = request.depth.filter(|depth| fit.measures_depth() && depth.is_usable()) else {
        return false;
    };
    let Some(known) = held.depth.as_deref() else { return true };
    if known.view.near_metres != depth.view.near_metres {
        return true;
    }
    let octaves = |one: f64, other: f64| (one / other).log2().abs();
    let moved = octaves(known.nearest_metres, depth.nearest_metres)
        .max(octaves(known.farthest_metres, depth.farthest_metres));
    let (all, all_known) = (depth.pixels(), known.pixels());
    let bins = depth.bins.iter().zip(&known.bins);
    let elsewhere: f64 = bins.map(|(one, other)| (one.pixels / all - other.pixels / all_known).abs()).sum();
    match fit {
        Fit::Histogram => 0.5 * elsewhere > SHIFTED_SHARE,
        _ => moved > SHIFTED_OCTAVES,
    }
}

/// What plans are made in and with; kept over frames, so that planning asks for no memory.
#[derive(Debug)]
pub(super) struct Planning {
    pub(super) planner: Planner,
    /// A plan for a view alone.
    pub(super) exact: ShadowPlan,
    /// A plan with a margin.
    wide: ShadowPlan,
}

impl Default for Planning {
    fn default() -> Self {
        Self { planner: Planner::new(), exact: ShadowPlan::empty(), wide: ShadowPlan::empty() }
    }
}

/// A plan for a request, with a margin for `reach` times the motion where that costs little, and the predicted footprint
/// of a plan without one.
pub(super) fn plan<'p>(
    request: &PlanRequest,
    motion: Option<Motion>,
    reach: &mut f64,
    planning: &'p mut Planning,
) -> Result<(&'p mut ShadowPlan, f64), PlanError> {
    let Planning { planner, exact, wide } = planning;
    planner.plan(request, exact)?;
    let best_pixels = exact.p95_pixels(request.view);
    // A lattice of views has a margin of its own.
    let has_lattice = matches!(request.case.stability, Stability::Quantised { .. });
    let Some(motion) = motion.filter(|motion| !motion.is_none() && !has_lattice) else {
        return Ok((exact, best_pixels));
    };

    // Look for the widest margin that costs little.
    *reach = (*reach * REACH_GROWTH).min(FARTHEST_REACH);
    while *reach >= NEAREST_REACH {
        let margin = ViewMargin {
            turn_radians: motion.turn_radians * *reach,
            move_metres: motion.move_metres * *reach,
        };
        if planner.plan(&PlanRequest { margin, ..*request }, wide).is_ok()
            && wide.p95_pixels(request.view) <= MARGIN_COST * best_pixels
        {
            return Ok((wide, best_pixels));
        }
        *reach *= 0.5;
    }
    *reach = reach.max(1.0);
    Ok((exact, best_pixels))
}
