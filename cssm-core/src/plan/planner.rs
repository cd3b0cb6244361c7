//! Planning without asking for memory: what a plan is made in and from outlives the frame.

use smallvec::SmallVec;

use super::finish::Finished;
use super::fitted::Fitted;
use super::fitting::Fitting;
use super::window::{Judged, Visible};
use super::{PlanError, PlanRequest, ShadowPlan, make};
use crate::case::LightCase;
use crate::choose::{Kept, Prediction};
use crate::facet::{Facet, FacetRows, Tile};
use crate::remap::Remap;
use crate::samples;
use crate::technique::Drafts;

/// Makes plans one after the other, of any cases, views and lights, and keeps the memory that takes: from the third plan or
/// so of a moving view on none is asked for, unless the case is fitted to what is seen.
///
/// Its plans are those of [`PlanRequest::plan`] to the last bit: nothing of an earlier frame enters a later one.
///
/// ```
/// use cssm_core::glam::DVec3;
/// use cssm_core::{Light, LightCase, PlanRequest, Planner, SceneBounds, ShadowPlan, View};
///
/// let sun = LightCase::builder("Sun").bands(8, 100_000.0).build().unwrap();
/// let light = Light::directional_travelling(DVec3::new(-0.4, -0.8, 0.3))?;
/// let (mut planner, mut plan) = (Planner::new(), ShadowPlan::empty());
/// for frame in 0..3 {
///     let eye = DVec3::new(0.1 * f64::from(frame), 1.7, 0.0);
///     let view = View::perspective(eye, eye - DVec3::Z, DVec3::Y, 1.0, 0.1, 500.0, (1920, 1080))?;
///     planner.plan(&PlanRequest::new(&sun, &view, &light, SceneBounds::default()), &mut plan)?;
///     assert!(!plan.facets.is_empty());
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Default)]
pub struct Planner {
    work: Work,
}

/// Forms that a configuration has at most.
const MOST_FORMS: usize = 3;

/// Everything that planning needs memory for.
#[derive(Debug, Default)]
pub(crate) struct Work {
    /// Whether it is used again: lists then have room for what other views of a case may need.
    is_kept: bool,
    pub(super) drafts: Drafts,
    /// Visible points by which drafts are judged.
    pub(super) points: Visible,
    /// The drafts with tiles, as many as there are drafts or more.
    pub(super) fitted: Vec<Fitted>,
    /// Which of them could be fitted.
    pub(super) usable: SmallVec<[usize; 8]>,
    pub(super) predictions: SmallVec<[Prediction; 8]>,
    pub(super) fitting: Fitting,
    /// Points by which a facet's depth is judged.
    pub(super) judged: Judged,
    pub(super) finished: SmallVec<[Finished; 4]>,
    /// A plan that is being made; what was in its place before is used again.
    pub(super) plan: ShadowPlan,
    /// Facets that the present plan has no use for.
    pub(super) spare: Vec<Facet>,
}

impl Planner {
    /// A planner that has made no plan yet.
    #[must_use]
    pub fn new() -> Self {
        Self { work: Work { is_kept: true, ..Work::default() } }
    }

    pub(crate) const fn work(&mut self) -> &mut Work {
        &mut self.work
    }

    /// Makes the plan of a request, as [`PlanRequest::plan`] does, in the place of another, whose memory it takes over.
    ///
    /// # Errors
    /// As [`PlanRequest::plan`]; `plan` stays as it was then.
    pub fn plan(&mut self, request: &PlanRequest<'_>, plan: &mut ShadowPlan) -> Result<(), PlanError> {
        make(request, Kept::default(), &mut self.work, plan)
    }
}

impl Work {
    /// Makes room for whatever a plan of a case may need, in the place of another; nothing where it is used once.
    pub(super) fn begin(&mut self, case: &LightCase, replaced: &ShadowPlan) {
        self.drafts.clear();
        if !self.is_kept {
            return;
        }

        // The plan that is made and the one that it replaces change places: both may be as large as any.
        let most = case.shape().cells() as usize;
        let made = &mut self.plan;
        let known = made.facets.len() + replaced.facets.len() + self.spare.len();
        self.spare.reserve(2 * most);
        self.spare.extend((known..2 * most).map(|_| Facet::with_room(true)));
        made.facets.reserve(most.saturating_sub(made.facets.len()));
        made.selection.reserve(most);
        let choice = &mut made.choice;
        choice.made_for_position.clear();
        choice.made_for_position.reserve(case.technique_spec().configurations.len());
        let drafts = MOST_FORMS * case.configurations.len();
        choice.predictions.clear();
        choice.predictions.reserve(drafts);
        self.predictions.clear();
        self.predictions.reserve(drafts);
        self.usable.clear();
        self.usable.reserve(drafts);
        self.points.clear();
        self.points.reserve(samples::MOST);
        self.drafts.make_room(drafts, most);
        self.fitted.resize_with(self.fitted.len().max(drafts), Fitted::default);
        for fitted in &mut self.fitted {
            fitted.begin(most);
            fitted.windows.expect_samples(samples::MOST);
        }
        self.finished.clear();
        self.finished.reserve(most);
        self.fitting.make_room(most);
    }

    /// Lists for so many facets in the plan that is being made.
    pub(super) fn list_facets(&mut self, count: usize) {
        let facets = &mut self.plan.facets;
        while facets.len() > count {
            self.spare.extend(facets.pop());
        }
        facets.reserve(count - facets.len());
        while facets.len() < count {
            facets.push(self.spare.pop().unwrap_or_else(|| Facet::with_room(self.is_kept)));
        }
    }
}

impl Facet {
    /// A facet of nothing, whose lists have room for what most facets have where they serve many frames.
    fn with_room(is_kept: bool) -> Self {
        let room = |most: usize| Vec::with_capacity(if is_kept { most } else { 0 });
        let none = glam::DVec4::ZERO;
        Self {
            cells: Vec::with_capacity(if is_kept { 8 } else { 0 }),
            rows: FacetRows { x: none, y: none, z: none, w: none, remap: Remap::NONE },
            select: room(8),
            clip: room(2),
            tile: Tile { x: 0, y: 0, width: 0, height: 0, gutter: 0 },
            receivers: room(32),
            casters: room(48),
            depth_per_metre: 0.0,
            texel_metres_per_w: 0.0,
            receiver_plane_depth: 0.0,
            rounding_depth: 0.0,
        }
    }
}
