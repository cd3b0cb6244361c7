//! One plan at an extreme, judged: whether it answers at all, whether every number is finite, whether every receiver has
//! one facet and a texel in its tile, and how far f32 moves that texel.

use std::panic::{AssertUnwindSafe, catch_unwind};

use cssm_core::facet::Facet;
use cssm_core::footprint::{accepts, quantile, volume};
use cssm_core::glam::{DVec3, DVec4};
use cssm_core::homography::{Gradients, singular_values};
use cssm_core::table::{CaseTable, write_capture_record, write_shadow_record};
use cssm_core::{LightCase, PlanError, ShadowPlan, View, plan};

use super::found::{Found, Worst};
use super::rounded::Rounded;
use super::situations::Situation;
use super::subjects::Subject;
use crate::scene::random::Random;

/// Distance from a lamp below which receivers are not asked for, in distances of the lamp from the eye: positions
/// relative to the eye hold no more.
const NEAREST_SHARE: f64 = 0.05;
/// One receiver in this many is moved onto a border of facets.
const BORDER_EVERY: usize = 4;
/// Largest band limit whose border is tried, in reaches.
const FARTHEST_BORDER: f64 = 10.0;
/// Steps of rounding by which receivers are moved off borders, at most.
const BORDER_STEPS: f64 = 8.0;
/// Share of the reach that receivers are asked for: its very end lies on the far plane.
const REACHED: f64 = 0.999;

/// Share of half a pixel by which rounding may move a receiver off its pixel's centre.
const CENTRE_ROUNDING: f64 = 1e-2;

/// How a plan is asked for.
pub type Planner = dyn Fn(&LightCase, &Situation) -> Result<ShadowPlan, PlanError> + Sync;

/// The house's own planner.
///
/// # Errors
/// What planning says.
pub fn house(case: &LightCase, situation: &Situation) -> Result<ShadowPlan, PlanError> {
    plan(case, &situation.view, &situation.light, &situation.bounds)
}

/// The case of a subject as a situation has it.
pub fn case_in(subject: &Subject, situation: &Situation) -> LightCase {
    let mut case = subject.case.clone();
    let bounded = !subject.technique.fits_infinity && !situation.unbounded;
    case.shadow_distance_metres = bounded.then_some(situation.reach_metres);
    (case.map.width, case.map.height) = situation.map_texels;
    case.map.format = situation.format;
    case
}

/// Plans a subject in a situation and judges the plan at so many receivers.
pub fn judge(subject: &Subject, situation: &Situation, receivers: usize, planner: &Planner) -> Found {
    let mut found = Found::default();
    let case = case_in(subject, situation);
    let place = || situation.to_string();

    // Plan: an answer or a typed reason, never a panic.
    let plan = match catch_unwind(AssertUnwindSafe(|| planner(&case, situation))) {
        Err(_) => {
            found.panics.add(&place);
            return found;
        }
        Ok(Err(error)) => {
            found.refuse(&error, &place);
            return found;
        }
        Ok(Ok(plan)) => plan,
    };
    found.plans = 1;
    if !all_finite(&case, &plan) {
        found.not_finite.add(&place);
    }
    if !plan.choice.complete {
        found.incomplete.add(&place);
        return found;
    }
    if !plan.choice.made_for_position.is_empty() {
        // A configuration that answers for a light it is not made for only has to answer.
        found.degraded = 1;
        return found;
    }
    let place = || format!("{}, {}", situation, plan.configuration);
    judge_receivers(&mut found, &plan, situation, receivers, &place);
    found
}

/// Whether every number of a plan is finite, in f64, in f32 and in the words that are uploaded.
fn all_finite(case: &LightCase, plan: &ShadowPlan) -> bool {
    let rows = |facet: &Facet| {
        let uploaded = [facet.rows.x, facet.rows.y, facet.rows.z, facet.rows.w];
        let own = facet.select.iter().chain(&facet.casters).chain(&facet.receivers);
        uploaded.iter().chain(&facet.clip).all(|row| row.as_vec4().is_finite())
            && own.copied().all(DVec4::is_finite)
    };
    let table = CaseTable::describe(case);
    let words = |bytes: Vec<u8>| {
        let mut words =
            bytes.chunks_exact(4).map(|word| f32::from_le_bytes([word[0], word[1], word[2], word[3]]));
        words.all(f32::is_finite)
    };
    plan.facets.iter().all(rows)
        && words(write_shadow_record(&table, plan))
        && plan.facets.iter().all(|facet| words(write_capture_record(&table, plan, facet)))
}

