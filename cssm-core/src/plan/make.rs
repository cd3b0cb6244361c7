//! From a request to a plan: drafts, their windows and tiles, the best of them finished.

use std::ops::Range;

use glam::{DVec2, DVec4};

use super::finish::{self, Depth};
use super::fitted::Fitted;
use super::planner::Work;
use super::visible::{self, Visible};
use super::window::{self, Frame};
use super::{DepthOrder, PlanError, PlanRequest, ShadowPlan, ViewMargin, dominant, snap};
use crate::case::{LightCase, LightKind, Stability};
use crate::choose::{ChoiceReason, Kept, choose, list_made_for};
use crate::distribution;
use crate::facet::{Facet, Selection};
use crate::fit::{self, Sighted};
use crate::light::LightPosition;
use crate::technique::Situation;
use crate::view::{View, ViewLattice};

/// Makes the plan of a request, with a configuration to stay with, in the place of another.
pub(crate) fn make(
    request: &PlanRequest<'_>,
    kept: Kept,
    work: &mut Work,
    plan: &mut ShadowPlan,
) -> Result<(), PlanError> {
    // Find what is visible, with the margin around it.
    let case = request.case;
    let region = request.checked_region()?;
    let view = &widened(request)?;
    let Visible { light_world, light_camera, cone, receivers, lit, seen } = Visible::of(request, view)?;
    let plane = visible::dominant_row(view, &request.bounds)?;
    let ground_planes = visible::ground_planes(request)?;
    let eye_height_metres = request.bounds.eye_height_metres.or(plane.map(|plane| plane.w.abs()));
    if eye_height_metres.is_none() && distribution::needs_eye_height(case) {
        return Err(PlanError::EyeHeight);
    }
    let spec = case.technique_spec();
    let sighted = Sighted::of(case.fit, view, light_camera, &receivers, &request.seen())?;
    let situation = Situation {
        case,
        view,
        map_size_texels: (region.width, region.height),
        light: light_camera,
        cone,
        eye_height_metres,
        receivers,
        seen,
        sighted,
    };
    let depth =
        Depth { orders: orders(case, light_camera), shear: shear(view, light_camera, spec.follows_camera) };
    work.begin(case, plan);
    work.plan.choice.position = LightPosition::of(view, light_camera);
    if situation.receivers.is_empty() {
        fill_nothing(case, depth, work);
    } else {
        fill(request, kept, (&situation, plane, depth), &lit, work)?;
    }

    // Everything relative to the eye in world axes, with tiles in the whole map.
    let made = &mut work.plan;
    let row_to_world = |row: DVec4| (view.camera_from_world.transpose() * row.truncate()).extend(row.w);
    for facet in &mut made.facets {
        facet.turn(&row_to_world);
        (facet.tile.x, facet.tile.y) = (facet.tile.x + region.x, facet.tile.y + region.y);
    }
    made.facets.sort_unstable_by_key(Facet::first_cell);
    for row in made.selection.rows_mut().chain(&mut made.basis.receivers) {
        *row = row_to_world(*row);
    }
    made.configuration = made.choice.configuration;
    list_made_for(case, made.choice.position, &mut made.choice.made_for_position);
    (made.eye_world, made.camera_from_world) = (view.eye_world, view.camera_from_world);
    (made.shear, made.light) = (depth.shear, light_world);
    made.pixel_metres = request.view.pixel_metres();
    (made.map_size_texels, made.region) = ((case.map.width, case.map.height), region);
    made.basis.light = *request.light;
    made.basis.follows_camera = spec.follows_camera;
    made.basis.lit.clear();
    made.basis.lit.extend(situation.receivers.planes[lit].iter().copied().map(row_to_world));
    made.basis.cut.clone_from(situation.sighted.cut());
    made.basis.ground_planes = ground_planes;
    if matches!(case.stability, Stability::Quantised { .. }) {
        // The lattice decides texels, not what they are relative to.
        made.rebase(request.view);
    }
    std::mem::swap(plan, made);
    Ok(())
}

