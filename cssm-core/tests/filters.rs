//! Filters against closed forms: the edge of a half-plane's shadow on level ground, whose softness a disc of light, or a
//! declared kernel, prescribes at every receiver, in whatever facet it lies.

mod support;

use std::collections::BTreeMap;
use std::f64::consts::PI;

use cssm_core::case::{Filter, Kernel, LightKind, PcfSize, Source};
use cssm_core::facet::Facet;
use cssm_core::glam::{DVec2, DVec3, DVec4};
use cssm_core::homography::Gradients;
use cssm_core::schema::{Value, Word};
use cssm_core::twin::{DepthMap, Triangle, capture, resolve};
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use support::{Random, level_view};

/// Height of the ground relative to the eye, metres.
const GROUND: f64 = -1.7;
/// Side of the caster, which stands for half a plane, metres.
const ENDLESS: f64 = 2000.0;
const SIDE: u32 = 2048;

/// A level half-plane above level ground.
struct Awning {
    /// A point of its edge, relative to the eye.
    edge: DVec3,
    /// Unit vector along its edge.
    along: DVec3,
    /// Unit vector from its edge over it.
    over: DVec3,
}

impl Awning {
    fn at_height(height: f64) -> Self {
        let along = DVec3::new(0.35, 0.0, -1.0).normalize();
        let over = DVec3::new(1.0, 0.0, 0.35).normalize();
        Self { edge: DVec3::new(-0.5, GROUND + height, 0.0), along, over }
    }

    fn triangles(&self) -> Vec<Triangle> {
        let corner = |x: f64, y: f64| self.edge + self.along * (x * ENDLESS) + self.over * (y * ENDLESS);
        let (a, b, c, d) = (corner(-1.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(-1.0, 1.0));
        vec![[a, b, c], [a, c, d]]
    }

    /// How far a light's centre stands clear of the edge as seen from a point: the sine of the angle for a directional light,
    /// metres for a local one. Negative where the awning hides it.
    fn clearance(&self, light: DVec4, point: DVec3) -> f64 {
        let outward = (self.edge - point).cross(self.along).normalize();
        let outward = if outward.dot(self.over) < 0.0 { outward } else { -outward };
        outward.dot(light.truncate() - point * light.w)
    }

    /// Ground points around the shadow's edge: where along the edge, and how far from it in half widths of the edge that
    /// `radius` throws.
    fn ground(&self, light: DVec4, along: f64, half_widths: f64, radius: f64) -> DVec3 {
        let above = self.edge + self.along * along;
        let toward = light.truncate() - above * light.w;
        let on_edge = above + toward * ((GROUND - above.y) / toward.y);
        let step = 1e-3;
        let slope =
            (self.clearance(light, on_edge - self.over * step) - self.clearance(light, on_edge)) / step;
        on_edge - self.over * (half_widths * radius / slope)
    }
}

/// Share of a disc above a line that passes its centre at so many radii.
fn disc_above(radii: f64) -> f64 {
    let u = radii.clamp(-1.0, 1.0);
    0.5 + (u * (1.0 - u * u).sqrt() + u.asin()) / PI
}

struct Scene {
    case: LightCase,
    view: View,
    plan: ShadowPlan,
    map: DepthMap,
    awning: Awning,
}

impl Scene {
    fn new(case: LightCase, light: &Light, height: f64) -> Self {
        Self::of(case, light, Awning::at_height(height))
    }

    fn of(case: LightCase, light: &Light, awning: Awning) -> Self {
        let view = level_view(0.2, 1000.0);
        let plan = plan(&case, &view, light, &SceneBounds::default()).unwrap();
        let map = capture(&plan, &awning.triangles()).stored(case.map.format);
        Self { case, view, plan, map, awning }
    }

    fn facet(&self, point: DVec3) -> Option<&Facet> {
        self.plan.facet(self.plan.selection.cell(point.extend(1.0)))
    }

    fn visibility_by(&self, filter: Filter, point: DVec3) -> f64 {
        let case = LightCase { filter, ..self.case.clone() };
        resolve(&case, &self.plan, &self.map, point, DVec3::Y).visibility
    }

