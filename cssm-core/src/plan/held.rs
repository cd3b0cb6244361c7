//! A plan held over frames: brought to another eye, asked whether it still covers what is seen, and judged anew.

use glam::{DVec3, DVec4};
use smallvec::SmallVec;

use super::fitted::around_rank;
use super::make::shear;
use super::visible::{self, Visible};
use super::{PlanRequest, ShadowPlan, WorldPlane};
use crate::case::MOST_GROUND_PLANES;
use crate::facet::{Facet, Tile};
use crate::fit::Cut;
use crate::homography::{Gradients, singular_values};
use crate::light::Light;
use crate::receivers::Polytope;
use crate::samples::{self, Points};
use crate::view::View;

/// What a plan was made from, as far as later frames need it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanBasis {
    /// The light.
    pub light: Light,
    /// Whether the technique's texels follow the eye, so that positions are sheared along a light near the view.
    pub follows_camera: bool,
    /// Half-spaces (h.X >= 0, relative to the plan's eye, world axes) that together with `lit` hold the receivers with a
    /// facet.
    pub receivers: Vec<DVec4>,
    /// By what receivers among them were left out.
    pub cut: Cut,
    /// Half-spaces that hold everything within a local light's range and cone; none for a directional light.
    pub lit: Vec<DVec4>,
    /// Planes with masks of their own, as many as the case declares, then none.
    pub ground_planes: [Option<WorldPlane>; MOST_GROUND_PLANES],
    /// Sample receivers by which the plan was judged.
    pub samples: u32,
    /// Predicted 95th percentile of the texel footprint over sample receivers of the view that the plan was made for,
    /// screen pixels.
    pub p95_pixels: f64,
}

impl PlanBasis {
    /// What a plan of nothing was made from.
    pub(super) const fn none() -> Self {
        Self {
            light: Light::Directional { toward_light_world: DVec3::Y },
            follows_camera: false,
            receivers: Vec::new(),
            cut: Cut::None,
            lit: Vec::new(),
            ground_planes: [None; MOST_GROUND_PLANES],
            samples: 0,
            p95_pixels: 0.0,
        }
    }
}

/// How far beyond a half-space a receiver may lie, relative to the terms of its distance: rounding of eyes far from the
/// world's origin.
const COVERED: f64 = 1e-9;
impl ShadowPlan {
    /// The same plan as seen from another view: every world point has the texel, the depth and the cell that it had,
    /// expressed relative to the new eye and, in records, in the new camera axes. Everything happens in f64.
    #[must_use]
    pub fn rebased(&self, view: &View) -> Self {
        let mut plan = self.clone();
        plan.rebase(view);
        plan
    }

    /// [`Self::rebased`] in place.
    pub fn rebase(&mut self, view: &View) {
        // A row takes the eye's way along in its constant, a point leaves it behind.
        let way = view.eye_world - self.eye_world;
        let row = |row: &mut DVec4| row.w += row.truncate().dot(way);
        for facet in &mut self.facets {
            facet.rows_mut().for_each(row);
            for point in &mut facet.receivers {
                *point -= (way * point.w).extend(0.0);
            }
        }
        self.selection.rows_mut().for_each(row);
        self.basis.receivers.iter_mut().chain(&mut self.basis.lit).for_each(row);

        self.eye_world = view.eye_world;
        self.camera_from_world = view.camera_from_world;
        self.pixel_metres = view.pixel_metres();
        self.light = self.basis.light.homogeneous(view.eye_world);
        let light_camera = (view.camera_from_world * self.light.truncate()).extend(self.light.w);
        self.shear = shear(view, light_camera, self.basis.follows_camera);
    }

