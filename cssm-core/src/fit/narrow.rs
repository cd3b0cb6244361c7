//! Parts of the receivers that are known to hold everything seen, and facets narrowed to them.

use glam::DVec4;

use super::{Cut, CutBounds, DepthHistogram, Seen, sweep};
use crate::facet::FacetRows;
use crate::plan::{BoundingBox, PlanError};
use crate::receivers::{Polytope, extremes, is_negligible};
use crate::technique::{Draft, FacetDraft, Sides, Situation};
use crate::view::View;

/// How far volumes are moved out, in distances from the eye: single precision in whatever made them.
const VOLUME_MARGIN: f64 = 1e-5;
/// How far measured depths are moved apart, relative: single precision in the reduction.
const DEPTH_MARGIN: f64 = 1e-4;
/// How far measured rectangles are moved out, pixels.
const PIXEL_MARGIN: f64 = 1.0;
/// How far a facet's window is moved out, relative to its size.
const WINDOW_MARGIN: f64 = 1e-9;

/// Parts of the receivers that hold everything seen that may be in shadow, and what they were cut by; nothing where no such
/// thing is known.
pub(super) fn parts(
    view: &View,
    light: DVec4,
    receivers: &Polytope,
    seen: &Seen<'_>,
    depth: Option<&DepthHistogram>,
) -> Result<(Option<Vec<Polytope>>, Cut), PlanError> {
    // Leave out what no caster stands before.
    let mut shadowed = receivers.clone();
    if let Some(casters) = &seen.casters_world {
        checked(casters, "the casters' bounding box")?;
        let from_eye = moved(casters, view);
        let rotation = view.camera_from_world;
        let light_world = (rotation.transpose() * light.truncate()).extend(light.w);
        for plane in sweep::half_spaces(&from_eye, light_world) {
            shadowed.cut((rotation * plane.truncate()).extend(plane.w));
        }
    }

    // Depth of this very frame is the tightest; then come volumes.
    if let Some(depth) = depth.filter(|depth| is_of(depth, view)) {
        return Ok((Some(measured(depth, view, &shadowed)), Cut::Depth));
    }
    if seen.volumes_world.is_empty() {
        return Ok(match seen.casters_world {
            Some(_) => (Some(vec![shadowed]), Cut::Bounds(CutBounds::of(seen))),
            None => (None, Cut::None),
        });
    }
    let mut parts = Vec::with_capacity(seen.volumes_world.len());
    for volume in seen.volumes_world {
        checked(volume, "a receivers' bounding volume")?;
        let from_eye = moved(volume, view);
        let mut part = shadowed.clone();
        part.cut_by_box(&from_eye, glam::DVec3::ZERO, &view.camera_from_world);
        if !part.vertices.is_empty() {
            parts.push(part);
        }
    }
    Ok((Some(parts), Cut::Bounds(CutBounds::of(seen))))
}

fn checked(bounds: &BoundingBox, what: &'static str) -> Result<(), PlanError> {
    let BoundingBox { min, max } = *bounds;
    if !min.is_finite() || !max.is_finite() {
        return Err(PlanError::NotFinite { what });
    }
    if min.cmpgt(max).any() { Err(PlanError::Bounds { min, max }) } else { Ok(()) }
}

/// A box relative to the eye, a little larger.
fn moved(bounds: &BoundingBox, view: &View) -> BoundingBox {
    let (min, max) = (bounds.min - view.eye_world, bounds.max - view.eye_world);
    let margin = VOLUME_MARGIN * min.abs().max(max.abs()).max_element();
    BoundingBox { min: min - margin, max: max + margin }
}

/// Whether depth was measured in this view, in this frame. The near planes may differ.
fn is_of(depth: &DepthHistogram, view: &View) -> bool {
    let near = view.near_metres;
    depth.latency_frames == 0
        && View { near_metres: near, ..depth.view } == View { near_metres: near, ..*view }
}

