//! Casters that only the engine can draw, in the map of many lights: what it skins, instances or displaces.
//!
//! The engine says of each where it may be and when it changed, by a box and a number; the service asks for a draw wherever
//! a tile is drawn anew whose facets such a box can throw a shadow into, with everything set that belongs to the map.

use cssm_core::glam::DVec3;
use cssm_core::{BoundingBox, ShadowPlan};

use super::LightService;
use super::description::{CaseHandle, LightHandle};
use super::prepared::{PreparedLights, PreparedShadow};
use crate::capture::{EngineFacet, Records};
use crate::casters::mixed;
use crate::error::ServiceError;
use crate::frame::PreparedFrame;

/// What the service must know of casters that the engine draws by itself.
///
/// One of them may stand for a single object or for all; the smaller the box, the fewer tiles are drawn when it changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EngineCaster {
    /// The only light whose shadows it is part of; `None`: it is part of every light's.
    pub light: Option<LightHandle>,
    /// A box in world space that holds whatever is drawn, at least until the next frame; `None`: it may be anywhere.
    pub bounds_world: Option<BoundingBox>,
    /// Tells what is drawn within the box: a number that no other caster of the engine's has, nor this one in another
    /// shape. Counting all changes of all casters makes such numbers.
    pub revision: u64,
}

/// Which casters are to be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CasterLayer {
    /// Those of [`LightFrame::static_engine_casters`](super::LightFrame::static_engine_casters).
    Static,
    /// Those of [`LightFrame::dynamic_engine_casters`](super::LightFrame::dynamic_engine_casters).
    Dynamic,
}

/// A facet of a light that the engine draws its casters into: viewport, scissor and record are set.
#[derive(Debug, Clone, Copy)]
pub struct LightFacet<'a> {
    /// The light.
    pub light: LightHandle,
    /// Its case, whose [`CasterPipelines`](crate::CasterPipelines) draw.
    pub case: CaseHandle,
    /// Which casters are to be drawn. Drawing others would leave them in tiles that they have left.
    pub layer: CasterLayer,
    /// The plan that the light is captured with, relative to an eye of its own:
    /// [`caster_rows`](cssm_core::table::caster_rows) places objects by it.
    pub plan: &'a ShadowPlan,
    /// The facet and its depth order.
    pub facet: EngineFacet<'a>,
}

impl LightFacet<'_> {
    /// Whether a box in world space can throw a shadow on what the facet's receivers are. Conservative.
    pub fn reached_by(&self, bounds_world: &BoundingBox) -> bool {
        let eye = self.plan.eye_world;
        let box_from_eye = BoundingBox { min: bounds_world.min - eye, max: bounds_world.max - eye };
        self.facet.facet.reached_by(&box_from_eye)
    }
}

impl EngineCaster {
    /// A caster of all lights.
    pub const fn new(bounds_world: BoundingBox, revision: u64) -> Self {
        Self { light: None, bounds_world: Some(bounds_world), revision }
    }

    /// What is drawn and where, well mixed.
    fn hash(&self) -> u64 {
        let nowhere = BoundingBox { min: DVec3::NAN, max: DVec3::NAN };
        let BoundingBox { min, max } = self.bounds_world.unwrap_or(nowhere);
        let corners = [min.x, min.y, min.z, max.x, max.y, max.z].map(f64::to_bits);
        corners.into_iter().fold(mixed(!self.revision), |hash, word| mixed(hash.wrapping_mul(31) ^ word))
    }
}

/// Where the engine draws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct EngineDraw {
    /// Position of the facet in the plan's list.
    pub(super) facet: usize,
    pub(super) layer: CasterLayer,
    /// Into the map of casters that stay.
    pub(super) is_still: bool,
}