    fn visibility(&self, point: DVec3) -> f64 {
        self.visibility_by(self.case.filter, point)
    }

    fn is_seen(&self, point: DVec3) -> bool {
        let depth = self.view.depth_metres(point);
        let ray = point / depth;
        depth > 2.0 && depth < 100.0 && ray.x.abs() < self.view.right && ray.y.abs() < self.view.top
    }

    /// Texels per metre across the light.
    fn texels_per_metre(&self, point: DVec3) -> Option<DVec2> {
        let facet = self.facet(point)?;
        let gradients = Gradients::at(&facet.rows, point);
        let size = DVec2::new(f64::from(facet.tile.width), f64::from(facet.tile.height));
        Some(DVec2::new(gradients.x.length(), gradients.y.length()) * 0.5 * size)
    }
}

fn sun() -> Light {
    Light::directional_travelling(DVec3::new(-0.5, -1.0, -0.35)).unwrap()
}

/// Cases for the sun whose facets differ in warp and density.
fn sunlit(filter: Filter) -> Vec<LightCase> {
    let builder = || LightCase::builder("Sun").filter(filter).map_size_texels(SIDE, SIDE);
    let splits = Word::with("parallel_split", [("splits", Value::Count(4))]);
    let warped = Word::plain("light_space_perspective");
    let bent = Word::plain("perspective");
    vec![
        builder().build().unwrap(),
        builder().technique(splits).shadow_distance_metres(150.0).build().unwrap(),
        builder().technique(warped).shadow_distance_metres(150.0).build().unwrap(),
        builder().configurations(&["face_columns"]).distribution(bent).build().unwrap(),
    ]
}

/// Mean difference from a closed form over the edge of a shadow, of the case's filter and of plain blending.
fn mean_errors(
    scene: &Scene,
    half_metres: impl Fn(DVec3) -> f64,
    radius: f64,
    truth: impl Fn(f64) -> f64,
) -> (f64, f64, usize) {
    let mut random = Random::new(7);
    let (mut own, mut plain, mut count) = (0.0, 0.0, 0);
    let reach = f64::from(scene.case.filter.radius_texels());
    for _ in 0..40_000 {
        let (along, offset) = (random.between(0.0, 120.0), random.between(-1.5, 1.5));
        let point = scene.awning.ground(scene.plan.light, along, offset, radius);
        let Some(per_metre) = scene.texels_per_metre(point).filter(|_| scene.is_seen(point)) else {
            continue;
        };
        let half = per_metre * half_metres(point);
        if half.min_element() < 1.5 || half.max_element() > 0.9 * reach {
            continue;
        }
        let truth = truth(scene.awning.clearance(scene.plan.light, point) / radius);
        own += (scene.visibility(point) - truth).abs();
        plain += (scene.visibility_by(Filter::Gather2x2, point) - truth).abs();
        count += 1;
    }
    (own / count as f64, plain / count as f64, count)
}

#[test]
fn soft_edges_are_as_wide_as_a_disc_of_light_makes_them() {
    const HEIGHT: f64 = 3.0;
    let source = Source::Angle(3.0);
    let mut tested = 0;
    for case in sunlit(Filter::Pcss { source, reach_texels: 10 }) {
        let scene = Scene::new(case, &sun(), HEIGHT);
        let along_ray = HEIGHT / scene.plan.light.y;
        let (own, plain, count) =
            mean_errors(&scene, |_| along_ray * source.radius(), source.radius(), disc_above);
        println!(
            "{} {own:.3} against {plain:.3} of plain blending, {count} points",
            scene.case.technique.name
        );
        assert!(own < 0.05 && plain > 2.0 * own, "{} {own} {plain}", scene.case.technique.name);
        tested += usize::from(count > 300);
    }
    assert!(tested >= 3);
}

#[test]
fn soft_edges_of_lamps_are_as_wide_as_their_spheres_make_them() {
    const HEIGHT: f64 = 2.0;
    let source = Source::Radius(0.5);
    for configuration in ["face_columns", "cube", "eight_plane"] {
        let case = LightCase::builder("Lamp").light(LightKind::Omni).map_size_texels(SIDE, SIDE);
        let filter = Filter::Pcss { source, reach_texels: 10 };
        let case = case.configurations(&[configuration]).filter(filter).build().unwrap();
        let view = level_view(0.2, 1000.0);
        let lamp = Light::omni(view.eye_world + DVec3::new(5.0, 9.0, -14.0), f64::INFINITY).unwrap();
        let scene = Scene::new(case, &lamp, HEIGHT);
        // Ray, caster and light share one plane: the edge is as far from the receiver as heights tell.
        let ratio = HEIGHT / (scene.plan.light.y - GROUND - HEIGHT);
        let (own, plain, count) =
            mean_errors(&scene, |_| ratio * source.radius(), source.radius(), disc_above);
        println!("{configuration} {own:.3} against {plain:.3} of plain blending, {count} points");
        assert!(own < 0.06 && plain > 1.5 * own && count > 100, "{configuration} {own} {plain} {count}");
    }
}

#[test]
fn soft_edges_end_in_plain_blending_where_caster_and_receiver_touch() {
    // Millimetres above the ground the sun's disc is far narrower than a texel.
    let filter = Filter::Pcss { source: Source::Angle(0.53), reach_texels: 5 };
    let scene = Scene::new(sunlit(filter).swap_remove(0), &sun(), 0.05);
    let mut random = Random::new(3);
    let (mut edges, mut worst) = (0, 0.0_f64);
    for _ in 0..20_000 {
        let along = random.between(0.0, 100.0);
        let point = scene.awning.ground(scene.plan.light, along, random.between(-300.0, 300.0), 0.0046);
        let (soft, plain) = (scene.visibility(point), scene.visibility_by(Filter::Gather2x2, point));
        let narrow = scene.texels_per_metre(point).is_some_and(|per| per.max_element() * 0.05 * 0.01 < 0.5);
        if scene.is_seen(point) && narrow {
            edges += usize::from(plain > 0.0 && plain < 1.0);
            worst = worst.max((soft - plain).abs());
        }
    }
    assert!(edges > 100 && worst < 1e-9, "{edges} {worst}");
}

#[test]
fn kernels_in_metres_are_as_wide_in_every_facet() {
    const METRES: f64 = 0.12;
    let radius = 0.5 * METRES;
    let ramp = |radii: f64| 0.5 + 0.5 * radii.clamp(-1.0, 1.0);
    let mut tested = 0;
    for case in sunlit(Filter::Pcf { size: PcfSize::Seven, kernel: Kernel::Metres(METRES) }) {
        // Clearance is an angle; at the caster's distance along the ray it is metres across it.
        let scene = Scene::new(case, &sun(), 3.0);
        let angle = radius * scene.plan.light.y / 3.0;
        let (own, plain, count) = mean_errors(&scene, |_| radius, angle, ramp);
        println!(
            "{} {own:.3} against {plain:.3} of plain blending, {count} points",
            scene.case.technique.name
        );
        if count > 300 {
            assert!(own < 0.06 && plain > 2.0 * own, "{} {own} {plain}", scene.case.technique.name);
            tested += 1;
        }
    }
    assert!(tested >= 3);
}

/// Adds changes of visibility where a line along the edge of a shadow crosses from one facet to another.
fn add_steps(scene: &Scene, offset: f64, radius: f64, crossings: &mut BTreeMap<(u32, u32), (f64, u32)>) {
    const STEP: f64 = 0.01;
    let mut before: Option<(u32, DVec3)> = None;
    for step in 0..6000 {
        let point = scene.awning.ground(scene.plan.light, 2.0 + STEP * f64::from(step), offset, radius);
        let facet = scene.facet(point).filter(|_| scene.is_seen(point));
        let now = facet.map(|facet| (facet.first_cell(), point));
        if let (Some(before), Some(now)) = (before, now)
            && before.0 != now.0
        {
            let change = scene.visibility(now.1) - scene.visibility(before.1);
            let (sum, count) = crossings.entry((before.0, now.0)).or_default();
            (*sum, *count) = (*sum + change, *count + 1);
        }
        before = now;
    }
}

#[test]
fn kernels_that_measure_are_continuous_across_facets() {
    // Away from the middle of the edge softness shows; kernels are chosen so that no facet's texels cut them off.
    const EDGES: u32 = 32;
    let (offset, height) = (0.6, 3.0);
    let (hard, source) = (Source::Angle(0.8).radius(), Source::Angle(1.5));
    let metres = 2.0 * hard * height / DVec3::new(0.5, 1.0, 0.35).normalize().y;

    // Many edges, so that what is left is not where each falls between texels.
    let steps = |filter, radius| {
        let mut crossings = BTreeMap::new();
        for edge in 0..EDGES {
            let arguments = [("splits", Value::Count(3)), ("scheme", Value::Word(Word::plain("uniform")))];
            let splits = Word::with("parallel_split", arguments);
            let case = LightCase::builder("Sun").filter(filter).technique(splits);
            let case = case.shadow_distance_metres(30.0).map_size_texels(SIDE, SIDE).build().unwrap();
            let mut awning = Awning::at_height(height);
            awning.edge += awning.over * (0.5 * f64::from(edge) / f64::from(EDGES));
            add_steps(&Scene::of(case, &sun(), awning), offset, radius, &mut crossings);
        }
        let mean = |(sum, count): &(f64, u32)| (sum / f64::from(*count)).abs();
        (crossings.values().map(mean).fold(0.0, f64::max), crossings.len())
    };
    let pcf = |kernel| Filter::Pcf { size: PcfSize::Seven, kernel };
    let (texels, crossings) = steps(pcf(Kernel::Texels), hard);
    let (metres, _) = steps(pcf(Kernel::Metres(metres)), hard);
    let (soft, _) = steps(Filter::Pcss { source, reach_texels: 10 }, source.radius());
    println!("{crossings} crossings: {texels:.3} in texels, {metres:.3} in metres, {soft:.3} soft");
    assert!(crossings >= 2, "{crossings}");
    assert!(metres < 0.05 && soft < 0.03 && texels > 2.0 * metres, "{texels} {metres} {soft}");
}

#[test]
fn moments_leave_ground_lit_umbrae_dark_and_edges_soft() {
    const HEIGHT: f64 = 3.0;
    let filter = Filter::Evsm2 { exponent: 20.0, blur_texels: 2, bleeding: 0.1 };
    for case in sunlit(filter) {
        // Moments need to know what is lit, so the ground is a caster too.
        let mut scene = Scene::new(case, &sun(), HEIGHT);
        let corner = |x: f64, z: f64| DVec3::new(x * ENDLESS, GROUND, z * ENDLESS);
        let [a, b, c, d] = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let mut triangles = scene.awning.triangles();
        triangles.extend([[a, b, c], [a, c, d]]);
        scene.map = capture(&scene.plan, &triangles).stored(scene.case.map.format);
        let name = scene.case.technique.name;
        let along_ray = HEIGHT / scene.plan.light.y;
        let mut random = Random::new(5);
        let (mut lit, mut dark, mut soft) = (0, 0, 0);
        for _ in 0..20_000 {
            let (along, offset) = (random.between(0.0, 100.0), random.between(-1.0, 1.0).powi(5));
            let point = scene.awning.ground(scene.plan.light, along, 200.0 * offset, 0.01);
            let per_metre = scene.texels_per_metre(point).filter(|_| scene.is_seen(point));
            let Some(per_metre) = per_metre else { continue };
            let clear = scene.awning.clearance(scene.plan.light, point) * along_ray * per_metre.min_element();
            let visibility = scene.visibility(point);
            if clear > 8.0 {
                assert!(visibility > 0.999, "{name}: {visibility} in the light at {point}");
                lit += 1;
            } else if clear < -8.0 {
                assert!(visibility < 0.02, "{name}: {visibility} in the shadow at {point}");
                dark += 1;
            } else {
                soft += usize::from(visibility > 0.05 && visibility < 0.95);
            }
        }
        assert!(lit > 1000 && dark > 1000 && soft > 50, "{name}: {lit} {dark} {soft}");
    }
}