/// A part for each bin with pixels.
fn measured(depth: &DepthHistogram, view: &View, receivers: &Polytope) -> Vec<Polytope> {
    let (width, height) = (f64::from(view.size_pixels.0), f64::from(view.size_pixels.1));
    let across = |x: f64| view.left + (view.right - view.left) * x / width;
    let up = |y: f64| view.top + (view.bottom - view.top) * y / height;
    let part = |(index, bin): (usize, &super::DepthBin)| {
        let (low, high) = depth.part(index).filter(|_| bin.pixels > 0.0)?;
        let [left, upper, right, lower] = bin.rectangle_pixels;
        let part = receivers.cut_by(&[
            DVec4::new(0.0, 0.0, -1.0, -low * (1.0 - DEPTH_MARGIN)),
            DVec4::new(0.0, 0.0, 1.0, high * (1.0 + DEPTH_MARGIN)),
            DVec4::new(1.0, 0.0, across(left - PIXEL_MARGIN), 0.0),
            DVec4::new(-1.0, 0.0, -across(right + PIXEL_MARGIN), 0.0),
            DVec4::new(0.0, -1.0, -up(upper - PIXEL_MARGIN), 0.0),
            DVec4::new(0.0, 1.0, up(lower + PIXEL_MARGIN), 0.0),
        ]);
        (!part.vertices.is_empty()).then_some(part)
    };
    depth.bins.iter().enumerate().filter_map(part).collect()
}

/// Shows every vertex of what some half-spaces leave of a part.
fn vertices_within(part: &Polytope, planes: &[DVec4], show: &mut impl FnMut(&DVec4)) {
    // Most parts lie on one side of each plane.
    let mut crossing = false;
    for plane in planes {
        let (low, high) = extremes(part.vertices.iter().map(|vertex| plane.dot(*vertex)));
        if high < 0.0 {
            return;
        }
        crossing |= low < 0.0;
    }
    if crossing {
        part.cut_by(planes).vertices.iter().for_each(show);
    } else {
        part.vertices.iter().for_each(show);
    }
}

/// Smallest and largest quotient of two rows over what is seen within some half-spaces, if that is known and there is
/// anything.
pub(crate) fn narrowed_range(
    situation: &Situation<'_>,
    within: &[DVec4],
    [row, unit]: [DVec4; 2],
) -> Option<(f64, f64)> {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for part in situation.sighted.parts.as_ref()? {
        vertices_within(part, within, &mut |vertex| {
            let (value, scale) = (row.dot(*vertex), unit.dot(*vertex));
            if scale > 0.0 && !is_negligible(scale, unit, *vertex) {
                low = low.min(value / scale);
                high = high.max(value / scale);
            } else if !is_negligible(value, row, *vertex) {
                low = low.min(value * f64::INFINITY);
                high = high.max(value * f64::INFINITY);
            }
        });
    }
    (low <= high).then_some((low, high))
}

/// Narrows a draft's facets to what is seen; facets that nothing seen lies in are gone.
pub(crate) fn narrow(draft: &mut Draft, situation: &Situation<'_>) {
    if let Some(parts) = &situation.sighted.parts {
        let Draft { facets, bodies, .. } = draft;
        facets.retain_mut(|facet| {
            let sides = window(facet, parts);
            if let Some(sides) = &sides
                && !sides.is_empty()
            {
                let receivers = bodies.get(facet.receivers).cut_by(sides);
                facet.receivers = bodies.add(receivers.body());
            }
            sides.is_some()
        });
    }
}

/// Half-spaces around what is seen of a facet; `None` where there is nothing.
fn window(facet: &FacetDraft, parts: &[Polytope]) -> Option<Sides> {
    let rows = FacetRows { x: facet.x, y: facet.y, z: facet.w, w: facet.w, remap: crate::remap::Remap::NONE };
    let mut window = [(f64::INFINITY, f64::NEG_INFINITY); 2];
    let mut along_light = false;
    for part in parts {
        vertices_within(part, &facet.select, &mut |vertex| {
            let scale = rows.w.dot(*vertex);
            if scale <= 0.0 || is_negligible(scale, rows.w, *vertex) {
                along_light = true;
                return;
            }
            for (range, row) in window.iter_mut().zip([rows.x, rows.y]) {
                let value = row.dot(*vertex) / scale;
                *range = (range.0.min(value), range.1.max(value));
            }
        });
    }
    if window[0].0 > window[0].1 {
        // Vertices along the light alone have no place in the window; keep what holds them.
        return along_light.then(Sides::new);
    }
    let mut sides = Sides::new();
    for ((low, high), row) in window.into_iter().zip([rows.x, rows.y]) {
        let margin = WINDOW_MARGIN * (high - low);
        sides.extend([row - rows.w * (low - margin), rows.w * (high + margin) - row]);
    }
    Some(if sides.iter().all(|side| side.is_finite()) { sides } else { Sides::new() })
}
