//! One view of one frame of all lights, ready to be captured and resolved.

use std::sync::Arc;

use cssm_core::facet::Tile;

use super::description::{LightHandle, ViewId};
use super::engine::EngineDraw;
use super::report::{LightReport, TileStatistics};
use super::shadow::TileWork;
use crate::commands::FrameCommands;
use crate::culling::CulledFrame;
use crate::frame::PreparedFrame;

/// One view of one frame: what [`LightService::prepare`](super::LightService::prepare) fills.
///
/// It may be filled again as soon as the commands that use it are submitted, and then keeps its memory.
#[derive(Debug, Default)]
pub struct PreparedLights {
    /// The service and the device that filled it.
    pub(super) identity: Option<Arc<()>>,
    pub(super) view: ViewId,
    /// Which call of the service filled it.
    pub(super) number: u64,
    pub(super) shadows: Vec<PreparedShadow>,
    /// Number of the shadows in use; the others keep their memory.
    pub(super) used: usize,
    pub(super) report: LightReport,
    /// Lists for the report, those of its first lights last.
    pub(super) tiles: Vec<Vec<TileStatistics>>,
    /// What the device culls for all of them.
    pub(super) culled: Option<Arc<CulledFrame>>,
}

/// What the tiles of one light that change in a frame draw of the service's own casters.
#[derive(Debug, Clone, PartialEq)]
pub struct LightCommands {
    /// The light.
    pub light: LightHandle,
    /// Static casters, into the map of casters that stay.
    pub still: FrameCommands,
    /// Static casters, into the shared map.
    pub fixed: FrameCommands,
    /// Dynamic casters, into the shared map.
    pub dynamic: FrameCommands,
}

/// One light's part.
#[derive(Debug)]
pub(super) struct PreparedShadow {
    pub(super) light: LightHandle,
    pub(super) case: usize,
    /// Serial number of the plan.
    pub(super) serial: u64,
    /// Records, bind groups and depth order.
    pub(super) frame: Option<PreparedFrame>,
    /// Tiles that change: position among the plan's tiles, rectangle, what is to be done.
    pub(super) works: Vec<(usize, Tile, TileWork)>,
    /// Draws into the map of static casters.
    pub(super) still: FrameCommands,
    /// Draws of static casters into the shared map.
    pub(super) fixed: FrameCommands,
    /// Draws of dynamic casters into the shared map.
    pub(super) dynamic: FrameCommands,
    /// Draws of the engine's own casters.
    pub(super) engine: Vec<EngineDraw>,
    /// Pixels of the view that the light can reach, x, y, width and height; `None`: all.
    pub(super) scissor: Option<[u32; 4]>,
}

impl PreparedLights {
    /// An empty one, to be filled.
    pub fn new() -> Self {
        Self::default()
    }

    /// What the frame costs and how every light fares.
    pub fn report(&self) -> &LightReport {
        &self.report
    }

    /// The plan, the map and the sampler of one light for the engine's own pipelines; they take it at the group number
    /// that its case declares. `None` for a light without shadows, which is lit everywhere, and where the case declares
    /// no resolve interface.
    pub fn shadow_bind_group(&self, light: LightHandle) -> Option<&wgpu::BindGroup> {
        self.shadow(light)?.frame.as_ref()?.shadow_bind_group()
    }

    /// Pixels of the view that a light can reach, x, y, width and height; `None`: all of them.
    pub fn scissor(&self, light: LightHandle) -> Option<[u32; 4]> {
        self.shadow(light)?.scissor
    }

    pub(super) fn shadow(&self, light: LightHandle) -> Option<&PreparedShadow> {
        self.shadows[..self.used].iter().find(|shadow| shadow.light == light)
    }

    pub(super) fn in_use(&self) -> &[PreparedShadow] {
        &self.shadows[..self.used]
    }

    /// Starts over, keeping memory.
    pub(super) fn reset(&mut self, identity: &Arc<()>, view: ViewId, number: u64) {
        self.identity = Some(Arc::clone(identity));
        self.view = view;
        self.number = number;
        self.used = 0;
        self.culled = None;
        for shadow in &mut self.shadows {
            shadow.frame = None;
        }
        let lists = self.report.lights.drain(..).rev();
        self.tiles.extend(lists.map(|light| TileStatistics::emptied(light.tiles)));
        self.report.reset();
    }

    /// The next unused part.
    pub(super) fn next(&mut self, light: LightHandle, case: usize, serial: u64) -> &mut PreparedShadow {
        if self.used == self.shadows.len() {
            self.shadows.push(PreparedShadow {
                light,
                case,
                serial,
                frame: None,
                works: Vec::new(),
                still: FrameCommands::default(),
                fixed: FrameCommands::default(),
                dynamic: FrameCommands::default(),
                engine: Vec::new(),
                scissor: None,
            });
        }
        self.used += 1;
        let shadow = &mut self.shadows[self.used - 1];
        shadow.light = light;
        shadow.case = case;
        shadow.serial = serial;
        shadow.works.clear();
        shadow.engine.clear();
        shadow
    }
}
