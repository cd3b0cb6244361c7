//! One call for everything: from a case and this frame's view and light to facets.

use glam::{DVec3, DVec4};

use crate::case::LightCase;
use crate::facet::{Facet, Selection};
use crate::light::Light;
use crate::view::View;

/// What is known about the scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SceneBounds {
    /// World-space box that holds every receiver; `None`: receivers may be anywhere in the view.
    pub receivers: Option<BoundingBox>,
}

/// An axis-aligned box in f64.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundingBox {
    /// Smallest corner.
    pub min: DVec3,
    /// Largest corner.
    pub max: DVec3,
}

/// This frame's configuration and facets.
#[derive(Debug, Clone, PartialEq)]
pub struct ShadowPlan {
    /// Chosen configuration, a name of the technique's table.
    pub configuration: &'static str,
    /// Eye position the rows are relative to, world space, metres.
    pub eye_world: DVec3,
    /// The light as a homogeneous point relative to the eye, world axes.
    pub light: DVec4,
    /// Width and height of the map in texels.
    pub map_size_texels: (u32, u32),
    /// The walk from a receiver to its facet.
    pub selection: Selection,
    /// Facets with receivers, in ascending index; an index that the selection can name but that is not listed
    /// belongs to no visible receiver.
    pub facets: Vec<Facet>,
}

/// Why no plan can be made.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum PlanError {
    /// The technique needs a finite receiver range.
    #[error(
        "technique {technique} cannot fit receivers at infinity; declare shadow_distance, give finite receiver bounds or a finite far plane"
    )]
    Unbounded {
        /// The technique.
        technique: &'static str,
    },
    /// The case declares finite views.
    #[error("the case declares view: perspective {{ far: finite }}, but this view's far plane is at infinity")]
    InfiniteView,
    /// The map cannot hold the tiles.
    #[error("the map of {width} x {height} texels cannot hold {tiles} tiles with gutters of {gutter} texels; enlarge it or use fewer facets")]
    MapTooSmall {
        /// Map width.
        width: u32,
        /// Map height.
        height: u32,
        /// Tiles that were to be placed.
        tiles: u32,
        /// Gutter of each.
        gutter: u32,
    },
    /// The numbers leave no usable matrix.
    #[error("facet {facet} has no usable matrix ({why}); check the view's near and far planes and the receiver bounds")]
    Degenerate {
        /// Facet index.
        facet: u32,
        /// What failed.
        why: &'static str,
    },
    /// The light or the bounds hold NaN or infinite numbers.
    #[error("{what} is not finite; give finite numbers")]
    NotFinite {
        /// The input at fault.
        what: &'static str,
    },
}

impl ShadowPlan {
    /// The facet with an index of [`Selection::facet`], if it has visible receivers.
    pub fn facet(&self, index: u32) -> Option<&Facet> {
        self.facets.iter().find(|facet| facet.index == index)
    }
}

impl Facet {
    /// Whether the shadow of a box can reach anything visible in this facet. Conservative: a box whose shadow does
    /// is never refused. The box is relative to the eye, world axes.
    pub fn reached_by(&self, box_from_eye: &BoundingBox) -> bool {
        let centre = (box_from_eye.min + box_from_eye.max) * 0.5;
        let half = (box_from_eye.max - box_from_eye.min) * 0.5;
        self.casters.iter().all(|plane| {
            let normal = plane.truncate();
            normal.dot(centre) + plane.w + normal.abs().dot(half) >= 0.0
        })
    }
}

/// Makes this frame's plan. Total: a plan or a typed reason.
///
/// # Errors
/// A [`PlanError`] that says what to change.
pub fn plan(
    case: &LightCase,
    view: &View,
    light: &Light,
    bounds: &SceneBounds,
) -> Result<ShadowPlan, PlanError> {
    let _ = (case, view, light, bounds);
    Err(PlanError::NotFinite { what: "the plan (not built yet)" })
}
