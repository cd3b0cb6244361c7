//! Many lights, one depth texture: the shadow service for whole scenes.
//!
//! An engine declares its light cases once, adds, updates and removes lights of them, and hands over its view and casters
//! every frame:
//!
//! 1. [`LightService::prepare`] plans what has to be planned, shares the texture among the lights that the view sees, finds
//!    the tiles whose casters changed and uploads the records;
//! 2. [`LightService::capture`] draws those tiles, and nothing else, in one render pass; [`LightService::capture_with`] lets
//!    the engine draw its own casters into them;
//! 3. [`LightService::mask`] writes one light's visibility, or the engine's own materials take
//!    [`PreparedLights::shadow_bind_group`].
//!
//! # Main choices
//!
//! * **One texture.** Each light has a square of the map that all cases declare alike. Its side follows the predicted
//!   footprint: the light with the largest error gets texels first, so a map that is too small degrades all evenly.
//!   Squares stay where they are until their size changes by more than a step.
//! * **Plans are held.** While the view moves slowly a plan is made for a slightly wider view and kept, re-based to every
//!   new eye in f64, as long as it covers what is seen and its predicted footprint stays within a tenth of the best. Its
//!   tiles then show the same casters at the same texels, and are drawn again only when casters change.
//! * **Static and dynamic casters are apart.** From a plan's second frame on, static casters are drawn once into a second
//!   texture; dynamic casters are drawn over a copy of them.
//! * **Nothing is lost to a budget.** What the map does not cover yet is drawn at once; only changes that can wait do.

mod content;
mod depth;
mod description;
mod engine;
mod hold;
mod layers;
mod meshes;
mod planned;
mod prepare;
mod prepared;
mod record;
mod report;
mod scissor;
mod shadow;
mod share;
mod shares;
mod stored;
mod tiles;
mod upload;

use std::collections::BinaryHeap;
use std::sync::Arc;

use cssm_core::table::CaseTable;
use cssm_core::{LightCase, ShadowPlan, View};

pub use description::{CaseHandle, LightDescription, LightFrame, LightHandle, LightOptions, Update, ViewId};
pub use engine::{CasterLayer, EngineCaster, LightFacet};
pub use prepared::{LightCommands, PreparedLights};
pub use report::{LightReport, LightState, LightStatistics, TileStatistics};

use crate::atlas::texture_format;
use crate::casters::CasterScene;
use crate::commands::{CommandScratch, FrameStatistics};
use crate::culling::{Culling, CullingWork, GpuCulling};
use crate::error::ServiceError;
use crate::service::{Options, ShadowService};
use depth::ObservedDepth;
use layers::Layers;
use meshes::Meshes;
use shadow::Shadow;
use tiles::Places;

/// Executes the tables of several light cases for any number of lights in one depth texture.
#[derive(Debug)]
pub struct LightService {
    device: wgpu::Device,
    queue: wgpu::Queue,
    options: LightOptions,
    cases: Vec<ServedCase>,
    layers: Layers,
    places: Places,
    lights: Vec<LightEntry>,
    meshes: Meshes,
    static_casters: CasterScene,
    dynamic_casters: CasterScene,
    /// Where the options ask for it and the device can.
    culling: Option<GpuCulling>,
    views: Vec<ServedView>,
    /// What is measured of views.
    depths: Vec<ObservedDepth>,
    scratch: Scratch,
    /// Counts calls of [`LightService::prepare`].
    number: u64,
    /// Counts plans.
    serial: u64,
    identity: Arc<()>,
}

/// A view as it was last.
#[derive(Debug)]
struct ServedView {
    id: ViewId,
    view: View,
    /// Number of the call that prepared it.
    prepared: u64,
}

/// A declared case and what executes it.
#[derive(Debug)]
struct ServedCase {
    case: LightCase,
    service: ShadowService,
}

#[derive(Debug, Default)]
struct LightEntry {
    generation: u32,
    light: Option<ServedLight>,
}

/// A light and its shadows, one for each view.
#[derive(Debug)]
struct ServedLight {
    description: LightDescription,
    shadows: Vec<Shadow>,
}

/// Memory that is kept from frame to frame.
#[derive(Debug, Default)]
struct Scratch {
    planning: hold::Planning,
    commands: CommandScratch,
    statistics: FrameStatistics,
    /// What the device is to cull in a frame, for all lights.
    work: CullingWork,
    claims: Vec<share::Claim>,
    sides: Vec<u32>,
    queue: BinaryHeap<share::Wish>,
    wishes: Vec<(f64, usize)>,
    ruled: Vec<u32>,
    claimants: Vec<shares::Claimant>,
    /// Filled in turn with what the engine holds, so that a failure leaves the engine's as it was.
    next: PreparedLights,
}

