//! One call for everything: from a case and this frame's view and light to facets.

use glam::{DVec3, DVec4};

mod casters;
mod finish;
mod window;

use crate::case::{FarKind, LightCase};
use crate::facet::{Facet, Selection};
use crate::layout::{self, MapArea, TileDemand};
use crate::light::Light;
use crate::receivers::Polytope;
use crate::technique::Situation;
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
    #[error(
        "the case declares view: perspective {{ far: finite }}, but this view's far plane is at infinity"
    )]
    InfiniteView,
    /// The map cannot hold the tiles.
    #[error(
        "the map of {width} x {height} texels cannot hold {tiles} tiles with gutters of {gutter} texels; enlarge it or use fewer facets"
    )]
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
    #[error(
        "facet {facet} has no usable matrix ({why}); check the view's near and far planes and the receiver bounds"
    )]
    Degenerate {
        /// Facet index.
        facet: u32,
        /// What failed.
        why: &'static str,
    },
    /// The receivers' bounding box is inside out.
    #[error(
        "the receivers' bounding box has its smallest corner {min} beyond its largest corner {max}; swap them, or give no box"
    )]
    Bounds {
        /// Smallest corner.
        min: DVec3,
        /// Largest corner.
        max: DVec3,
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
    // Bring the light to camera space; refuse what is not finite.
    let light_world = light.homogeneous();
    if !light_world.is_finite() {
        return Err(PlanError::NotFinite { what: "the light" });
    }
    if case.far == FarKind::Finite && view.far_metres.is_infinite() {
        return Err(PlanError::InfiniteView);
    }
    let toward = (view.camera_from_world * light_world.truncate()).normalize();
    let situation =
        Situation { case, view, light: toward.extend(0.0), receivers: receivers(case, view, bounds)? };

    // Let the technique choose facets, fit their windows and share the map among those with receivers.
    let draft = (case.technique_spec().draft)(&situation)?;
    let windows = window::fit(&draft, &situation);
    let demands: Vec<TileDemand> = windows.iter().map(window::Window::demand).collect();
    let area = MapArea {
        width: case.map.width,
        height: case.map.height,
        gutter: case.gutter_texels(),
        strips: case.map.columns,
    };
    let tiles = if demands.is_empty() { Vec::new() } else { layout::place(&demands, &area)? };

    // Finish each facet and turn everything to world axes.
    let camera_from_world = view.camera_from_world;
    let row_to_world = |row: DVec4| (camera_from_world.transpose() * row.truncate()).extend(row.w);
    let mut facets = Vec::with_capacity(windows.len());
    for (window, tile) in windows.into_iter().zip(tiles) {
        let facet = finish::finish(window, tile, &situation)?;
        facets.push(facet.turned(&row_to_world));
    }
    let mut selection = draft.selection;
    for row in selection.borders.iter_mut().chain(&mut selection.distances) {
        *row = row_to_world(*row);
    }
    Ok(ShadowPlan {
        configuration: draft.configuration,
        eye_world: view.eye_world,
        light: light_world,
        map_size_texels: (case.map.width, case.map.height),
        selection,
        facets,
    })
}

/// Everything visible that may be in shadow, in camera space.
fn receivers(case: &LightCase, view: &View, bounds: &SceneBounds) -> Result<Polytope, PlanError> {
    let far = case.shadow_distance_metres.map_or(view.far_metres, |distance| distance.min(view.far_metres));
    if far <= view.near_metres {
        return Ok(Polytope::empty());
    }
    let mut receivers = Polytope::frustum(view, far);
    if let Some(bounds) = &bounds.receivers {
        if !bounds.min.is_finite() || !bounds.max.is_finite() {
            return Err(PlanError::NotFinite { what: "the receivers' bounding box" });
        }
        if bounds.min.cmpgt(bounds.max).any() {
            return Err(PlanError::Bounds { min: bounds.min, max: bounds.max });
        }
        receivers.cut_by_box(bounds, view.eye_world, &view.camera_from_world);
    }
    Ok(receivers)
}

impl Facet {
    /// The facet with every row and vertex turned from camera axes to world axes.
    fn turned(mut self, row_to_world: &impl Fn(DVec4) -> DVec4) -> Self {
        let rows = [&mut self.rows.x, &mut self.rows.y, &mut self.rows.z, &mut self.rows.w];
        let lists = [&mut self.select, &mut self.clip, &mut self.casters, &mut self.receivers];
        // The rotation is orthogonal, so points turn as rows do.
        for row in rows.into_iter().chain(lists.into_iter().flatten()) {
            *row = row_to_world(*row);
        }
        self
    }
}
