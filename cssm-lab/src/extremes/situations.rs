//! Situations at the extremes: one axis is swept at a time under several lights, then all of them together.

use std::fmt;

use cssm_core::case::{DepthFormat, LightKind};
use cssm_core::glam::DVec3;
use cssm_core::plan::WorldPlane;
use cssm_core::{BoundingBox, Light, SceneBounds, View};

use super::lights::{self, Place};
use crate::error::LabError;
use crate::scene::random::Random;

/// What is swept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Axis {
    /// Near plane over far plane.
    DepthRange,
    /// No far plane.
    InfiniteFar,
    /// Vertical field of view.
    FieldOfView,
    /// Width over height.
    Aspect,
    /// The eye's distance from the world's origin.
    Offset,
    /// The light's angle to a special direction.
    LightAngle,
    /// Size of everything, and of the scene's bounds.
    Scale,
    /// Size and format of the map.
    Map,
    /// Everything at once.
    Together,
}

/// Every axis, in the order of tables.
pub const AXES: [Axis; 9] = [
    Axis::DepthRange,
    Axis::InfiniteFar,
    Axis::FieldOfView,
    Axis::Aspect,
    Axis::Offset,
    Axis::LightAngle,
    Axis::Scale,
    Axis::Map,
    Axis::Together,
];

impl Axis {
    /// Name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::DepthRange => "near/far",
            Self::InfiniteFar => "infinite far",
            Self::FieldOfView => "field of view",
            Self::Aspect => "aspect",
            Self::Offset => "world offset",
            Self::LightAngle => "light angle",
            Self::Scale => "scale, bounds",
            Self::Map => "map",
            Self::Together => "together",
        }
    }

    /// What is swept, in words.
    pub const fn range(self) -> &'static str {
        match self {
            Self::DepthRange => "near/far 1e-7 to 1 - 1e-7",
            Self::InfiniteFar => "near 1e-4 to 100 m, shadow distance and none",
            Self::FieldOfView => "0.5 to 175 degrees",
            Self::Aspect => "0.05 to 20",
            Self::Offset => "0 to 1e8 m",
            Self::LightAngle => {
                "0 to 1e-2 rad off the view axis, corner and edge rays, the near plane, up and sideways, both ways"
            }
            Self::Scale => {
                "1e-30 to 1e9 times, a far plane at 1e12 m; boxes without volume, denormal, huge, elsewhere"
            }
            Self::Map => "1 to 16384 texels, D32 and D16",
            Self::Together => "seeded draws of all",
        }
    }
}

/// A view, a light, a map.
#[derive(Debug, Clone)]
pub struct Situation {
    /// What is swept.
    pub axis: Axis,
    /// Where on the axis, and the light, in words.
    pub name: String,
    /// The view.
    pub view: View,
    /// The light.
    pub light: Light,
    /// What planning is told of the scene.
    pub bounds: SceneBounds,
    /// Depth of the deepest receiver that is asked for; the shadow distance of techniques that cannot fit infinity.
    pub reach_metres: f64,
    /// Whether those techniques are given no shadow distance and have to refuse.
    pub unbounded: bool,
    /// Width and height of the map.
    pub map_texels: (u32, u32),
    /// Format of the map.
    pub format: DepthFormat,
}

impl fmt::Display for Situation {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}: {}", self.axis.name(), self.name)
    }
}

/// The camera that all axes but one leave alone.
#[derive(Debug, Clone, Copy)]
struct Camera {
    near: f64,
    far: f64,
    fov_degrees: f64,
    aspect: f64,
    offset: f64,
    /// The eye above the ground: world coordinates hold no scene that is much smaller than its distance from the origin.
    eye_height: f64,
    /// Pitched down and turned, so that no axis of the world is one of the camera's.
    turned: bool,
}

const CAMERA: Camera = Camera {
    near: 0.2,
    far: 1000.0,
    fov_degrees: 60.0,
    aspect: 1.0,
    offset: 0.0,
    eye_height: EYE_HEIGHT,
    turned: false,
};
/// Lines of every image.
const LINES: f64 = 1080.0;
/// Side of the map where it is not swept.
const MAP: (u32, u32) = (2048, 2048);
/// Deepest receiver of a view to infinity: the horizon that distributions have by default, metres, and in near distances.
const HORIZON_METRES: f64 = 1e5;
const HORIZON_NEARS: f64 = 1e3;
/// Eye above the ground, metres.
const EYE_HEIGHT: f64 = 1.7;
/// Off a special direction, radians.
const OFFS: [f64; 6] = [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2];
/// Draws of everything at once.
const DRAWS: usize = 120;

