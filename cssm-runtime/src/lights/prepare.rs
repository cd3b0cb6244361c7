//! One view of one frame: which lights need another plan, which tiles other casters, and the commands that bring both
//! about.

use cssm_core::facet::Facet;
use cssm_core::plan::{MapRegion, PlanRequest};
use cssm_core::{LightCase, PlanError, ShadowPlan};

use super::content::Sources;
use super::description::{LightDescription, LightFrame, LightHandle, Update};
use super::engine;
use super::hold::{self, Motion, Need};
use super::prepared::{PreparedLights, PreparedShadow};
use super::report::{LightState, LightStatistics, TileStatistics};
use super::shadow::{Fill, Shadow, TileState, TileWork, is_measured};
use super::{LightService, Scratch, ServedCase, ServedView};
use crate::commands::MeshFacts;
use crate::culling::GpuCulling;
use crate::error::ServiceError;
use crate::mesh::MeshHandle;

/// Side of the square that lights are planned for before they have one.
const SURVEY_SIDE: u32 = 512;
/// How often squares that turn out too small for a plan's tiles are enlarged within one frame.
const ENLARGEMENTS: u32 = 6;

impl LightService {
    /// Prepares one view of one frame; `prepared` may hold an earlier one, whose memory is used again.
    ///
    /// Lights that cannot be planned are reported ([`LightState::Failed`]) and keep the shadows they had. A failure of the
    /// whole leaves `prepared` and the map as they were.
    ///
    /// # Errors
    /// Unknown meshes and transforms that are not finite, naming the list and the instance; a lost device, no memory.
    pub fn prepare(&mut self, frame: &LightFrame, prepared: &mut PreparedLights) -> Result<(), ServiceError> {
        // Fill the memory that is not the engine's, then swap.
        let mut next = std::mem::take(&mut self.scratch.next);
        let filled = self.decide(frame, &mut next).and_then(|draws_still| {
            if draws_still {
                self.layers.keep_still_casters(&self.device)?;
            }
            self.upload(frame, &mut next)
        });
        if filled.is_ok() {
            std::mem::swap(&mut next, prepared);
        }
        self.scratch.next = next;
        filled
    }

    /// Everything but the upload: plans, squares, and lists of what is drawn. Returns whether static casters are drawn
    /// apart. Allocates nothing where lists have their room and no plan is made, which no view that stands still needs.
    pub(super) fn decide(
        &mut self,
        frame: &LightFrame,
        next: &mut PreparedLights,
    ) -> Result<bool, ServiceError> {
        self.update_casters(frame)?;
        self.number += 1;
        let motion = self.motion(frame);
        let depth = self.depth_now(frame);
        let frame = &LightFrame { depth: frame.depth.or(depth.as_ref()), ..*frame };

        // Plan, and share the map anew where a square turns out too small.
        let mut moved = 0;
        let mut planned = 0;
        self.survey(frame);
        for _ in 0..ENLARGEMENTS {
            moved += self.share_map();
            let (plans, is_short) = self.replan(frame, motion);
            planned += plans;
            if !is_short {
                break;
            }
        }
        next.reset(&self.identity, frame.view_id, self.number);
        next.report.planned = planned;
        next.report.moved = moved;
        self.list(frame, next)
    }

    fn update_casters(&mut self, frame: &LightFrame) -> Result<(), ServiceError> {
        engine::check("static", frame.static_engine_casters)?;
        engine::check("dynamic", frame.dynamic_engine_casters)?;
        let Self { meshes, cases, static_casters, dynamic_casters, .. } = self;
        let first = cases.first().ok_or(ServiceError::NoCases)?;
        let facts = |mesh| meshes.facts(&first.service, 0, mesh);
        let named = |list| move |source| ServiceError::Casters { list, source: Box::new(source) };
        static_casters.update(frame.static_casters, facts).map_err(named("static"))?;
        dynamic_casters.update(frame.dynamic_casters, facts).map_err(named("dynamic"))?;
        Ok(())
    }

