//! A draft fitted to the map: windows, tiles, predicted quality.

use glam::DVec3;

use super::PlanError;
use super::window::{self, Window};
use crate::choose::Prediction;
use crate::facet::Tile;
use crate::layout::{self, MapArea, TileDemand};
use crate::technique::{Draft, Region, Situation};

/// A draft with a tile for every facet that has receivers.
pub(super) struct Fitted<'a> {
    pub(super) draft: &'a Draft,
    pub(super) windows: Vec<Window<'a>>,
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

/// Fits the windows of a draft and shares the situation's part of the map among them; tiles count from its corner.
pub(super) fn fit<'a>(
    draft: &'a Draft,
    situation: &Situation<'_>,
    samples: &[DVec3],
) -> Result<Fitted<'a>, PlanError> {
    let (mut windows, outside) = window::fit(draft, situation, samples);
    let whole = map_area(situation);

    // The dominant plane's facet takes a strip over the whole width: it is as wide as the screen.
    let has_dominant = windows.iter().any(|window| window.draft.is_dominant());
    if has_dominant && whole.height < 2 * whole.smallest_side() {
        return Err(whole.too_small(windows.len()));
    }
    let strip = has_dominant.then(|| {
        let share = situation.case.dominant_plane.map_or(0.0, |plane| plane.share);
        let height = (f64::from(whole.height) * share).round() as u32;
        height.clamp(whole.smallest_side(), whole.height - whole.smallest_side())
    });
    let area = MapArea { height: whole.height - strip.unwrap_or(0), ..whole };
    let strip =
        strip.map(|height| Tile { x: 0, y: area.height, width: whole.width, height, gutter: whole.gutter });

    // One demand for each tile: a facet's own, or a square's.
    let mut demands: Vec<TileDemand> = Vec::new();
    let mut squares: Vec<(u32, usize)> = Vec::new();
    let mut places = Vec::with_capacity(windows.len());
    for window in windows.iter().filter(|window| !window.draft.is_dominant()) {
        let known = match window.draft.region {
            Region::Tile(_) | Region::Whole(_) => None,
            Region::Triangle { square, .. } => squares.iter().find(|(known, _)| *known == square),
        };
        let place = match known {
            Some((_, place)) => {
                demands[*place].samples.extend_from_slice(&window.grams);
                *place
            }
            None => {
                demands.push(window.demand());
                if let Region::Triangle { square, .. } = window.draft.region {
                    squares.push((square, demands.len() - 1));
                }
                demands.len() - 1
            }
        };
        places.push(place);
    }
    let placed = if demands.is_empty() { Vec::new() } else { layout::place(&demands, &area)? };
    let mut places = places.into_iter();
    let tile = |window: &mut Window<'_>| match strip {
        Some(strip) if window.draft.is_dominant() => Some(strip),
        _ => places.next().map(|place| {
            if placed[place].turned {
                window.turn();
            }
            placed[place].tile
        }),
    };
    let tiles: Vec<Tile> = windows.iter_mut().filter_map(tile).collect();

    // Predict over the view's own samples, not over those added where a facet had few.
    let mut footprints = vec![f64::INFINITY; outside];
    for (window, tile) in windows.iter().zip(&tiles) {
        let inner = |side: u32| f64::from(side.saturating_sub(2 * tile.gutter));
        let (width, height) = (inner(tile.width), inner(tile.height));
        let seen = window.grams.iter().take(window.seen);
        footprints.extend(seen.map(|gram| gram.major_pixels(width, height)));
    }
    footprints.sort_by(f64::total_cmp);
    let rank = (0.95 * footprints.len() as f64) as usize;
    let p95_pixels = footprints.get(rank).copied().unwrap_or(0.0);
    Ok(Fitted { draft, windows, tiles, p95_pixels })
}

/// The part of the map that a situation's facets share.
pub(super) fn map_area(situation: &Situation<'_>) -> MapArea {
    let (width, height) = situation.map_size_texels;
    let case = situation.case;
    MapArea { width, height, gutter: case.gutter_texels(), strips: case.map.columns }
}
