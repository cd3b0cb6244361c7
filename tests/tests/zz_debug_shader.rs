//! Random declarations, captured and resolved on the device as the f64 twin does it: whatever a field may hold, map and
//! visibility are right. Where rows are bent, visibility alone is judged here, in the map that the device captured.

use std::collections::{BTreeMap, BTreeSet};

use cssm_core::case::{FarKind, LightCase};
use cssm_core::distribution::RemapKind;
use cssm_core::glam::DVec3;
use cssm_core::plan::WorldPlane;
use cssm_core::schema::Value;
use cssm_core::technique::TECHNIQUES;
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
const CASES: usize = 60;
/// Techniques under each kind of light that they serve.
const COMBINATIONS: usize = 5;
/// Declarations that the cases are picked from: few hold a technique's own fields without contradiction.
const POOL: usize = 3000;
/// Cases that must be drawn; the others have more tiles than their small map can hold.
const LEAST_DRAWN: usize = 54;
/// Size of the image in pixels.
const SIZE: (u32, u32) = (128, 72);

/// As many random cases of each technique and kind of light, with maps of 128 to 512 texels a side.
fn small_cases() -> Vec<LightCase> {
    let mut cases = Vec::new();
    let mut taken = BTreeMap::new();
    for case in random::cases(SEED, POOL) {
        let taken = taken.entry((case.technique.name, case.light.name())).or_insert(0);
        if *taken < CASES / COMBINATIONS && cases.len() < CASES {
            *taken += 1;
            cases.push(shrunk(case));
        }
    }
    assert_eq!(cases.len(), CASES);
    cases
}

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
    let bounds = SceneBounds {
        receivers: case.scene_bounds.then(|| yard.bounds()),
        eye_height_metres: Some(view.eye_world.y - ORIGIN.y),
        dominant_plane: Some(WorldPlane { point_world: ORIGIN, normal_world: DVec3::Y }),
    };
    let foreign = case.far == FarKind::Finite && view.far_metres.is_infinite();
    match plan(case, view, &lights(case.light)[light], &bounds) {
        Ok(plan) if !foreign => Some(plan),
        Err(PlanError::InfiniteView) if foreign => None,
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

#[test]
fn debug() {
    let (gpu, yard) = (exclusive(), Yard::new());
    let seen = seen(&yard);
    for (number, case) in small_cases().iter().enumerate() {
        let mut stage = Stage::new(&gpu, &yard, case, &Options::default());
        for (turn, (view, visible)) in seen.iter().enumerate() {
            let Some(plan) = planned(case, &yard, view, (number + turn) % 3) else { println!("{} none", case.name); continue };
            let straight = case.remap() == RemapKind::None;
            let bracket = straight.then(|| DepthBracket::new(&yard, &plan, case.map.format));
            if case.name == "RandomD" {
                for (i, a) in plan.facets.iter().enumerate() { for b in &plan.facets[i + 1..] {
                    let (a, b) = (a.tile, b.tile);
                    if a != b && a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height { println!("OVERLAP {a:?} {b:?}"); }
                } }
            }
            let drawn = stage.draw(plan, view, visible);
            let outside = bracket.as_ref().map_or(0, |bracket| bracket.violations(&drawn.map));
            let mut score = Score::default();
            score.add(case, &drawn, visible);
            println!("{number} {} {} {} {:?} {:?} {} view {turn}: outside {outside} of {}, {score:?}", case.name, case.light.name(), drawn.plan.configuration, case.remap(), case.stretch, case.bias.name(), drawn.map.depths.len());
            if outside > 10 {
                let bracket = bracket.unwrap();
                println!("{case:?}");
                println!("{:?} {:?}", drawn.plan.depth_order, drawn.plan.facets.iter().map(|f| (f.first_cell(), f.tile)).collect::<Vec<_>>());
                for y in 45..52 { let i = (y * drawn.map.width + 72) as usize; println!("row {y}: {} in {:?}", drawn.map.depths[i], bracket.limits(i)); }
                let f13 = drawn.plan.facets.iter().position(|f| f.first_cell() == 13).unwrap_or(0);
                println!("reached {:?}", (0..yard.places.len()).filter(|p| yard.reaches(*p, &drawn.plan, f13)).collect::<Vec<_>>());
                let mut shown = 0;
                for (index, depth) in drawn.map.depths.iter().enumerate() {
                    let (low, high) = bracket.limits(index);
                    if (*depth < low - 2e-5 || *depth > high + 2e-5) && shown < 12 {
                        shown += 1;
                        let (x, y) = (index as u32 % drawn.map.width, index as u32 / drawn.map.width);
                        let f = drawn.plan.facets.iter().find(|f| x >= f.tile.x && x < f.tile.x + f.tile.width && y >= f.tile.y && y < f.tile.y + f.tile.height);
                        println!("  {x},{y} {depth} in {low}..{high} {:?}", f.map(|f| (f.first_cell(), f.tile)));
                    }
                }
            }
        }
    }
}
