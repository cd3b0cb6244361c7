//! Shared inputs of the core tests: a seeded generator, cases, views and lights at the extremes.

#![allow(dead_code, reason = "each test file uses its part")]

use cssm_core::case::{DominantPlane, LightKind, Stretch};
use cssm_core::glam::DVec3;
use cssm_core::plan::WorldPlane;
use cssm_core::schema::{Value, Word};
use cssm_core::{Light, LightCase, SceneBounds, View};

/// xorshift64*: small, seeded, the same everywhere.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1)
    }

    pub(crate) fn bits(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub(crate) fn direction(&mut self) -> DVec3 {
        loop {
            let cube = DVec3::new(self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-1.0, 1.0));
            if (0.01..1.0).contains(&cube.length()) {
                return cube.normalize();
            }
        }
    }
}

/// A case of each technique, configuration and distribution at a map size.
pub(crate) fn cases(size: u32, shadow_distance: f64) -> Vec<LightCase> {
    let split = |scheme: &'static str, splits: u32| {
        let arguments = [("splits", Value::Count(splits)), ("scheme", Value::Word(Word::plain(scheme)))];
        Word::with("parallel_split", arguments)
    };
    let bounded = |name: &str, technique: Word| {
        let builder = LightCase::builder(name).technique(technique).shadow_distance_metres(shadow_distance);
        builder.map_size_texels(size, size).build().unwrap()
    };
    let camera_space = |name: &str, configurations: &[&'static str]| {
        LightCase::builder(name).configurations(configurations).map_size_texels(size, size)
    };
    let perspective = || Word::plain("perspective");
    vec![
        bounded("Standard", Word::plain("standard")),
        bounded("Logarithmic", split("logarithmic", 4)),
        bounded("Uniform", split("uniform", 3)),
        LightCase::builder("Faces").bands(8, 1e5).map_size_texels(size, size).build().unwrap(),
        LightCase::builder("Column").bands(1, 1e5).map_size_texels(size, size).build().unwrap(),
        LightCase::builder("Fine").bands(16, 1e5).map_size_texels(size, size).build().unwrap(),
        camera_space("FocusedFaces", &["face_columns"]).distribution(perspective()).build().unwrap(),
        camera_space("OnePlane", &["one_plane"]).distribution(perspective()).build().unwrap(),
        camera_space("BandedPlane", &["one_plane"]).build().unwrap(),
        camera_space("FourPlane", &["four_plane"]).build().unwrap(),
        camera_space("Chosen", &["four_plane", "one_plane"]).build().unwrap(),
    ]
}

/// A case of each peer technique, in every way it can be declared for a kind of light.
pub(crate) fn peers(size: u32, shadow_distance: f64, light: LightKind) -> Vec<LightCase> {
    let word = |field: &'static str, name: &'static str| (field, Value::Word(Word::plain(name)));
    let logarithmic = ("scheme", Value::Word(Word::plain("logarithmic")));
    let warped = |warp: &'static str| vec![logarithmic.clone(), word("warp", warp)];
    let all = [
        ("Box", "bounding_box", vec![]),
        ("SeenBox", "bounding_box", vec![word("over", "visible")]),
        ("Stable", "stable_cascades", vec![logarithmic.clone()]),
        ("Trapezoid", "trapezoidal", vec![]),
        ("FocusedTrapezoid", "trapezoidal", vec![word("rule", "focused")]),
        ("FixedTrapezoid", "trapezoidal", vec![word("line", "fixed")]),
        ("LightSpace", "light_space_perspective", vec![]),
        ("Perspective", "perspective", vec![word("slide_back", "none")]),
        ("SlidPerspective", "perspective", vec![]),
        ("Linear", "generalized_linear", vec![]),
        ("Family", "warp_family", vec![]),
        ("StrongFamily", "warp_family", vec![("eta", Value::Number(0.5))]),
        ("Logarithm", "logarithmic_perspective", vec![]),
        ("TrapezoidSplits", "parallel_split", warped("trapezoidal")),
        ("LightSpaceSplits", "parallel_split", warped("light_space_perspective")),
        ("LinearSplits", "parallel_split", warped("generalized_linear")),
        ("FamilySplits", "parallel_split", warped("warp_family")),
    ];
    let build = |name: &str, technique: Word, configuration: Option<&'static str>| {
        let builder = LightCase::builder(name).light(light).technique(technique);
        let builder = match configuration {
            Some(configuration) => builder.configurations(&[configuration]),
            None => builder,
        };
        builder.shadow_distance_metres(shadow_distance).map_size_texels(size, size).build()
    };
    let plain = all
        .into_iter()
        .map(|(name, technique, arguments)| build(name, Word::with(technique, arguments), None));
    let faces = build("Faces", Word::plain("perspective"), Some("cube_faces"));
    // A technique without a configuration for the light is refused.
    plain.chain([faces]).filter_map(Result::ok).collect()
}

