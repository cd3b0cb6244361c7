//! Casters whose edges bent rows bend are decided texel by texel: the device draws what the f64 twin draws, also where
//! triangles pass the eye; straight edges stay within their bound; nothing shows between the two.

use cssm_codegen::generate;
use cssm_core::case::{LightCase, LightCaseBuilder, Stretch};
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::remap::Remap;
use cssm_core::schema::{Value, Word};
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
    let mut around = |size: f64, random: &mut Random| {
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

#[test]
fn random_triangles_cover_what_they_cover_in_space() {
    let mut random = Random(17);
    let (mut violations, mut judged, mut covered, mut crossing) = (0, 0, 0, 0);
    for (distribution, view, sun) in [
        (Word::plain("logarithmic"), 0, [0.4, -1.0, 0.3]),
        (many_before(), 2, [-0.8, -0.7, 0.1]),
        (Word::plain("perspective"), 1, [0.3, -0.6, 0.5]),
    ] {
        let case = builder(distribution, "one_plane", 0.0).build().unwrap();
        let gpu = device(&case);
        let view = &views((160, 90))[view];
        let yard = before_the_eye(view, soup(&mut random, 60));
        let mut stage = Stage::new(&gpu, &yard, &case, &Options::default());
        let toward = view.camera_from_world.transpose() * DVec3::from_array(sun);
        let plan = planned(&case, view, &Light::directional_travelling(toward).unwrap());
        for place in 0..yard.places.len() {
            let map = stage.capture_place(&plan, view, place);
            let single = alone(&yard, place);
            let bracket = DepthBracket::new(&single, &plan, case.map.format);
            let wrong = bracket.violations(&map);
            let behind = single
                .triangles_from_eye(view)
                .iter()
                .flatten()
                .any(|corner| plan.facets[0].rows.w.dot(corner.extend(1.0)) <= 0.0);
            if wrong > 0 {
                let twin = cssm_core::twin::capture(
                    &plan,
                    &single.place_from_eye(0, plan.eye_world, &plan.capture_from_world()),
                );
                let cleared = plan.depth_order.cleared();
                let coverage = (map.depths.iter().zip(&twin.depths))
                    .filter(|(one, other)| (**one == cleared) != (**other == cleared))
                    .count();
                let mut depths: Vec<_> = (map.depths.iter().zip(&twin.depths))
                    .filter(|(one, other)| **one != cleared && **other != cleared)
                    .map(|(one, other)| (one - other).abs())
                    .collect();
                depths.sort_by(f64::total_cmp);
                let worst = depths.last();
                println!(
                    "place {place}: {wrong} wrong, {coverage} by coverage, depth off by {worst:?} of {}",
                    depths.len()
                );
            }
            let own = map.depths.iter().filter(|depth| **depth != plan.depth_order.cleared()).count();
            crossing += usize::from(behind && own > 0);
            violations += wrong;
            judged += map.depths.len();
            covered += own;
        }
    }
    println!("{judged} texels, {covered} covered, {crossing} triangles across w = 0: {violations} wrong");
    assert!(judged >= 1_000_000 && covered > 100_000 && crossing >= 10);
    assert!(violations as f64 <= SLIVERS * judged as f64);
}

/// A tilted sheet before the eye, cut into uneven triangles: some bend past any bound, some do not.
fn sheet(random: &mut Random) -> Geometry {
    const SIDE: u32 = 24;
    let mut positions = Vec::new();
    for index in 0..SIDE * SIDE {
        let (column, row) = (index % SIDE, index / SIDE);
        let inner = |step: u32| step > 0 && step < SIDE - 1;
        let mut shake = |step: u32| if inner(step) { random.unit() - 0.5 } else { 0.0 };
        let (x, z) = (f64::from(column) + 0.9 * shake(column), f64::from(row) + 0.9 * shake(row));
        let depth = 1.5 * (80.0_f64 / 1.5).powf((z / f64::from(SIDE - 1)).powf(1.7));
        positions.push([(x / f64::from(SIDE - 1) - 0.5) as f32 * 1.4 * depth as f32, -0.8, -depth as f32]);
    }
    let cells = (0..(SIDE - 1) * (SIDE - 1)).map(|cell| cell / (SIDE - 1) * SIDE + cell % (SIDE - 1));
    let cell = |first: u32| [first, first + SIDE, first + SIDE + 1, first, first + SIDE + 1, first + 1];
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
            let yard = before_the_eye(view, vec![sheet(&mut random)]);
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
            assert_eq!(holes, 0);
            assert_eq!(beyond, 0);
        }
    }
}

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
        for (x, y) in
            (-1..=1).flat_map(|x| (-4..=4).map(move |y| (f64::from(x) / 64.0, f64::from(y) * texels / 4.0)))
        {
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
