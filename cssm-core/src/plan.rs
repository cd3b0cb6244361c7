//! One call for everything: from a case and this frame's view and light to facets.

use glam::{DMat3, DVec2, DVec3, DVec4};

pub(crate) mod beams;
mod casters;
mod dominant;
mod finish;
mod fitted;
mod fitting;
mod held;
mod inner;
mod lit;
mod make;
mod planner;
mod region;
mod request;
mod rows;
mod snap;
mod texels;
mod visible;
mod window;

pub(crate) use self::dominant::DominantFacet;
pub use self::dominant::dominant_plane;
pub use self::held::PlanBasis;
pub(crate) use self::make::make;
pub use self::planner::Planner;
pub(crate) use self::planner::Work;
pub use self::request::{MapRegion, PlanRequest, ViewMargin};
use crate::case::{LightCase, MOST_GROUND_PLANES};
use crate::choose::ConfigurationChoice;
use crate::facet::{Facet, Selection};
use crate::fit::Seen;
use crate::light::{Light, LightError};
use crate::view::{View, ViewError};

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
    /// Planes whose receivers shadow nothing on themselves, for cases with masks of them
    /// ([`crate::case::Filter::GroundMasks`]): the first as many as the case declares are taken, and must be there.
    pub ground_planes: [Option<WorldPlane>; MOST_GROUND_PLANES],
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
    /// Metres that a screen pixel spans at a point's depth, across the view axis: a functional on points relative to the eye,
    /// world axes. Kernels that are so many pixels wide follow it.
    pub pixel_metres: DVec4,
    /// How the map stores depth.
    pub depth_order: DepthOrder,
    /// Width and height of the map in texels.
    pub map_size_texels: (u32, u32),
    /// The rectangle of the map that holds every tile; the whole map unless the request named one.
    pub region: MapRegion,
    /// What the plan was made from, by which it can be held over frames.
    pub basis: PlanBasis,
    /// The walk from a receiver to its facet.
    pub selection: Selection,
    /// Facets with receivers, in order of their first cells; a cell that the selection can name but that no facet lists belongs to no visible
    /// receiver. Empty where the light reaches nothing visible: there is nothing to capture, and every receiver is lit.
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
    /// The region is no part of the map.
    #[error(
        "the region of {} x {} texels at ({}, {}) is no part of the map of {width} x {height} texels; give a rectangle with texels inside the map",
        .region.width, .region.height, .region.x, .region.y
    )]
    Region {
        /// The region.
        region: MapRegion,
        /// Map width.
        width: u32,
        /// Map height.
        height: u32,
    },
    /// The margin leaves no view.
    #[error("the view with its margin makes no sense: {0}; plan with a smaller margin")]
    Margin(#[source] ViewError),
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
    /// The case has masks of more planes than are given.
    #[error(
        "the case declares filter: ground_masks {{ planes: {declared} }}, but ground plane {missing} of the scene bounds is none; give it, or declare fewer planes"
    )]
    GroundPlane {
        /// Planes of the case.
        declared: u32,
        /// Place of the first that is not given, from 0.
        missing: u32,
    },
    /// The light or the bounds hold NaN or infinite numbers.
    #[error("{what} is not finite; give finite numbers")]
    NotFinite {
        /// The input at fault.
        what: &'static str,
    },
}

impl Default for ShadowPlan {
    fn default() -> Self {
        Self::empty()
    }
}

impl ShadowPlan {
    /// A plan of nothing, made for no view and no case: a place for a [`Planner`]'s plans.
    #[must_use]
    pub const fn empty() -> Self {
        let region = MapRegion { x: 0, y: 0, width: 0, height: 0 };
        Self {
            configuration: "",
            choice: ConfigurationChoice::none(),
            eye_world: DVec3::ZERO,
            camera_from_world: DMat3::IDENTITY,
            shear: DVec2::ZERO,
            light: DVec4::Y,
            pixel_metres: DVec4::ZERO,
            depth_order: DepthOrder::Standard,
            map_size_texels: (0, 0),
            region,
            basis: PlanBasis::none(),
            selection: Selection::around(1, 1),
            facets: Vec::new(),
        }
    }

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
/// with the smallest predicted footprint is taken; [`crate::choose::Chooser`] also remembers earlier frames. A thin door
/// to [`PlanRequest::plan`], which takes more.
///
/// # Errors
/// A [`PlanError`] that says what to change.
pub fn plan(
    case: &LightCase,
    view: &View,
    light: &Light,
    bounds: &SceneBounds,
) -> Result<ShadowPlan, PlanError> {
    PlanRequest::new(case, view, light, *bounds).plan()
}

/// [`plan()`], knowing [bounding volumes of the receivers](PlanRequest::volumes_world).
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
    PlanRequest { volumes_world, ..PlanRequest::new(case, view, light, *bounds) }.plan()
}

/// [`plan()`], knowing of what is seen whatever the case's fit takes.
///
/// # Errors
/// As [`plan()`].
pub fn plan_seen(
    case: &LightCase,
    view: &View,
    light: &Light,
    bounds: &SceneBounds,
    seen: &Seen<'_>,
) -> Result<ShadowPlan, PlanError> {
    PlanRequest::new(case, view, light, *bounds).knowing(seen).plan()
}
