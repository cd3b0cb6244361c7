//! Fit to what is seen: what a frame's visible surfaces tell a plan beside the view, and what is done with it.
//!
//! Two kinds of knowledge are told apart, and they may do different things.
//!
//! * **This frame's**: bounding volumes from the engine's own culling, the nearest depth it may hold, a box around the
//!   casters, and depth measured in this very frame. It is exact, so it **cuts**: receivers that are in no volume, and
//!   those that no caster stands before, need no texels; facets without receivers are dropped, and their receivers,
//!   should there be any, are lit.
//! * **Late**: depth that was measured in an earlier frame, as every read-back without a stall is. What it lacks may have
//!   come into view since, so it never cuts. It only **moves texels**: every receiver keeps a facet, and what was not
//!   seen keeps a floor share of them.
//!
//! Both become points: places where pixels are, spread as pixels are. Everything else follows from them, whichever
//! technique uses it: how often each depth is seen ([`Profile`]) sets band limits and focus; how many points a facet has
//! sets how fine its texels are (`weigh`), and how much it counts in the predicted footprint. Points move continuously
//! with the measured depth, and so do plans; a [`DepthHistogram`] is blended over frames so that depth itself does not
//! jump.
//!
//! Without any of it, or with depth that makes no sense, a plan is what `fit: none` makes.

mod histogram;
mod narrow;
mod points;
mod profile;
mod sweep;
mod weigh;

use std::cmp::Ordering;

use glam::DVec3;

pub use self::histogram::{BINS, DepthBin, DepthHistogram, SQUARE_PIXELS, WORDS, bin, bin_range_metres};
pub(crate) use self::narrow::{narrow, narrowed_range};
pub use self::profile::Profile;
use crate::case::Fit;
use crate::plan::{BoundingBox, PlanError};
use crate::receivers::Polytope;
use crate::technique::{Draft, Situation};
use crate::view::View;
use glam::DVec4;

/// What a frame's visible surfaces are known to be. Nothing of it need be known.
#[derive(Debug, Clone, Copy, Default)]
pub struct Seen<'a> {
    /// Bounding volumes of the receivers in world space, which may overlap and may be points: everything visible in this
    /// frame that may be in shadow lies in one of them. Empty: not known.
    pub volumes_world: &'a [BoundingBox],
    /// World-space box that holds every caster; what it throws no shadow on needs no texels.
    pub casters_world: Option<BoundingBox>,
    /// Depth in metres before which nothing is visible in this frame.
    pub near_hint_metres: Option<f64>,
    /// Measured depth, of this frame or an earlier one.
    pub depth: Option<&'a DepthHistogram>,
}

impl<'a> Seen<'a> {
    /// Nothing but the receivers' volumes is known.
    pub const fn volumes(volumes_world: &'a [BoundingBox]) -> Self {
        Self { volumes_world, casters_world: None, near_hint_metres: None, depth: None }
    }

    /// The view with its near plane where the hint says, for cases that are fitted.
    pub(crate) fn hinted(&self, fit: Fit, view: &View) -> View {
        let hint = self.near_hint_metres.filter(|hint| fit != Fit::None && hint.is_finite());
        let near_metres = hint.map_or(view.near_metres, |hint| view.near_metres.max(hint));
        View { near_metres, ..*view }
    }
}

/// By what receivers were left out of a plan because nothing is seen of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Cut {
    /// All receivers of the view have a facet.
    #[default]
    None,
    /// By where the engine says that receivers and casters are. What lies in these volumes has a facet wherever the plan's
    /// view, with its margin, sees it.
    Bounds(CutBounds),
    /// By depth measured in the plan's own frame, which says nothing of others.
    Depth,
}

/// Volumes that a plan was cut by.
#[derive(Debug, Clone, PartialEq)]
pub struct CutBounds {
    /// [`Seen::volumes_world`] in an order of their own.
    receivers_world: Vec<BoundingBox>,
    /// [`Seen::casters_world`].
    casters_world: Option<BoundingBox>,
}

impl CutBounds {
    fn of(seen: &Seen<'_>) -> Self {
        let mut receivers_world = seen.volumes_world.to_vec();
        receivers_world.sort_unstable_by(by_corners);
        Self { receivers_world, casters_world: seen.casters_world }
    }

    /// Whether everything that other knowledge leaves lies in these volumes.
    pub(crate) fn hold(&self, seen: &Seen<'_>) -> bool {
        let known = |volume: &BoundingBox| {
            self.receivers_world.binary_search_by(|known| by_corners(known, volume)).is_ok()
        };
        let receivers = self.receivers_world.is_empty()
            || (!seen.volumes_world.is_empty() && seen.volumes_world.iter().all(known));
        let casters = self.casters_world.is_none_or(|whole| {
            let inside =
                |part: BoundingBox| part.min.cmpge(whole.min).all() && part.max.cmple(whole.max).all();
            seen.casters_world.is_some_and(inside)
        });
        receivers && casters
    }
}

