//! Which tiles share a strip, and whole-texel sides that fill the map.

use super::MapArea;
use crate::facet::Tile;

/// A tile's area in texels and the width it would like across the strip.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wish {
    pub(super) area: f64,
    pub(super) across: f64,
}

/// Tiles of each strip, in order.
pub(super) type Partition = Vec<Vec<usize>>;

/// Splits the wishes, ordered by width, into strips so that widths differ least from those wished. `length` is the
/// strips' length; `count` their number, if declared. Cost is the area-weighted squared logarithm of the misfit.
pub(super) fn partition(wishes: &[Wish], length: f64, count: Option<u32>) -> Partition {
    let mut order: Vec<usize> = (0..wishes.len()).collect();
    order.sort_by(|one, two| wishes[*two].across.total_cmp(&wishes[*one].across).then(one.cmp(two)));

    // Cost of a strip of neighbours, from running sums of area, area log(width) and area log(width)^2.
    let mut sums = vec![(0.0, 0.0, 0.0)];
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
    let costs: Vec<Vec<f64>> = (0..=tiles).map(|to| (0..to).map(|from| cost(from, to)).collect()).collect();
    let mut best = vec![vec![(f64::INFINITY, 0); tiles + 1]; strips + 1];
    best[0][0].0 = 0.0;
    for strip in 1..=strips {
        for to in 1..=tiles {
            for from in 0..to {
                let total = best[strip - 1][from].0 + costs[to][from];
                if total < best[strip][to].0 {
                    best[strip][to] = (total, from);
                }
            }
        }
    }
    let fewest = if count.is_some() { strips } else { 1 };
    let chosen = (fewest..=strips).min_by(|one, two| best[*one][tiles].0.total_cmp(&best[*two][tiles].0));
    let mut strip = chosen.unwrap_or(0);
    let mut parts = Vec::with_capacity(strip);
    let mut to = tiles;
    while strip > 0 {
        let from = best[strip][to].1;
        parts.push(order[from..to].to_vec());
        (to, strip) = (from, strip - 1);
    }
    parts.reverse();
    parts
}

/// Whole-texel tiles of a partition: strips side by side across the map, tiles end to end along each. `None` when the
/// smallest sides do not fit.
pub(super) fn tiles(
    partition: &Partition,
    areas: &[f64],
    area: &MapArea,
    upright: bool,
) -> Option<Vec<Tile>> {
    let (across, along) = if upright { (area.width, area.height) } else { (area.height, area.width) };
    let strip_areas: Vec<f64> =
        partition.iter().map(|strip| strip.iter().map(|index| areas[*index]).sum()).collect();
    let strip_sides = share(&strip_areas, across, area.smallest_side())?;
    let mut tiles = vec![Tile { x: 0, y: 0, width: 0, height: 0, gutter: area.gutter }; areas.len()];
    let mut strip_start = 0;
    for (strip, strip_side) in partition.iter().zip(strip_sides) {
        let wishes: Vec<f64> = strip.iter().map(|index| areas[*index]).collect();
        let sides = share(&wishes, along, area.smallest_side())?;
        let mut start = 0;
        for (index, side) in strip.iter().zip(sides) {
            let tile = &mut tiles[*index];
            (tile.x, tile.y, tile.width, tile.height) = if upright {
                (strip_start, start, strip_side, side)
            } else {
                (start, strip_start, side, strip_side)
            };
            start += side;
        }
        strip_start += strip_side;
    }
    Some(tiles)
}

/// Splits `total` into whole parts in proportion to the wishes, none below `smallest`.
fn share(wishes: &[f64], total: u32, smallest: u32) -> Option<Vec<u32>> {
    let free = total.checked_sub(smallest.checked_mul(wishes.len() as u32)?)?;

    // Parts below the smallest take it; the others share the rest, until no further part falls below.
    let mut raised = vec![false; wishes.len()];
    loop {
        let rest =
            f64::from(total) - raised.iter().filter(|raised| **raised).count() as f64 * f64::from(smallest);
        let sum: f64 = wishes.iter().zip(&raised).filter(|(_, raised)| !**raised).map(|(wish, _)| wish).sum();
        let low = |(index, wish): (usize, &f64)| {
            (!raised[index] && *wish / sum * rest < f64::from(smallest)).then_some(index)
        };
        let lows: Vec<usize> = wishes.iter().enumerate().filter_map(low).collect();
        if lows.is_empty() || free == 0 {
            // Round the running sums, so that the parts add up.
            let (mut exact, mut used) = (0.0, 0_u32);
            let last = wishes.len() - 1;
            let parts = wishes.iter().enumerate().map(|(index, wish)| {
                exact += if raised[index] || free == 0 { f64::from(smallest) } else { wish / sum * rest };
                let end = if index == last { total } else { (exact + 0.5).floor() as u32 };
                let part = end.saturating_sub(used);
                used = end;
                part
            });
            return Some(parts.collect());
        }
        for index in lows {
            raised[index] = true;
        }
    }
}
