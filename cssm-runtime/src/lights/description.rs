//! What an engine tells of its lights, once and every frame.

use cssm_core::fit::DepthHistogram;
use cssm_core::{BoundingBox, Light, SceneBounds, View};

use super::engine::EngineCaster;
use crate::error::ServiceError;
use crate::mesh::CasterInstance;
use crate::service::Options;

/// A light case of a [`LightService`](super::LightService): its position in the list that the service was made from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct CaseHandle(pub u32);

/// A light of a [`LightService`](super::LightService).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct LightHandle {
    pub(super) index: u32,
    pub(super) generation: u32,
}

/// One of several views whose shadows live in the same map: split screen, two eyes, reflections.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct ViewId(pub u32);

/// A light and what its shadows may cost.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightDescription {
    /// Its declared case; filter, bias and technique are the case's.
    pub case: CaseHandle,
    /// The light, of the case's kind.
    pub light: Light,
    /// Weight of its errors where texels or redraws are short; 1 is usual.
    pub priority: f64,
    /// Predicted 95th percentile of the texel footprint in screen pixels that is good enough.
    pub enough_pixels: f64,
    /// Smallest side of its square of the map in texels.
    pub min_side_texels: u32,
    /// Largest side of its square of the map in texels.
    pub max_side_texels: u32,
    /// When changes must reach the map.
    pub update: Update,
}

/// When changes of casters, of the light and of what the view needs must reach the map.
///
/// Whatever is chosen, receivers that the map does not cover yet are drawn at once: no update rate loses a shadow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Update {
    /// In the frame of the change.
    #[default]
    EveryFrame,
    /// At most once in so many frames, which lights take in turn.
    Every {
        /// The number of frames, at least 1.
        frames: u32,
    },
}

impl LightDescription {
    /// A light of usual priority whose square may have 64 to 4096 texels a side.
    pub const fn new(case: CaseHandle, light: Light) -> Self {
        Self {
            case,
            light,
            priority: 1.0,
            enough_pixels: 1.0,
            min_side_texels: 64,
            max_side_texels: 4096,
            update: Update::EveryFrame,
        }
    }

    pub(super) fn checked(&self) -> Result<(), ServiceError> {
        self.light.checked()?;
        let fault = |what| Err(ServiceError::LightSetting { what });
        if !(self.priority.is_finite() && self.priority > 0.0) {
            return fault("priority");
        }
        if !(self.enough_pixels.is_finite() && self.enough_pixels > 0.0) {
            return fault("enough_pixels");
        }
        if self.min_side_texels == 0 || self.max_side_texels < self.min_side_texels {
            return fault("range of sides");
        }
        if self.update == (Update::Every { frames: 0 }) {
            return fault("number of frames between updates");
        }
        Ok(())
    }
}

/// One view of one frame.
#[derive(Debug, Clone, Copy)]
pub struct LightFrame<'a> {
    /// Which of the engine's views it is.
    pub view_id: ViewId,
    /// The view.
    pub view: &'a View,
    /// What is known of the scene.
    pub bounds: SceneBounds,
    /// Boxes in world space that together hold every visible receiver; empty: not known. Cases that declare a fit need no
    /// texels elsewhere.
    pub volumes_world: &'a [BoundingBox],
    /// Depth in metres before which nothing is visible in this frame, for cases that declare a fit.
    pub near_hint_metres: Option<f64>,
    /// Depth as [`crate::DepthReduction`] measured it, in this frame or an earlier one, for cases whose fit measures depth;
    /// in the place of what [`LightService::observe_depth`](super::LightService::observe_depth) measures.
    pub depth: Option<&'a DepthHistogram>,
    /// Casters that rarely change.
    pub static_casters: &'a [CasterInstance],
    /// Casters that may change every frame.
    pub dynamic_casters: &'a [CasterInstance],
    /// Casters that rarely change and that the engine draws by itself, in [`super::LightService::capture_with`].
    pub static_engine_casters: &'a [EngineCaster],
    /// Casters that may change every frame and that the engine draws by itself.
    pub dynamic_engine_casters: &'a [EngineCaster],
}

impl<'a> LightFrame<'a> {
    /// A frame of the engine's only view, of which nothing else is known.
    pub fn new(
        view: &'a View,
        static_casters: &'a [CasterInstance],
        dynamic_casters: &'a [CasterInstance],
    ) -> Self {
        Self {
            view_id: ViewId::default(),
            view,
            bounds: SceneBounds::default(),
            volumes_world: &[],
            near_hint_metres: None,
            depth: None,
            static_casters,
            dynamic_casters,
            static_engine_casters: &[],
            dynamic_engine_casters: &[],
        }
    }
}

/// Choices of the engine for all lights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightOptions {
    /// Mask format and material stages, and where casters are culled: with [`Culling::Gpu`](crate::Culling::Gpu) those of all
    /// tiles that a frame draws in one go.
    pub service: Options,
    /// Texels that may be redrawn in a frame for changes that can wait; what cannot wait is drawn in any case and counts
    /// first.
    pub redrawn_texels: u64,
    /// Whether plans are held over frames while the view moves slowly, with a margin around what it sees. Without, each
    /// frame whose view differs from the last plans and draws anew.
    pub hold: bool,
}

impl Default for LightOptions {
    fn default() -> Self {
        Self { service: Options::default(), redrawn_texels: u64::MAX, hold: true }
    }
}
