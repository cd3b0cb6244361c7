//! The figures' numbers: smooth over the light's direction, small where the literature says so, and small for no other
//! reason.

use cssm_core::LightCase;
use cssm_lab::figures::{density, focus_area};

/// Share of the map that the focus region covers, with the light so many degrees off the line of sight.
fn share(case: &LightCase, degrees: f64) -> f64 {
    let view = focus_area::view().unwrap();
    focus_area::share(case, &view, 0.6 * degrees, -0.8 * degrees).unwrap()
}

/// Steps over the half circle, and finer steps in the steepest of them.
const STEPS: u32 = 90;
const FINER: u32 = 32;
/// Share of the steepest step's change that one finer step may have: a jump would have all of it.
const SMOOTH: f64 = 0.25;
/// The same where facets share the map, each sized by itself.
const SMOOTH_SHARED: f64 = 0.38;

/// Changes of the share below this are flat, whatever whole texels make of them.
const FLAT: f64 = 0.05;

/// How much of the steepest step's change falls into one of its finer steps.
fn jump(share: &dyn Fn(f64) -> f64) -> f64 {
    let step = 180.0 / f64::from(STEPS);
    let largest = |start: f64, step: f64, count: u32| {
        let at = |index: u32| share(start + step * f64::from(index));
        let changes = (0..count).map(|index| (index, (at(index + 1) - at(index)).abs()));
        changes.max_by(|one, two| one.1.total_cmp(&two.1)).unwrap()
    };
    let (steepest, change) = largest(0.0, step, STEPS);
    largest(step * f64::from(steepest), step / f64::from(FINER), FINER).1 / change.max(FLAT)
}

/// Shares that are small, and that are not.
const SMALL: f64 = 0.04;
const LARGE: f64 = 0.25;

#[test]
fn focus_regions_change_smoothly_and_are_small_where_frusta_duel() {
    for (name, case) in focus_area::cases().unwrap() {
        let jump = jump(&|degrees| share(&case, degrees));
        let [behind, beside, ahead] = [0.0, 90.0, 180.0].map(|degrees| share(&case, degrees));
        println!("{name}: {behind:.3} behind, {beside:.3} beside, {ahead:.3} ahead, jump {jump:.3}");
        let smooth = if case.shape().cells() == 1 { SMOOTH } else { SMOOTH_SHARED };
        assert!(jump < smooth, "{name}: {jump}");
        assert!(beside > LARGE, "{name}: {beside}");
        if case.shape().cells() == 1 {
            assert!(behind < SMALL && ahead < SMALL, "{name}: {behind} {ahead}");
        } else {
            assert!(behind > LARGE && ahead > LARGE, "{name}: {behind} {ahead}");
        }
    }
}

#[test]
fn a_jump_between_two_maps_is_seen() {
    let (_, case) = focus_area::cases().unwrap().remove(0);
    let jumping = |degrees: f64| share(&case, degrees) * if degrees < 77.3 { 1.0 } else { 0.3 };
    assert!(jump(&jumping) > 2.0 * SMOOTH);
}

#[test]
fn face_columns_sample_every_depth_alike() {
    let columns = density::columns().unwrap();
    let (least, most) = columns
        .iter()
        .fold((f64::MAX, 0.0_f64), |range, (_, density)| (range.0.min(*density), range.1.max(*density)));
    assert!(most / least < 2.5, "{least} to {most} texels per pixel");
    let splits = density::of("parallel_split { splits: 4, scheme: uniform }").unwrap();
    assert!(splits[0].1 < 0.01 * splits[splits.len() - 1].1, "uniform slabs starve the foreground");
}