impl LightService {
    /// Creates the texture and the pipelines of some cases, whose tables code generation has filled and whose maps have
    /// one size and format.
    ///
    /// # Errors
    /// No case, maps that differ, a table of another case; else as [`ShadowService::new`].
    pub fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        cases: &[(&LightCase, &CaseTable)],
        options: &LightOptions,
    ) -> Result<Self, ServiceError> {
        let (first, _) = *cases.first().ok_or(ServiceError::NoCases)?;
        let layers =
            Layers::new(device, texture_format(first.map.format), first.map.width, first.map.height)?;
        let served = |(case, table): &(&LightCase, &CaseTable)| {
            ServedCase::new(device, queue, case, table, options, &layers.main)
        };
        let culling = match options.service.culling {
            Culling::Cpu => None,
            Culling::Gpu => GpuCulling::new(device)?,
        };
        let cases = cases.iter().map(served).collect::<Result<Vec<_>, _>>()?;
        Ok(Self {
            device: device.clone(),
            queue: queue.clone(),
            options: *options,
            places: Places::new(layers.main.width(), layers.main.height()),
            cases,
            layers,
            lights: Vec::new(),
            meshes: Meshes::default(),
            static_casters: CasterScene::new(),
            dynamic_casters: CasterScene::new(),
            culling,
            views: Vec::new(),
            depths: Vec::new(),
            scratch: Scratch::default(),
            number: 0,
            serial: 0,
            identity: Arc::new(()),
        })
    }

    /// Adds a light.
    ///
    /// # Errors
    /// Unknown cases, lights of another kind than their case's, numbers that make no sense.
    pub fn add_light(&mut self, description: &LightDescription) -> Result<LightHandle, ServiceError> {
        self.check(description)?;
        let free = self.lights.iter().position(|entry| entry.light.is_none());
        let index = free.unwrap_or_else(|| {
            self.lights.push(LightEntry::default());
            self.lights.len() - 1
        });
        let entry = &mut self.lights[index];
        entry.light = Some(ServedLight { description: *description, shadows: Vec::new() });
        Ok(LightHandle { index: index as u32, generation: entry.generation })
    }

    /// Changes a light: where it stands, what it may cost, even its case.
    ///
    /// # Errors
    /// As [`LightService::add_light`], and [`ServiceError::UnknownLight`]. The light stays as it was then.
    pub fn update_light(
        &mut self,
        light: LightHandle,
        description: &LightDescription,
    ) -> Result<(), ServiceError> {
        self.check(description)?;
        let places = &mut self.places;
        let entry = self.lights.get_mut(light.index as usize);
        let served = entry.filter(|entry| entry.generation == light.generation);
        let served = served.and_then(|entry| entry.light.as_mut()).ok_or(ServiceError::UnknownLight)?;
        if served.description.case != description.case {
            // Plans of one case mean nothing to another.
            for shadow in served.shadows.drain(..) {
                shadow.place.into_iter().for_each(|place| places.give_back(place));
            }
        }
        served.description = *description;
        Ok(())
    }

    /// Forgets a light; returns whether it was known.
    pub fn remove_light(&mut self, light: LightHandle) -> bool {
        let Some(entry) = self.lights.get_mut(light.index as usize) else { return false };
        if entry.generation != light.generation {
            return false;
        }
        let Some(served) = entry.light.take() else { return false };
        entry.generation = entry.generation.wrapping_add(1);
        for place in served.shadows.into_iter().filter_map(|shadow| shadow.place) {
            self.places.give_back(place);
        }
        true
    }

    /// What is known of a light.
    pub fn light(&self, light: LightHandle) -> Option<&LightDescription> {
        let entry = self.lights.get(light.index as usize)?;
        let served = entry.light.as_ref().filter(|_| entry.generation == light.generation)?;
        Some(&served.description)
    }

    /// The plan that a light's shadows in a view were drawn by, relative to an eye of its own; `None` without shadows.
    /// [`cssm_core::ShadowPlan::rebased`] brings it to the view's present eye.
    pub fn plan(&self, light: LightHandle, view: ViewId) -> Option<&ShadowPlan> {
        let entry = self.lights.get(light.index as usize)?;
        let served = entry.light.as_ref().filter(|_| entry.generation == light.generation)?;
        let shadow = served.shadows.iter().find(|shadow| shadow.view == view)?;
        shadow.held.as_ref().map(|held| &held.plan)
    }

    /// Forgets a view: its lights' squares become free.
    pub fn remove_view(&mut self, view: ViewId) {
        self.views.retain(|known| known.id != view);
        self.depths.retain(|known| known.view != view);
        for served in self.lights.iter_mut().filter_map(|entry| entry.light.as_mut()) {
            served.shadows.retain(|shadow| {
                if shadow.view == view
                    && let Some(place) = shadow.place
                {
                    self.places.give_back(place);
                }
                shadow.view != view
            });
        }
    }

    /// Replaces a case's declaration and shaders, such as after they were generated anew. A table that the device refuses
    /// changes nothing: the earlier shaders stay in use.
    ///
    /// # Errors
    /// As [`LightService::new`], and lights of the case that are of another kind than the new one's.
    pub fn replace_case(
        &mut self,
        handle: CaseHandle,
        case: &LightCase,
        table: &CaseTable,
    ) -> Result<(), ServiceError> {
        let index = handle.0 as usize;
        if index >= self.cases.len() {
            return Err(ServiceError::UnknownCase { case: handle.0 });
        }
        let mut served = self.lights.iter().filter_map(|entry| entry.light.as_ref());
        let uses = |served: &ServedLight| served.description.case == handle;
        if served.any(|served| uses(served) && served.description.light.kind() != case.light) {
            return Err(ServiceError::LightKind { case: case.name.clone(), declared: case.light.name() });
        }
        let (device, queue) = (&self.device, &self.queue);
        let mut served = ServedCase::new(device, queue, case, table, &self.options, &self.layers.main)?;
        self.meshes.add_all_to(&mut served.service, index)?;
        self.cases[index] = served;
        self.depths.clear();
        for served in self
            .lights
            .iter_mut()
            .filter_map(|entry| entry.light.as_mut())
            .filter(|one| one.description.case == handle)
        {
            served.shadows.iter_mut().for_each(|shadow| (shadow.held, shadow.unseen) = (None, None));
        }
        Ok(())
    }

    /// The shared map, for debug views; [`wgpu::TextureUsages::COPY_SRC`] is among its usages.
    pub fn map(&self) -> &wgpu::Texture {
        &self.layers.main
    }

    /// What executes a case: its bind group layouts for the engine's own pipelines.
    pub fn executor(&self, case: CaseHandle) -> Option<&ShadowService> {
        self.cases.get(case.0 as usize).map(|served| &served.service)
    }

    /// Where casters are culled: [`Culling::Gpu`] only if the options ask for it and the device can.
    pub fn culling(&self) -> Culling {
        if self.culling.is_some() { Culling::Gpu } else { Culling::Cpu }
    }

    /// Whether the device is lost; see [`ShadowService::device_lost`].
    pub fn device_lost(&self) -> bool {
        self.cases.iter().any(|served| served.service.device_lost())
    }

    /// Starts over on another device, after a loss. Lights and their handles stay; meshes are forgotten and their handles
    /// refused: add the meshes' new buffers again. On failure everything stays as it was.
    ///
    /// # Errors
    /// As [`LightService::new`].
    pub fn rebuild(&mut self, device: &wgpu::Device, queue: &wgpu::Queue) -> Result<(), ServiceError> {
        let declared: Vec<_> =
            self.cases.iter().map(|served| (&served.case, served.service.table())).collect();
        let mut fresh = Self::new(device, queue, &declared, &self.options)?;
        fresh.meshes = std::mem::take(&mut self.meshes).of_lost_device();
        fresh.lights = std::mem::take(&mut self.lights);
        (fresh.number, fresh.serial) = (self.number, self.serial);
        for served in fresh.lights.iter_mut().filter_map(|entry| entry.light.as_mut()) {
            served.shadows.clear();
        }
        *self = fresh;
        Ok(())
    }

    fn check(&self, description: &LightDescription) -> Result<(), ServiceError> {
        description.checked()?;
        let case = description.case.0;
        let served = self.cases.get(case as usize).ok_or(ServiceError::UnknownCase { case })?;
        if served.case.light != description.light.kind() {
            let (case, declared) = (served.case.name.clone(), served.case.light.name());
            return Err(ServiceError::LightKind { case, declared });
        }
        Ok(())
    }
}

impl ServedCase {
    fn new(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        case: &LightCase,
        table: &CaseTable,
        options: &LightOptions,
        map: &wgpu::Texture,
    ) -> Result<Self, ServiceError> {
        if CaseTable::describe(case).fingerprint != table.fingerprint {
            return Err(ServiceError::ForeignTable { case: case.name.clone() });
        }
        let size = (case.map.width, case.map.height);
        if size != (map.width(), map.height()) || texture_format(case.map.format) != map.format() {
            return Err(ServiceError::MixedMaps { case: case.name.clone() });
        }
        // All cases are culled together.
        let options = Options { culling: Culling::Cpu, ..options.service };
        let service = ShadowService::sharing(device, queue, table, &options, map)?;
        Ok(Self { case: case.clone(), service })
    }
}

#[cfg(test)]
mod tests;
