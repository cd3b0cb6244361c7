//! One light in one view: its square, the plan that is held for it, and what its tiles show.

use cssm_core::facet::Tile;
use cssm_core::fit::DepthHistogram;
use cssm_core::plan::{MapRegion, PlanRequest};
use cssm_core::{Light, PlanError, SceneBounds, ShadowPlan, View};

use super::description::ViewId;
use super::tiles::Place;

/// The shadow of one light in one view.
#[derive(Debug)]
pub(super) struct Shadow {
    pub(super) view: ViewId,
    pub(super) place: Option<Place>,
    /// Predicted 95th percentile of the footprint, times the side; `None` while the light reaches nothing visible.
    pub(super) pixels_times_side: Option<f64>,
    pub(super) held: Option<Held>,
    /// Multiple of the view's last motion that plans reach beyond it.
    pub(super) reach: f64,
    /// Why there is no plan.
    pub(super) failure: Option<PlanError>,
    /// The view, the light and the bounds for which it was last found to reach nothing visible.
    pub(super) unseen: Option<(View, Light, SceneBounds)>,
}

/// A plan that outlives its frame, and what its tiles show.
#[derive(Debug)]
pub(super) struct Held {
    pub(super) plan: ShadowPlan,
    /// Tells this plan from all others of the service.
    pub(super) serial: u64,
    /// The light it was made for.
    pub(super) light: Light,
    /// Predicted 95th percentile of the footprint that a plan for the view alone would have had.
    pub(super) best_pixels: f64,
    /// The last view that its footprint was predicted for, and what was predicted.
    pub(super) predicted: Option<(View, f64)>,
    /// The last view that it was found to cover, in bounds.
    pub(super) covered: Option<(View, SceneBounds)>,
    /// The measured depth that it was fitted to.
    pub(super) depth: Option<Box<DepthHistogram>>,
    /// The plan relative to a later eye.
    seen: Option<Box<ShadowPlan>>,
    /// Frames that have used it.
    pub(super) frames: u32,
    pub(super) tiles: Vec<TileState>,
    /// Tiles of earlier plans, for their memory.
    spare: Vec<TileState>,
}

/// A tile and what it shows. Triangular facets share one.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TileState {
    pub(super) tile: Tile,
    /// Positions of its facets in the plan.
    pub(super) facets: Vec<usize>,
    /// What the shared map shows.
    pub(super) shown: Option<Content>,
    /// Static casters that the map of casters that stay shows.
    pub(super) still: Option<u64>,
    /// What it should show of the service's own casters, with the revisions of both lists that this was found for.
    pub(super) own: Option<((u64, u64), Content)>,
    /// What it should show of casters that the engine draws, with the hashes of both lists.
    pub(super) engine: Option<((u64, u64), Content)>,
}

/// Hashes of what is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Content {
    pub(super) fixed: u64,
    /// 0 where no dynamic caster is drawn.
    pub(super) dynamic: u64,
}

/// What is to be done to a tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct TileWork {
    /// Empty the tile and draw static casters into the map of casters that stay.
    pub(super) draw_still: bool,
    /// How the tile of the shared map gets its static casters.
    pub(super) fill: Fill,
    pub(super) content: Content,
}

/// Where static casters come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fill {
    /// They are drawn.
    Draw,
    /// They are there already.
    Restore,
}

impl Shadow {
    pub(super) fn new(view: ViewId) -> Self {
        Self {
            view,
            place: None,
            pixels_times_side: None,
            held: None,
            reach: FARTHEST_REACH,
            failure: None,
            unseen: None,
        }
    }

    /// Its square.
    pub(super) fn region(&self) -> Option<MapRegion> {
        self.place.map(|place| place.region)
    }
}

/// Whether a request knows of this very frame what is seen, which may differ in every frame and cuts. Late depth does not.
pub(super) fn is_measured(request: &PlanRequest) -> bool {
    let is_fresh = request.depth.is_some_and(|depth| depth.latency_frames == 0);
    !request.volumes_world.is_empty() || request.near_hint_metres.is_some() || is_fresh
}

/// Multiples of the view's motion that are tried first.
pub(super) const FARTHEST_REACH: f64 = 16.0;

impl Held {
    /// A place for plans, which holds none yet.
    pub(super) fn empty(request: &PlanRequest) -> Self {
        Self {
            plan: ShadowPlan::empty(),
            serial: 0,
            light: *request.light,
            best_pixels: 0.0,
            predicted: None,
            covered: None,
            seen: None,
            depth: None,
            frames: 0,
            tiles: Vec::new(),
            spare: Vec::new(),
        }
    }

