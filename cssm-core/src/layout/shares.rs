//! Shares of the map: tiles as square as can be.

use super::strips::{self, Few, Strip};
use super::{MapArea, TileDemand};
use crate::facet::Tile;
use crate::plan::PlanError;
use crate::technique::TileRequest;
use smallvec::{SmallVec, smallvec};

pub(super) fn place(demands: &[TileDemand], area: &MapArea, tiles: &mut Few<Tile>) -> Result<(), PlanError> {
    if let ([_], true) = (demands, area.width.min(area.height) >= area.smallest_side()) {
        let MapArea { width, height, gutter, .. } = *area;
        tiles.clear();
        tiles.push(Tile { x: 0, y: 0, width, height, gutter });
        return Ok(());
    }
    let total = f64::from(area.width) * f64::from(area.height);
    let areas: Few<f64> =
        demands.iter().map(|demand| asked(&demand.request, demands.len()) * total).collect();
    let sum: f64 = areas.iter().sum();
    let areas: Few<f64> = areas.iter().map(|area| area / sum * total).collect();

    // Try upright and lying strips and keep the better.
    let orientations = if area.strips.is_some() { &[true][..] } else { &[true, false][..] };
    let mut best: Option<(f64, Few<Tile>)> = None;
    for upright in orientations {
        let along = f64::from(if *upright { area.height } else { area.width });
        let wishes: Few<Wish> = areas.iter().map(|area| Wish { area: *area, across: area.sqrt() }).collect();
        let strips: Few<Strip> = partition(&wishes, along, area.strips)
            .iter()
            .map(|strip| Strip {
                side: strip.iter().map(|index| areas[*index]).sum(),
                tiles: strip.iter().map(|index| (*index, areas[*index])).collect(),
            })
            .collect();
        let Some(tiles) = strips::tiles(strips.iter(), demands.len(), area, *upright) else { continue };
        let misfit = misfit(&tiles);
        if best.as_ref().is_none_or(|(least, _)| misfit < *least) {
            best = Some((misfit, tiles));
        }
    }
    let (_, best) = best.ok_or_else(|| area.too_small(demands.len()))?;
    tiles.clear();
    tiles.extend(best);
    Ok(())
}

/// Share of the map that a facet asks for; an even one where it does not say.
fn asked(request: &TileRequest, facets: usize) -> f64 {
    match request {
        TileRequest::Share(share) => *share,
        TileRequest::Footprint | TileRequest::Coarser { .. } | TileRequest::Fixed(..) => 1.0 / facets as f64,
    }
}

/// Largest deviation of a tile's inner part from a square.
fn misfit(tiles: &[Tile]) -> f64 {
    let one = |tile: &Tile| {
        let inner = |side: u32| f64::from(side - 2 * tile.gutter);
        libm::fabs(libm::log(inner(tile.height) / inner(tile.width)))
    };
    tiles.iter().map(one).fold(0.0, f64::max)
}

/// A tile's area in texels and the width it would like across the strip.
#[derive(Debug, Clone, Copy)]
struct Wish {
    area: f64,
    across: f64,
}

/// Tiles of each strip, in order.
type Partition = Few<Few<usize>>;

/// Splits the wishes, ordered by width, into strips so that widths differ least from those wished. `length` is the
/// strips' length; `count` their number, if declared. Cost is the area-weighted squared logarithm of the misfit.
fn partition(wishes: &[Wish], length: f64, count: Option<u32>) -> Partition {
    let mut order: Few<usize> = (0..wishes.len()).collect();
    order.sort_by(|one, two| wishes[*two].across.total_cmp(&wishes[*one].across).then(one.cmp(two)));

    // Cost of a strip of neighbours, from running sums of area, area log(width) and area log(width)^2.
    let mut sums: Few<(f64, f64, f64)> = smallvec![(0.0, 0.0, 0.0)];
    for index in &order {
        let (wish, last) = (&wishes[*index], sums[sums.len() - 1]);
        let logarithm = libm::log(wish.across);
        let weighted = wish.area * logarithm;
        sums.push((last.0 + wish.area, last.1 + weighted, last.2 + weighted * logarithm));
    }
    let cost = |from: usize, to: usize| -> f64 {
        let (start, end) = (sums[from], sums[to]);
        let (area, first, second) = (end.0 - start.0, end.1 - start.1, end.2 - start.2);
        let across = libm::log(area / length);
        (area * across - 2.0 * first) * across + second
    };

    // best[s][i]: least cost of the first i tiles in s strips.
    let tiles = wishes.len();
    let strips = count.map_or(tiles, |count| (count as usize).min(tiles));
    let places = tiles + 1;
    let mut costs: SmallVec<[f64; 64]> = SmallVec::from_elem(0.0, places * places);
    for to in 0..places {
        for from in 0..to {
            costs[to * places + from] = cost(from, to);
        }
    }
    let mut best: SmallVec<[(f64, usize); 64]> =
        SmallVec::from_elem((f64::INFINITY, 0), places * (strips + 1));
    best[0].0 = 0.0;
    for strip in 1..=strips {
        for to in 1..=tiles {
            for from in 0..to {
                let total = best[(strip - 1) * places + from].0 + costs[to * places + from];
                if total < best[strip * places + to].0 {
                    best[strip * places + to] = (total, from);
                }
            }
        }
    }
    let fewest = if count.is_some() { strips } else { 1 };
    let least = |strip: usize| best[strip * places + tiles].0;
    let chosen = (fewest..=strips).min_by(|one, two| least(*one).total_cmp(&least(*two)));
    let mut strip = chosen.unwrap_or(0);
    let mut parts = Partition::new();
    let mut to = tiles;
    while strip > 0 {
        let from = best[strip * places + to].1;
        parts.push(Few::from_slice(&order[from..to]));
        (to, strip) = (from, strip - 1);
    }
    parts.reverse();
    parts
}
