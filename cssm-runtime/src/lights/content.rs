//! What the tiles of a light should show, in 64 bits for each list of casters.

use cssm_core::ShadowPlan;

use super::description::{LightFrame, LightHandle};
use super::engine::{self, CasterLayer, EngineCaster, EngineDraw};
use super::shadow::{Content, Fill, TileState, TileWork};
use crate::casters::CasterScene;
use crate::commands::{CommandScratch, FrameCommands};

/// Everything that casts shadows in a frame.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sources<'a> {
    pub(super) fixed: &'a CasterScene,
    pub(super) dynamic: &'a CasterScene,
    engine: [&'a [EngineCaster]; 2],
    /// Hashes of the engine's lists.
    revisions: (u64, u64),
}

impl<'a> Sources<'a> {
    /// The frame's engine casters beside the scenes that hold its other ones.
    pub(super) fn new(fixed: &'a CasterScene, dynamic: &'a CasterScene, frame: &LightFrame<'a>) -> Self {
        let engine = [frame.static_engine_casters, frame.dynamic_engine_casters];
        let [of_fixed, of_dynamic] = engine.map(engine::revision);
        Self { fixed, dynamic, engine, revisions: (of_fixed, of_dynamic) }
    }

    /// Lists where the engine draws into a tile that changes.
    pub(super) fn list_engine_draws(
        &self,
        light: LightHandle,
        plan: &ShadowPlan,
        (state, work): (&TileState, &TileWork),
        draws: &mut Vec<EngineDraw>,
    ) {
        let [fixed, dynamic] = self.engine;
        let passes = [
            (work.draw_still, fixed, CasterLayer::Static, true),
            (work.fill == Fill::Draw, fixed, CasterLayer::Static, false),
            (work.content.dynamic != 0, dynamic, CasterLayer::Dynamic, false),
        ];
        for (_, casters, layer, is_still) in passes.into_iter().filter(|(is_drawn, ..)| *is_drawn) {
            let reached = |facet: &&usize| engine::content(casters, light, plan, **facet) != 0;
            let facets = state.facets.iter().filter(reached);
            draws.extend(facets.map(|facet| EngineDraw { facet: *facet, layer, is_still }));
        }
    }
}

impl TileState {
    /// Hashes of the casters that the tile should show.
    pub(super) fn content_now(
        &mut self,
        light: LightHandle,
        plan: &ShadowPlan,
        sources: &Sources,
        scratch: &mut CommandScratch,
    ) -> Content {
        let own = self.own_content(plan, sources, scratch);
        let engine = self.engine_content(light, plan, sources);
        let (fixed, dynamic) =
            (own.fixed.wrapping_add(engine.fixed), own.dynamic.wrapping_add(engine.dynamic));
        Content { fixed, dynamic }
    }

    /// The part that the service draws.
    fn own_content(&mut self, plan: &ShadowPlan, sources: &Sources, scratch: &mut CommandScratch) -> Content {
        let revisions = (sources.fixed.revision(), sources.dynamic.revision());
        let mut sum = |casters: &CasterScene| {
            let contents = self.facets.iter();
            summed(contents.map(|facet| FrameCommands::content(plan, *facet, casters, scratch)))
        };
        let (known, content) = self.own.unwrap_or((revisions, Content::NONE));
        let is_known = self.own.is_some();
        let fixed = if is_known && known.0 == revisions.0 { content.fixed } else { sum(sources.fixed) };
        let dynamic = if is_known && known.1 == revisions.1 { content.dynamic } else { sum(sources.dynamic) };
        let content = Content { fixed, dynamic };
        self.own = Some((revisions, content));
        content
    }

    /// The part that the engine draws.
    fn engine_content(&mut self, light: LightHandle, plan: &ShadowPlan, sources: &Sources) -> Content {
        if let Some((known, content)) = self.engine
            && known == sources.revisions
        {
            return content;
        }
        let [fixed, dynamic] = sources.engine.map(|casters| {
            let contents = self.facets.iter();
            summed(contents.map(|facet| engine::content(casters, light, plan, *facet)))
        });
        let content = Content { fixed, dynamic };
        self.engine = Some((sources.revisions, content));
        content
    }
}

/// Contents of the facets of one tile as one.
fn summed(contents: impl Iterator<Item = u64>) -> u64 {
    contents.fold(0_u64, |sum, content| sum.rotate_left(1).wrapping_add(content))
}
