//! A small scene with everything that is hard: a wide ground, boxes, thin poles, tilted sheets, a tower above the view.

use cssm_core::case::LightKind;
use cssm_core::glam::{DAffine3, DMat3, DQuat, DVec3, DVec4};
use cssm_core::{BoundingBox, Light, ShadowPlan, View};
use cssm_runtime::{CasterInstance, ServiceError, ShadowService};

use super::casters::{Geometry, GeometryBuffers};
use super::device::TestDevice;
use crate::touch::box_corners;

/// Where the yard lies in the world: far enough that f32 would lose whole metres.
pub const ORIGIN: DVec3 = DVec3::new(4.1e6, 120.0, -5.3e6);

/// Geometries and where they stand.
#[derive(Debug)]
pub struct Yard {
    /// Shapes.
    pub geometries: Vec<Geometry>,
    /// Index of the shape and where it stands.
    pub places: Vec<(usize, DAffine3)>,
}

/// What a ray hits.
#[derive(Debug, Clone, Copy)]
pub struct Hit {
    /// Multiple of the ray.
    pub along: f64,
    /// Unit normal, facing the ray's start.
    pub normal: DVec3,
}

impl Yard {
    /// The scene; always the same.
    pub fn new() -> Self {
        let geometries = vec![
            Geometry::ground(500.0, 16),
            Geometry::cuboid([-0.5, 0.0, -0.5], [0.5, 1.0, 0.5]),
            Geometry::triangle([[-3.0, 0.0, 0.0], [4.0, 1.0, 0.5], [0.0, 5.0, -2.0]]),
        ];
        let stand = |shape: usize, at: [f64; 3], size: [f64; 3], turn: f64| {
            let turn = DQuat::from_rotation_y(turn);
            let at = ORIGIN + DVec3::from_array(at);
            (shape, DAffine3::from_scale_rotation_translation(DVec3::from_array(size), turn, at))
        };
        let mut places = vec![
            stand(0, [0.0; 3], [1.0; 3], 0.0),
            stand(1, [4.0, 0.0, -12.0], [3.0, 4.0, 3.0], 0.3),
            stand(1, [-6.0, 0.0, -25.0], [6.0, 9.0, 4.0], 0.7),
            stand(1, [30.0, 0.0, -70.0], [20.0, 25.0, 12.0], 1.1),
            stand(1, [-60.0, 0.0, 40.0], [8.0, 90.0, 8.0], 0.2),
            stand(2, [2.0, 2.0, -8.0], [0.5; 3], 0.0),
            stand(2, [-9.0, 1.0, -16.0], [1.4; 3], 2.0),
        ];
        // Poles from thin to thinner, away from the eye.
        for pole in 0..6 {
            let step = f64::from(pole);
            places.push(stand(1, [-3.0 + 2.3 * step, 0.0, -6.0 - 7.0 * step], [0.12, 5.0, 0.12], 0.1 * step));
        }
        Self { geometries, places }
    }

    /// Buffers of the shapes.
    pub fn upload(&self, gpu: &TestDevice) -> Vec<GeometryBuffers> {
        self.geometries.iter().map(|geometry| geometry.upload(gpu)).collect()
    }

    /// Adds the shapes to a service; the instances of the scene.
    ///
    /// # Errors
    /// Those of the service.
    pub fn add_to(
        &self,
        service: &mut ShadowService,
        buffers: &[GeometryBuffers],
    ) -> Result<Vec<CasterInstance>, ServiceError> {
        let meshes = buffers
            .iter()
            .map(|buffers| service.add_mesh(&buffers.description()))
            .collect::<Result<Vec<_>, _>>()?;
        let instance = |(shape, world_from_object): &(usize, DAffine3)| CasterInstance {
            mesh: meshes[*shape],
            world_from_object: *world_from_object,
        };
        Ok(self.places.iter().map(instance).collect())
    }

    /// Triangles of one place relative to the eye, world axes, as the device reads them in a camera's axes.
    pub fn place_from_eye(
        &self,
        place: usize,
        eye_world: DVec3,
        camera_from_world: &DMat3,
    ) -> Vec<[DVec3; 3]> {
        let (shape, world_from_object) = &self.places[place];
        self.geometries[*shape].triangles_from_eye(world_from_object, eye_world, camera_from_world).collect()
    }

    /// All triangles relative to a view's eye.
    pub fn triangles_from_eye(&self, view: &View) -> Vec<[DVec3; 3]> {
        let place = |place| self.place_from_eye(place, view.eye_world, &view.camera_from_world);
        (0..self.places.len()).flat_map(place).collect()
    }

    /// Whether the service draws a place into a facet of a plan: the shadow of its own box, turned as it stands, reaches the
    /// facet.
    pub fn reaches(&self, place: usize, plan: &ShadowPlan, facet: usize) -> bool {
        let corners = self.place_corners(place, plan.eye_world);
        let holds = |plane: &DVec4| corners.iter().any(|corner| plane.dot(corner.extend(1.0)) >= 0.0);
        plan.facets[facet].casters.iter().all(holds)
    }