    /// Changes its plan for another, whose tiles show nothing yet.
    pub(super) fn renew(
        &mut self,
        plan: &mut ShadowPlan,
        serial: u64,
        request: &PlanRequest,
        best_pixels: f64,
    ) {
        std::mem::swap(&mut self.plan, plan);
        self.spare.append(&mut self.tiles);
        for (position, facet) in self.plan.facets.iter().enumerate() {
            match self.tiles.iter_mut().find(|state| state.tile == facet.tile) {
                Some(state) => state.facets.push(position),
                None => {
                    let mut facets = self.spare.pop().map_or_else(Vec::new, |spare| spare.facets);
                    facets.clear();
                    facets.push(position);
                    self.tiles.push(TileState::new(facet.tile, facets));
                }
            }
        }
        let measured = request.depth.filter(|depth| request.case.fit.measures_depth() && depth.is_usable());
        self.depth = measured.map(|depth| Box::new(*depth));
        (self.serial, self.light, self.best_pixels, self.frames) = (serial, *request.light, best_pixels, 0);
        (self.predicted, self.covered, self.seen) = (None, None, None);
    }

    /// Whether it was made relative to a view's eye and axes.
    pub(super) fn is_of(&self, view: &View) -> bool {
        self.plan.eye_world == view.eye_world && self.plan.camera_from_world == view.camera_from_world
    }

    /// The plan as it was made, and relative to a view's eye. Memory is taken once in the plan's life; the constants of rows
    /// that are brought from eye to eye lose a bit of f64 in a thousand frames.
    pub(super) fn seen_from(&mut self, view: &View) -> (&ShadowPlan, &ShadowPlan) {
        if self.is_of(view) {
            return (&self.plan, &self.plan);
        }
        let seen = self.seen.get_or_insert_with(|| Box::new(self.plan.clone()));
        if seen.eye_world != view.eye_world || seen.camera_from_world != view.camera_from_world {
            seen.rebase(view);
        }
        (&self.plan, seen)
    }

    /// Whether it covers what a request sees, whatever the request's light.
    pub(super) fn covers(&mut self, request: &PlanRequest) -> bool {
        let asked = (*request.view, request.bounds);
        if !is_measured(request) && self.covered == Some(asked) {
            return true;
        }
        let covers = self.plan.covers(&PlanRequest { light: &self.light, ..*request });
        self.covered = covers.then_some(asked);
        covers
    }

    /// Predicted 95th percentile of the footprint in a view.
    pub(super) fn pixels(&mut self, view: &View) -> f64 {
        if let Some((known, pixels)) = &self.predicted
            && known == view
        {
            return *pixels;
        }
        let pixels = self.plan.p95_pixels(view);
        self.predicted = Some((*view, pixels));
        pixels
    }
}

impl Content {
    /// No casters.
    pub(super) const NONE: Self = Self { fixed: 0, dynamic: 0 };
}

impl TileState {
    /// A tile that shows nothing yet.
    fn new(tile: Tile, facets: Vec<usize>) -> Self {
        Self { tile, facets, shown: None, still: None, own: None, engine: None }
    }

    /// What brings a tile from what it shows to some content; `None` where nothing is to be done. A plan in its first
    /// frame may not live to see another, so only later ones keep static casters apart.
    pub(super) fn work(&self, content: Content, first_frame: bool) -> Option<TileWork> {
        if self.shown == Some(content) {
            return None;
        }
        let keeps = self.still == Some(content.fixed);
        let worth_keeping =
            !first_frame && (content.dynamic != 0 || self.shown.is_some_and(|c| c.dynamic != 0));
        let fill = if keeps || worth_keeping { Fill::Restore } else { Fill::Draw };
        Some(TileWork { draw_still: worth_keeping && !keeps, fill, content })
    }

    /// Remembers what was drawn.
    pub(super) fn drawn(&mut self, work: TileWork) {
        self.shown = Some(work.content);
        if work.draw_still {
            self.still = Some(work.content.fixed);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STILL: Content = Content { fixed: 7, dynamic: 0 };
    const MOVING: Content = Content { fixed: 7, dynamic: 3 };

    fn tile() -> TileState {
        let tile = Tile { x: 0, y: 0, width: 64, height: 64, gutter: 2 };
        TileState::new(tile, vec![0])
    }

    #[test]
    fn a_tile_is_drawn_once_while_nothing_changes() {
        let mut tile = tile();
        let work = tile.work(STILL, true).unwrap();
        assert_eq!(work, TileWork { draw_still: false, fill: Fill::Draw, content: STILL });
        tile.drawn(work);
        assert_eq!(tile.work(STILL, false), None);
        assert!(tile.work(Content { fixed: 8, dynamic: 0 }, false).is_some());
    }

    #[test]
    fn static_casters_are_kept_apart_from_the_second_frame_on() {
        let mut tile = tile();
        tile.drawn(tile.work(MOVING, true).unwrap());
        assert_eq!(tile.still, None);

        let moved = Content { dynamic: 4, ..MOVING };
        let work = tile.work(moved, false).unwrap();
        assert_eq!(work, TileWork { draw_still: true, fill: Fill::Restore, content: moved });
        tile.drawn(work);
        let again = Content { dynamic: 5, ..MOVING };
        let work = tile.work(again, false).unwrap();
        assert_eq!(work, TileWork { draw_still: false, fill: Fill::Restore, content: again });

        // The last dynamic caster leaves; then static casters change.
        assert_eq!(tile.work(STILL, false).unwrap().fill, Fill::Restore);
        let work = tile.work(Content { fixed: 9, dynamic: 5 }, false).unwrap();
        assert!(work.draw_still);
    }
}
