//! Masks of planes against closed forms: the blurred edge of a half-plane's shadow on level ground, and what must not change.

mod support;

use cssm_core::case::{Filter, LightKind, Stretch};
use cssm_core::glam::{DVec2, DVec3, DVec4};
use cssm_core::ground::PlaneInTile;
use cssm_core::plan::WorldPlane;
use cssm_core::schema::Word;
use cssm_core::twin::{DepthMap, Triangle, capture, resolve};
use cssm_core::{Light, LightCase, PlanError, SceneBounds, ShadowPlan, View, plan};
use support::{Random, level_view};

/// Height of the ground, metres; the eye stands at the origin.
const GROUND: f64 = -1.7;
/// Depth of a wall at the far end of the ground, metres.
const WALL: f64 = -25.0;
/// Side of planes and of the caster, which stand for endless ones, metres.
const ENDLESS: f64 = 2000.0;
const SIDE: u32 = 2048;
/// Height of the caster above the ground, metres.
const HEIGHT: f64 = 3.0;
const BLUR: f64 = 0.08;

fn masks(planes: u32, blur_metres: f64) -> Filter {
    Filter::GroundMasks { planes, blur_metres, reach_texels: 12 }
}

fn ground() -> WorldPlane {
    WorldPlane { point_world: DVec3::new(7.0, GROUND, 3.0), normal_world: DVec3::new(0.0, 3.0, 0.0) }
}

fn wall() -> WorldPlane {
    WorldPlane { point_world: DVec3::new(0.0, 0.0, WALL), normal_world: DVec3::NEG_Z }
}

fn bounds(planes: &[WorldPlane]) -> SceneBounds {
    let mut bounds = SceneBounds::default();
    for (place, plane) in bounds.ground_planes.iter_mut().zip(planes) {
        *place = Some(*plane);
    }
    bounds
}

fn sun() -> Light {
    Light::directional_travelling(DVec3::new(-0.5, -1.0, -0.35)).unwrap()
}

/// A level half-plane: a point of its edge, the direction of the edge, and the horizontal direction from its edge over it.
struct Awning {
    edge: DVec3,
    along: DVec3,
    over: DVec3,
}

impl Awning {
    fn new() -> Self {
        let along = DVec3::new(0.35, 0.0, -1.0).normalize();
        let over = DVec3::new(1.0, 0.0, 0.35).normalize();
        Self { edge: DVec3::new(-0.5, GROUND + HEIGHT, 0.0), along, over }
    }

    /// A ground point so far from the shadow's edge, in metres; negative in the shadow.
    fn ground(&self, light: DVec4, along: f64, metres: f64) -> DVec3 {
        let above = self.edge + self.along * along;
        let toward = light.truncate() - above * light.w;
        above + toward * ((GROUND - above.y) / toward.y) - self.over * metres
    }

    fn triangles(&self) -> Vec<Triangle> {
        quad(self.edge + self.over * ENDLESS, self.along * ENDLESS, self.over * ENDLESS)
    }
}

fn quad(centre: DVec3, one: DVec3, two: DVec3) -> Vec<Triangle> {
    let corner = |x: f64, y: f64| centre + one * x + two * y;
    let (a, b, c, d) = (corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0));
    vec![[a, b, c], [a, c, d]]
}

struct Scene {
    case: LightCase,
    view: View,
    plan: ShadowPlan,
    map: DepthMap,
    awning: Awning,
}

impl Scene {
    /// The ground is a caster too: nothing of it may shadow itself.
    fn new(case: LightCase, light: &Light) -> Self {
        let (view, awning) = (level_view(0.2, 200.0), Awning::new());
        let planes = [ground(), wall()];
        let plan =
            plan(&case, &view, light, &bounds(&planes[..case.filter.ground_planes() as usize])).unwrap();
        let mut triangles = awning.triangles();
        triangles.extend(quad(DVec3::Y * GROUND, DVec3::X * ENDLESS, DVec3::Z * ENDLESS));
        let map = capture(&plan, &triangles).stored(case.map.format);
        Self { case, view, plan, map, awning }
    }

    fn visibility_by(&self, filter: Filter, point: DVec3, normal: DVec3) -> f64 {
        let case = LightCase { filter, ..self.case.clone() };
        resolve(&case, &self.plan, &self.map, point, normal).visibility
    }

    fn visibility(&self, point: DVec3) -> f64 {
        self.visibility_by(self.case.filter, point, DVec3::Y)
    }

    fn is_seen(&self, point: DVec3) -> bool {
        let depth = self.view.depth_metres(point);
        let ray = point / depth;
        depth > 2.0 && depth < 100.0 && ray.x.abs() < self.view.right && ray.y.abs() < self.view.top
    }

