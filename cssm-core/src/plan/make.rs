//! From a request to a plan: drafts, their windows and tiles, the best of them finished.

use glam::{DVec2, DVec4};

use super::fitted::{self, Fitted};
use super::held::PlanBasis;
use super::visible::{self, Visible};
use super::{DepthOrder, PlanError, PlanRequest, ShadowPlan, ViewMargin, dominant, finish, snap, window};
use crate::case::{LightCase, LightKind, Stability};
use crate::choose::{ChoiceReason, ConfigurationChoice, Kept, Prediction, choose, made_for};
use crate::distribution;
use crate::facet::{Facet, Selection};
use crate::fit::{self, Sighted};
use crate::light::LightPosition;
use crate::schema::Word;
use crate::technique::{Draft, Situation};
use crate::view::{View, ViewLattice};

/// Makes the plan of a request, with a configuration to stay with.
pub(crate) fn make(request: &PlanRequest<'_>, kept: Kept) -> Result<ShadowPlan, PlanError> {
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
    let position = LightPosition::of(view, light_camera);
    let shear = shear(view, light_camera, spec.follows_camera);
    let nothing = receivers.is_empty();
    let map_size_texels = (region.width, region.height);
    let sighted = Sighted::of(case.fit, view, light_camera, &receivers, &request.seen())?;
    let situation = Situation {
        case,
        view,
        map_size_texels,
        light: light_camera,
        cone,
        eye_height_metres,
        receivers,
        seen,
        sighted,
    };
    let plan = |made: Made| {
        let row_to_world = |row: DVec4| (view.camera_from_world.transpose() * row.truncate()).extend(row.w);
        let Made { choice, depth_order, facets, selection, covered, samples, p95_pixels } = made;
        let mut facets: Vec<Facet> = facets.into_iter().map(|facet| facet.turned(&row_to_world)).collect();
        for tile in facets.iter_mut().map(|facet| &mut facet.tile) {
            (tile.x, tile.y) = (tile.x + region.x, tile.y + region.y);
        }
        facets.sort_by_key(Facet::first_cell);
        let mut plan = ShadowPlan {
            configuration: choice.configuration,
            choice,
            eye_world: view.eye_world,
            camera_from_world: view.camera_from_world,
            shear,
            light: light_world,
            pixel_metres: request.view.pixel_metres(),
            depth_order,
            map_size_texels: (case.map.width, case.map.height),
            region,
            basis: PlanBasis {
                light: *request.light,
                follows_camera: spec.follows_camera,
                lit: situation.receivers.planes[lit.clone()].iter().copied().map(row_to_world).collect(),
                receivers: covered.into_iter().map(row_to_world).collect(),
                cut: situation.sighted.cut().clone(),
                ground_planes,
                samples,
                p95_pixels,
            },
            selection: walk(selection, case, &row_to_world),
            facets,
        };
        if matches!(case.stability, Stability::Quantised { .. }) {
            // The lattice decides texels, not what they are relative to.
            plan.rebase(request.view);
        }
        plan
    };

    // Nothing visible is nothing to draft.
    if nothing {
        let configuration = case.configurations.first().map_or("", |word| word.name);
        let choice = ConfigurationChoice {
            position,
            configuration,
            reason: ChoiceReason::Only,
            predictions: Vec::new(),
            complete: true,
            fallback: None,
            made_for_position: made_for(case, position),
        };
        return Ok(plan(Made {
            choice,
            depth_order: orders(case, light_camera)[0],
            facets: Vec::new(),
            selection: Selection::single(),
            covered: vec![-DVec4::W],
            samples: 0,
            p95_pixels: 0.0,
        }));
    }

    // Draft every declared configuration, fit the drafts and take the best.
    let dominant = plane.and_then(|plane| dominant::facet(&situation, plane));
    let draft = |word: &Word| (spec.configuration(word.name).draft)(&situation, word);
    let drafted = any(case.configurations.iter().map(draft))?.into_iter().flatten();
    let whole = |draft: Draft| {
        let draft =
            if case.stability == Stability::Snapped { snap::aligned(draft, &situation) } else { draft };
        fit::narrowed(draft.with_dominant(dominant.as_ref()), &situation)
    };
    let drafts: Vec<Draft> = drafted.map(whole).collect();
    let (samples, sample_count) = window::samples(&situation, &drafts);
    let mut fitted = any(drafts.iter().map(|draft| fitted::fit(draft, &situation, &samples)))?;
    if fitted.is_empty() {
        return Err(PlanError::Degenerate {
            facet: 0,
            why: "no declared configuration has facets for this light; declare the technique's defaults",
        });
    }
    let predictions: Vec<Prediction> = fitted.iter().map(Fitted::prediction).collect();
    let (best_draft, reason) = choose(&predictions, kept);
    let complete = predictions[best_draft].p95_pixels.is_finite();
    let Fitted { draft, windows, tiles, p95_pixels } = fitted.swap_remove(best_draft);

    // Store depth the way that rounds least.
    let shape = case.shape();
    let depth = finish::Depth { orders: orders(case, light_camera), shear };
    let mut finished = Vec::with_capacity(windows.list.len());
    for (index, (window, tile)) in windows.list.iter().zip(&tiles).enumerate() {
        let cells = if window.draft.is_dominant() {
            vec![shape.cells() - 1]
        } else {
            window.draft.cells.iter().map(|cell| cell.index(shape.sectors, shape.bands)).collect()
        };
        finished.push(finish::finish(
            window,
            &windows.judged(index, &situation, &samples),
            *tile,
            cells,
            depth,
            &situation,
        )?);
    }
    let moved = |order: usize| finished.iter().map(|facet| facet.moved(order)).sum::<Option<f64>>();
    let sums = (0..depth.orders.len()).filter_map(|order| Some((order, moved(order)?)));
    let best_order = sums.min_by(|(_, one), (_, two)| one.total_cmp(two)).map_or(0, |(order, _)| order);
    let depth_order = depth.orders[best_order];
    let facets: Result<Vec<Facet>, PlanError> =
        finished.into_iter().map(|facet| facet.stored(best_order)).collect();
    let facets = facets?;

    // The one facet over what is seen of some volumes holds less than everything visible.
    let mut own = draft.facets.iter().filter(|facet| !facet.is_dominant());
    let planes = match (own.next(), own.next()) {
        (Some(whole), None) if !request.volumes_world.is_empty() => &whole.receivers.planes,
        _ => &situation.receivers.planes,
    };
    let not_lit = planes.iter().enumerate().filter(|(index, _)| !lit.contains(index));
    let covered = not_lit.map(|(_, plane)| *plane).collect();
    let choice = ConfigurationChoice {
        position,
        configuration: draft.configuration,
        reason,
        predictions: if predictions.len() > 1 { predictions } else { Vec::new() },
        complete,
        fallback: draft.fallback,
        made_for_position: made_for(case, position),
    };
    let selection = draft.selection.clone();
    Ok(plan(Made { choice, depth_order, facets, selection, covered, samples: sample_count, p95_pixels }))
}

