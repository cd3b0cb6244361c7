//! Columns: facets over a region of the light's view whose rows run with a distance row, split by the declared
//! distribution.

use glam::DVec4;

use crate::distribution::{self, DistanceRange, Piece};
use crate::receivers::{DEPTH_ROW, Polytope};
use crate::technique::{FacetDraft, Region, Situation, TileRequest};

/// A region of the light's view that is unrolled into a column of the map.
pub(super) struct Column {
    /// Its sector in the selection walk.
    pub(super) sector: u32,
    /// Row across, up to an affine change; annihilates the light.
    pub(super) across: DVec4,
    /// Distance in metres, 1 at a metre; annihilates the light.
    pub(super) distance: DVec4,
    /// Half-spaces that part it from its neighbours.
    pub(super) sides: Vec<DVec4>,
    /// Its receivers.
    pub(super) receivers: Polytope,
}

/// The facets of a column under the case's distribution, and the limits between them, ascending.
pub(super) fn facets(column: &Column, situation: &Situation<'_>) -> (Vec<FacetDraft>, Vec<f64>) {
    let pieces = distribution::split(situation.case, &range(column, situation));
    let limits = pieces.iter().skip(1).map(|piece| piece.nearest_metres).collect();
    (split(column, &pieces), limits)
}

/// The facets of a column, one for each piece.
pub(super) fn split(column: &Column, pieces: &[Piece]) -> Vec<FacetDraft> {
    let facet = |(band, piece): (usize, &Piece)| {
        let mut ends = Vec::new();
        if band > 0 {
            ends.push(column.distance - DVec4::W * piece.nearest_metres);
        }
        if band + 1 < pieces.len() {
            ends.push(DVec4::W * piece.farthest_metres - column.distance);
        }
        // Perspective rows are affine in 1/w, uniform ones in the distance itself.
        let uniform = piece.push_back_metres.is_infinite();
        FacetDraft {
            sector: column.sector,
            band: band as u32,
            x: column.across,
            y: if uniform { column.distance } else { -DVec4::W },
            w: if uniform { DVec4::W } else { column.distance + DVec4::W * piece.push_back_metres },
            receivers: column.receivers.cut_by(&ends),
            select: column.sides.iter().chain(&ends).copied().collect(),
            region: Region::Tile(TileRequest::Footprint),
        }
    };
    pieces.iter().enumerate().map(facet).collect()
}

/// The distances of a column's receivers.
pub(super) fn range(column: &Column, situation: &Situation<'_>) -> DistanceRange {
    let (nearest, farthest) = column.receivers.range(column.distance);
    let (nearest, farthest) = if nearest <= farthest { (nearest, farthest) } else { (1.0, 2.0) };

    // A direction along the light has distance 0, whatever rounding makes of it.
    let nearest = if nearest.is_finite() { nearest } else { 0.0 };
    let (depth_near, _) = situation.receivers.range(DEPTH_ROW);
    DistanceRange {
        nearest_metres: nearest,
        farthest_metres: farthest,
        core_metres: (depth_near - nearest).max(0.0),
    }
}
