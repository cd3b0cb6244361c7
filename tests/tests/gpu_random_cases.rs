//! Random declarations, captured and resolved on the device as the f64 twin does it: whatever a field may hold, map and
//! visibility are right. Where rows are bent, visibility alone is judged here, in the map that the device captured.

use std::collections::{BTreeMap, BTreeSet};

use cssm_core::case::{FarKind, LightCase, LightKind, Stability};
use cssm_core::distribution::RemapKind;
use cssm_core::glam::DVec3;
use cssm_core::plan::WorldPlane;
use cssm_core::schema::Value;
use cssm_core::table::{CaseTable, RecordKind};
use cssm_core::technique::{TECHNIQUES, TechniqueSpec};
use cssm_core::{PlanError, SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::Options;
use cssm_tests::gpu::depth_bracket::{DepthBracket, SLIVERS};
use cssm_tests::gpu::exclusive;
use cssm_tests::gpu::resolve::Visible;
use cssm_tests::gpu::score::Score;
use cssm_tests::gpu::stage::{Drawn, Stage};
use cssm_tests::gpu::yard::{ORIGIN, Yard, lights, views};
use cssm_tests::random;

const SEED: u64 = 0x5eed;
const CASES: usize = 50;
/// Declarations that the cases are picked from: few hold a technique's own fields without contradiction.
const POOL: usize = 12_000;
/// Cases that must be drawn; the others have more tiles than their small map can hold.
const LEAST_DRAWN: usize = 45;
/// Largest uniform record of the test device, which has the lowest limits there are; many bands in both halves of a local
/// light's columns need more.
const LARGEST_RECORD_BYTES: u32 = 16384;
/// How many times more texels than [`SLIVERS`] a local light may round beyond the bracket: depth steps grow towards it.
const NEAR_LAMPS: f64 = 12.0;
/// Size of the image in pixels.
const SIZE: (u32, u32) = (128, 72);

/// As many random cases of each technique and kind of light, with maps of 128 to 512 texels a side.
fn small_cases() -> Vec<LightCase> {
    let mut cases = Vec::new();
    let kinds = [LightKind::Directional, LightKind::Spot, LightKind::Omni];
    let serves = |technique: &&TechniqueSpec, kind: LightKind| technique.serving(kind).next().is_some();
    let combinations: usize =
        kinds.iter().map(|kind| TECHNIQUES.iter().filter(|technique| serves(technique, *kind)).count()).sum();
    let mut taken = BTreeMap::new();
    for case in random::cases(SEED, POOL) {
        let table = CaseTable::describe(&case);
        if table.record(RecordKind::Shadow).unwrap().size_bytes > LARGEST_RECORD_BYTES {
            continue;
        }
        let taken = taken.entry((case.technique.name, case.light.name())).or_insert(0);
        if *taken < CASES.div_ceil(combinations) && cases.len() < CASES {
            *taken += 1;
            cases.push(shrunk(case));
        }
    }
    assert_eq!(cases.len(), CASES);
    cases
}

/// Smallest share of the rows before the focus at which a lamp's depth is bracketed.
const SMALLEST_SHARE: f64 = 0.005;

/// The case with a smaller map; order and variety of the declared sides remain.
fn shrunk(mut case: LightCase) -> LightCase {
    let side = |side: u32, smallest: f64| (smallest * (f64::from(side) / 64.0).max(1.0).sqrt().sqrt()) as u32;
    (case.map.width, case.map.height) = (side(case.map.width, 128.0), side(case.map.height, 128.0));
    for (_, value) in &mut case.technique.arguments.0 {
        if let Value::Sizes(sizes) = value {
            sizes.iter_mut().for_each(|tile| *tile = (side(tile.0, 32.0), side(tile.1, 32.0)));
        }
    }
    LightCase::from_arguments(&case.name, &case.doc, case.public, &case.to_arguments()).unwrap()
}

/// The case's plan; `None` where the small map cannot hold its tiles or the view is not one that it serves.
fn planned(case: &LightCase, yard: &Yard, view: &View, light: usize) -> Option<ShadowPlan> {
    let plane = |height: f64, normal_world: DVec3| {
        Some(WorldPlane { point_world: ORIGIN + DVec3::Y * height, normal_world })
    };
    let bounds = SceneBounds {
        receivers: case.scene_bounds.then(|| yard.bounds()),
        eye_height_metres: Some(view.eye_world.y - ORIGIN.y),
        dominant_plane: plane(0.0, DVec3::Y),
        ground_planes: [
            plane(0.0, DVec3::Y),
            plane(4.0, DVec3::Y),
            plane(0.0, DVec3::X),
            plane(50.0, DVec3::new(0.3, 1.0, 0.2)),
        ],
    };
    let foreign = case.far == FarKind::Finite && view.far_metres.is_infinite();
    match plan(case, view, &lights(case.light)[light], &bounds) {
        Ok(plan) if !foreign => Some(plan),
        Err(PlanError::InfiniteView) if foreign => None,
        // A lattice of orientations so coarse that a view around all nearby sees more than half of space.
        Err(PlanError::Margin(_)) if matches!(case.stability, Stability::Quantised { .. }) => None,
        Err(PlanError::MapTooSmall { width, height, gutter, .. }) => {
            assert_eq!((width, height, gutter), (case.map.width, case.map.height, case.gutter_texels()));
            None
        }
        other => panic!("{case:?}: {other:?}"),
    }
}

fn seen(yard: &Yard) -> Vec<(View, Visible)> {
    let see = |view: View| (view, Visible::new(&view, &yard.triangles_from_eye(&view)));
    views(SIZE).map(see).into()
}

/// Whether a lamp's map gives what is near so few rows that depth between them rounds to more than the bracket allows;
/// what such maps resolve to is judged all the same.
fn squeezes_a_lamp(case: &LightCase) -> bool {
    let share = case.technique.arguments.0.iter().find(|(name, _)| *name == "share");
    let few =
        share.is_some_and(|(_, value)| matches!(value, Value::Number(share) if *share < SMALLEST_SHARE));
    few && case.light.is_local()
}

#[test]
fn random_cases_draw_what_the_twin_draws() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let seen = seen(&yard);
    let (mut drawn_cases, mut all_texels, mut all_covered) = (0, 0, 0);
    let (mut all_judged, mut all_shadowed) = (0, 0);
    for (number, case) in small_cases().iter().enumerate() {
        let (mut texels, mut outside) = (0, 0);
        let mut score = Score::default();
        let mut stage = Stage::new(&gpu, &yard, case, &Options::default());
        for (turn, (view, visible)) in seen.iter().enumerate() {
            let Some(plan) = planned(case, &yard, view, (number + turn) % 3) else { continue };
            let (cleared, straight) = (plan.depth_order.cleared(), case.remap() == RemapKind::None);
            let bracketed = straight && !squeezes_a_lamp(case);
            let bracket = bracketed.then(|| DepthBracket::new(&yard, &plan, case.map.format));
            let drawn = stage.draw(plan, view, visible);
            texels += drawn.map.depths.len();
            all_covered += drawn.map.depths.iter().filter(|depth| **depth != cleared).count();
            outside += bracket.map_or(0, |bracket| bracket.violations(&drawn.map));
            score.add(case, &drawn, visible);
        }
        let what = format!("{outside} of {texels} texels, {score:?}: {case:?}");
        let slivers = SLIVERS * if case.light.is_local() { NEAR_LAMPS } else { 1.0 };
        assert!(outside as f64 <= 1.0 + slivers * texels as f64, "{what}");
        assert!(score.mask_wrong * 2000 <= score.mask_judged, "{what}");
        assert!(score.material_wrong * 2000 <= score.judged, "{what}");
        drawn_cases += usize::from(texels > 0);
        all_texels += texels;
        all_judged += score.judged;
        all_shadowed += score.shadowed;
    }
    assert!(drawn_cases >= LEAST_DRAWN, "only {drawn_cases} of {CASES} cases are drawn");
    assert!(all_covered * 3 > all_texels, "only {all_covered} of {all_texels} texels are covered");
    assert!(all_shadowed * 10 > all_judged, "only {all_shadowed} of {all_judged} pixels are shadowed");
}