    /// Texels per metre of the ground along x and y of the map.
    fn texels_per_metre(&self, point: DVec3) -> Option<DVec2> {
        let facet = self.plan.facet(self.plan.selection.cell(point.extend(1.0)))?;
        let ground = self.plan.ground_planes().next()?;
        let sign = self.plan.depth_order.sign();
        let PlaneInTile { across, up, .. } = PlaneInTile::of(ground, facet, self.plan.light, sign, 0.0)?;
        let homogeneous = point.extend(1.0);
        let w = facet.rows.w.dot(homogeneous);
        let (x, y) = (facet.rows.x.dot(homogeneous) / w, facet.rows.y.dot(homogeneous) / w);
        let powers = |value: f64| DVec3::new(1.0, value, value * value);
        let slope = facet.rows.remap.slope(y).abs();
        Some(DVec2::new(across.dot(powers(x)).sqrt(), up.dot(powers(y)).sqrt() * slope) / w)
    }
}

/// Cases whose facets differ in warp, density, bending and kind of light.
fn scenes() -> Vec<Scene> {
    let of = |light: LightKind| {
        LightCase::builder("Masks").light(light).filter(masks(1, BLUR)).map_size_texels(SIDE, SIDE)
    };
    let builder = || of(LightKind::Directional);
    let splits = Word::with("parallel_split", [("splits", cssm_core::schema::Value::Count(4))]);
    let bent = |name| Word::plain(name);
    let exact = Stretch::Exact { bound_texels: 0.25 };
    let sunlit = [
        builder().configurations(&["face_columns"]),
        builder().technique(splits).shadow_distance_metres(120.0),
        builder().technique(Word::plain("light_space_perspective")).shadow_distance_metres(120.0),
        builder().configurations(&["face_columns"]).distribution(bent("perspective")).stretch(exact),
        builder().configurations(&["one_plane"]).distribution(bent("logarithmic")).stretch(exact),
    ];
    let mut scenes: Vec<_> =
        sunlit.into_iter().map(|case| Scene::new(case.build().unwrap(), &sun())).collect();
    let ahead = Light::directional_travelling(DVec3::new(0.15, -0.6, 1.0)).unwrap();
    scenes.push(Scene::new(builder().configurations(&["four_plane"]).build().unwrap(), &ahead));
    let lamp = Light::omni(DVec3::new(5.0, 9.0, -14.0), f64::INFINITY).unwrap();
    for configuration in ["face_columns", "cube", "eight_plane"] {
        let case = of(LightKind::Omni).configurations(&[configuration]).build().unwrap();
        scenes.push(Scene::new(case, &lamp));
    }
    scenes
}

fn named(scene: &Scene) -> String {
    format!("{} {} {:?}", scene.plan.configuration, scene.case.technique.name, scene.case.light)
}

/// The share of a normal distribution below a value in standard deviations.
fn normal_below(value: f64) -> f64 {
    const STEPS: u32 = 400;
    let (low, high) = (-6.0, value.clamp(-6.0, 6.0));
    let step = (high - low) / f64::from(STEPS);
    let density = |x: f64| (-0.5 * x * x).exp() / (2.0 * std::f64::consts::PI).sqrt();
    (0..STEPS).map(|k| density(low + step * (f64::from(k) + 0.5)) * step).sum()
}

#[test]
fn lit_ground_stays_lit_and_umbrae_dark() {
    for scene in scenes() {
        let mut random = Random::new(5);
        let (mut lit, mut dark) = (0, 0);
        for _ in 0..14_000 {
            let metres = 60.0 * random.between(-1.0, 1.0).powi(3);
            let point = scene.awning.ground(scene.plan.light, random.between(0.0, 100.0), metres);
            let per_metre = scene.texels_per_metre(point).filter(|_| scene.is_seen(point));
            let Some(per_metre) = per_metre else { continue };
            // A kernel reaches twelve texels along each axis, and bilinear reading one more.
            let reach = 13.0 * std::f64::consts::SQRT_2 * 2.0 / per_metre.min_element();
            let visibility = scene.visibility(point);
            if metres > reach {
                assert!(visibility > 1.0 - 1e-12, "{}: {visibility} at {point}", named(&scene));
                lit += 1;
            } else if metres < -reach {
                assert!(visibility < 1e-12, "{}: {visibility} at {point}", named(&scene));
                dark += 1;
            }
        }
        println!("{}: {lit} lit, {dark} dark", named(&scene));
        assert!(lit > 200 && dark > 20, "{}: {lit} {dark}", named(&scene));
    }
}

#[test]
fn edges_are_as_wide_as_declared_on_the_plane() {
    let mut tested = 0;
    for scene in scenes() {
        let mut random = Random::new(7);
        let (mut own, mut plain, mut count) = (0.0, 0.0, 0);
        for _ in 0..20_000 {
            let metres = random.between(-2.5, 2.5) * BLUR;
            let point = scene.awning.ground(scene.plan.light, random.between(0.0, 100.0), metres);
            let per_metre = scene.texels_per_metre(point).filter(|_| scene.is_seen(point));
            let Some(per_metre) = per_metre else { continue };
            // Where the deviation is held at neither end.
            let deviation = per_metre * BLUR;
            if deviation.min_element() < 1.0 || deviation.max_element() > 4.5 {
                continue;
            }
            let truth = normal_below(metres / BLUR);
            own += (scene.visibility(point) - truth).abs();
            plain += (scene.visibility_by(Filter::Gather2x2, point, DVec3::Y) - truth).abs();
            count += 1;
        }
        let (own, plain) = (own / f64::from(count), plain / f64::from(count));
        println!("{}: {own:.4} against {plain:.3} of plain blending, {count} points", named(&scene));
        if count > 200 {
            assert!(own < 0.04 && plain > 3.0 * own, "{}: {own} {plain}", named(&scene));
            tested += 1;
        }
    }
    assert!(tested >= 6, "{tested}");
}