impl Camera {
    fn view(&self) -> Result<View, LabError> {
        let eye = DVec3::new(0.6, -0.3, 0.7) * self.offset + DVec3::Y * self.eye_height;
        let ahead = if self.turned { DVec3::new(0.5, -0.2, -0.8) } else { DVec3::NEG_Z };
        // A target as far as the eye keeps the direction at any offset.
        let target = eye + ahead * (1.0 + self.offset);
        let size = ((LINES * self.aspect).round().max(1.0) as u32, LINES as u32);
        Ok(View::perspective(
            eye,
            target,
            DVec3::Y,
            self.fov_degrees.to_radians(),
            self.near,
            self.far,
            size,
        )?)
    }

    fn reach(&self) -> f64 {
        if self.far.is_finite() { self.far } else { HORIZON_METRES.max(HORIZON_NEARS * self.near) }
    }

    fn situation(
        &self,
        axis: Axis,
        kind: LightKind,
        (name, place): &(String, Place),
    ) -> Result<Situation, LabError> {
        let view = self.view()?;
        let light = place.light(kind, &view, self.reach())?;
        let ground = WorldPlane {
            point_world: view.eye_world - DVec3::Y * self.eye_height,
            normal_world: DVec3::new(0.01, 1.0, -0.02),
        };
        let bounds = SceneBounds {
            receivers: None,
            eye_height_metres: Some(self.eye_height),
            dominant_plane: Some(ground),
            ..SceneBounds::default()
        };
        Ok(Situation {
            axis,
            name: name.clone(),
            view,
            light,
            bounds,
            reach_metres: self.reach(),
            unbounded: false,
            map_texels: MAP,
            format: DepthFormat::Depth32Float,
        })
    }
}

/// Every situation for a kind of light.
///
/// # Errors
/// When a view or a light makes no sense, which is a fault of this list.
pub fn situations(kind: LightKind) -> Result<Vec<Situation>, LabError> {
    let mut list = Vec::new();

    // Sweep the camera, one number at a time.
    let mut sweep = |axis: Axis, cameras: Vec<(String, Camera)>| -> Result<(), LabError> {
        for (name, camera) in cameras {
            for (light, place) in lights::usual(kind) {
                list.push(camera.situation(axis, kind, &(format!("{name}, {light}"), place))?);
            }
        }
        Ok(())
    };
    let ratios = [1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5, 0.9, 0.999, 1.0 - 1e-7];
    let ranged = |ratio: &f64| (format!("near/far {ratio:e}"), Camera { near: 1000.0 * ratio, ..CAMERA });
    sweep(Axis::DepthRange, ratios.iter().map(ranged).collect())?;
    let endless =
        |near: &f64| (format!("near {near} m"), Camera { near: *near, far: f64::INFINITY, ..CAMERA });
    sweep(Axis::InfiniteFar, [1e-4, 0.01, 0.2, 1.0, 100.0].iter().map(endless).collect())?;
    let degrees = [0.5, 1.0, 5.0, 20.0, 60.0, 90.0, 120.0, 150.0, 170.0, 175.0];
    let opened = |fov: &f64| (format!("{fov} degrees"), Camera { fov_degrees: *fov, ..CAMERA });
    sweep(Axis::FieldOfView, degrees.iter().map(opened).collect())?;
    let wide = |aspect: &f64| (format!("aspect {aspect}"), Camera { aspect: *aspect, ..CAMERA });
    sweep(Axis::Aspect, [0.05, 0.2, 0.5, 1.0, 16.0 / 9.0, 5.0, 20.0].iter().map(wide).collect())?;
    let far_off =
        |offset: &f64| (format!("offset {offset:e} m"), Camera { offset: *offset, turned: true, ..CAMERA });
    sweep(Axis::Offset, [0.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8].iter().map(far_off).collect())?;
    let scales = [1e-30, 1e-20, 1e-10, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9];
    let scaled = |scale: &f64| {
        let (near, far) = (0.2 * scale, 1000.0 * scale);
        (format!("scale {scale:e}"), Camera { near, far, eye_height: EYE_HEIGHT * scale, ..CAMERA })
    };
    sweep(Axis::Scale, scales.iter().map(scaled).collect())?;

    // Turn the light around every special direction, in a level view and in a wide one.
    let wide = Camera { aspect: 16.0 / 9.0, fov_degrees: 100.0, turned: true, ..CAMERA };
    for (which, camera) in [("level", CAMERA), ("wide", wide)] {
        for place in lights::special(kind, &camera.view()?, &OFFS) {
            let named = (format!("{which}, {}", place.0), place.1);
            list.push(camera.situation(Axis::LightAngle, kind, &named)?);
        }
    }

    list.extend(unbounded(kind)?);
    list.extend(boxes(kind)?);
    list.extend(maps(kind)?);
    list.extend(together(kind)?);
    Ok(list)
}