/// Some total order of boxes.
fn by_corners(one: &BoundingBox, two: &BoundingBox) -> Ordering {
    let corners = |volume: &BoundingBox| volume.min.to_array().into_iter().chain(volume.max.to_array());
    let mut orders = corners(one).zip(corners(two)).map(|(one, two)| one.total_cmp(&two));
    orders.find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
}

/// What planning knows of what is seen, camera space; by default nothing.
#[derive(Debug, Default)]
pub struct Sighted {
    /// Parts of the receivers that hold everything seen that may be in shadow, as far as it is known exactly.
    parts: Option<Vec<Polytope>>,
    /// What the parts were found by.
    cut: Cut,
    /// Places where pixels are; empty: nothing is known of them.
    points: Vec<DVec3>,
    /// How far the points are to be believed: the share of those measured that this frame's camera still sees.
    trust: f64,
}

impl Sighted {
    /// What a case's fit takes of what is known; `receivers` are everything that may be visible and in shadow.
    pub(crate) fn of(
        fit: Fit,
        view: &View,
        light: DVec4,
        receivers: &Polytope,
        seen: &Seen<'_>,
    ) -> Result<Self, PlanError> {
        if fit == Fit::None || receivers.is_empty() {
            return Ok(Self::default());
        }
        let depth = seen.depth.filter(|depth| fit.measures_depth() && depth.is_usable());
        let depth = depth.map(|depth| if fit == Fit::Histogram { *depth } else { depth.range_alone() });
        let (parts, cut) = narrow::parts(view, light, receivers, seen, depth.as_ref())?;
        let (points, trust) = match (&parts, &depth) {
            (Some(parts), depth) => {
                // A range of depths says nothing of how often each is seen.
                let often = depth.as_ref().filter(|_| fit == Fit::Histogram);
                (points::within(parts, view, often), 1.0)
            }
            (None, Some(depth)) => points::measured(depth, view, receivers),
            (None, None) => (Vec::new(), 0.0),
        };
        Ok(Self { parts, cut, points, trust })
    }

    /// What receivers were left out by.
    pub(crate) const fn cut(&self) -> &Cut {
        &self.cut
    }

    /// Whether anything is known of where pixels are.
    pub(crate) const fn is_known(&self) -> bool {
        !self.points.is_empty()
    }

    /// How far what is known of pixels is to be believed.
    pub(crate) const fn trust(&self) -> f64 {
        self.trust
    }

    /// Places where pixels are, if anything is known of them.
    fn points(&self) -> Option<&[DVec3]> {
        (!self.points.is_empty()).then_some(&self.points)
    }

    /// Points that hold everything seen and nothing else, if that is known exactly.
    pub(crate) fn samples(&self) -> Option<&[DVec3]> {
        self.points().filter(|_| self.parts.is_some())
    }

    /// How many points each facet of a draft has, if anything is known of them.
    pub(crate) fn counts(&self, draft: &Draft) -> Option<Vec<usize>> {
        let points = self.points()?;
        let owners = draft.owners();
        let mut counts = vec![0; draft.facets.len()];
        for point in points {
            let owner = owners.get(draft.selection.cell(point.extend(1.0)) as usize);
            if let Some(count) = owner.and_then(|owner| counts.get_mut(*owner as usize)) {
                *count += 1;
            }
        }
        Some(counts)
    }

    /// How coarse the texels of facets are to be beside each other's, given how many each wants and how many points it
    /// has.
    pub(crate) fn coarser(&self, wanted: &[f64], points: &[usize]) -> Vec<f64> {
        weigh::coarser(wanted, points, self.trust)
    }
}

impl Situation<'_> {
    /// How often each value of a distance row is seen among receivers within some half-spaces; the row's value is the
    /// ratio of two rows plus `core`.
    pub(crate) fn profile(
        &self,
        within: &[DVec4],
        [distance, unit]: [DVec4; 2],
        core: f64,
    ) -> Option<Profile> {
        let points = self.sighted.points()?;
        let inside = |point: &&DVec3| within.iter().all(|plane| plane.dot(point.extend(1.0)) >= 0.0);
        let value = |point: &DVec3| distance.dot(point.extend(1.0)) / unit.dot(point.extend(1.0)) + core;
        Profile::of(points.iter().filter(inside).map(value), self.sighted.trust)
    }
}
