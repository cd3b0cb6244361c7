//! Texels of linear facets on a lattice that is fixed in the world: its axes, its pitch and its origin depend on the light
//! alone, so that a static edge keeps its texels while the camera moves.

use glam::{DVec2, DVec4};

use super::window::{Frame, Window, Windows};
use crate::facet::Tile;
use crate::remap::Curve;
use crate::technique::{Draft, FacetDraft, Region, Situation, light_plane_axes};
use crate::view::View;

/// Pitches per octave; a texel is larger than it need be by at most one step.
const PITCHES_PER_OCTAVE: f64 = 8.0;
/// Part of a pitch by which rounding may move one that lies on the ladder.
const SAME_PITCH: f64 = 1e-9;

/// Fixes the axes of a draft's linear facets in the world.
pub(super) fn align(draft: &mut Draft, situation: &Situation<'_>) {
    if situation.light.w != 0.0 {
        return;
    }
    let camera_from_world = situation.view.camera_from_world;
    let light_world = camera_from_world.transpose() * situation.light.truncate();
    let (x, y) = light_plane_axes(light_world.extend(0.0));
    let to_camera = |axis: DVec4| (camera_from_world * axis.truncate()).extend(0.0);
    for facet in draft.facets.iter_mut().filter(|facet| is_linear(facet)) {
        (facet.x, facet.y) = (to_camera(x), to_camera(y));
    }
}

/// Enlarges the windows of linear facets to whole texels of the lattice, whose pitch is the next one that holds them.
pub(super) fn snap(windows: &mut Windows, tiles: &[Tile], frame: &Frame<'_>) {
    let view = frame.situation.view;
    for (index, tile) in tiles.iter().enumerate() {
        let window = &windows.list[index];
        if !is_linear(frame.facet(window)) {
            continue;
        }
        let across = Snapped::of(window, window.rows.x, tile.width.saturating_sub(2 * tile.gutter), view);
        let up = Snapped::of(window, window.rows.y, tile.height.saturating_sub(2 * tile.gutter), view);
        if let (Some(across), Some(up)) = (across, up) {
            let scale = DVec2::new(across.scale, up.scale);
            windows.moved(index, scale, DVec2::new(across.shift, up.shift));
        }
    }
}

/// Whether a facet's texels are equal parallelograms all over, in a tile of its own.
fn is_linear(facet: &FacetDraft) -> bool {
    let alone = matches!(facet.region, Region::Tile(_)) && !facet.is_dominant();
    alone && facet.w == DVec4::W && facet.curve == Curve::Straight
}

/// What a clip coordinate is scaled by and then shifted by.
struct Snapped {
    scale: f64,
    shift: f64,
}

impl Snapped {
    /// `row` is linear and spans the window's receivers from -1 to 1 over so many texels.
    fn of(window: &Window, row: DVec4, texels: u32, view: &View) -> Option<Self> {
        // Find the next pitch with which the window, wherever it begins, spans whole texels.
        let per_metre = row.truncate().length() / window.rows.w.w;
        let texels = f64::from(texels);
        let least = 2.0 / per_metre / (texels - 1.0);
        let step = libm::ceil(libm::log2(least) * PITCHES_PER_OCTAVE - SAME_PITCH);
        let pitch = libm::exp2(step / PITCHES_PER_OCTAVE);
        if texels < 2.0 || !pitch.is_finite() || pitch <= 0.0 {
            return None;
        }

        // Begin at a whole texel from the world's origin.
        let axis_world = view.camera_from_world.transpose() * row.truncate().normalize();
        let eye = axis_world.dot(view.eye_world);
        let low = (-1.0 - row.w) / per_metre;
        let begin = libm::floor((low + eye) / pitch) * pitch - eye;
        let scale = 2.0 / (texels * pitch * per_metre);
        Some(Self { scale, shift: -1.0 - scale * (per_metre * begin + row.w) })
    }
}