#[test]
fn wrong_twins_are_caught() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let (view, visible) = &seen(&yard)[0];
    let cases = small_cases();
    let wrong = |case: &LightCase, drawn: &Drawn| {
        let mut score = Score::default();
        score.add(case, drawn, visible);
        score.mask_wrong + score.material_wrong
    };
    let [mut rows, mut maps, mut declarations] = [Control::default(); 3];
    for (number, case) in cases.iter().enumerate().step_by(3) {
        let Some(plan) = planned(case, &yard, view, 0) else { continue };
        let mut drawn = Stage::new(&gpu, &yard, case, &Options::default()).draw(plan, view, visible);

        // Rows off by a twentieth of a texel.
        let mut plan = drawn.plan.clone();
        for facet in &mut plan.facets {
            facet.rows.x += facet.rows.w * (0.1 / f64::from(facet.tile.width));
        }
        if case.remap() == RemapKind::None {
            rows.add(DepthBracket::new(&yard, &plan, case.map.format).violations(&drawn.map));
        }

        // Another case's filter and bias.
        let next = &cases[(number + 1) % cases.len()];
        let other = LightCase { filter: next.filter, bias: next.bias, ..case.clone() };
        if other != *case {
            declarations.add(wrong(&other, &drawn));
        }

        // A map shifted by a texel.
        drawn.map.depths.rotate_right(1);
        maps.add(wrong(case, &drawn));
    }
    // Large biases and short distances leave some cases without any shadow to get wrong.
    for (what, control) in [("rows", rows), ("maps", maps), ("declarations", declarations)] {
        assert!(control.tried > 10, "{what}: {control:?}");
        assert!(control.caught * 4 >= control.tried * 3, "{what}: {control:?}");
    }
}

