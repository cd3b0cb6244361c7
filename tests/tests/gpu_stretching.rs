//! Casters whose edges bent rows bend are decided texel by texel: the device draws what the f64 twin draws, also where
//! triangles pass the eye; straight edges stay within their bound; nothing shows between the two.

use cssm_codegen::generate;
use cssm_core::case::{LightCase, LightCaseBuilder, Stretch};
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::remap::Remap;
use cssm_core::schema::{Value, Word};
use cssm_core::stretch::BentTriangle;
use cssm_core::table::{CaseTable, ShaderKind};
use cssm_core::{Light, SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::Options;
use cssm_tests::gpu::depth_bracket::{DepthBracket, SLIVERS};
use cssm_tests::gpu::device::device_for;
use cssm_tests::gpu::stage::Stage;
use cssm_tests::gpu::yard::{Yard, suns, views};
use cssm_tests::gpu::{Geometry, TestDevice};
use cssm_tests::random::Random;

fn builder(distribution: Word, configuration: &'static str, bound_texels: f64) -> LightCaseBuilder {
    LightCase::builder("Sun")
        .configurations(&[configuration])
        .distribution(distribution)
        .stretch(Stretch::Exact { bound_texels })
        .map_size_texels(256, 256)
}

/// Two segments with many rows before the focus: two facets with bent rows each.
fn many_before() -> Word {
    Word::with("two_segment", [("share", Value::Number(0.85))])
}

fn device(case: &LightCase) -> TestDevice {
    device_for(&generate(case).unwrap().table)
}

/// What stands before the eye of a view, given in its own axes; kept in the world's, as boxes are.
fn before_the_eye(view: &View, mut geometries: Vec<Geometry>) -> Yard {
    let turn = view.camera_from_world.transpose();
    for position in geometries.iter_mut().flat_map(|geometry| &mut geometry.positions) {
        *position = (turn * DVec3::from_array(position.map(f64::from))).as_vec3().to_array();
    }
    let place = DAffine3::from_translation(view.eye_world);
    let places = (0..geometries.len()).map(|geometry| (geometry, place)).collect();
    Yard { geometries, places }
}

/// One place of a yard, alone.
fn alone(yard: &Yard, place: usize) -> Yard {
    let (geometry, stands) = yard.places[place];
    Yard { geometries: vec![yard.geometries[geometry].clone()], places: vec![(0, stands)] }
}

fn planned(case: &LightCase, view: &View, light: &Light) -> ShadowPlan {
    plan(case, view, light, &SceneBounds::default()).unwrap()
}

#[test]
fn the_device_draws_what_the_twin_draws() {
    let yard = Yard::new();
    for (distribution, configuration) in [
        (Word::plain("perspective"), "one_plane"),
        (Word::plain("logarithmic"), "face_columns"),
        (many_before(), "one_plane"),
    ] {
        let case = builder(distribution, configuration, 0.0).build().unwrap();
        let gpu = device(&case);
        let mut stage = Stage::new(&gpu, &yard, &case, &Options::default());
        let (mut violations, mut texels, mut covered) = (0, 0, 0);
        for view in &views((160, 90)) {
            for sun in &suns() {
                let plan = planned(&case, view, sun);
                let map = stage.capture(&plan, view);
                let bracket = DepthBracket::new(&yard, &plan, case.map.format);
                let wrong = bracket.violations(&map);
                println!("{:?} {configuration} {:?}: {wrong}", case.distribution, plan.depth_order);
                violations += wrong;
                texels += map.depths.len();
                covered += map.depths.iter().filter(|depth| **depth != plan.depth_order.cleared()).count();
            }
        }
        assert!(covered > texels / 10, "only {covered} of {texels} texels are covered");
        let share = violations as f64 / texels as f64;
        assert!(share <= SLIVERS, "{violations} of {texels} texels leave the bracket");
    }
}

/// Triangles before, beside and behind the eye: from a thousandth of their distance to many times it, some nearly
/// degenerate, wound both ways.
fn soup(random: &mut Random, count: usize) -> Vec<Geometry> {
    let around = |size: f64, random: &mut Random| {
        DVec3::new(random.unit() - 0.5, random.unit() - 0.5, random.unit() - 0.5) * 2.0 * size
    };
    let triangle = |_| {
        let distance = 10.0_f64.powf(3.0 * random.unit() - 0.7);
        let centre =
            DVec3::new(random.unit() - 0.5, random.unit() - 0.6, -0.9 + 0.3 * random.unit()) * distance;
        let size = distance * 10.0_f64.powf(2.2 * random.unit() - 1.5);
        let mut corners = [0; 3].map(|_| centre + around(size, random));
        if random.below(6) == 0 {
            corners[2] = corners[0].lerp(corners[1], random.unit()) + around(size * 1e-2, random);
        }
        Geometry::triangle(corners.map(|corner| corner.as_vec3().to_array()))
    };
    (0..count).map(triangle).collect()
}

/// A case, the soup before one of the yard's views, and its plan.
struct Scene {
    case: LightCase,
    yard: Yard,
    view: View,
    plan: ShadowPlan,
}

/// Three distributions, each with a soup of its own.
fn scenes(count: usize, bound_texels: f64) -> Vec<Scene> {
    let mut random = Random(17);
    let setups = [
        (Word::plain("logarithmic"), 0, [0.4, -1.0, 0.3]),
        (many_before(), 2, [-0.8, -0.7, 0.1]),
        (Word::plain("perspective"), 1, [0.3, -0.6, 0.5]),
    ];
    let scene = |(distribution, view, sun): (Word, usize, [f64; 3])| {
        let case = builder(distribution, "one_plane", bound_texels).build().unwrap();
        let view = views((160, 90))[view];
        let yard = before_the_eye(&view, soup(&mut random, count));
        let along = view.camera_from_world.transpose() * DVec3::from_array(sun);
        let plan = planned(&case, &view, &Light::directional_travelling(along).unwrap());
        Scene { case, yard, view, plan }
    };
    setups.into_iter().map(scene).collect()
}

#[test]
fn random_triangles_cover_what_they_cover_in_space() {
    let (mut violations, mut judged, mut covered, mut crossing) = (0, 0, 0, 0);
    let mut errors = Vec::new();
    for Scene { case, yard, view, plan } in scenes(60, 0.0) {
        let gpu = device(&case);
        let mut stage = Stage::new(&gpu, &yard, &case, &Options::default());
        let cleared = plan.depth_order.cleared();
        for place in 0..yard.places.len() {
            let map = stage.capture_place(&plan, &view, place);
            let single = alone(&yard, place);
            violations += DepthBracket::new(&single, &plan, case.map.format).violations(&map);
            judged += map.depths.len();

            // Depths in texels: what the light sees a texel's width farther on.
            let triangles = single.place_from_eye(0, plan.eye_world, &plan.capture_from_world());
            let twin = cssm_core::twin::capture(&plan, &triangles);
            let facet = &plan.facets[0];
            let step = facet.depth_per_metre * facet.texel_metres_per_w;
            let both = map.depths.iter().zip(&twin.depths);
            let both = both.filter(|(one, other)| **one != cleared && **other != cleared);
            errors.extend(both.map(|(one, other)| (one - other).abs() / step));
            let own = map.depths.iter().filter(|depth| **depth != cleared).count();
            let mut corners = triangles.iter().flatten();
            let behind = corners.any(|corner| facet.rows.w.dot(corner.extend(1.0)) <= 0.0);
            crossing += usize::from(behind && own > 0);
            covered += own;
        }
    }
    errors.sort_by(f64::total_cmp);
    let (median, high) = (errors[errors.len() / 2], errors[errors.len() * 99 / 100]);
    println!("{judged} texels, {covered} covered, {crossing} triangles across w = 0: {violations} wrong");
    println!("depth off by {median:e} texel, p99 {high:e}");
    assert!(judged >= 1_000_000 && covered > 100_000 && crossing >= 10);
    assert!(violations as f64 <= SLIVERS * judged as f64);
    assert!(high <= 1e-3);
}

/// A case's table with words of its texel by texel shader replaced.
fn changed(case: &LightCase, edits: &[(&str, &str)]) -> CaseTable {
    let mut table = generate(case).unwrap().table;
    for shader in table.shaders.to_mut().iter_mut().filter(|shader| shader.kind == ShaderKind::CaptureBent) {
        for (from, to) in edits {
            assert!(shader.wgsl.contains(from), "the shader has no `{from}`");
            shader.wgsl = shader.wgsl.replace(from, to).into();
        }
    }
    table
}

#[test]
fn covers_without_tangents_lose_texels() {
    let Scene { case, yard, view, plan } = &scenes(40, 0.0)[0];
    let gpu = device(case);
    let lost = |edits: &[(&str, &str)]| -> usize {
        let table = changed(case, edits);
        let mut stage = Stage::of_table(&gpu, yard, case, &table, &Options::default());
        let violations = |place| {
            let map = stage.capture_place(plan, view, place);
            DepthBracket::new(&alone(yard, place), plan, case.map.format).violations(&map)
        };
        (0..yard.places.len()).map(violations).sum()
    };
    assert_eq!(lost(&[]), 0);
    let without = lost(&[("if !(part > 0.0 && part < 1.0) {", "if part < 1e9 {")]);
    assert!(without > 100, "only {without} texels without tangents");
}

#[test]
fn edges_that_are_not_recentred_are_seen() {
    // Every second triangle of a sheet, about a texel large: the smaller a triangle, the more its edges are off.
    let mut random = Random(29);
    let mut apart = sheet(&mut random, 240, 0.3, [60.0, 75.0]);
    for position in &mut apart.positions {
        // To the side, where x is as large as w.
        position[0] -= 0.75 * position[2];
    }
    apart.indices = apart.indices.chunks_exact(6).flat_map(|two| two[..3].to_vec()).collect();
    let case = builder(Word::plain("perspective"), "one_plane", 0.0);
    let case = case.map_size_texels(2048, 2048).build().unwrap();
    let gpu = device(&case);
    let view = &views((160, 90))[0];
    let yard = before_the_eye(view, vec![apart]);
    let along = view.camera_from_world.transpose() * DVec3::new(0.35, -1.0, 0.1);
    let plan = planned(&case, view, &Light::directional_travelling(along).unwrap());
    let bracket = DepthBracket::new(&yard, &plan, case.map.format);
    let wrong = |edits: &[(&str, &str)]| {
        let table = changed(&case, edits);
        let map = Stage::of_table(&gpu, &yard, &case, &table, &Options::default()).capture(&plan, view);
        let covered = map.depths.iter().filter(|depth| **depth != plan.depth_order.cleared()).count();
        assert!(covered > 1000, "only {covered} texels are covered");
        bracket.violations(&map)
    };
    let weights =
        "sun_turned(from_two, from_three), sun_turned(from_three, from_one), sun_turned(from_one, from_two)";
    let plain = "dot(from_here, cross(two.xyw, three.xyw)), dot(from_here, cross(three.xyw, one.xyw)), \
                 dot(from_here, cross(one.xyw, two.xyw))";
    let here = "let from_here = vec3<f32>(place, 1.0);\n    let from_one = one.xy";
    let (with, without) = (wrong(&[]), wrong(&[(weights, plain), ("let from_one = one.xy", here)]));
    println!("{with} texels wrong, {without} without recentring");
    assert!(with <= 2, "{with} texels are wrong");
    assert!(without > 10, "only {without} texels are wrong without recentring");
}

#[test]
fn straight_edges_miss_bent_ones_by_no_more_than_the_bound() {
    const BOUND: f64 = 1.0;
    let (mut off, mut beyond, mut ordinary) = (0, 0, 0);
    for Scene { case, yard, view, plan } in scenes(60, BOUND) {
        let gpu = device(&case);
        let mut stage = Stage::new(&gpu, &yard, &case, &Options::default());
        let cleared = plan.depth_order.cleared();
        for place in 0..yard.places.len() {
            let single = alone(&yard, place);
            let triangles = single.place_from_eye(0, plan.eye_world, &plan.capture_from_world());
            let errors = plan.facets.iter().filter_map(|facet| BentTriangle::new(facet, &triangles[0]));
            let errors: Vec<_> = errors.map(|bent| bent.chord_error_texels()).collect();
            if !errors.iter().any(|error| *error > 0.1 && *error < BOUND) {
                continue;
            }
            ordinary += 1;
            let map = stage.capture_place(&plan, &view, place);
            off += Bracket::new(&single, &plan, 1.0 / 64.0).differing(&map.depths, cleared);
            beyond += Bracket::new(&single, &plan, BOUND + 1.0 / 64.0).differing(&map.depths, cleared);
        }
    }
    println!("{ordinary} triangles: {off} texels off by more than 1/64, {beyond} by more than the bound");
    assert!(ordinary > 10 && off > 50);
    assert!(beyond <= 1);
}

/// A level sheet before the eye, so many times as wide as deep and between two depths, cut into uneven triangles: some
/// bend past any bound, some do not.
fn sheet(random: &mut Random, side: u32, width: f64, [near, far]: [f64; 2]) -> Geometry {
    let mut positions = Vec::new();
    for index in 0..side * side {
        let (column, row) = (index % side, index / side);
        let inner = |step: u32| step > 0 && step < side - 1;
        let mut shake = |step: u32| if inner(step) { random.unit() - 0.5 } else { 0.0 };
        let (x, z) = (f64::from(column) + 0.9 * shake(column), f64::from(row) + 0.9 * shake(row));
        let depth = near * (far / near).powf((z / f64::from(side - 1)).powf(1.7));
        let across = (x / f64::from(side - 1) - 0.5) * width * depth;
        positions.push([across as f32, -0.8, -depth as f32]);
    }
    let cells = (0..(side - 1) * (side - 1)).map(|cell| cell / (side - 1) * side + cell % (side - 1));
    let cell = |first: u32| [first, first + side, first + side + 1, first, first + side + 1, first + 1];
    Geometry { positions, indices: cells.flat_map(cell).collect() }
}

#[test]
fn straight_edges_stay_within_their_bound_and_no_texel_shows_between() {
    let mut random = Random(23);
    for distribution in [Word::plain("logarithmic"), Word::plain("perspective"), many_before()] {
        for bound in [0.25, 0.02] {
            let case =
                builder(distribution.clone(), "one_plane", bound).map_size_texels(512, 1024).build().unwrap();
            let gpu = device(&case);
            let view = &views((160, 90))[0];
            let yard = before_the_eye(view, vec![sheet(&mut random, 24, 1.4, [1.5, 80.0])]);
            let mut stage = Stage::new(&gpu, &yard, &case, &Options::default());
            let toward = view.camera_from_world.transpose() * DVec3::new(0.35, -1.0, 0.1);
            let plan = planned(&case, view, &Light::directional_travelling(toward).unwrap());
            let map = stage.capture(&plan, view);

            // The sheet without seams covers what the twin covers, but for its outline.
            let cleared = plan.depth_order.cleared();
            let bracket = |texels: f64| Bracket::new(&yard, &plan, texels);
            let (near, far) = (bracket(1.0 / 64.0), bracket(bound + 1.0 / 64.0));
            let holes = near.surely_covered.iter().zip(&map.depths);
            let holes = holes.filter(|(sure, depth)| **sure && **depth == cleared).count();
            let (off, beyond) = (near.differing(&map.depths, cleared), far.differing(&map.depths, cleared));
            println!("{:?} bound {bound}: {holes} holes, {off} off, {beyond} beyond", case.distribution);
            // A few texels of half a million may lie where the rasteriser's fixed point and the exact decision disagree.
            assert!(holes <= 3 && beyond <= 3, "{holes} holes, {beyond} beyond");
        }
    }
}

/// Steps to either side in which rows are shifted.
const STEPS: i32 = 8;

/// What a yard surely covers and surely does not, if its outline may be off by some texels along the rows.
struct Bracket {
    surely_covered: Vec<bool>,
    surely_empty: Vec<bool>,
}

impl Bracket {
    fn new(yard: &Yard, plan: &ShadowPlan, texels: f64) -> Self {
        let triangles = (0..yard.places.len())
            .flat_map(|place| yard.place_from_eye(place, plan.eye_world, &plan.capture_from_world()));
        let triangles: Vec<_> = triangles.collect();
        let area = (plan.map_size_texels.0 * plan.map_size_texels.1) as usize;
        let (mut surely_covered, mut surely_empty) = (vec![true; area], vec![true; area]);
        for (x, y) in (-1..=1).flat_map(|x| (-STEPS..=STEPS).map(move |y| (x, y))) {
            let (x, y) = (f64::from(x) / 64.0, f64::from(y) / f64::from(STEPS) * texels);
            let mut shifted = plan.clone();
            for facet in &mut shifted.facets {
                facet.rows.x += facet.rows.w * (2.0 * x / f64::from(facet.tile.width));
                let remap: &mut Remap = &mut facet.rows.remap;
                remap.shift += 2.0 * y / f64::from(facet.tile.height);
            }
            let map = cssm_core::twin::capture(&shifted, &triangles);
            for (texel, depth) in map.depths.iter().enumerate() {
                let covered = *depth != plan.depth_order.cleared();
                surely_covered[texel] &= covered;
                surely_empty[texel] &= !covered;
            }
        }
        Self { surely_covered, surely_empty }
    }

    /// Texels that are covered and should not be, or the other way round.
    fn differing(&self, depths: &[f64], cleared: f64) -> usize {
        let sides = self.surely_covered.iter().zip(&self.surely_empty).zip(depths);
        sides.filter(|((covered, empty), depth)| if **depth == cleared { **covered } else { **empty }).count()
    }
}

#[test]
fn few_triangles_of_scenes_need_more_than_straight_edges() {
    for (name, scene) in [("palm", cssm_lab::scene::Scene::palm()), ("city", cssm_lab::scene::Scene::city())]
    {
        let (view, light) = scene.views[0].pictured((1280, 720)).unwrap();
        for distribution in [Word::plain("logarithmic"), Word::plain("perspective")] {
            let case =
                builder(distribution.clone(), "one_plane", 0.25).map_size_texels(2048, 2048).build().unwrap();
            let plan = planned(&case, &view, &light);
            let (mut drawn, mut bent, mut texels, mut bent_texels) = (0_u32, 0_u32, 0.0, 0.0);
            for instance in &scene.instances {
                let mesh = &scene.meshes[instance.mesh];
                let corner = |index: &u32| {
                    let [x, y, z] = mesh.positions[*index as usize].map(f64::from);
                    instance.world_from_object.transform_point3(DVec3::new(x, y, z)) - view.eye_world
                };
                for corners in mesh.indices.chunks_exact(3) {
                    let triangle = [corner(&corners[0]), corner(&corners[1]), corner(&corners[2])];
                    for facet in &plan.facets {
                        let Some(triangle) = BentTriangle::new(facet, &triangle) else { continue };
                        let (area, error) = (triangle.covered_tile_texels(), triangle.chord_error_texels());
                        if area == 0.0 {
                            continue;
                        }
                        drawn += 1;
                        texels += area;
                        if error > 0.25 {
                            bent += 1;
                            bent_texels += area;
                        }
                    }
                }
            }
            let percent = |part: f64, whole: f64| 100.0 * part / whole;
            let (triangles, area) = (percent(bent.into(), drawn.into()), percent(bent_texels, texels));
            println!(
                "{name} {}: {triangles:.1} % of {drawn} triangles, {area:.1} % of texels",
                distribution.name
            );
            assert!(drawn > 1000 && triangles < 50.0);
        }
    }
}
