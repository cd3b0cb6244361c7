//! Situations at the extremes: depth ranges to infinity, fields of view from 1 to 170 degrees, images a tenth as wide as
//! high, lights along every special direction and a hair off it, ten thousand kilometres from the origin.

use std::f64::consts::TAU;
use std::fmt;

use cssm_core::glam::{DVec3, DVec4, Vec3};
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};

use crate::random::Random;

/// Every this many receivers one is moved onto a border of facets.
pub const BORDER_EVERY: usize = 4;
/// Steps of rounding by which receivers are moved off borders, at most.
const BORDER_STEPS: i64 = 8;
/// Largest band limit in metres whose border is tried.
const FARTHEST_BORDER: f64 = 1e12;
/// Deepest receiver in near plane depths.
const DEEPEST: f64 = 1e6;

/// A view and a light.
#[derive(Debug, Clone, Copy)]
pub struct Situation {
    /// The view.
    pub view: View,
    /// Direction towards the light, world axes.
    pub toward_light_world: DVec3,
    /// Depth of the deepest receiver.
    pub reach_metres: f64,
}

impl Situation {
    /// Every view with every light: 54 times 48.
    ///
    /// # Panics
    /// Never; the views are fixed.
    pub fn all() -> Vec<Self> {
        let mut random = Random(11);
        let mut situations = Vec::new();
        for (near, far) in [(0.1, 1e6), (1e-4, 1e3), (0.1, f64::INFINITY)] {
            for fov in [1.0, 60.0, 170.0_f64] {
                for size in [(100, 1000), (1000, 700), (2000, 200)] {
                    for origin in [0.0, 1e7] {
                        let eye = DVec3::new(1.0, -0.5, 0.7) * origin;
                        let target = eye + DVec3::new(0.3, -0.1, -1.0);
                        let view =
                            View::perspective(eye, target, DVec3::Y, fov.to_radians(), near, far, size)
                                .expect("a fixed view");
                        let reach_metres = far.min(DEEPEST * near);
                        situations.extend(
                            lights(&view, &mut random).into_iter().map(|toward_light_world| Self {
                                view,
                                toward_light_world,
                                reach_metres,
                            }),
                        );
                    }
                }
            }
        }
        situations
    }

    /// Whether the view opens by a degree.
    pub fn narrow(&self) -> bool {
        self.view.top < 0.05
    }

    /// The plan of a case. Techniques that cannot fit infinity get the reach for a shadow distance; the others get none.
    ///
    /// # Panics
    /// When there is no plan.
    pub fn plan(&self, case: &LightCase) -> ShadowPlan {
        let mut case = case.clone();
        let bounded = !case.technique_spec().fits_infinity;
        case.shadow_distance_metres = bounded.then_some(self.reach_metres);
        let light = Light::directional_travelling(-self.toward_light_world).expect("a unit vector");
        plan(&case, &self.view, &light, &SceneBounds::default())
            .unwrap_or_else(|error| panic!("{}: {error}: {self}", case.name))
    }

    /// Receivers in camera axes as shaders get them; the last of every [`BORDER_EVERY`] lies on a border of facets, a few
    /// steps of rounding off, where the plan has any.
    pub fn receivers(&self, plan: &ShadowPlan, count: usize, random: &mut Random) -> Vec<Vec3> {
        let view = &self.view;
        let borders = border_rows(plan);
        let mut receivers = Vec::with_capacity(count);
        while receivers.len() < count {
            let depth = view.near_metres * (self.reach_metres / view.near_metres).powf(random.unit());
            let x = random.unit() * f64::from(view.size_pixels.0);
            let y = random.unit() * f64::from(view.size_pixels.1);
            let mut point = view.ray_world(x, y) * depth;
            if receivers.len() % BORDER_EVERY == BORDER_EVERY - 1
                && let Some(row) = borders.get(random.below(borders.len()))
            {
                let normal = row.truncate();
                point -= normal * (row.dot(point.extend(1.0)) / normal.length_squared());
                let mut factor = || {
                    let steps = random.below(2 * BORDER_STEPS as usize + 1) as i64 - BORDER_STEPS;
                    1.0 + steps as f64 * f64::from(f32::EPSILON)
                };
                point *= DVec3::new(factor(), factor(), factor());
            }
            let camera = (view.camera_from_world * point).as_vec3();
            if self.sees(camera.as_dvec3()) {
                receivers.push(camera);
            }
        }
        receivers
    }

    fn sees(&self, camera: DVec3) -> bool {
        let (view, depth) = (&self.view, -camera.z);
        (view.near_metres..=self.reach_metres * 0.999).contains(&depth)
            && (view.left..=view.right).contains(&(camera.x / depth))
            && (view.bottom..=view.top).contains(&(camera.y / depth))
    }
}

impl fmt::Display for Situation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let View { near_metres, far_metres, size_pixels, eye_world, .. } = self.view;
        let fov = (2.0 * self.view.top.atan()).to_degrees();
        let light = self.view.camera_from_world * self.toward_light_world;
        write!(f, "{near_metres} to {far_metres} m, {fov:.0} degrees, {size_pixels:?}, ")?;
        write!(f, "eye {eye_world}, light {light}")
    }
}

/// Rows that are zero on the borders between facets.
fn border_rows(plan: &ShadowPlan) -> Vec<DVec4> {
    let selection = &plan.selection;
    let mut rows: Vec<DVec4> = selection.borders.iter().copied().filter(|row| row.w == 0.0).collect();
    for (sector, row) in selection.distances.iter().enumerate() {
        let limits = selection.limits(sector).iter().filter(|limit| **limit < FARTHEST_BORDER);
        rows.extend(limits.map(|limit| *row - DVec4::W * *limit));
    }
    rows.retain(|row| row.truncate() != DVec3::ZERO);
    rows
}

/// Along the axis, an edge, a corner and the near plane of a view, ahead and behind, exactly and a hair off.
fn lights(view: &View, random: &mut Random) -> Vec<DVec3> {
    let to_world = view.camera_from_world.transpose();
    let corner = DVec3::new(view.right, view.top, -1.0);
    let edge = DVec3::new(0.3 * view.left, view.top, -1.0);
    let mut lights = Vec::new();
    for special in [DVec3::NEG_Z, edge, corner, DVec3::new(0.6, 0.8, 0.0)] {
        for offset in [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2] {
            for sign in [1.0, -1.0] {
                let (turn, height) = (TAU * random.unit(), 2.0 * random.unit() - 1.0);
                let level = (1.0 - height * height).sqrt();
                let anywhere = DVec3::new(level * turn.cos(), height, level * turn.sin());
                let camera = (special.normalize() + anywhere * offset) * sign;
                lights.push((to_world * camera).normalize());
            }
        }
    }
    lights
}