    /// The planes with masks of their own, as unit normals and offsets relative to the eye, world axes, in the order of their
    /// channels.
    pub fn ground_planes(&self) -> impl Iterator<Item = DVec4> + '_ {
        self.basis.ground_planes.iter().flatten().map(|plane| {
            let normal = plane.normal_world.normalize_or_zero();
            normal.extend(normal.dot(self.eye_world - plane.point_world))
        })
    }

    /// Whether the plan has a facet for everything that a request may see in shadow: all receivers of its view, without
    /// its margin, must lie among those that the plan was made for. Also false where the light or a plane with a mask of
    /// its own is another one, or where the request names another part of the map. The request's case must be the plan's own.
    pub fn covers(&self, request: &PlanRequest<'_>) -> bool {
        let map = (request.case.map.width, request.case.map.height);
        if *request.light != self.basis.light
            || map != self.map_size_texels
            || request.checked_region() != Ok(self.region)
            || visible::ground_planes(request).as_ref() != Ok(&self.basis.ground_planes)
        {
            return false;
        }
        let is_known = match &self.basis.cut {
            Cut::None => true,
            Cut::Bounds(bounds) => bounds.hold(&request.seen()),
            Cut::Depth => false,
        };
        if !is_known {
            return false;
        }
        let view = visible::shadowed(request);
        let Ok(visible) = Visible::of(request, &view) else { return false };
        if visible.receivers.is_empty() {
            return true;
        }

        // Bring every vertex to the plan's eye; those at infinity stay where they are. The same light reaches the same
        // points, so that its own half-spaces, which are only near its range and cone, need no comparison.
        let world_from_camera = view.camera_from_world.transpose();
        let way = view.eye_world - self.eye_world;
        visible.points(request).iter().all(|vertex| {
            let point = (world_from_camera * vertex.truncate() + way * vertex.w).extend(vertex.w);
            self.basis.receivers.iter().all(|plane| {
                let terms = plane.truncate().length() * point.truncate().length() + (plane.w * point.w).abs();
                plane.dot(point) >= -COVERED * terms
            })
        })
    }

    /// Predicted 95th percentile of the texel footprint over sample receivers of a view, screen pixels: what
    /// [`crate::choose::Prediction`] says of a plan made for the view. Receivers are those of the view that the plan
    /// covers; 0 where there are none. The view's far plane should be no farther than shadows reach.
    pub fn p95_pixels(&self, view: &View) -> f64 {
        let Some(receivers) = self.covered_part(view) else { return 0.0 };
        let world_from_camera = view.camera_from_world.transpose();
        let way = view.eye_world - self.eye_world;
        let mut points = Points::new();
        samples::sample(view, &receivers, self.basis.samples, &mut |point| points.push(point));
        let mut footprints: SmallVec<[f64; 512]> = points
            .into_iter()
            .map(|point| {
                let from_eye = world_from_camera * point + way;
                let facet = self.facet(self.selection.cell(from_eye.extend(1.0)));
                let metres = facet.map_or(f64::INFINITY, |facet| texel_metres(facet, from_eye));
                metres * view.pixels_per_tangent() / -point.z
            })
            .collect();
        around_rank(&mut footprints)
    }

    /// Receivers of a view that the plan covers, in the view's camera space; `None` where there are none.
    fn covered_part(&self, view: &View) -> Option<Polytope> {
        if view.far_metres <= view.near_metres {
            return None;
        }
        let way = view.eye_world - self.eye_world;
        let mut receivers = Polytope::frustum(view, view.far_metres);
        for plane in self.basis.receivers.iter().chain(&self.basis.lit) {
            let normal = plane.truncate();
            receivers.cut((view.camera_from_world * normal).extend(plane.w + normal.dot(way)));
        }
        (!receivers.is_empty()).then_some(receivers)
    }
}

/// Major axis in metres across the light of a facet's texel at a point.
fn texel_metres(facet: &Facet, from_eye: DVec3) -> f64 {
    let Tile { width, height, .. } = facet.tile;
    let (across, up) = Gradients::at(&facet.rows, from_eye).across_light();
    let (major, _) = singular_values(across * (2.0 / f64::from(width)), up * (2.0 / f64::from(height)));
    if major.is_finite() { major } else { f64::INFINITY }
}

impl Facet {
    /// Every row of the facet: all but its points.
    fn rows_mut(&mut self) -> impl Iterator<Item = &mut DVec4> {
        let rows = [&mut self.rows.x, &mut self.rows.y, &mut self.rows.z, &mut self.rows.w];
        let lists = [&mut self.select, &mut self.clip, &mut self.casters];
        rows.into_iter().chain(lists.into_iter().flatten())
    }
}
