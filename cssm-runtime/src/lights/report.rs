//! What a frame cost and why: plain data, for overlays, logs and tests.

use cssm_core::PlanError;
use cssm_core::facet::Tile;
use cssm_core::plan::MapRegion;

use super::description::LightHandle;

/// Counts of one prepared view of one frame; they do not depend on the machine.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct LightReport {
    /// Every light, in the order of its handle.
    pub lights: Vec<LightStatistics>,
    /// Texels of the map that belong to a light's square, over all views.
    pub owned_texels: u64,
    /// Texels of the map.
    pub map_texels: u64,
    /// Texels drawn or restored in the shared map.
    pub redrawn_texels: u64,
    /// Texels drawn in the map of static casters.
    pub static_texels: u64,
    /// Draw calls for casters; with culling on the device the largest number that there may be.
    pub draws: u32,
    /// Triangles submitted; with culling on the device those of all candidates.
    pub triangles: u64,
    /// Facets that the engine is asked to draw its own casters into, static and dynamic ones apart.
    pub engine_facets: u32,
    /// Lights that were planned anew.
    pub planned: u32,
    /// Lights whose changes wait for the budget or their update rate.
    pub waiting: u32,
    /// Lights whose squares moved because the map had to be packed anew.
    pub moved: u32,
}

/// One light in one view of one frame.
#[derive(Debug, Clone, PartialEq)]
pub struct LightStatistics {
    /// The light.
    pub light: LightHandle,
    /// How it fares.
    pub state: LightState,
    /// Its square of the map.
    pub region: Option<MapRegion>,
    /// Configuration of its plan; empty without one.
    pub configuration: &'static str,
    /// Predicted 95th percentile of the texel footprint in this view, screen pixels.
    pub p95_pixels: f64,
    /// Frames that its plan has been in use; 0 in its first.
    pub held_frames: u32,
    /// Texels redrawn in this frame.
    pub redrawn_texels: u64,
    /// Draw calls for casters; with culling on the device the largest number that there may be.
    pub draws: u32,
    /// Triangles submitted; with culling on the device those of all candidates.
    pub triangles: u64,
    /// Tiles of its facets.
    pub tiles: Vec<TileStatistics>,
}

/// How a light fares in a frame.
#[derive(Debug, Clone, PartialEq)]
pub enum LightState {
    /// Its shadows are as the view, the light and the casters ask for.
    Current,
    /// Its shadows cover the view, but a change waits for the budget or its update rate.
    Waits,
    /// It reaches nothing visible.
    Unseen,
    /// The map has no texels left for it: everything counts as lit.
    NoTexels,
    /// No plan could be made: the shadows of an earlier frame stay in use where there are any, else everything is lit.
    Failed(PlanError),
}

/// One tile of a light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TileStatistics {
    /// First cell of its first facet in the selection's numbering.
    pub first_cell: u32,
    /// Its rectangle of the map.
    pub tile: Tile,
    /// Whether it was redrawn in this frame.
    pub redrawn: bool,
}

impl TileStatistics {
    /// An empty list in the memory of another.
    pub(super) fn emptied(mut list: Vec<Self>) -> Vec<Self> {
        list.clear();
        list
    }
}

impl LightReport {
    /// Counts a light's part.
    pub(super) fn add(&mut self, light: &LightStatistics, static_texels: u64, engine_facets: u32) {
        self.engine_facets += engine_facets;
        self.redrawn_texels += light.redrawn_texels;
        self.static_texels += static_texels;
        self.draws += light.draws;
        self.triangles += light.triangles;
    }

    /// Starts over, keeping memory.
    pub(super) fn reset(&mut self) {
        let mut lights = std::mem::take(&mut self.lights);
        lights.clear();
        *self = Self { lights, ..Self::default() };
    }
}