#[test]
fn receivers_off_the_planes_are_filtered_as_by_gathering() {
    let case = LightCase::builder("Masks").filter(masks(2, BLUR)).map_size_texels(SIDE, SIDE);
    let scene = Scene::new(case.configurations(&["face_columns"]).build().unwrap(), &sun());
    let mut random = Random::new(3);
    let (mut edges, mut masked) = (0, 0);
    for _ in 0..20_000 {
        let along = random.between(0.0, 40.0);
        let point = scene.awning.ground(scene.plan.light, along, random.between(-0.2, 0.2));
        if !scene.is_seen(point) {
            continue;
        }
        // A millimetre is more than rounding, and the ground's own texels are nearer.
        let above = point + DVec3::Y * 0.001;
        let (own, plain) = (scene.visibility(above), scene.visibility_by(Filter::Gather2x2, above, DVec3::Y));
        assert_eq!(own, plain, "{above}");
        edges += usize::from(plain > 0.0 && plain < 1.0);
        masked +=
            usize::from(scene.visibility(point) != scene.visibility_by(Filter::Gather2x2, point, DVec3::Y));
    }
    assert!(edges > 100 && masked > 1000, "{edges} {masked}");
}

#[test]
fn each_plane_has_its_own_mask() {
    // Farther than any blur reaches, metres.
    const CLEAR: f64 = 0.8;

    // The awning's shadow on the wall is not the one on the ground. At its foot the blur reaches beneath the ground.
    let case = LightCase::builder("Masks").filter(masks(2, BLUR)).map_size_texels(SIDE, SIDE);
    let scene = Scene::new(case.configurations(&["face_columns"]).build().unwrap(), &sun());
    let mut random = Random::new(9);
    let (mut lit, mut dark) = (0, 0);
    for _ in 0..20_000 {
        let point = DVec3::new(random.between(-15.0, 15.0), random.between(GROUND + CLEAR, 10.0), WALL);
        let toward = scene.plan.light.truncate();
        let at_awning = point + toward * ((scene.awning.edge.y - point.y) / toward.y);
        let over = (at_awning - scene.awning.edge).dot(scene.awning.over);
        let below = scene.awning.edge.y - point.y;
        if !scene.is_seen(point) || over.abs() < 2.0 * CLEAR || (over > 0.0 && below.abs() < CLEAR) {
            continue;
        }
        let shadowed = below > 0.0 && over > 0.0;
        let visibility = scene.visibility_by(scene.case.filter, point, DVec3::Z);
        assert!((visibility - f64::from(u8::from(!shadowed))).abs() < 1e-3, "{point} {over} {visibility}");
        (lit, dark) = (lit + u32::from(!shadowed), dark + u32::from(shadowed));
    }
    assert!(lit > 300 && dark > 100, "{lit} {dark}");
}

#[test]
fn missing_and_impossible_planes_are_typed_errors() {
    let case = LightCase::builder("Masks").filter(masks(2, BLUR)).build().unwrap();
    let view = level_view(0.2, 200.0);
    let missing = plan(&case, &view, &sun(), &bounds(&[ground()]));
    assert_eq!(missing.unwrap_err(), PlanError::GroundPlane { declared: 2, missing: 1 });
    let flat = WorldPlane { normal_world: DVec3::ZERO, ..ground() };
    let flat = plan(&case, &view, &sun(), &bounds(&[ground(), flat]));
    assert!(matches!(flat, Err(PlanError::NotFinite { .. })), "{flat:?}");
    for planes in [0, 5] {
        assert!(LightCase::builder("Masks").filter(masks(planes, BLUR)).build().is_err(), "{planes}");
    }
}

#[test]
fn held_plans_do_not_cover_other_planes() {
    let case = LightCase::builder("Masks").filter(masks(1, BLUR)).build().unwrap();
    let (view, light) = (level_view(0.2, 200.0), sun());
    let request = |plane| cssm_core::PlanRequest::new(&case, &view, &light, bounds(&[plane]));
    let plan = request(ground()).plan().unwrap();
    assert!(plan.covers(&request(ground())));
    assert!(!plan.covers(&request(WorldPlane { point_world: DVec3::ZERO, ..ground() })));

    // Brought to another eye, the plane is where it was.
    let moved = View { eye_world: DVec3::new(4.0, 2.0, -1.0), ..view };
    let ground = plan.rebased(&moved).ground_planes().next().unwrap();
    assert!((ground - DVec4::new(0.0, 1.0, 0.0, 2.0 - GROUND)).length() < 1e-12, "{ground}");
}
