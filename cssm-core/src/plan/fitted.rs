//! A draft fitted to the map: windows, tiles, predicted quality.

use glam::DVec3;
use smallvec::SmallVec;

use super::PlanError;
use super::fitting::Fitting;
use super::snap;
use super::texels::Texels;
use super::window::{self, Frame, Window, Windows};
use crate::case::Stability;
use crate::choose::Prediction;
use crate::facet::Tile;
use crate::layout::{self, MapArea, Spread, TileDemand};
use crate::technique::{Draft, NO_FACET, Region, Situation};

/// A draft's windows and tiles.
#[derive(Debug, Default)]
pub(crate) struct Fitted {
    pub(super) windows: Windows,
    /// Tile of each window.
    pub(super) tiles: SmallVec<[Tile; 4]>,
    /// 95th percentile of the footprint over sample receivers; infinite where too many have no facet.
    pub(super) p95_pixels: f64,
}

/// Share of sample receivers whose footprint is not above the predicted one.
pub(super) const PREDICTED: f64 = 0.95;
/// How far around it values count.
const AROUND: f64 = 0.025;

impl Fitted {
    /// Fits the windows of a draft and shares the situation's part of the map among them; tiles count from its corner.
    pub(super) fn fit(&mut self, frame: &Frame<'_>, fitting: &mut Fitting) -> Result<(), PlanError> {
        fitting.begin();
        self.begin(frame.draft.facets.len().max(fitting.room));
        self.windows.fit(frame, &mut fitting.known);
        self.place(frame, fitting)?;
        if frame.situation.case.stability == Stability::Snapped {
            snap::snap(&mut self.windows, &self.tiles, frame);
        }
        self.p95_pixels = self.predicted(frame, fitting);
        Ok(())
    }

    /// Forgets all windows and makes room for so many.
    pub(super) fn begin(&mut self, most: usize) {
        self.tiles.clear();
        self.tiles.reserve(most);
        self.windows.begin(most);
    }

    pub(super) fn prediction(&self, draft: &Draft) -> Prediction {
        Prediction {
            configuration: draft.configuration,
            form: draft.form,
            p95_pixels: if draft.complete { self.p95_pixels } else { f64::INFINITY },
        }
    }

    /// Finds the tile of each window; windows that lie better turned are turned.
    fn place(&mut self, frame: &Frame<'_>, fitting: &mut Fitting) -> Result<(), PlanError> {
        // The dominant plane's facet takes a strip over the whole width: it is as wide as the screen.
        let Self { windows, tiles, .. } = self;
        let Fitting { known, layout, demands, sharing, placed, .. } = fitting;
        let situation = frame.situation;
        let whole = map_area(situation);
        let has_dominant = windows.list.iter().any(|window| frame.facet(window).is_dominant());
        if has_dominant && whole.height < 2 * whole.smallest_side() {
            return Err(whole.too_small(windows.list.len()));
        }
        let strip = has_dominant.then(|| {
            let share = situation.case.dominant_plane.map_or(0.0, |plane| plane.share);
            let height = (f64::from(whole.height) * share).round() as u32;
            height.clamp(whole.smallest_side(), whole.height - whole.smallest_side())
        });
        let area = MapArea { height: whole.height - strip.unwrap_or(0), ..whole };
        let strip = Tile {
            x: 0,
            y: area.height,
            width: whole.width,
            height: strip.unwrap_or(0),
            gutter: whole.gutter,
        };

        // One demand for each tile; the facets of a square share one.
        for window in &windows.list {
            let facet = frame.facet(window);
            if facet.is_dominant() {
                sharing.push(NO_FACET);
                continue;
            }
            let square = |window: &Window| match frame.facet(window).region {
                Region::Tile(_) | Region::Whole(_) => None,
                Region::Triangle { square, .. } => Some(square),
            };
            let own = square(window);
            let known = own.and_then(|own| windows.list.iter().position(|known| square(known) == Some(own)));
            match known.filter(|known| *known < sharing.len()) {
                Some(known) => sharing.push(sharing[known]),
                None => {
                    sharing.push(demands.len() as u32);
                    demands.push(TileDemand {
                        request: window::request(facet),
                        spread: Spread::NONE,
                        may_turn: window.may_turn(frame.draft),
                    });
                }
            }
        }

        // Where footprints are not balanced, or a tile is alone and lies as it must or as well as turned, nobody asks what it
        // spans.
        let balanced = demands.iter().all(|demand| layout::is_balanced(demand.request));
        let turns = area.width != area.height && demands.iter().any(|demand| demand.may_turn);
        if balanced && (demands.len() > 1 || turns) {
            for (index, demand) in sharing.iter().enumerate().filter(|(_, demand)| **demand != NO_FACET) {
                let spread = &mut demands[*demand as usize].spread;
                *spread = spread.max(windows.spread(index, frame, known));
            }
        }
        if !demands.is_empty() {
            // What does not fit beside the strip does not fit the map.
            layout.place(demands, &area, placed).map_err(|error| match error {
                PlanError::MapTooSmall { .. } => whole.too_small(windows.list.len()),
                other => other,
            })?;
        }
        for (index, demand) in sharing.iter().enumerate() {
            let placement = placed.get(*demand as usize);
            tiles.push(placement.map_or(strip, |placement| placement.tile));
            if placement.is_some_and(|placement| placement.turned) {
                windows.turn(index);
            }
        }
        Ok(())
    }

    /// The predicted footprint: over the view's samples, which count by the pixels that they stand for.
    fn predicted(&self, frame: &Frame<'_>, fitting: &mut Fitting) -> f64 {
        let Self { windows, tiles, .. } = self;
        let Fitting { texels, squares, weighted, .. } = fitting;
        texels.extend(windows.list.iter().zip(tiles).map(|(window, tile)| {
            let inner = |side: u32| f64::from(side.saturating_sub(2 * tile.gutter));
            Texels::of(&window.rows, inner(tile.width), inner(tile.height), frame.situation)
        }));
        let square = |(point, owner): (&DVec3, Option<usize>)| {
            let Some(owner) = owner else { return Some((f64::INFINITY, 1.0)) };
            let square = texels[owner].major_square(*point);
            square.is_finite().then_some((square, windows.list[owner].weight))
        };
        let known = windows.owned(frame.samples).filter_map(square);
        if windows.list.iter().any(|window| window.weight != 1.0) {
            weighted.clear();
            weighted.extend(known);
            return weighted_rank(weighted).sqrt();
        }
        squares.clear();
        squares.extend(known.map(|(square, _)| square));
        around_rank(squares).sqrt()
    }
}

/// The mean logarithm's value of those around the one that the predicted share does not exceed, which tells it from fewer
/// values; 0 where there is none.
pub(super) fn around_rank(values: &mut [f64]) -> f64 {
    let count = values.len();
    let rank = |share: f64| ((share * count as f64) as usize).min(count.saturating_sub(1));
    let (first, middle, last) = (rank(PREDICTED - AROUND), rank(PREDICTED), rank(PREDICTED + AROUND));
    if count == 0 {
        return 0.0;
    }
    let (_, _, above) = values.select_nth_unstable_by(first, f64::total_cmp);
    above.sort_unstable_by(f64::total_cmp);
    if !values[middle].is_finite() {
        return f64::INFINITY;
    }
    let around = values[first..=last].iter().filter(|value| value.is_finite());
    let (mut product, mut number) = (1.0, 0);
    for value in around {
        product *= value / values[middle];
        number += 1;
    }
    values[middle] * libm::pow(product, 1.0 / f64::from(number))
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
