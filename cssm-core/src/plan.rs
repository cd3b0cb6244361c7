//! One call for everything: from a case and this frame's view and light to facets.

use glam::{DMat3, DVec2, DVec3, DVec4};

mod casters;
mod finish;
mod fitted;
mod region;
mod window;

use self::fitted::Fitted;
use crate::case::{FarKind, LightCase};
use crate::choose::{ConfigurationChoice, Kept, Prediction, choose, made_for};
use crate::facet::{Facet, Selection};
use crate::light::{Light, LightPosition};
use crate::receivers::Polytope;
use crate::schema::Word;
use crate::technique::{Draft, Situation};
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
    /// Why it was chosen.
    pub choice: ConfigurationChoice,
    /// Eye position the rows are relative to, world space, metres.
    pub eye_world: DVec3,
    /// Rotation (or reflection) from world axes to camera axes; records hold rows in camera axes.
    pub camera_from_world: DMat3,
    /// Moves a point of camera axes along the light to the plane z = 0: x + shear.x z, y + shear.y z. With the light in
    /// or near the view every facet row but depth then depends on two coordinates that hold no part along the
    /// light; without, f32 sums would cancel where receivers lie far along their rays. Zero elsewhere.
    pub shear: DVec2,
    /// The light as a homogeneous point relative to the eye, world axes.
    pub light: DVec4,
    /// How the map stores depth.
    pub depth_order: DepthOrder,
    /// Width and height of the map in texels.
    pub map_size_texels: (u32, u32),
    /// The walk from a receiver to its facet.
    pub selection: Selection,
    /// Facets with receivers, in ascending index; an index that the selection can name but that is not listed
    /// belongs to no visible receiver.
    pub facets: Vec<Facet>,
}

/// Which end of stored depth lies towards the light.
///
/// Floats are finest near zero, and texels are finest near the eye: zero belongs to the end of the rays where the eye
/// is (facet algebra: with the light ahead, a map stored the other way loses two orders of magnitude).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DepthOrder {
    /// 0 towards the light; the smallest depth wins.
    Standard,
    /// 1 towards the light; the largest depth wins.
    Reversed,
}

impl DepthOrder {
    /// 1, or -1 where depth falls away from the light.
    pub const fn sign(self) -> f64 {
        match self {
            Self::Standard => 1.0,
            Self::Reversed => -1.0,
        }
    }

    /// What the map holds where no caster is.
    pub const fn cleared(self) -> f64 {
        match self {
            Self::Standard => 1.0,
            Self::Reversed => 0.0,
        }
    }
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
    /// From directions of world axes to the sheared camera axes of capture records: compose instance transforms with it
    /// in f64 and round once.
    pub fn capture_from_world(&self) -> DMat3 {
        let shear = DMat3::from_cols(DVec3::X, DVec3::Y, self.shear.extend(1.0));
        shear * self.camera_from_world
    }

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

/// Makes this frame's plan. Total: a plan or a typed reason. Where the case declares several configurations, the one
/// with the smallest predicted footprint is taken; [`crate::choose::Chooser`] also remembers earlier frames.
///
/// # Errors
/// A [`PlanError`] that says what to change.
pub fn plan(
    case: &LightCase,
    view: &View,
    light: &Light,
    bounds: &SceneBounds,
) -> Result<ShadowPlan, PlanError> {
    plan_preferring(case, view, light, bounds, Kept::default())
}

/// [`plan()`], with a configuration to stay with.
pub(crate) fn plan_preferring(
    case: &LightCase,
    view: &View,
    light: &Light,
    bounds: &SceneBounds,
    kept: Kept,
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

    // Draft every declared configuration, fit the drafts and take the best.
    let spec = case.technique_spec();
    let samples = window::samples(&situation);
    let draft = |word: &Word| (spec.configuration(word.name).draft)(&situation, word);
    let drafts: Vec<Draft> = any(case.configurations.iter().map(draft))?.into_iter().flatten().collect();
    let mut fitted = any(drafts.iter().map(|draft| fitted::fit(draft, &situation, &samples)))?;
    if fitted.is_empty() {
        return Err(PlanError::Degenerate { facet: 0, why: "the case declares no configuration" });
    }
    let predictions: Vec<Prediction> = fitted.iter().map(Fitted::prediction).collect();
    let (best, reason) = choose(&predictions, kept);
    let Fitted { draft, windows, tiles, .. } = fitted.swap_remove(best);

    // Store depth and shear positions the way that rounds least.
    let position = LightPosition::of(view, toward);
    let shear = match LightPosition::ray(toward) {
        Some(ray) if spec.follows_camera && LightPosition::is_near(view, ray) => ray,
        _ => DVec2::ZERO,
    };
    let ahead = toward.z < 0.0;
    let depth_order = if ahead && spec.follows_camera { DepthOrder::Reversed } else { DepthOrder::Standard };

    // Finish each facet and turn everything to world axes.
    let rules = finish::DepthRules { order: depth_order, shear };
    let shape = case.shape();
    let camera_from_world = view.camera_from_world;
    let row_to_world = |row: DVec4| (camera_from_world.transpose() * row.truncate()).extend(row.w);
    let mut facets = Vec::with_capacity(windows.len());
    for (window, tile) in windows.iter().zip(tiles) {
        let index = window.draft.sector * shape.bands + window.draft.band;
        let facet = finish::finish(window, tile, index, rules, &situation)?;
        facets.push(facet.turned(&row_to_world));
    }
    let mut selection = draft.selection.clone().padded(&shape);
    for row in selection.borders.iter_mut().chain(&mut selection.distances) {
        *row = row_to_world(*row);
    }
    let configuration = draft.configuration;
    let choice = ConfigurationChoice {
        position,
        configuration,
        reason,
        predictions: if predictions.len() > 1 { predictions } else { Vec::new() },
        made_for_position: made_for(spec, position, configuration),
    };
    Ok(ShadowPlan {
        configuration,
        choice,
        eye_world: view.eye_world,
        camera_from_world,
        shear,
        light: light_world,
        depth_order,
        map_size_texels: (case.map.width, case.map.height),
        selection,
        facets,
    })
}

/// What succeeded; the first error only where nothing did.
fn any<T>(results: impl Iterator<Item = Result<T, PlanError>>) -> Result<Vec<T>, PlanError> {
    let (mut found, mut first_error) = (Vec::new(), None);
    for result in results {
        match result {
            Ok(one) => found.push(one),
            Err(error) => first_error = first_error.or(Some(error)),
        }
    }
    match first_error {
        Some(error) if found.is_empty() => Err(error),
        _ => Ok(found),
    }
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