/// Fills in the plan of a light that reaches nothing visible: nothing visible is nothing to draft.
fn fill_nothing(case: &LightCase, depth: Depth<'_>, work: &mut Work) {
    work.list_facets(0);
    let made = &mut work.plan;
    made.choice.configuration = case.configurations.first().map_or("", |word| word.name);
    (made.choice.reason, made.choice.complete, made.choice.fallback) = (ChoiceReason::Only, true, None);
    made.choice.predictions.clear();
    made.depth_order = depth.orders[0];
    made.basis.receivers.clear();
    made.basis.receivers.push(-DVec4::W);
    (made.basis.samples, made.basis.p95_pixels) = (0, 0.0);
    list_walk(&Selection::single(), case, &mut made.selection);
}

/// Fills in facets, walk and choice, in camera space with tiles from the region's corner.
fn fill(
    request: &PlanRequest<'_>,
    kept: Kept,
    (situation, plane, depth): (&Situation<'_>, Option<DVec4>, Depth<'_>),
    lit: &Range<usize>,
    work: &mut Work,
) -> Result<(), PlanError> {
    // Draft every declared configuration.
    let case = request.case;
    let spec = case.technique_spec();
    let dominant = plane.and_then(|plane| dominant::facet(situation, plane));
    let mut first_error = None;
    for word in &case.configurations {
        let known = work.drafts.len();
        if let Err(error) = (spec.configuration(word.name).draft)(situation, word, &mut work.drafts) {
            work.drafts.truncate(known);
            first_error = first_error.or(Some(error));
        }
    }
    if let (Some(error), 0) = (first_error, work.drafts.len()) {
        return Err(error);
    }
    for draft in work.drafts.list_mut() {
        if case.stability == Stability::Snapped {
            snap::align(draft, situation);
        }
        draft.add_dominant(dominant.as_ref());
        fit::narrow(draft, situation);
    }

    // Fit the drafts and take the best.
    let drafts = work.drafts.list();
    let samples = window::samples(situation, drafts, &mut work.points);
    work.fitted.resize_with(work.fitted.len().max(drafts.len()), Fitted::default);
    work.usable.clear();
    work.predictions.clear();
    let mut first_error = None;
    for (index, draft) in drafts.iter().enumerate() {
        let frame = Frame { draft, situation, samples: &work.points };
        let fitted = &mut work.fitted[index];
        match fitted.fit(&frame, &mut work.fitting) {
            Ok(()) => {
                work.predictions.push(fitted.prediction(draft));
                work.usable.push(index);
            }
            Err(error) => first_error = first_error.or(Some(error)),
        }
    }
    if work.usable.is_empty() {
        return Err(first_error.unwrap_or(PlanError::Degenerate {
            facet: 0,
            why: "no declared configuration has facets for this light; declare the technique's defaults",
        }));
    }
    let (best, reason) = choose(&work.predictions, kept);
    let is_complete = work.predictions[best].p95_pixels.is_finite();
    let best = work.usable[best];
    let count = work.fitted[best].windows.list.len();
    work.list_facets(count);
    let draft = &work.drafts.list()[best];
    let frame = Frame { draft, situation, samples: &work.points };
    let fitted = &work.fitted[best];

    // Store depth the way that rounds least.
    work.finished.clear();
    for (index, facet) in work.plan.facets.iter_mut().enumerate() {
        fitted.windows.judged(index, &frame, &mut work.judged);
        let finished = finish::finish((fitted, index), &frame, &work.judged, depth, facet)?;
        work.finished.push(finished);
    }
    let moved = |order: usize| work.finished.iter().map(|facet| facet.moved(order)).sum::<Option<f64>>();
    let best_order = if depth.orders.len() == 1 {
        0
    } else {
        let sums = (0..depth.orders.len()).filter_map(|order| Some((order, moved(order)?)));
        sums.min_by(|(_, one), (_, two)| one.total_cmp(two)).map_or(0, |(order, _)| order)
    };
    for (finished, facet) in work.finished.iter().zip(&mut work.plan.facets) {
        finished.store(best_order, facet)?;
    }

    // The one facet over what is seen of some volumes holds less than everything visible.
    let made = &mut work.plan;
    let mut own = draft.facets.iter().filter(|facet| !facet.is_dominant());
    let planes = match (own.next(), own.next()) {
        (Some(whole), None) if !request.volumes_world.is_empty() => draft.receivers(whole).planes,
        _ => &situation.receivers.planes,
    };
    let not_lit = planes.iter().enumerate().filter(|(index, _)| !lit.contains(index));
    made.basis.receivers.clear();
    made.basis.receivers.extend(not_lit.map(|(_, plane)| *plane));
    (made.basis.samples, made.basis.p95_pixels) = (samples, fitted.p95_pixels);
    made.depth_order = depth.orders[best_order];
    let choice = &mut made.choice;
    (choice.configuration, choice.reason) = (draft.configuration, reason);
    (choice.complete, choice.fallback) = (is_complete, draft.fallback);
    choice.predictions.clear();
    if work.predictions.len() > 1 {
        choice.predictions.extend_from_slice(&work.predictions);
    }
    list_walk(&draft.selection, case, &mut made.selection);
    Ok(())
}

