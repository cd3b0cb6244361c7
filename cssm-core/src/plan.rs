//! One call for everything: from a case and this frame's view and light to facets.

use glam::{DMat3, DVec2, DVec3, DVec4};

mod casters;
mod dominant;
mod finish;
mod fitted;
mod lit;
mod region;
mod window;

pub(crate) use self::dominant::DominantFacet;
pub use self::dominant::dominant_plane;
use self::fitted::Fitted;
use crate::case::{FarKind, LightCase, LightKind};
use crate::choose::{ConfigurationChoice, Kept, Prediction, choose, made_for};
use crate::distribution;
use crate::facet::{Facet, Selection, Tile};
use crate::light::{Light, LightError, LightPosition};
use crate::receivers::Polytope;
use crate::schema::Word;
use crate::technique::{Cone, Draft, Situation};
use crate::view::View;

/// What is known about the scene.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SceneBounds {
    /// World-space box that holds every receiver; `None`: receivers may be anywhere in the view.
    pub receivers: Option<BoundingBox>,
    /// Height of the eye above the ground in metres, for a focus that is a multiple of it; `None`: the distance from
    /// the dominant plane, if there is one.
    pub eye_height_metres: Option<f64>,
    /// The plane that most of what is visible lies on, for cases that set a share of the map apart for it.
    pub dominant_plane: Option<WorldPlane>,
}

impl SceneBounds {
    /// Nothing but the receivers' box is known.
    pub fn of(receivers: Option<BoundingBox>) -> Self {
        Self { receivers, ..Self::default() }
    }
}

/// A plane in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WorldPlane {
    /// A point on it, metres.
    pub point_world: DVec3,
    /// Its normal, of any length but zero, to either side.
    pub normal_world: DVec3,
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
    /// The light as a homogeneous point relative to the eye, world axes: unit direction towards it and w = 0, or position
    /// and w = 1.
    pub light: DVec4,
    /// How the map stores depth.
    pub depth_order: DepthOrder,
    /// Width and height of the map in texels.
    pub map_size_texels: (u32, u32),
    /// The walk from a receiver to its facet.
    pub selection: Selection,
    /// Facets with receivers, in order of their first cells; a cell that the selection can name but that no facet lists belongs to no visible
    /// receiver.
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
    /// The light is of another kind than the case's.
    #[error(
        "the case declares light: {declared}, but the plan's light is {given}; give a light of that kind or declare another case"
    )]
    LightKind {
        /// Name of the declared kind.
        declared: &'static str,
        /// Name of the given kind.
        given: &'static str,
    },
    /// The light makes no sense.
    #[error(transparent)]
    Light(#[from] LightError),
    /// A focus is a multiple of an unknown height.
    #[error(
        "the case declares a focus in multiples of the eye's height above the ground; give eye_height_metres or a dominant plane with the scene bounds"
    )]
    EyeHeight,
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

    /// The facet of a cell of [`Selection::cell`], if it has visible receivers.
    pub fn facet(&self, cell: u32) -> Option<&Facet> {
        self.facets.iter().find(|facet| facet.cells.contains(&cell))
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
    plan_over(case, view, light, bounds, &[])
}

/// [`plan()`], knowing bounding volumes of the receivers in world space, which may overlap and may be points: everything
/// visible that may be in shadow must lie in one of them. Techniques that fit their map to what is seen use them.
///
/// # Errors
/// As [`plan()`].
pub fn plan_over(
    case: &LightCase,
    view: &View,
    light: &Light,
    bounds: &SceneBounds,
    volumes_world: &[BoundingBox],
) -> Result<ShadowPlan, PlanError> {
    plan_preferring(case, view, light, bounds, volumes_world, Kept::default())
}

