//! What a request sees: its view and light in camera space, and everything visible that may be in shadow.

use std::ops::Range;

use glam::{DVec3, DVec4};

use super::{BoundingBox, PlanError, PlanRequest, SceneBounds, WorldPlane, lit};
use crate::case::{FarKind, MOST_GROUND_PLANES};
use crate::light::Light;
use crate::receivers::Polytope;
use crate::technique::Cone;
use crate::view::View;

/// What a request sees, in the camera space of a view.
#[derive(Debug)]
pub(super) struct Visible {
    /// The light as a homogeneous point, relative to the eye in world axes.
    pub(super) light_world: DVec4,
    /// The same in camera space; unit length at infinity.
    pub(super) light_camera: DVec4,
    /// Cone of a spot light.
    pub(super) cone: Option<Cone>,
    /// Everything visible that may be in shadow and that the light may reach.
    pub(super) receivers: Polytope,
    /// Which planes of the receivers bound what the light reaches.
    pub(super) lit: Range<usize>,
    /// Corners of the receivers' bounding volumes, as far as they are visible; empty where none were given.
    pub(super) seen: Vec<DVec4>,
}

/// The view of a request with its far plane no farther than its shadow distance, and its near plane where nothing visible
/// lies before it.
pub(super) fn shadowed(request: &PlanRequest<'_>) -> View {
    let view = request.seen().hinted(request.case.fit, request.view);
    let far = request.case.shadow_distance_metres.unwrap_or(f64::INFINITY).min(view.far_metres);
    View { far_metres: far, ..view }
}

impl Visible {
    /// What a request's case, light and bounds leave of a view, whose far plane is where receivers end.
    pub(super) fn of(request: &PlanRequest<'_>, view: &View) -> Result<Self, PlanError> {
        // Refuse what is not finite or not declared.
        let light_world = request.light.homogeneous(view.eye_world);
        if !light_world.is_finite() {
            return Err(PlanError::NotFinite { what: "the light" });
        }
        let light = request.light.checked()?;
        if light.kind() != request.case.light {
            let (declared, given) = (request.case.light.name(), light.kind().name());
            return Err(PlanError::LightKind { declared, given });
        }
        if request.case.far == FarKind::Finite && request.view.far_metres.is_infinite() {
            return Err(PlanError::InfiniteView);
        }

        // Bring the light to camera space and cut what is visible to what it reaches.
        let turned = view.camera_from_world * light_world.truncate();
        let light_camera =
            if light_world.w > 0.0 { turned } else { turned.normalize() }.extend(light_world.w);
        let cone = match light {
            Light::Spot { direction_world, half_angle_radians, .. } => {
                let direction = (view.camera_from_world * direction_world).normalize();
                Some(Cone { direction, half_angle_radians })
            }
            Light::Directional { .. } | Light::Omni { .. } => None,
        };
        let mut receivers = receivers(view, &request.bounds)?;
        let visible_planes = receivers.planes.len();
        lit::cut(&mut receivers, &light, light_camera, cone);
        let lit = visible_planes..receivers.planes.len();
        let seen = seen(&receivers, view, request.volumes_world)?;
        Ok(Self { light_world, light_camera, cone, receivers, lit, seen })
    }

    /// Points whose convex hull holds everything that is seen.
    pub(super) fn points(&self, request: &PlanRequest<'_>) -> &[DVec4] {
        if request.volumes_world.is_empty() { &self.receivers.vertices } else { &self.seen }
    }
}

/// The dominant plane as unit normal and offset, camera space.
pub(super) fn dominant_row(view: &View, bounds: &SceneBounds) -> Result<Option<DVec4>, PlanError> {
    let Some(WorldPlane { point_world, normal_world }) = bounds.dominant_plane else { return Ok(None) };
    let normal = normal_world.try_normalize().filter(|_| point_world.is_finite());
    let normal =
        normal.ok_or(PlanError::NotFinite { what: "the dominant plane, or its normal's inverse length," })?;
    let offset = -normal.dot(point_world - view.eye_world);
    Ok(Some((view.camera_from_world * normal).extend(offset)))
}

/// The planes that the request's case has masks of.
pub(super) fn ground_planes(
    request: &PlanRequest<'_>,
) -> Result<[Option<WorldPlane>; MOST_GROUND_PLANES], PlanError> {
    let declared = request.case.filter.ground_planes();
    let mut planes = [None; MOST_GROUND_PLANES];
    for (index, (plane, given)) in
        planes.iter_mut().zip(request.bounds.ground_planes).take(declared as usize).enumerate()
    {
        let given = given.ok_or(PlanError::GroundPlane { declared, missing: index as u32 })?;
        if !given.point_world.is_finite() || given.normal_world.try_normalize().is_none() {
            return Err(PlanError::NotFinite { what: "a ground plane, or its normal's inverse length," });
        }
        *plane = Some(given);
    }
    Ok(planes)
}

/// Corners of what is visible of some volumes, camera space.
fn seen(receivers: &Polytope, view: &View, volumes_world: &[BoundingBox]) -> Result<Vec<DVec4>, PlanError> {
    let mut corners = Vec::new();
    for volume in volumes_world {
        if !volume.min.is_finite() || !volume.max.is_finite() {
            return Err(PlanError::NotFinite { what: "a receivers' bounding volume" });
        }
        checked(volume.min, volume.max)?;
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
fn receivers(view: &View, bounds: &SceneBounds) -> Result<Polytope, PlanError> {
    if view.far_metres <= view.near_metres {
        return Ok(Polytope::empty());
    }
    let mut receivers = Polytope::frustum(view, view.far_metres);
    if let Some(bounds) = &bounds.receivers {
        if !bounds.min.is_finite() || !bounds.max.is_finite() {
            return Err(PlanError::NotFinite { what: "the receivers' bounding box" });
        }
        checked(bounds.min, bounds.max)?;
        receivers.cut_by_box(bounds, view.eye_world, &view.camera_from_world);
    }
    Ok(receivers)
}

/// Refuses a box that is inside out.
fn checked(min: DVec3, max: DVec3) -> Result<(), PlanError> {
    if min.cmpgt(max).any() { Err(PlanError::Bounds { min, max }) } else { Ok(()) }
}
