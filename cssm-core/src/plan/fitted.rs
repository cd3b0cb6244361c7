//! A draft fitted to the map: windows, tiles, predicted quality.

use glam::DVec3;
use smallvec::SmallVec;

use super::PlanError;
use super::snap;
use super::texels::Texels;
use super::window::{self, Window, Windows};
use crate::case::Stability;
use crate::choose::Prediction;
use crate::facet::Tile;
use crate::layout::{self, MapArea, Spread, TileDemand};
use crate::technique::{Draft, Region, Situation};

/// A draft with a tile for every facet that has receivers.
pub(super) struct Fitted<'a> {
    pub(super) draft: &'a Draft,
    pub(super) windows: Windows<'a>,
    /// Tile of each window.
    pub(super) tiles: Vec<Tile>,
    /// 95th percentile of the footprint over sample receivers; infinite where too many have no facet.
    pub(super) p95_pixels: f64,
}

impl Fitted<'_> {
    pub(super) fn prediction(&self) -> Prediction {
        Prediction {
            configuration: self.draft.configuration,
            form: self.draft.form,
            p95_pixels: if self.draft.complete { self.p95_pixels } else { f64::INFINITY },
        }
    }
}

/// Share of sample receivers whose footprint is not above the predicted one.
pub(super) const PREDICTED: f64 = 0.95;

/// Fits the windows of a draft and shares the situation's part of the map among them; tiles count from its corner.
pub(super) fn fit<'a>(
    draft: &'a Draft,
    situation: &Situation<'_>,
    samples: &[DVec3],
) -> Result<Fitted<'a>, PlanError> {
    let mut windows = window::fit(draft, situation, samples);
    let tiles = tiles(&mut windows, situation, samples)?;
    if situation.case.stability == Stability::Snapped {
        snap::snap(&mut windows, &tiles, situation.view);
    }
    let p95_pixels = predicted(&windows, &tiles, situation, samples);
    Ok(Fitted { draft, windows, tiles, p95_pixels })
}

/// The tile of each window; windows that lie better turned are turned.
fn tiles(
    windows: &mut Windows<'_>,
    situation: &Situation<'_>,
    samples: &[DVec3],
) -> Result<Vec<Tile>, PlanError> {
    // The dominant plane's facet takes a strip over the whole width: it is as wide as the screen.
    let whole = map_area(situation);
    let has_dominant = windows.list.iter().any(|window| window.draft.is_dominant());
    if has_dominant && whole.height < 2 * whole.smallest_side() {
        return Err(whole.too_small(windows.list.len()));
    }
    let strip = has_dominant.then(|| {
        let share = situation.case.dominant_plane.map_or(0.0, |plane| plane.share);
        let height = (f64::from(whole.height) * share).round() as u32;
        height.clamp(whole.smallest_side(), whole.height - whole.smallest_side())
    });
    let area = MapArea { height: whole.height - strip.unwrap_or(0), ..whole };
    let strip =
        Tile { x: 0, y: area.height, width: whole.width, height: strip.unwrap_or(0), gutter: whole.gutter };

    // Find who shares a tile: the facets of a square.
    let mut shared: SmallVec<[SmallVec<[usize; 4]>; 4]> = SmallVec::new();
    let mut squares: SmallVec<[(u32, usize); 4]> = SmallVec::new();
    for (index, window) in windows.list.iter().enumerate().filter(|(_, window)| !window.draft.is_dominant()) {
        let square = match window.draft.region {
            Region::Tile(_) | Region::Whole(_) => None,
            Region::Triangle { square, .. } => Some(square),
        };
        let known = square.and_then(|square| squares.iter().find(|(known, _)| *known == square));
        match known {
            Some((_, place)) => shared[*place].push(index),
            None => {
                squares.extend(square.map(|square| (square, shared.len())));
                shared.push(SmallVec::from_slice(&[index]));
            }
        }
    }

    // One demand for each tile; where footprints are not balanced, or a tile is alone and lies as it must or as well as
    // turned, nobody asks what it spans.
    let first = |sharers: &SmallVec<[usize; 4]>| &windows.list[sharers[0]];
    let balanced = shared.iter().all(|sharers| layout::is_balanced(window::request(first(sharers).draft)));
    let turns = area.width != area.height && shared.iter().any(|sharers| first(sharers).may_turn());
    let asked = balanced && (shared.len() > 1 || turns);
    let demand = |sharers: &SmallVec<[usize; 4]>| {
        let spreads = sharers.iter().filter(|_| asked);
        let spreads = spreads.map(|index| windows.spread(*index, situation, samples));
        TileDemand {
            request: window::request(first(sharers).draft),
            spread: spreads.fold(Spread::NONE, Spread::max),
            may_turn: first(sharers).may_turn(),
        }
    };
    let demands: SmallVec<[TileDemand; 8]> = shared.iter().map(demand).collect();
    // What does not fit beside the strip does not fit the map.
    let of_map = |error| match error {
        PlanError::MapTooSmall { .. } => whole.too_small(windows.list.len()),
        other => other,
    };
    let placed =
        if demands.is_empty() { Vec::new() } else { layout::place(&demands, &area).map_err(of_map)? };
    let mut tiles = vec![strip; windows.list.len()];
    for (sharers, placement) in shared.iter().zip(&placed) {
        for index in sharers {
            tiles[*index] = placement.tile;
            if placement.turned {
                windows.turn(*index);
            }
        }
    }
    Ok(tiles)
}

/// The predicted footprint: over the view's samples, which count by the pixels that they stand for.
fn predicted(windows: &Windows<'_>, tiles: &[Tile], situation: &Situation<'_>, samples: &[DVec3]) -> f64 {
    let texels = |(window, tile): (&Window<'_>, &Tile)| {
        let inner = |side: u32| f64::from(side.saturating_sub(2 * tile.gutter));
        Texels::of(window, inner(tile.width), inner(tile.height), situation)
    };
    let texels: SmallVec<[Texels; 32]> = windows.list.iter().zip(tiles).map(texels).collect();
    let square = |(point, owner): (&DVec3, Option<usize>)| {
        let Some(owner) = owner else { return Some((f64::INFINITY, 1.0)) };
        let square = texels[owner].major_square(*point);
        square.is_finite().then_some((square, windows.list[owner].weight))
    };
    let squares = windows.owned(samples).filter_map(square);
    if windows.list.iter().any(|window| window.weight != 1.0) {
        return weighted_rank(&mut squares.collect::<Vec<_>>()).sqrt();
    }
    let mut squares: SmallVec<[f64; 512]> = squares.map(|(square, _)| square).collect();
    let rank = (PREDICTED * squares.len() as f64) as usize;
    if rank >= squares.len() {
        return 0.0;
    }
    let (_, square, _) = squares.select_nth_unstable_by(rank, f64::total_cmp);
    square.sqrt()
}

/// The value that the predicted share of the weight does not exceed; 0 where there is none.
fn weighted_rank(values: &mut [(f64, f64)]) -> f64 {
    values.sort_unstable_by(|one, two| one.0.total_cmp(&two.0));
    let limit = PREDICTED * values.iter().map(|(_, weight)| weight).sum::<f64>();
    let mut passed = 0.0;
    let ranked = values.iter().find(|(_, weight)| {
        passed += weight;
        passed > limit
    });
    ranked.map_or(0.0, |(value, _)| *value)
}

/// The part of the map that a situation's facets share.
pub(super) fn map_area(situation: &Situation<'_>) -> MapArea {
    let (width, height) = situation.map_size_texels;
    let case = situation.case;
    MapArea { width, height, gutter: case.gutter_texels(), strips: case.map.columns }
}