fn judge_receivers(
    found: &mut Found,
    plan: &ShadowPlan,
    situation: &Situation,
    receivers: usize,
    place: &dyn Fn() -> String,
) {
    let rounded = Rounded::of(plan);
    let (view, format) = (&situation.view, situation.format);
    let mut random = Random::new(plan.facets.len() as u64 + 5);
    let borders = border_rows(plan, situation.reach_metres);
    let (width, height) = plan.map_size_texels;
    let longer = (f64::from(width.max(height)) / 2048.0).max(1.0);
    let (mut footprints, mut depths) = (Vec::new(), Vec::new());
    for index in 0..receivers {
        let point = receiver(situation, &borders, index, &mut random);
        // The position itself is f32: compare what both do with the same numbers.
        let camera = (view.camera_from_world * point).as_vec3().as_dvec3();
        let point = view.camera_from_world.transpose() * camera;
        if !is_receiver(situation, plan, camera, point) {
            continue;
        }
        found.receivers += 1;

        // Every receiver has one facet.
        let homogeneous = point.extend(1.0);
        let own = plan.selection.cell(homogeneous);
        let dominant = plan.selection.dominant_cell();
        let accepting = plan.facets.iter().filter(|facet| !facet.cells.contains(&dominant));
        if accepting.filter(|facet| accepts(facet, point)).count() > 1 {
            found.multiple.add(place);
        }
        let Some(facet) = plan.facet(own) else {
            found.missing.add(place);
            continue;
        };
        let exact = Gradients::at(&facet.rows, point);
        if exact.w.is_nan() || exact.w <= 0.0 {
            found.behind.add(place);
            continue;
        }

        // On a border f32 may choose the neighbour, if the texel lies in its tile.
        let position = rounded.position(camera);
        let chosen = rounded.cell(&plan.selection, position);
        let lies_in_tile = |facet: &Facet| {
            let exact = Gradients::at(&facet.rows, point);
            exact.w > 0.0 && exact.ndc.truncate().abs().max_element() <= 1.0
        };
        let Some(facet) = plan.facet(chosen).filter(|facet| lies_in_tile(facet)) else {
            found.outside.add(place);
            continue;
        };
        if !is_shown(view, camera) {
            continue;
        }
        let exact = Gradients::at(&facet.rows, point);

        // Compare across the map.
        let (ndc, w) = rounded.ndc(&facet.rows, position);
        let error = (ndc - exact.ndc).abs();
        let (width, height) = (f64::from(facet.tile.width), f64::from(facet.tile.height));
        let texels = (error.x * width).max(error.y * height) * 0.5;
        let pixels = volume(facet, view, point).major_pixels;
        let seen = || format!("{}, {camera} in camera axes, a texel spans {pixels:.1e} px", place());
        let largest = width.max(height);
        let texels = if w > 0.0 && texels < largest { texels } else { largest };
        found.texels.take(texels, &seen);
        found.relative_texels.take(texels / longer, &seen);

        // Compare along the light, in texels there, with what the format adds.
        let (across, up) = exact.across_light();
        let texel = singular_values(across * (2.0 / width), up * (2.0 / height)).0;
        let distance = if plan.light.w > 0.0 { point.distance(plan.light.truncate()) } else { 1.0 };
        if (-0.01..=1.01).contains(&exact.ndc.z) {
            let stored = error.z + format.rounding();
            depths.push(stored * exact.w / facet.depth_per_metre * distance / texel);
        }
        footprints.push(pixels);
    }

    // Take the plan's own percentiles; footprints as if every map had the same texels.
    let (width, height) = plan.map_size_texels;
    let side = (f64::from(width) * f64::from(height)).sqrt() / 2048.0;
    if let Some(p95) = percentile(footprints, 0.95) {
        found.footprint_worst.take(p95 * side, place);
        found.footprint_best = found.footprint_best.min(p95 * side);
    }
    if let Some(p99) = percentile(depths, 0.99) {
        found.depth.take(p99, place);
    }
}

