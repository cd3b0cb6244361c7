//! The plan of one light in one view: made, judged, and told.

use cssm_core::plan::PlanRequest;
use cssm_core::{PlanError, ShadowPlan, View};

use super::description::{LightDescription, LightHandle};
use super::hold::{self, Motion, Planning};
use super::report::{LightState, LightStatistics, TileStatistics};
use super::shadow::{Held, Shadow};

/// Changes of what a shadow needs that are not followed, as a share.
const SAME_PRODUCT: f64 = 0.25;

impl Shadow {
    /// Takes another plan. Returns whether the square was too small for it.
    pub(super) fn plan(
        &mut self,
        request: &PlanRequest,
        motion: Option<Motion>,
        serial: u64,
        description: &LightDescription,
        planning: &mut Planning,
    ) -> bool {
        self.failure = None;
        let side = request.region.map_or(0, |region| region.width);
        match hold::plan(request, motion, &mut self.reach, planning) {
            Ok((plan, best_pixels)) => {
                self.estimate(plan, request.view, side, description);
                if plan.facets.is_empty() {
                    self.held = None;
                } else {
                    let held = self.held.get_or_insert_with(|| Held::empty(request));
                    held.renew(plan, serial, request, best_pixels);
                }
                false
            }
            Err(PlanError::MapTooSmall { .. }) if side < description.max_side_texels => {
                // Ask for more than the next size promises.
                self.pixels_times_side = Some(description.enough_pixels * f64::from(side) * 2.0);
                self.held = None;
                true
            }
            Err(error) => {
                self.failure = Some(error);
                false
            }
        }
    }

    /// Remembers how many texels a plan with tiles in a square of some side would need.
    pub(super) fn estimate(
        &mut self,
        plan: &ShadowPlan,
        view: &View,
        side: u32,
        description: &LightDescription,
    ) {
        let pixels = plan.p95_pixels(view);
        let most = description.enough_pixels * f64::from(description.max_side_texels);
        let product = if pixels.is_finite() { pixels * f64::from(side) } else { most };
        let known = self.pixels_times_side.filter(|known| (product / known - 1.0).abs() <= SAME_PRODUCT);
        self.pixels_times_side = (!plan.facets.is_empty()).then_some(known.unwrap_or(product));
    }

    /// What is known before anything is drawn.
    pub(super) fn statistics(
        &mut self,
        light: LightHandle,
        view: &View,
        tiles: Vec<TileStatistics>,
    ) -> LightStatistics {
        let p95_pixels = self.held.as_mut().map_or(f64::INFINITY, |held| held.pixels(view));
        let state = match (&self.failure, &self.held, self.pixels_times_side) {
            (Some(error), ..) => LightState::Failed(error.clone()),
            (None, Some(_), _) => LightState::Current,
            (None, None, Some(_)) => LightState::NoTexels,
            (None, None, None) => LightState::Unseen,
        };
        let held = self.held.as_ref();
        LightStatistics {
            light,
            state,
            region: self.region(),
            configuration: held.map_or("", |held| held.plan.configuration),
            p95_pixels,
            held_frames: held.map_or(0, |held| held.frames),
            redrawn_texels: 0,
            draws: 0,
            triangles: 0,
            tiles,
        }
    }
}
