//! Columns: facets over a region of the light's view whose rows run with a distance row, split by the declared
//! distribution.

use glam::DVec4;
use smallvec::smallvec;

use crate::distribution::{self, DistanceRange, Piece};
use crate::facet::Cell;
use crate::fit;
use crate::receivers::{DEPTH_ROW, Polytope, Slices};
use crate::remap::Curve;
use crate::technique::{Draft, FacetDraft, Region, Sides, Situation, TileRequest};

/// Slant up to which pieces ask for the footprint of the others.
const STEEPEST_SLANT: f64 = 8.0;
/// Largest footprint that a piece asks for, in footprints of the others.
const COARSEST: f64 = 100.0;

/// A region of the light's view that is unrolled into a column of the map. Its distance in metres is the ratio of two
/// rows, which both annihilate the light.
pub(super) struct Column {
    /// Its half in the selection walk.
    pub(super) half: u32,
    /// Its sector in the half.
    pub(super) sector: u32,
    /// Row across, up to an affine change; annihilates the light.
    pub(super) across: DVec4,
    /// Numerator of the distance.
    pub(super) distance: DVec4,
    /// Denominator of the distance, positive on receivers; (0, 0, 0, 1) for a directional light.
    pub(super) unit: DVec4,
    /// How far lines of equal place across lean, at most: 1 is half a right angle.
    pub(super) slant: f64,
    /// Half-spaces that part it from its neighbours.
    pub(super) sides: Sides,
    /// Its receivers.
    pub(super) receivers: Polytope,
}

/// Adds the facets of a column under the case's distribution, and the limits between them.
pub(super) fn add(column: &Column, situation: &Situation<'_>, draft: &mut Draft) {
    let bends = distribution::remap_kind(situation.case) != distribution::RemapKind::None;
    let range = DistanceRange { bends, ..range(column, situation) };
    let pieces = distribution::split(situation.case, &range);
    draft.selection.thresholds.extend(pieces.iter().skip(1).map(|piece| piece.nearest_metres));
    split(column, &pieces, draft);
}

/// Adds the facets of a column, one for each piece.
pub(super) fn split(column: &Column, pieces: &[Piece], draft: &mut Draft) {
    // Pieces mostly lie one behind the other.
    let follow = |pair: &[Piece]| {
        let limit = pair[0].farthest_metres;
        limit.is_finite() && limit == pair[1].nearest_metres && limit < pair[1].farthest_metres
    };
    let are_slices = pieces.windows(2).all(follow);
    let whole = column.receivers.body();
    let mut slices = are_slices.then(|| Slices::of(whole, column.distance, column.unit)).flatten();
    draft.reserve(pieces.len());
    for (band, piece) in pieces.iter().enumerate() {
        let mut ends = Sides::new();
        if band > 0 {
            ends.push(column.distance - column.unit * piece.nearest_metres);
        }
        if band + 1 < pieces.len() {
            ends.push(column.unit * piece.farthest_metres - column.distance);
        }
        // Perspective rows are affine in 1/w, uniform ones in the distance itself; bent ones begin with 1/w.
        let uniform = piece.push_back_metres.is_infinite();
        let (y, w) = match (uniform, piece.curve) {
            (true, _) => (column.distance, column.unit),
            (false, Curve::Straight) => {
                (-column.unit, column.distance + column.unit * piece.push_back_metres)
            }
            (false, _) => (column.unit, column.distance + column.unit * piece.push_back_metres),
        };
        let last = band + 1 == pieces.len();
        let receivers = match &mut slices {
            Some(slices) => slices.next((!last).then_some(piece.farthest_metres), &mut draft.bodies),
            None => draft.bodies.add(whole.cut_by(&ends).body()),
        };
        draft.facets.push(FacetDraft {
            cells: smallvec![Cell { half: column.half, sector: column.sector, band: band as u32 }],
            x: column.across,
            y,
            curve: if uniform { Curve::Straight } else { piece.curve },
            w,
            receivers,
            select: column.sides.iter().chain(&ends).copied().collect(),
            region: Region::Tile(request(column, piece)),
        });
    }
}

/// What a piece asks for: a finer footprint where its weight says so, one that grows beyond a focus. Beyond a slant texels
/// grow as well, so that the column vanishes from the map as its region vanishes from the light's view.
fn request(column: &Column, piece: &Piece) -> TileRequest {
    let slanted = (column.slant / STEEPEST_SLANT).sqrt().clamp(1.0, COARSEST);
    let (times, focus_metres) = (slanted / piece.weight, piece.focus_metres);
    if times == 1.0 && focus_metres.is_infinite() {
        TileRequest::Footprint
    } else {
        TileRequest::Coarser { times, focus_metres }
    }
}

/// The distances of a column's receivers, for rows that are not bent.
pub(super) fn range(column: &Column, situation: &Situation<'_>) -> DistanceRange {
    let (nearest, farthest) = column.receivers.quotient_range(column.distance, column.unit);
    let (nearest, farthest) = if nearest <= farthest { (nearest, farthest) } else { (1.0, 2.0) };

    // A direction along the light has distance 0, whatever rounding makes of it.
    let nearest = if nearest.is_finite() { nearest } else { 0.0 };
    let (depth_near, _) = situation.receivers.range(DEPTH_ROW);
    let view_near = situation.view.near_metres;
    let unlit = situation.light.w > 0.0 && depth_near > view_near;
    let (core, rows) = ((depth_near - nearest).max(0.0), [column.distance, column.unit]);
    let (nearest, farthest) =
        fit::narrowed_range(situation, &column.sides, rows).unwrap_or((nearest, farthest));
    DistanceRange {
        nearest_metres: nearest,
        farthest_metres: farthest,
        seen: situation.profile(&column.sides, rows, core),
        core_metres: core,
        unlit_near_metres: unlit.then_some(view_near),
        eye_height_metres: situation.eye_height_metres,
        bends: false,
    }
}