/// Views to infinity without a shadow distance.
fn unbounded(kind: LightKind) -> Result<Vec<Situation>, LabError> {
    let camera = Camera { far: f64::INFINITY, ..CAMERA };
    let one = |(light, place): (String, Place)| {
        let named = (format!("no shadow distance, {light}"), place);
        Ok(Situation { unbounded: true, ..camera.situation(Axis::InfiniteFar, kind, &named)? })
    };
    lights::usual(kind).into_iter().map(one).collect()
}

/// Scene bounds without volume, of denormal and of huge size, and elsewhere.
fn boxes(kind: LightKind) -> Result<Vec<Situation>, LabError> {
    let eye = CAMERA.view()?.eye_world;
    let ahead = eye + DVec3::new(1.0, -1.0, -20.0);
    let around = |centre: DVec3, half: DVec3| BoundingBox { min: centre - half, max: centre + half };
    let boxes = [
        ("box of 1e12 m", around(eye, DVec3::splat(1e12))),
        ("box of 1e300 m", around(eye, DVec3::splat(1e300))),
        ("flat box", around(ahead, DVec3::new(30.0, 0.0, 15.0))),
        ("box that is a line", around(ahead, DVec3::new(0.0, 0.0, 15.0))),
        ("box that is a point", around(ahead, DVec3::ZERO)),
        ("box of 1e-9 m", around(ahead, DVec3::splat(1e-9))),
        ("box of denormal size", BoundingBox { min: DVec3::splat(-1e-310), max: DVec3::splat(1e-310) }),
        ("box around the eye, 1 mm", around(eye, DVec3::splat(5e-4))),
        ("box behind the eye", around(eye + DVec3::Z * 50.0, DVec3::splat(10.0))),
        ("box of a town", around(ahead, DVec3::new(300.0, 40.0, 300.0))),
    ];
    let mut list = Vec::new();
    for (name, bounds) in boxes {
        for (light, place) in lights::usual(kind) {
            let named = (format!("{name}, {light}"), place);
            let mut situation = CAMERA.situation(Axis::Scale, kind, &named)?;
            situation.bounds.receivers = Some(bounds);
            list.push(situation);
        }
    }
    Ok(list)
}

/// Maps from too small to the largest, square and not, in both formats.
fn maps(kind: LightKind) -> Result<Vec<Situation>, LabError> {
    let sizes = [
        (1, 1),
        (2, 2),
        (16, 16),
        (64, 64),
        (64, 16384),
        (256, 256),
        (1024, 1024),
        (4096, 1024),
        (4096, 4096),
        (16384, 64),
        (16384, 16384),
    ];
    let mut list = Vec::new();
    for map_texels in sizes {
        for format in [DepthFormat::Depth32Float, DepthFormat::Depth16Unorm] {
            for (light, place) in lights::usual(kind) {
                let (width, height) = map_texels;
                let named = (format!("{width} x {height} {}, {light}", format.name()), place);
                let situation = CAMERA.situation(Axis::Map, kind, &named)?;
                list.push(Situation { map_texels, format, ..situation });
            }
        }
    }
    Ok(list)
}

/// Seeded draws of everything at once.
fn together(kind: LightKind) -> Result<Vec<Situation>, LabError> {
    let mut random = Random::new(41);
    let mut list = Vec::new();
    for _ in 0..DRAWS {
        let far = libm::pow(10.0, random.between(0.0, 6.0));
        let near = far * libm::pow(10.0, random.between(-7.0, -0.05));
        let camera = Camera {
            near,
            far: if random.below(4) == 0 { f64::INFINITY } else { far },
            fov_degrees: [0.5, 1.0, 10.0, 60.0, 100.0, 150.0, 175.0][random.below(7)],
            aspect: libm::pow(20.0, random.between(-1.0, 1.0)),
            offset: [0.0, 1e3, 1e6, 1e8][random.below(4)],
            eye_height: EYE_HEIGHT,
            turned: random.below(2) == 0,
        };
        let special = lights::special(kind, &camera.view()?, &OFFS);
        let (light, place) = special[random.below(special.len())].clone();
        let Camera { near, far, fov_degrees, aspect, offset, .. } = camera;
        let name = format!(
            "{near:.1e} to {far:.1e} m, {fov_degrees} degrees, aspect {aspect:.2}, offset {offset:e} m, {light}"
        );
        list.push(camera.situation(Axis::Together, kind, &(name, place))?);
    }
    Ok(list)
}
