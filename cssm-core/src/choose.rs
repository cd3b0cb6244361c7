//! Which configuration a frame uses, among those its case declares.
//!
//! Every declared configuration is drafted and fitted; the one with the smallest predicted 95th percentile of the texel
//! footprint wins. Predictions change continuously with view and light, so a switch happens where both qualities agree:
//! no step is seen. What remains, a flicker between two equal ones, is the [`Chooser`]'s part: it dwells.

use std::fmt;

use crate::case::LightCase;
use crate::light::{Light, LightPosition};
use crate::plan::{PlanError, PlanRequest, Planner, SceneBounds, ShadowPlan, Work, make};
use crate::technique::Fallback;
use crate::view::View;

/// What was chosen for a frame, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct ConfigurationChoice {
    /// Where the light stands.
    pub position: LightPosition,
    /// The chosen configuration.
    pub configuration: &'static str,
    /// Why it was chosen.
    pub reason: ChoiceReason,
    /// What was predicted, one entry for each form of each declared configuration; empty when there was nothing to
    /// choose.
    pub predictions: Vec<Prediction>,
    /// Whether every visible receiver that the light reaches has a facet; if not, nothing is promised of the rest.
    pub complete: bool,
    /// How far the technique gives way to another near a situation that it has no answer for.
    pub fallback: Option<Fallback>,
    /// Configurations of the technique that are made for the light's position; empty when one of them is declared.
    pub made_for_position: Vec<&'static str>,
}

/// Why a configuration was chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChoiceReason {
    /// There is no other.
    Only,
    /// Its predicted footprint is the smallest.
    SmallestFootprint,
    /// It was in use and the better one is so little better that the switch may wait.
    Dwells {
        /// Frames until the switch is allowed.
        frames: u32,
    },
}

/// Predicted quality of one form of a configuration.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Prediction {
    /// The configuration.
    pub configuration: &'static str,
    /// Which of its forms; empty where it has one.
    pub form: &'static str,
    /// 95th percentile of the texel footprint over sample receivers, screen pixels; infinite where it leaves some
    /// out.
    pub p95_pixels: f64,
}

impl ConfigurationChoice {
    /// The choice of nothing.
    pub(crate) const fn none() -> Self {
        Self {
            position: LightPosition::General,
            configuration: "",
            reason: ChoiceReason::Only,
            predictions: Vec::new(),
            complete: true,
            fallback: None,
            made_for_position: Vec::new(),
        }
    }
}

impl fmt::Display for ConfigurationChoice {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { position, configuration, reason, predictions, complete, fallback, made_for_position } =
            self;
        write!(out, "{configuration}: light {}; ", position.name())?;
        match reason {
            ChoiceReason::Only => write!(out, "the only one declared")?,
            ChoiceReason::SmallestFootprint => write!(out, "smallest predicted p95 footprint")?,
            ChoiceReason::Dwells { frames } => {
                write!(out, "kept for {frames} more frames, nearly the smallest predicted p95 footprint")?;
            }
        }
        for (index, Prediction { configuration, form, p95_pixels }) in predictions.iter().enumerate() {
            let lead = if index == 0 { " (" } else { ", " };
            let space = if form.is_empty() { "" } else { " " };
            write!(out, "{lead}{configuration}{space}{form} {p95_pixels:.2} px")?;
        }
        if !predictions.is_empty() {
            write!(out, ")")?;
        }
        if !complete {
            write!(out, "; incomplete: some receivers have no facet")?;
        }
        if let Some(Fallback { to, why, share }) = fallback {
            write!(out, "; falls back to {to} by {:.0} %: {why}", 100.0 * share)?;
        }
        if !made_for_position.is_empty() {
            let names = made_for_position.join(" or ");
            write!(out, "; degraded: {names} is made for this light, declare it for better shadows")?;
        }
        Ok(())
    }
}

/// Frames after a switch in which no other follows, unless the better one is much better.
const DWELL_FRAMES: u32 = 30;
/// Ratio of predicted footprints that is not waited out.
const MUCH_BETTER: f64 = 1.05;

/// Chooses configurations from frame to frame: remembers the last choice and dwells on it.
///
/// One for each light and view. Without it, [`crate::plan()`] chooses each frame by itself, which is the same but for
/// flicker where two configurations are equally good.
#[derive(Debug, Clone, PartialEq)]
pub struct Chooser {
    dwell_frames: u32,
    current: Option<&'static str>,
    frames_left: u32,
}