    /// How far the view has moved since its last frame.
    fn motion(&mut self, frame: &LightFrame) -> Option<Motion> {
        let (view, prepared) = (*frame.view, self.number);
        match self.views.iter_mut().find(|known| known.id == frame.view_id) {
            Some(known) => {
                let motion = Motion::between(&known.view, frame.view);
                (known.view, known.prepared) = (view, prepared);
                motion.filter(|_| self.options.hold)
            }
            None => {
                self.views.push(ServedView { id: frame.view_id, view, prepared });
                None
            }
        }
    }

    /// Finds out how many texels the lights without a square would need.
    fn survey(&mut self, frame: &LightFrame) {
        let Self { lights, cases, scratch, .. } = self;
        for served in lights.iter_mut().filter_map(|entry| entry.light.as_mut()) {
            let Some(index) = shadow_of(&mut served.shadows, frame) else { continue };
            let (shadow, description) = (&mut served.shadows[index], &served.description);
            if shadow.place.is_some() {
                continue;
            }
            let Some(case) = cases.get(description.case.0 as usize) else { continue };
            let map = case.case.map;
            let side = SURVEY_SIDE.min(map.width).min(map.height);
            let region = MapRegion { x: 0, y: 0, width: side, height: side };
            let request = request(&case.case, description, frame, Some(region));
            let asked = (*frame.view, description.light, frame.bounds);
            if !is_measured(&request) && shadow.unseen == Some(asked) {
                continue;
            }
            shadow.failure = None;
            let hold::Planning { planner, exact: plan, .. } = &mut scratch.planning;
            match planner.plan(&request, plan) {
                Ok(()) => {
                    shadow.estimate(plan, frame.view, side, description);
                    shadow.unseen = plan.facets.is_empty().then_some(asked);
                }
                Err(PlanError::MapTooSmall { .. }) => {
                    shadow.pixels_times_side = Some(description.enough_pixels * f64::from(side) * 2.0);
                }
                Err(error) => {
                    shadow.pixels_times_side = None;
                    shadow.failure = Some(error);
                }
            }
        }
    }

    /// Plans the shadows that need another plan, and those that would be better off as far as the budget reaches. Returns
    /// how many, and whether a square was too small for its tiles.
    fn replan(&mut self, frame: &LightFrame, motion: Option<Motion>) -> (u32, bool) {
        let (mut planned, mut is_short) = (0, false);
        let mut left_texels = self.options.redrawn_texels;
        let mut wishes = std::mem::take(&mut self.scratch.wishes);
        wishes.clear();
        for index in 0..self.lights.len() {
            let turn = self.is_its_turn(index);
            let Some((served, shadow, case)) = parts(&mut self.lights, &self.cases, index, frame) else {
                continue;
            };
            let Some(region) = shadow.region() else {
                shadow.held = None;
                continue;
            };
            let request = request(&case.case, served, frame, Some(region));
            match hold::need(shadow.held.as_mut(), &request, self.options.hold) {
                Need::Nothing => {}
                Need::Better => {
                    if turn {
                        let cost = shadow
                            .held
                            .as_ref()
                            .map_or(1.0, |held| held.plan.p95_pixels(frame.view) / held.best_pixels);
                        wishes.push((served.priority * cost, index));
                    }
                }
                Need::Another => {
                    left_texels = left_texels.saturating_sub(texels(region));
                    planned += 1;
                    self.serial += 1;
                    is_short |=
                        shadow.plan(&request, motion, self.serial, served, &mut self.scratch.planning);
                }
            }
        }

        // What could be better comes after what must be, the worst first.
        wishes.sort_unstable_by(|one, other| other.0.total_cmp(&one.0).then(one.1.cmp(&other.1)));
        for (_, index) in wishes.drain(..) {
            let Some((served, shadow, case)) = parts(&mut self.lights, &self.cases, index, frame) else {
                continue;
            };
            let Some(region) = shadow.region().filter(|region| texels(*region) <= left_texels) else {
                continue;
            };
            left_texels -= texels(region);
            planned += 1;
            self.serial += 1;
            let request = request(&case.case, served, frame, Some(region));
            is_short |= shadow.plan(&request, motion, self.serial, served, &mut self.scratch.planning);
        }
        self.scratch.wishes = wishes;
        (planned, is_short)
    }