/// What was made, in camera space, with tiles from the region's corner.
struct Made {
    choice: ConfigurationChoice,
    depth_order: DepthOrder,
    facets: Vec<Facet>,
    selection: Selection,
    /// Half-spaces of the receivers that have a facet.
    covered: Vec<DVec4>,
    /// Sample receivers by which it was judged.
    samples: u32,
    p95_pixels: f64,
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

/// The walk with as many cells as the case has, in world axes.
fn walk(selection: Selection, case: &LightCase, row_to_world: &impl Fn(DVec4) -> DVec4) -> Selection {
    let shape = case.shape();
    let mut selection = selection.padded(&shape);
    if case.scales_thresholds() && selection.units.is_empty() {
        // Another configuration of the case scales its limits; this one's are plain.
        selection.units = vec![DVec4::W; (shape.halves * shape.sectors) as usize];
    }
    if !case.scales_thresholds() {
        selection.units.clear();
    }
    for row in selection.rows_mut() {
        *row = row_to_world(*row);
    }
    selection
}

/// What succeeded; the first error only where nothing did.
fn any<T>(results: impl Iterator<Item = Result<T, PlanError>>) -> Result<Vec<T>, PlanError> {
    let (mut found, mut first_error) = (Vec::new(), None);
    for result in results {
        match result {
            Ok(one) => found.push(one),
            Err(error) => first_error = first_error.or(Some(error)),
        }
    }
    match first_error {
        Some(error) if found.is_empty() => Err(error),
        _ => Ok(found),
    }
}

impl Facet {
    /// The facet with every row and vertex turned from camera axes to world axes.
    fn turned(mut self, row_to_world: &impl Fn(DVec4) -> DVec4) -> Self {
        let rows = [&mut self.rows.x, &mut self.rows.y, &mut self.rows.z, &mut self.rows.w];
        let lists = [&mut self.select, &mut self.clip, &mut self.casters, &mut self.receivers];
        // The rotation is orthogonal, so points turn as rows do.
        for row in rows.into_iter().chain(lists.into_iter().flatten()) {
            *row = row_to_world(*row);
        }
        self
    }
}