/// What the engine's casters show in a facet of a light, as [`crate::FrameCommands::content`] tells it of others: 0 where
/// none reaches it.
pub(super) fn content(
    casters: &[EngineCaster],
    light: LightHandle,
    plan: &ShadowPlan,
    position: usize,
) -> u64 {
    let Some(facet) = plan.facets.get(position) else { return 0 };
    let eye = plan.eye_world;
    let reaches = |caster: &&EngineCaster| {
        caster.light.is_none_or(|own| own == light)
            && caster.bounds_world.is_none_or(|bounds| {
                facet.reached_by(&BoundingBox { min: bounds.min - eye, max: bounds.max - eye })
            })
    };
    casters.iter().filter(reaches).fold(0, |sum, caster| sum.wrapping_add(caster.hash()))
}

/// A number for a whole list, which others have only by an odd chance.
pub(super) fn revision(casters: &[EngineCaster]) -> u64 {
    let number = |light: LightHandle| u64::from(light.index) << 32 | u64::from(light.generation);
    let words = casters.iter().flat_map(|one| [one.light.map_or(u64::MAX, number), one.hash()]);
    words.fold(casters.len() as u64, |hash, word| mixed(hash.wrapping_mul(31) ^ word))
}

/// Refuses boxes that hold nothing.
///
/// # Errors
/// [`ServiceError::EngineBounds`].
pub(super) fn check(list: &'static str, casters: &[EngineCaster]) -> Result<(), ServiceError> {
    let is_box = |bounds: &BoundingBox| {
        bounds.min.is_finite() && bounds.max.is_finite() && bounds.min.cmple(bounds.max).all()
    };
    let wrong = casters.iter().position(|one| one.bounds_world.is_some_and(|bounds| !is_box(&bounds)));
    wrong.map_or(Ok(()), |caster| Err(ServiceError::EngineBounds { list, caster }))
}

impl LightService {
    /// Records a capture as [`LightService::capture`] does, and calls `draw` wherever a tile is drawn whose facets casters
    /// of the engine's own can reach: it draws them with its own pipelines, vertex buffers and bind groups.
    ///
    /// `draw` leaves viewport, scissor and the facet's bind group alone, and is called in the passes of the service's own
    /// casters. A tile that shows the same casters as before is not asked for again.
    ///
    /// # Errors
    /// As [`LightService::capture`]; nothing is recorded then.
    pub fn capture_with(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        frame: &PreparedLights,
        timestamps: Option<wgpu::RenderPassTimestampWrites>,
        mut draw: impl FnMut(&mut wgpu::RenderPass, LightFacet),
    ) -> Result<(), ServiceError> {
        self.record(encoder, frame, timestamps, &mut draw)
    }

    /// Lets the engine draw into the facets of a light, either in the map of casters that stay or in the shared map.
    pub(super) fn draw_engine(
        &self,
        pass: &mut wgpu::RenderPass,
        (shadow, frame): (&PreparedShadow, &PreparedFrame),
        is_still: bool,
        draw: &mut dyn FnMut(&mut wgpu::RenderPass, LightFacet),
    ) {
        let draws = shadow.engine.iter().filter(|draw| draw.is_still == is_still);
        let Some(plan) = self.captured_plan(shadow) else { return };
        let Some(served) = self.cases.get(shadow.case) else { return };
        let records = Records {
            slot: &frame.slot,
            facet_stride: served.service.gpu().layouts.uniforms.facet_stride,
            order: frame.depth_order,
            culled: None,
        };
        for EngineDraw { facet: position, layer, .. } in draws.copied() {
            let Some(facet) = plan.facets.get(position) else { continue };
            records.begin_facet(pass, position, &facet.tile);
            let facet = EngineFacet { position, facet, depth_order: frame.depth_order };
            let (light, case) = (shadow.light, CaseHandle(shadow.case as u32));
            draw(pass, LightFacet { light, case, layer, plan, facet });
        }
    }

    /// The plan that a light's part of a frame was prepared with.
    fn captured_plan(&self, shadow: &PreparedShadow) -> Option<&ShadowPlan> {
        let entry = self.lights.get(shadow.light.index as usize)?;
        let served = entry.light.as_ref().filter(|_| entry.generation == shadow.light.generation)?;
        let mut held = served.shadows.iter().filter_map(|shadow| shadow.held.as_ref());
        held.find(|held| held.serial == shadow.serial).map(|held| &held.plan)
    }
}