    /// Whether a light's changes may reach the map in this frame.
    fn is_its_turn(&self, index: usize) -> bool {
        let served = self.lights.get(index).and_then(|entry| entry.light.as_ref());
        match served.map(|served| served.description.update) {
            Some(Update::Every { frames }) => {
                (self.number + index as u64).is_multiple_of(u64::from(frames.max(1)))
            }
            _ => true,
        }
    }

    /// Builds the commands of all lights. Returns whether static casters are drawn apart.
    fn list(&mut self, frame: &LightFrame, next: &mut PreparedLights) -> Result<bool, ServiceError> {
        next.report.map_texels = u64::from(self.layers.main.width()) * u64::from(self.layers.main.height());
        let mut left_texels = self.options.redrawn_texels;
        let mut draws_still = false;
        self.scratch.work.clear();
        for index in 0..self.lights.len() {
            let turn = self.is_its_turn(index);
            let Self { lights, cases, static_casters, dynamic_casters, scratch, meshes, culling, .. } = self;
            let sources = Sources::new(static_casters, dynamic_casters, frame);
            let Some(entry) = lights.get_mut(index) else { continue };
            let light = LightHandle { index: index as u32, generation: entry.generation };
            let Some(served) = &mut entry.light else { continue };
            let description = served.description;
            let Some(shadow) = served.shadows.iter_mut().find(|shadow| shadow.view == frame.view_id) else {
                continue;
            };
            next.report.owned_texels += shadow.region().map_or(0, texels);
            let case_index = description.case.0 as usize;
            let Some(case) = cases.get_mut(case_index) else { continue };
            let mut statistics = shadow.statistics(light, frame.view, next.tiles.pop().unwrap_or_default());
            let Some(held) = &mut shadow.held else {
                next.report.lights.push(statistics);
                continue;
            };

            // Find the tiles that show something else than they should.
            let part = next.next(light, case_index, held.serial);
            let is_first = held.frames == 0;
            let plan = &held.plan;
            for (position, state) in held.tiles.iter_mut().enumerate() {
                let content = state.content_now(light, plan, &sources, &mut scratch.commands);
                let Some(work) = state.work(content, is_first) else { continue };
                let side = state.tile.texels();
                if state.shown.is_some() && (!turn || side > left_texels) {
                    statistics.state = LightState::Waits;
                    continue;
                }
                left_texels = left_texels.saturating_sub(side);
                draws_still |= work.draw_still;
                part.works.push((position, state.tile, work));
                sources.list_engine_draws(light, plan, (state, &work), &mut part.engine);
            }
            let facts = |mesh| meshes.facts(&case.service, case_index, mesh);
            part.build(&held.plan, &held.tiles, &sources, facts, culling.as_ref(), scratch, &mut statistics)?;
            let static_texels = part.works.iter().filter(|(.., work)| work.draw_still);
            let static_texels: u64 = static_texels.map(|(_, tile, _)| tile.texels()).sum();
            let engine_facets = part.engine.len() as u32;
            next.report.add(&statistics, static_texels, engine_facets);
            if held.light != description.light && statistics.state == LightState::Current {
                statistics.state = LightState::Waits;
            }
            held.frames = held.frames.saturating_add(1);

            next.report.lights.push(statistics);
        }
        next.report.waiting =
            next.report.lights.iter().filter(|light| light.state == LightState::Waits).count() as u32;
        next.tiles.reserve(next.report.lights.len());
        Ok(draws_still)
    }
}