/// The view that a plan is made for: as far as shadows reach, with the request's margin, around the nearest view of the
/// case's lattice where it has one.
fn widened(request: &PlanRequest<'_>) -> Result<View, PlanError> {
    let mut view = visible::shadowed(request);
    let ViewMargin { mut turn_radians, mut move_metres } = request.margin;
    if let Stability::Quantised { move_metres: pitch_metres, turn_degrees } = request.case.stability {
        let lattice = ViewLattice { pitch_metres, pitch_radians: turn_degrees.to_radians() };
        view = lattice.nearest(&view);
        turn_radians += lattice.farthest_turn_radians();
        move_metres += lattice.farthest_move_metres();
    }
    if (turn_radians, move_metres) == (0.0, 0.0) || view.far_metres <= view.near_metres {
        return Ok(view);
    }
    view.widened(turn_radians, move_metres).map_err(PlanError::Margin)
}

/// How positions are sheared along the light; see [`ShadowPlan::shear`].
pub(super) fn shear(view: &View, light_camera: DVec4, follows_camera: bool) -> DVec2 {
    match LightPosition::ray(light_camera) {
        Some(ray) if follows_camera && LightPosition::is_near(view, ray) => ray,
        _ => DVec2::ZERO,
    }
}

/// Ways to store depth that are worth a try; at least one.
fn orders(case: &LightCase, light_camera: DVec4) -> &'static [DepthOrder] {
    let ahead = case.technique_spec().follows_camera && light_camera.z < 0.0;
    match (case.light, ahead) {
        (LightKind::Spot | LightKind::Omni, _) => &[DepthOrder::Reversed, DepthOrder::Standard],
        (LightKind::Directional, true) => &[DepthOrder::Reversed],
        (LightKind::Directional, false) => &[DepthOrder::Standard],
    }
}

/// The walk with as many cells as the case has.
fn list_walk(selection: &Selection, case: &LightCase, padded: &mut Selection) {
    let shape = case.shape();
    selection.pad(&shape, padded);
    if !case.scales_thresholds() {
        padded.units.clear();
    } else if padded.units.is_empty() {
        // Another configuration of the case scales its limits; this one's are plain.
        padded.units.extend((0..shape.halves * shape.sectors).map(|_| DVec4::W));
    }
}

impl Facet {
    /// Turns every row and vertex from camera axes to world axes.
    fn turn(&mut self, row_to_world: &impl Fn(DVec4) -> DVec4) {
        let rows = [&mut self.rows.x, &mut self.rows.y, &mut self.rows.z, &mut self.rows.w];
        let lists = [&mut self.select, &mut self.clip, &mut self.casters, &mut self.receivers];
        // The rotation is orthogonal, so points turn as rows do.
        for row in rows.into_iter().chain(lists.into_iter().flatten()) {
            *row = row_to_world(*row);
        }
    }
}