/// A case of each configuration and distribution for spot and omni lights, and cases with a dominant plane.
pub(crate) fn local_cases(size: u32) -> Vec<LightCase> {
    let local =
        |name: String, light: LightKind, configurations: &[&'static str], distribution: Option<&str>| {
            let mut builder = LightCase::builder(&name).light(light).map_size_texels(size, size);
            if !configurations.is_empty() {
                builder = builder.configurations(configurations);
            }
            match distribution {
                Some("perspective") => builder.distribution(Word::plain("perspective")).build().unwrap(),
                Some("bent") => {
                    let builder = builder.distribution(Word::plain("perspective"));
                    builder.stretch(Stretch::Exact { bound_texels: 0.25 }).build().unwrap()
                }
                Some("logarithmic") => builder.distribution(Word::plain("logarithmic")).build().unwrap(),
                Some("two_segment") => builder.distribution(Word::plain("two_segment")).build().unwrap(),
                _ => builder.build().unwrap(),
            }
        };
    let mut cases = Vec::new();
    for light in [LightKind::Omni, LightKind::Spot] {
        let kind = if light == LightKind::Omni { "Omni" } else { "Spot" };
        cases.push(local(format!("{kind}Chosen"), light, &[], None));
        for configuration in ["four_plane", "eight_plane", "tetrahedron", "cube"] {
            cases.push(local(format!("{kind}Case{}", cases.len()), light, &[configuration], None));
        }
        for configuration in ["face_columns", "one_plane"] {
            for distribution in ["bands", "perspective", "bent", "logarithmic", "two_segment"] {
                let name = format!("{kind}Case{}", cases.len());
                cases.push(local(name, light, &[configuration], Some(distribution)));
            }
        }
    }
    cases.push(local("SpotProjection".into(), LightKind::Spot, &["light_projection"], None));
    for configuration in ["face_columns", "one_plane"] {
        for distribution in ["bent", "logarithmic", "two_segment"] {
            let name = format!("Sun{}", cases.len());
            cases.push(local(name, LightKind::Directional, &[configuration], Some(distribution)));
        }
    }
    let plane = DominantPlane { share: 0.25, thickness_metres: 0.5 };
    let dominant = LightCase::builder("Flight").dominant_plane(plane).map_size_texels(size, size);
    cases.push(dominant.build().unwrap());
    cases
}

/// Bounds that give the ground as dominant plane to the cases that take one.
pub(crate) fn bounds_for(case: &LightCase, view: &View) -> SceneBounds {
    let ground = WorldPlane {
        point_world: view.eye_world - DVec3::Y * 1.7,
        normal_world: DVec3::new(0.01, 1.0, -0.02),
    };
    SceneBounds { dominant_plane: case.dominant_plane.map(|_| ground), ..SceneBounds::default() }
}

/// Omni lights at every kind of place: in the view near and far, beside, behind, above, at the eye, in the near plane, on
/// the axis, in a corner, and within 1e-9 radians of borders.
pub(crate) fn lamps(view: &View, random: &mut Random) -> Vec<Light> {
    let corner = DVec3::new(view.right, view.top, -1.0);
    let edge = DVec3::new(0.3 * view.left + 0.7 * view.right, view.top, -1.0);
    let near = view.near_metres;
    let mut places = vec![
        DVec3::new(1.0, 1.0, -3.0),
        DVec3::new(0.0, 1.0, -10.0),
        DVec3::new(3.0, 4.0, -60.0),
        DVec3::new(0.0, 0.0, -20.0),
        DVec3::new(0.0, 15.0, -10.0),
        DVec3::new(0.0, 30.0, -20.0),
        DVec3::new(1.0, 1.0, 20.0),
        DVec3::new(0.2, 0.3, 2.0),
        DVec3::new(0.0, 0.0, 5.0),
        DVec3::new(4.0, 8.0, 0.0),
        DVec3::new(-30.0, 80.0, 10.0),
        DVec3::ZERO,
        DVec3::new(0.3 * near, 0.2 * near, -near),
        DVec3::new(0.0, 0.0, -0.5 * near),
        corner * 10.0,
        edge * 10.0,
        edge * -10.0,
    ];
    for place in [corner, edge, -edge] {
        places.push(place * 10.0 + random.direction() * 1e-8);
    }
    let to_world = view.camera_from_world.transpose();
    let range = |index: usize| if index.is_multiple_of(3) { 12.0 } else { f64::INFINITY };
    let lamp = |(index, place): (usize, DVec3)| {
        Light::omni(view.eye_world + to_world * place, range(index)).unwrap()
    };
    places.into_iter().enumerate().map(lamp).collect()
}