/// The request for a light's plan.
fn request<'a>(
    case: &'a LightCase,
    description: &'a LightDescription,
    frame: &LightFrame<'a>,
    region: Option<MapRegion>,
) -> PlanRequest<'a> {
    PlanRequest {
        volumes_world: frame.volumes_world,
        near_hint_metres: frame.near_hint_metres,
        depth: frame.depth,
        region,
        ..PlanRequest::new(case, frame.view, &description.light, frame.bounds)
    }
}

/// A light, its shadow in the frame's view and its case.
fn parts<'l>(
    lights: &'l mut [super::LightEntry],
    cases: &'l [ServedCase],
    index: usize,
    frame: &LightFrame,
) -> Option<(&'l LightDescription, &'l mut Shadow, &'l ServedCase)> {
    let served = lights.get_mut(index)?.light.as_mut()?;
    let shadow = served.shadows.iter_mut().find(|shadow| shadow.view == frame.view_id)?;
    Some((&served.description, shadow, cases.get(served.description.case.0 as usize)?))
}

/// The position of the frame's shadow, made on first use.
fn shadow_of(shadows: &mut Vec<Shadow>, frame: &LightFrame) -> Option<usize> {
    let known = shadows.iter().position(|shadow| shadow.view == frame.view_id);
    known.or_else(|| {
        shadows.push(Shadow::new(frame.view_id));
        Some(shadows.len() - 1)
    })
}

fn texels(region: MapRegion) -> u64 {
    u64::from(region.width) * u64::from(region.height)
}

impl PreparedShadow {
    /// Builds the draws of the tiles that change, and counts them.
    #[allow(
        clippy::too_many_arguments,
        reason = "the parts of the service that one light's commands are made from"
    )]
    fn build<'m>(
        &mut self,
        plan: &ShadowPlan,
        tiles: &[TileState],
        sources: &Sources,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        culling: Option<&GpuCulling>,
        scratch: &mut Scratch,
        statistics: &mut LightStatistics,
    ) -> Result<(), ServiceError> {
        let Self { works, still, fixed, dynamic, .. } = self;
        let Scratch { commands: memory, statistics: counts, work: left, .. } = scratch;
        let drawn_still: fn(&TileWork) -> bool = |work| work.draw_still;
        let drawn_fixed: fn(&TileWork) -> bool = |work| work.fill == Fill::Draw;
        let drawn_dynamic: fn(&TileWork) -> bool = |work| work.content.dynamic != 0;
        let lists = [
            (still, drawn_still, sources.fixed, "static"),
            (fixed, drawn_fixed, sources.fixed, "static"),
            (dynamic, drawn_dynamic, sources.dynamic, "dynamic"),
        ];
        for (list, is_drawn, casters, name) in lists {
            let chosen = works.iter().filter(|(.., work)| is_drawn(work));
            let facets = chosen.flat_map(|(position, ..)| tiles[*position].facets.iter().copied());
            let rebuilt = match culling {
                None => list.rebuild(plan, facets, casters, &facts, memory, counts),
                Some(culling) => culling.rebuild(list, plan, facets, casters, &facts, memory, counts, left),
            };
            rebuilt.map_err(|source| ServiceError::Casters { list: name, source: Box::new(source) })?;
            statistics.draws += counts.draws;
            statistics.triangles += counts.triangles;
        }

        // List the tiles.
        statistics.redrawn_texels = works.iter().map(|(_, tile, _)| tile.texels()).sum();
        statistics.tiles.extend(tiles.iter().enumerate().map(|(position, state)| {
            let facet = state.facets.first().and_then(|facet| plan.facets.get(*facet));
            TileStatistics {
                first_cell: facet.map_or(0, Facet::first_cell),
                tile: state.tile,
                redrawn: works.iter().any(|(changed, ..)| *changed == position),
            }
        }));
        Ok(())
    }
}