fn percentile(mut values: Vec<f64>, share: f64) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    (!values.is_empty()).then(|| quantile(&values, share))
}

/// A point of the view; one in [`BORDER_EVERY`] on a border of facets, one on the edge of the image.
fn receiver(situation: &Situation, borders: &[DVec4], index: usize, random: &mut Random) -> DVec3 {
    let view = &situation.view;
    let range = situation.reach_metres * REACHED / view.near_metres;
    let depth = view.near_metres * libm::pow(range.max(1.0), random.between(0.0, 1.0));
    let (width, height) = (f64::from(view.size_pixels.0), f64::from(view.size_pixels.1));
    let (mut x, y) = (random.between(0.0, width), random.between(0.0, height));
    if index % BORDER_EVERY == 1 {
        // On the very edge, or at the centre of the last pixel.
        x = [0.0, 0.5, width - 0.5, width][random.below(4)];
    }
    let mut point = view.ray_world(x, y) * depth;
    if index.is_multiple_of(BORDER_EVERY)
        && let Some(row) = borders.get(random.below(borders.len()))
    {
        // Step along the row's normal onto its plane, then a few roundings off.
        let normal = row.truncate();
        point -= normal * (row.dot(point.extend(1.0)) / normal.length_squared());
        let mut factor =
            || 1.0 + random.between(-BORDER_STEPS, BORDER_STEPS).round() * f64::from(f32::EPSILON);
        point *= DVec3::new(factor(), factor(), factor());
    }
    point
}

/// Rows that are zero on the borders between facets.
fn border_rows(plan: &ShadowPlan, reach: f64) -> Vec<DVec4> {
    let selection = &plan.selection;
    let mut rows: Vec<DVec4> = selection.borders.clone();
    rows.extend(selection.split);
    for (sector, row) in selection.distances.iter().enumerate() {
        let unit = selection.units.get(sector).copied().unwrap_or(DVec4::W);
        let limits = selection.limits(sector).iter().filter(|limit| **limit < FARTHEST_BORDER * reach);
        rows.extend(limits.map(|limit| *row - unit * *limit));
    }
    rows.retain(|row| {
        let squared = row.truncate().length_squared();
        squared > f64::MIN_POSITIVE && squared.is_finite()
    });
    rows
}

/// Whether a point may be asked for: in the view and the bounds, lit, not at the lamp.
fn is_receiver(situation: &Situation, plan: &ShadowPlan, camera: DVec3, point: DVec3) -> bool {
    let Situation { view, light, bounds, reach_metres, .. } = situation;
    let depth = -camera.z;
    let world = view.eye_world + point;
    let in_box = bounds.receivers.is_none_or(|bounds| {
        // Moving the eye rounds as well.
        let inner = (bounds.max - bounds.min) * 1e-9;
        world.cmpge(bounds.min + inner).all() && world.cmple(bounds.max - inner).all()
    });
    let far_from_lamp = plan.light.w == 0.0 || {
        let lamp = plan.light.truncate();
        point.distance(lamp) >= NEAREST_SHARE * lamp.length().max(5.0 * view.near_metres)
    };
    depth >= view.near_metres
        && depth <= reach_metres * REACHED
        && in_image(view, camera)
        && in_box
        && light.reaches(world)
        && far_from_lamp
}

fn in_image(view: &View, camera: DVec3) -> bool {
    in_image_by(view, camera, 0.0)
}

/// Whether a receiver can be a pixel's centre: on slivers of facets outside those nothing is ever shown.
fn is_shown(view: &View, camera: DVec3) -> bool {
    in_image_by(view, camera, 0.5 * (1.0 - CENTRE_ROUNDING))
}

fn in_image_by(view: &View, camera: DVec3, pixels: f64) -> bool {
    let (x, y) = (camera.x / -camera.z, camera.y / -camera.z);
    let (width, height) = (f64::from(view.size_pixels.0), f64::from(view.size_pixels.1));
    let (across, up) =
        ((view.right - view.left) / width * pixels, (view.top - view.bottom) / height * pixels);
    (view.left + across..=view.right - across).contains(&x) && (view.bottom + up..=view.top - up).contains(&y)
}

/// The largest of what two judgements found.
pub(super) fn larger(one: Worst, two: Worst) -> Worst {
    if two.value > one.value { two } else { one }
}
