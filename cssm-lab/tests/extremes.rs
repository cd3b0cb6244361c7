//! The extremes, sampled: every technique plans or refuses with a reason, every receiver has one facet, and nothing of
//! camera space breaks. Deliberately wrong plans are seen.

use std::collections::BTreeSet;

use cssm_core::case::LightKind;
use cssm_core::glam::DVec4;
use cssm_core::technique::TECHNIQUES;
use cssm_lab::extremes::found::{Found, TEXEL_TARGET};
use cssm_lab::extremes::judge::{Planner, house, judge};
use cssm_lab::extremes::situations::{AXES, Axis, situations};
use cssm_lab::extremes::subjects::{Subject, house_technique, subjects};
use cssm_lab::extremes::{Extent, sweep};
use cssm_lab::progress::Progress;

#[test]
fn nothing_of_camera_space_breaks_and_every_technique_answers() {
    let found = sweep(&[], Extent::SAMPLED, &house, Progress::Hidden).unwrap();
    let techniques: BTreeSet<_> = found.rows.iter().map(|row| row.technique).collect();
    assert_eq!(techniques.len(), TECHNIQUES.len());
    for row in &found.rows {
        for (axis, found) in AXES.iter().zip(&row.axes) {
            let place = || format!("{}, {}", row.name, axis.name());
            assert!(found.plans + found.refused() > 0, "{}: nothing was asked for", place());

            // Whatever the technique: an answer or a reason, and numbers.
            let never = [&found.panics, &found.not_finite, &found.without_remedy];
            for count in never {
                assert_eq!(count.times, 0, "{}: {}", place(), count.place);
            }
            if row.is_house {
                assert_eq!(found.breaks(), [], "{}", place());
            }
            if row.is_house && row.is_variant {
                let worst = &found.relative_texels;
                assert!(worst.value <= TEXEL_TARGET, "{}: {} at {}", place(), worst.value, worst.place);
            }
        }
        assert_eq!(row.casters.breaks(), [], "{}", row.name);
        assert!(row.casters.maps > 0, "{}", row.name);
    }
    for control in &found.controls {
        assert!(control.is_seen(), "{control:?}");
    }
}

/// The house's own technique under the usual lights of one axis, planned by another planner.
fn judged(axis: Axis, planner: &Planner) -> Found {
    let subject: Subject = subjects(&[house_technique().unwrap().to_owned()]).unwrap().remove(0);
    let mut found = Found::default();
    for situation in situations(LightKind::Directional).unwrap() {
        if situation.axis == axis {
            found.merge(judge(&subject, &situation, 100, planner));
        }
    }
    found
}

/// A hundredth of the receivers.
fn few(found: &Found) -> u64 {
    found.receivers / 100
}

#[test]
fn sound_plans_pass_and_wrong_ones_are_seen() {
    let sound = judged(Axis::Offset, &house);
    assert!(sound.breaks().is_empty() && sound.receivers > 1000, "{sound:?}");

    let swapped = judged(Axis::Offset, &|case, situation| {
        let mut plan = house(case, situation)?;
        let (one, two) = (plan.facets[0].cells.clone(), plan.facets[1].cells.clone());
        (plan.facets[0].cells, plan.facets[1].cells) = (two, one);
        Ok(plan)
    });
    assert!(swapped.outside.times + swapped.behind.times > few(&swapped), "{swapped:?}");

    let lost = judged(Axis::Offset, &|case, situation| {
        let mut plan = house(case, situation)?;
        plan.facets.remove(0);
        Ok(plan)
    });
    assert!(lost.missing.times > few(&lost), "{lost:?}");

    let doubled = judged(Axis::Offset, &|case, situation| {
        let mut plan = house(case, situation)?;
        let first = plan.facets[0].select.clone();
        plan.facets[1].select = first;
        Ok(plan)
    });
    assert!(doubled.multiple.times > few(&doubled), "{doubled:?}");

    let not_finite = judged(Axis::Offset, &|case, situation| {
        let mut plan = house(case, situation)?;
        plan.facets[0].rows.z = DVec4::splat(f64::NAN);
        Ok(plan)
    });
    assert_eq!(not_finite.not_finite.times, not_finite.plans);

    let too_large = judged(Axis::Offset, &|case, situation| {
        let mut plan = house(case, situation)?;
        plan.facets[0].rows.x *= 1e60;
        Ok(plan)
    });
    assert!(too_large.not_finite.times > 0, "f32 overflows: {too_large:?}");
}