/// A spot light where an omni light stands, which shines at something visible.
pub(crate) fn shining(view: &View, lamp: Light, random: &mut Random) -> Light {
    let Light::Omni { position_world, range_metres } = lamp else { return lamp };
    let target = view.eye_world + view.ray_world(random.unit() * 900.0, random.unit() * 900.0) * 8.0;
    let half_angle = random.between(0.2, 1.4);
    Light::spot(position_world, target - position_world, half_angle, range_metres).unwrap()
}

/// Direction towards the light in camera space: azimuth 0 ahead, 90 right, 180 behind.
pub(crate) fn toward(elevation_degrees: f64, azimuth_degrees: f64) -> DVec3 {
    let (elevation, azimuth) = (elevation_degrees.to_radians(), azimuth_degrees.to_radians());
    DVec3::new(elevation.cos() * azimuth.sin(), elevation.sin(), -elevation.cos() * azimuth.cos())
}

pub(crate) fn sun(toward_light_world: DVec3) -> Light {
    Light::directional_travelling(-toward_light_world).unwrap()
}

pub(crate) fn level_view(near: f64, far: f64) -> View {
    let size = (1080, 1080);
    View::perspective(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 60_f64.to_radians(), near, far, size).unwrap()
}

/// A tilted, turned view far from the origin.
pub(crate) fn turned_view(near: f64, far: f64) -> View {
    let eye = DVec3::new(1200.0, 30.0, -800.0);
    let target = eye + DVec3::new(0.5, -0.2, 0.8);
    View::perspective(eye, target, DVec3::Y, 75_f64.to_radians(), near, far, (1920, 1080)).unwrap()
}

/// The same view off-centre.
pub(crate) fn off_centre_view(near: f64, far: f64) -> View {
    let mut view = turned_view(near, far);
    (view.left, view.right, view.bottom, view.top) = (-0.1, 1.3, -0.9, 0.2);
    view
}

/// Views at the extremes of depth range, field of view, aspect and distance from the origin.
pub(crate) fn extreme_views() -> Vec<View> {
    let mut views = Vec::new();
    for (near, far) in [(0.1, 1e6), (1e-4, 1e3), (0.1, f64::INFINITY)] {
        for fov in [1.0, 60.0, 170.0_f64] {
            for size in [(100, 1000), (1000, 700), (2000, 200)] {
                for origin in [0.0, 1e7] {
                    let eye = DVec3::new(3.0, 1.7, 5.0) + DVec3::new(1.0, -0.5, 0.7) * origin;
                    let target = eye + DVec3::new(0.3, -0.1, -1.0);
                    let view = View::perspective(eye, target, DVec3::Y, fov.to_radians(), near, far, size);
                    views.push(view.unwrap());
                }
            }
        }
    }
    views
}

/// Directions towards lights along the axis, an edge, a corner and the near plane of a view, ahead and behind, exactly
/// and from 1e-12 to 1e-2 radians off.
pub(crate) fn extreme_lights(view: &View, random: &mut Random) -> Vec<DVec3> {
    let to_world = view.camera_from_world.transpose();
    let corner = DVec3::new(view.right, view.top, -1.0);
    let edge = DVec3::new(0.3 * view.left, view.top, -1.0);
    let mut lights = Vec::new();
    for special in [DVec3::NEG_Z, edge, corner, DVec3::new(0.6, 0.8, 0.0)] {
        for offset in [0.0, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2] {
            for sign in [1.0, -1.0] {
                let camera = (special.normalize() + random.direction() * offset) * sign;
                lights.push((to_world * camera).normalize());
            }
        }
    }
    lights
}