    /// World-space box around everything.
    pub fn bounds(&self) -> BoundingBox {
        let boxes = (0..self.places.len()).map(|place| self.place_bounds(place, DVec3::ZERO));
        let none = BoundingBox { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
        boxes.fold(none, |all, one| BoundingBox { min: all.min.min(one.min), max: all.max.max(one.max) })
    }

    /// Box around one place, relative to a point.
    fn place_bounds(&self, place: usize, origin_world: DVec3) -> BoundingBox {
        let none = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        let corners = self.place_corners(place, origin_world).into_iter();
        let (min, max) = corners.fold(none, |(min, max), corner| (min.min(corner), max.max(corner)));
        BoundingBox { min, max }
    }

    /// Corners of one place's own box, relative to a point, world axes.
    fn place_corners(&self, place: usize, origin_world: DVec3) -> [DVec3; 8] {
        let (shape, mut from_object) = self.places[place];
        from_object.translation -= origin_world;
        box_corners(&self.geometries[shape].bounds(), &from_object)
    }
}

impl Default for Yard {
    fn default() -> Self {
        Self::new()
    }
}

/// The nearest triangle that a ray from the eye meets.
pub fn hit(triangles: &[[DVec3; 3]], ray: DVec3) -> Option<Hit> {
    let meets = |triangle: &[DVec3; 3]| {
        let (one, two) = (triangle[1] - triangle[0], triangle[2] - triangle[0]);
        let normal = one.cross(two);
        let along = normal.dot(triangle[0]) / normal.dot(ray);
        if !(along > 0.0 && along.is_finite()) {
            return None;
        }
        let point = ray * along - triangle[0];
        let scale = 1.0 / normal.length_squared();
        let (u, v) = (point.cross(two).dot(normal) * scale, one.cross(point).dot(normal) * scale);
        let normal = normal.normalize() * -normal.dot(ray).signum();
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0).then_some(Hit { along, normal })
    };
    triangles.iter().filter_map(meets).min_by(|one, other| one.along.total_cmp(&other.along))
}

/// Views of the yard: at eye level, from above, and close to the ground with an infinite far plane.
///
/// # Panics
/// Never; the views are fixed.
pub fn views(size_pixels: (u32, u32)) -> [View; 3] {
    let view = |eye: [f64; 3], target: [f64; 3], fov: f64, far: f64| {
        let (eye, target) = (ORIGIN + DVec3::from_array(eye), ORIGIN + DVec3::from_array(target));
        View::perspective(eye, target, DVec3::Y, fov, 0.2, far, size_pixels).expect("a fixed view")
    };
    [
        view([0.3, 1.7, 2.0], [0.0, 1.4, -20.0], 1.05, 200.0),
        view([25.0, 30.0, 18.0], [0.0, 0.0, -15.0], 0.8, 300.0),
        view([-4.0, 0.6, -3.0], [20.0, 4.0, -60.0], 1.2, f64::INFINITY),
    ]
}

/// Suns: steep from the side, low from behind, low from ahead.
///
/// # Panics
/// Never; the directions are fixed.
pub fn suns() -> [Light; 3] {
    [[-0.5, -1.0, -0.3], [0.4, -0.35, -0.9], [-0.2, -0.3, 1.0]].map(|direction| {
        Light::directional_travelling(DVec3::from_array(direction)).expect("a fixed direction")
    })
}

/// Lights of a kind: the suns, or lamps that stand high beside the view, in it, and behind the eye; spots shine on what
/// the views see.
///
/// # Panics
/// Never; the lights are fixed.
pub fn lights(kind: LightKind) -> [Light; 3] {
    const LAMPS: [([f64; 3], f64); 3] =
        [([14.0, 18.0, -22.0], 120.0), ([-1.0, 3.5, -11.0], f64::INFINITY), ([1.5, 4.0, 9.0], 80.0)];
    const AIMS: [([f64; 3], f64); 3] =
        [([0.0, 0.0, -14.0], 0.7), ([4.0, 0.0, -20.0], 1.1), ([-1.0, 1.0, -20.0], 0.5)];
    let at = |place: [f64; 3]| ORIGIN + DVec3::from_array(place);
    match kind {
        LightKind::Directional => suns(),
        LightKind::Omni => LAMPS.map(|(place, range)| Light::omni(at(place), range).expect("a fixed lamp")),
        LightKind::Spot => std::array::from_fn(|index| {
            let ((place, range), (aim, half_angle)) = (LAMPS[index], AIMS[index]);
            Light::spot(at(place), at(aim) - at(place), half_angle, range).expect("a fixed spot")
        }),
    }
}