impl Default for Chooser {
    fn default() -> Self {
        Self::new(DWELL_FRAMES)
    }
}

impl Chooser {
    /// A chooser that waits `dwell_frames` frames after a switch before it allows the next between configurations
    /// that are within 5 % of each other.
    pub const fn new(dwell_frames: u32) -> Self {
        Self { dwell_frames, current: None, frames_left: 0 }
    }

    /// This frame's plan; as [`crate::plan()`], with the choice of earlier frames in mind. On failure the chooser
    /// stays as it was.
    ///
    /// # Errors
    /// As [`crate::plan()`].
    pub fn plan(
        &mut self,
        case: &LightCase,
        view: &View,
        light: &Light,
        bounds: &SceneBounds,
    ) -> Result<ShadowPlan, PlanError> {
        self.plan_of(&PlanRequest::new(case, view, light, *bounds))
    }

    /// The plan of a request; as [`PlanRequest::plan`], with the choice of earlier frames in mind. On failure the
    /// chooser stays as it was, and where the light reaches nothing visible it keeps the configuration in use.
    ///
    /// # Errors
    /// As [`PlanRequest::plan`].
    pub fn plan_of(&mut self, request: &PlanRequest<'_>) -> Result<ShadowPlan, PlanError> {
        let mut plan = ShadowPlan::empty();
        self.make(request, &mut Work::default(), &mut plan)?;
        Ok(plan)
    }

    /// [`Self::plan_of`] by a planner, in the place of another plan, whose memory it takes over.
    ///
    /// # Errors
    /// As [`PlanRequest::plan`]; `plan` and the chooser stay as they were then.
    pub fn plan_with(
        &mut self,
        planner: &mut Planner,
        request: &PlanRequest<'_>,
        plan: &mut ShadowPlan,
    ) -> Result<(), PlanError> {
        self.make(request, planner.work(), plan)
    }

    fn make(
        &mut self,
        request: &PlanRequest<'_>,
        work: &mut Work,
        plan: &mut ShadowPlan,
    ) -> Result<(), PlanError> {
        let kept = Kept { configuration: self.current, frames: self.frames_left };
        make(request, kept, work, plan)?;
        let is_switch = self.current.is_some_and(|current| current != plan.configuration);
        if plan.facets.is_empty() {
            self.frames_left = self.frames_left.saturating_sub(1);
            return Ok(());
        }
        self.frames_left = if is_switch { self.dwell_frames } else { self.frames_left.saturating_sub(1) };
        self.current = Some(plan.configuration);
        Ok(())
    }
}

/// The configuration in use and how long it is to be kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Kept {
    pub(crate) configuration: Option<&'static str>,
    pub(crate) frames: u32,
}

/// The index of the prediction to take, and why; `predictions` is not empty.
pub(crate) fn choose(predictions: &[Prediction], kept: Kept) -> (usize, ChoiceReason) {
    if predictions.len() == 1 {
        return (0, ChoiceReason::Only);
    }
    let smallest = |indices: &mut dyn Iterator<Item = usize>| {
        indices.min_by(|one, two| predictions[*one].p95_pixels.total_cmp(&predictions[*two].p95_pixels))
    };
    let best = smallest(&mut (0..predictions.len())).unwrap_or(0);

    // Stay while the dwell lasts and the difference cannot be seen.
    let in_use = |index: &usize| Some(predictions[*index].configuration) == kept.configuration;
    let current = smallest(&mut (0..predictions.len()).filter(in_use));
    match current {
        Some(current) if kept.frames > 0 && !in_use(&best) => {
            let ratio = predictions[current].p95_pixels / predictions[best].p95_pixels;
            if ratio <= MUCH_BETTER {
                (current, ChoiceReason::Dwells { frames: kept.frames })
            } else {
                (best, ChoiceReason::SmallestFootprint)
            }
        }
        _ => (best, ChoiceReason::SmallestFootprint),
    }
}

/// Lists names of the technique's configurations that are made for a position of the light, if none of those declared is.
pub(crate) fn list_made_for(case: &LightCase, position: LightPosition, names: &mut Vec<&'static str>) {
    let spec = case.technique_spec();
    let made = || spec.made_for(case.light, position);
    let is_declared = |name: &'static str| case.configurations.iter().any(|word| word.name == name);
    names.clear();
    if !made().any(is_declared) {
        names.extend(made());
    }
}
