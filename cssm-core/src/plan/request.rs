//! What a plan is asked for.

use super::{BoundingBox, PlanError, SceneBounds, ShadowPlan, Work, make};
use crate::case::LightCase;
use crate::choose::Kept;
use crate::fit::{DepthHistogram, Seen};
use crate::light::Light;
use crate::view::View;

/// Everything that a plan depends on.
#[derive(Debug, Clone, Copy)]
pub struct PlanRequest<'a> {
    /// The declaration.
    pub case: &'a LightCase,
    /// This frame's view.
    pub view: &'a View,
    /// This frame's light.
    pub light: &'a Light,
    /// What is known about the scene.
    pub bounds: SceneBounds,
    /// Bounding volumes of the receivers in world space, which may overlap and may be points; empty where none are
    /// known. If there are any, everything visible that may be in shadow must lie in one of them. Techniques that fit
    /// their map to what is seen use them.
    pub volumes_world: &'a [BoundingBox],
    /// World-space box that holds every caster, for cases that are fitted; `None`: casters may be anywhere.
    pub casters_world: Option<BoundingBox>,
    /// Depth in metres before which nothing is visible in this frame, for cases that are fitted.
    pub near_hint_metres: Option<f64>,
    /// Measured depth, for cases that are fitted to it.
    pub depth: Option<&'a DepthHistogram>,
    /// The rectangle of the map that the plan may use; `None`: the whole map.
    pub region: Option<MapRegion>,
    /// How far the view may move and turn before the plan no longer covers it.
    pub margin: ViewMargin,
}

/// A rectangle of the map in whole texels; (0, 0) is the map's upper left corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MapRegion {
    /// Left edge.
    pub x: u32,
    /// Upper edge.
    pub y: u32,
    /// Width.
    pub width: u32,
    /// Height.
    pub height: u32,
}

/// How far a view may move and turn; none by default.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ViewMargin {
    /// Largest angle between the axes of two views, about any axis, radians.
    pub turn_radians: f64,
    /// Largest distance between their eyes, metres.
    pub move_metres: f64,
}

impl ViewMargin {
    /// The view must stay as it is.
    pub const NONE: Self = Self { turn_radians: 0.0, move_metres: 0.0 };
}

impl<'a> PlanRequest<'a> {
    /// A request over the whole map for exactly this view, without volumes.
    pub const fn new(case: &'a LightCase, view: &'a View, light: &'a Light, bounds: SceneBounds) -> Self {
        Self {
            case,
            view,
            light,
            bounds,
            volumes_world: &[],
            casters_world: None,
            near_hint_metres: None,
            depth: None,
            region: None,
            margin: ViewMargin::NONE,
        }
    }

    /// The same request with all that is known of what is seen.
    #[must_use]
    pub const fn knowing(self, seen: &Seen<'a>) -> Self {
        let Seen { volumes_world, casters_world, near_hint_metres, depth } = *seen;
        Self { volumes_world, casters_world, near_hint_metres, depth, ..self }
    }

    /// What is known of what is seen.
    pub(super) const fn seen(&self) -> Seen<'a> {
        let Self { volumes_world, casters_world, near_hint_metres, depth, .. } = *self;
        Seen { volumes_world, casters_world, near_hint_metres, depth }
    }

    /// Makes the plan. Total: a plan or a typed reason. Where the case declares several configurations, the one with
    /// the smallest predicted footprint is taken; [`crate::choose::Chooser`] also remembers earlier frames.
    ///
    /// With a margin the plan is made for the view [widened](View::widened) by it, whose eye lies behind this one:
    /// [`ShadowPlan::rebased`] brings it to views inside. A light that reaches nothing visible has a plan without
    /// facets.
    ///
    /// # Errors
    /// A [`PlanError`] that says what to change.
    pub fn plan(&self) -> Result<ShadowPlan, PlanError> {
        let mut plan = ShadowPlan::empty();
        make(self, Kept::default(), &mut Work::default(), &mut plan)?;
        Ok(plan)
    }

    /// The rectangle of the map that the plan shares among its facets.
    pub(super) fn checked_region(&self) -> Result<MapRegion, PlanError> {
        let (width, height) = (self.case.map.width, self.case.map.height);
        let region = self.region.unwrap_or(MapRegion { x: 0, y: 0, width, height });
        let inside = |start: u32, side: u32, whole: u32| {
            side > 0 && start.checked_add(side).is_some_and(|end| end <= whole)
        };
        if !inside(region.x, region.width, width) || !inside(region.y, region.height, height) {
            return Err(PlanError::Region { region, width, height });
        }
        Ok(region)
    }
}