/// How many cases show an error.
#[derive(Debug, Clone, Copy, Default)]
struct Control {
    tried: usize,
    caught: usize,
}

impl Control {
    fn add(&mut self, wrong: usize) {
        self.tried += 1;
        self.caught += usize::from(wrong > 20);
    }
}

#[test]
fn too_many_tiles_are_refused() {
    let (yard, view) = (Yard::new(), &views(SIZE)[0]);
    let case = |gutter| {
        let case = LightCase::builder("Crowded").map_size_texels(64, 64).bands(16, 1e5);
        case.map_gutter_texels(gutter).build().unwrap()
    };
    assert!(planned(&case(1), &yard, view, 0).is_some());
    assert!(planned(&case(16), &yard, view, 0).is_none());
}

#[test]
fn the_cases_differ() {
    let cases = small_cases();
    let different = |of: &dyn Fn(&LightCase) -> String| cases.iter().map(of).collect::<BTreeSet<_>>().len();
    assert_eq!(different(&|case| case.technique.name.into()), TECHNIQUES.len());
    assert_eq!(different(&|case| case.light.name().into()), 3);
    assert!(different(&|case| format!("{:?}", case.remap())) > 1);
    assert_eq!(different(&|case| case.dominant_plane.is_some().to_string()), 2);
    assert!(different(&|case| case.filter.name().into()) >= 6);
    assert_eq!(different(&|case| case.bias.name().into()), 5);
    assert_eq!(different(&|case| case.map.format.name().into()), 2);
    assert!(different(&|case| format!("{:?}", case.resolve)) > 8);
    assert!(different(&|case| format!("{} x {}", case.map.width, case.map.height)) > 5);
}