/// [`plan()`], with a configuration to stay with.
pub(crate) fn plan_preferring(
    case: &LightCase,
    view: &View,
    light: &Light,
    bounds: &SceneBounds,
    volumes_world: &[BoundingBox],
    kept: Kept,
) -> Result<ShadowPlan, PlanError> {
    // Refuse what is not finite or not declared.
    let light_world = light.homogeneous(view.eye_world);
    if !light_world.is_finite() {
        return Err(PlanError::NotFinite { what: "the light" });
    }
    let light = light.checked()?;
    if light.kind() != case.light {
        let (declared, given) = (case.light.name(), light.kind().name());
        return Err(PlanError::LightKind { declared, given });
    }
    if case.far == FarKind::Finite && view.far_metres.is_infinite() {
        return Err(PlanError::InfiniteView);
    }
    let plane = dominant_row(view, bounds)?;
    let eye_height_metres = bounds.eye_height_metres.or(plane.map(|plane| plane.w.abs()));
    if eye_height_metres.is_none() && distribution::needs_eye_height(case) {
        return Err(PlanError::EyeHeight);
    }

    // Bring the light to camera space.
    let turned = view.camera_from_world * light_world.truncate();
    let light_camera = if light_world.w > 0.0 { turned } else { turned.normalize() }.extend(light_world.w);
    let cone = match light {
        Light::Spot { direction_world, half_angle_radians, .. } => {
            let direction = (view.camera_from_world * direction_world).normalize();
            Some(Cone { direction, half_angle_radians })
        }
        Light::Directional { .. } | Light::Omni { .. } => None,
    };
    let mut receivers = receivers(case, view, bounds)?;
    lit::cut(&mut receivers, &light, light_camera, cone);
    let seen = seen(&receivers, view, volumes_world)?;
    let situation = Situation { case, view, light: light_camera, cone, eye_height_metres, receivers, seen };

    // Draft every declared configuration, fit the drafts and take the best.
    let spec = case.technique_spec();
    let samples = window::samples(&situation);
    let dominant = plane.and_then(|plane| dominant::facet(&situation, plane));
    let draft = |word: &Word| (spec.configuration(word.name).draft)(&situation, word);
    let drafted = any(case.configurations.iter().map(draft))?.into_iter().flatten();
    let drafts: Vec<Draft> = drafted.map(|draft| draft.with_dominant(dominant.as_ref())).collect();
    let mut fitted = any(drafts.iter().map(|draft| fitted::fit(draft, &situation, &samples)))?;
    if fitted.is_empty() {
        return Err(PlanError::Degenerate {
            facet: 0,
            why: "no declared configuration has facets for this light; declare the technique's defaults",
        });
    }
    let predictions: Vec<Prediction> = fitted.iter().map(Fitted::prediction).collect();
    let (best_draft, reason) = choose(&predictions, kept);
    let complete = predictions[best_draft].p95_pixels.is_finite();
    let Fitted { draft, windows, tiles, .. } = fitted.swap_remove(best_draft);

    // Store depth and shear positions the way that rounds least.
    let position = LightPosition::of(view, light_camera);
    let shear = match LightPosition::ray(light_camera) {
        Some(ray) if case.technique_spec().follows_camera && LightPosition::is_near(view, ray) => ray,
        _ => DVec2::ZERO,
    };
    let ahead = spec.follows_camera && light_camera.z < 0.0;
    let orders: &[DepthOrder] = match (case.light, ahead) {
        (LightKind::Spot | LightKind::Omni, _) => &[DepthOrder::Reversed, DepthOrder::Standard],
        (LightKind::Directional, true) => &[DepthOrder::Reversed],
        (LightKind::Directional, false) => &[DepthOrder::Standard],
    };
    let finished = |order: &DepthOrder| {
        let rules = finish::DepthRules { order: *order, shear };
        finish_all(&windows, &tiles, rules, &situation).map(|(facets, rounding)| (*order, facets, rounding))
    };
    let finished = any(orders.iter().map(finished))?;
    let best = finished.into_iter().min_by(|(.., one), (.., two)| one.total_cmp(two));
    let (depth_order, facets, _) =
        best.ok_or(PlanError::Degenerate { facet: 0, why: "its depth has no order" })?;

    // Turn everything to world axes.
    let camera_from_world = view.camera_from_world;
    let row_to_world = |row: DVec4| (camera_from_world.transpose() * row.truncate()).extend(row.w);
    let mut facets: Vec<Facet> = facets.into_iter().map(|facet| facet.turned(&row_to_world)).collect();
    facets.sort_by_key(Facet::first_cell);
    let shape = case.shape();
    let mut selection = draft.selection.clone().padded(&shape);
    if case.scales_thresholds() && selection.units.is_empty() {
        // Another configuration of the case scales its limits; this one's are plain.
        selection.units = vec![DVec4::W; (shape.halves * shape.sectors) as usize];
    }
    if !case.scales_thresholds() {
        selection.units.clear();
    }
    for row in selection.rows_mut() {
        *row = row_to_world(*row);
    }
    let configuration = draft.configuration;
    let choice = ConfigurationChoice {
        position,
        configuration,
        reason,
        predictions: if predictions.len() > 1 { predictions } else { Vec::new() },
        complete,
        fallback: draft.fallback,
        made_for_position: made_for(case, position),
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

/// Finishes every window in camera space; also says how far rounding moves depth: the logarithm of texels, averaged over
/// the receivers of the view.
fn finish_all(
    windows: &[window::Window<'_>],
    tiles: &[Tile],
    rules: finish::DepthRules,
    situation: &Situation<'_>,
) -> Result<(Vec<Facet>, f64), PlanError> {
    let shape = situation.case.shape();
    let mut facets = Vec::with_capacity(windows.len());
    let mut moved = 0.0;
    for (window, tile) in windows.iter().zip(tiles) {
        let cells = if window.draft.is_dominant() {
            vec![shape.cells() - 1]
        } else {
            window.draft.cells.iter().map(|cell| cell.index(shape.sectors, shape.bands)).collect()
        };
        let (facet, rounding) = finish::finish(window, *tile, cells, rules, situation)?;
        moved += window.seen as f64 * libm::log(rounding.max(f64::MIN_POSITIVE));
        facets.push(facet);
    }
    Ok((facets, moved))
}

/// The dominant plane as unit normal and offset, camera space.
fn dominant_row(view: &View, bounds: &SceneBounds) -> Result<Option<DVec4>, PlanError> {
    let Some(WorldPlane { point_world, normal_world }) = bounds.dominant_plane else { return Ok(None) };
    let normal = normal_world.try_normalize().filter(|_| point_world.is_finite());
    let normal =
        normal.ok_or(PlanError::NotFinite { what: "the dominant plane, or its normal's inverse length," })?;
    let offset = -normal.dot(point_world - view.eye_world);
    Ok(Some((view.camera_from_world * normal).extend(offset)))
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

/// Corners of what is visible of some volumes, camera space.
fn seen(receivers: &Polytope, view: &View, volumes_world: &[BoundingBox]) -> Result<Vec<DVec4>, PlanError> {
    let mut corners = Vec::new();
    for volume in volumes_world {
        if !volume.min.is_finite() || !volume.max.is_finite() {
            return Err(PlanError::NotFinite { what: "a receivers' bounding volume" });
        }
        if volume.min.cmpgt(volume.max).any() {
            return Err(PlanError::Bounds { min: volume.min, max: volume.max });
        }
        if volume.min == volume.max {
            // A visible point needs no cutting.
            let point = (view.camera_from_world * (volume.min - view.eye_world)).extend(1.0);
            corners.extend(receivers.contains(point).then_some(point));
        } else {
            let mut visible = receivers.clone();
            visible.cut_by_box(volume, view.eye_world, &view.camera_from_world);
            corners.extend(visible.vertices);
        }
    }
    Ok(corners)
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
