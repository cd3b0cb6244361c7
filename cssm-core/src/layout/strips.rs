//! Strips side by side, tiles end to end: whole-texel sides that fill the map.

use smallvec::SmallVec;

use super::MapArea;
use crate::facet::Tile;

/// A short list.
pub(super) type Few<T> = SmallVec<[T; 8]>;

/// Tiles end to end along the map; sides are wishes, in proportion.
#[derive(Debug, Clone)]
pub(super) struct Strip {
    /// Side across the strip.
    pub(super) side: f64,
    /// Index of each tile and its side along the strip.
    pub(super) tiles: Few<(usize, f64)>,
}

/// Whole-texel tiles of strips side by side: across the map's width, or its height unless `upright`. `None` when the
/// smallest sides do not fit.
pub(super) fn tiles<'a>(
    strips: impl Iterator<Item = &'a Strip> + Clone,
    count: usize,
    area: &MapArea,
    upright: bool,
) -> Option<Few<Tile>> {
    let mut tiles = Few::from_elem(Tile { x: 0, y: 0, width: 0, height: 0, gutter: area.gutter }, count);
    let (across, along) = if upright { (area.width, area.height) } else { (area.height, area.width) };
    let wishes: Few<f64> = strips.clone().map(|strip| strip.side).collect();
    let strip_sides = share(&wishes, across, area.smallest_side())?;
    let mut strip_start = 0;
    for (strip, strip_side) in strips.zip(strip_sides) {
        let wishes: Few<f64> = strip.tiles.iter().map(|(_, side)| *side).collect();
        let sides = share(&wishes, along, area.smallest_side())?;
        let mut start = 0;
        for ((index, _), side) in strip.tiles.iter().zip(sides) {
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
pub(super) fn share(wishes: &[f64], total: u32, smallest: u32) -> Option<Parts> {
    let free = total.checked_sub(smallest.checked_mul(wishes.len() as u32)?)?;

    // Parts below the smallest take it; the others share the rest, until no further part falls below.
    let mut raised: SmallVec<[bool; MOST]> = SmallVec::from_elem(false, wishes.len());
    let mut count = 0;
    loop {
        let rest = f64::from(total) - f64::from(count) * f64::from(smallest);
        let sum: f64 = wishes.iter().zip(&raised).filter(|(_, raised)| !**raised).map(|(wish, _)| wish).sum();
        let before = count;
        if free > 0 {
            for (wish, raised) in wishes.iter().zip(&mut raised).filter(|(_, raised)| !**raised) {
                *raised = *wish / sum * rest < f64::from(smallest);
                count += u32::from(*raised);
            }
        }
        if count == before {
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
    }
}

/// Parts of a side that need no allocation.
const MOST: usize = 64;
/// Parts of a side.
pub(super) type Parts = SmallVec<[u32; MOST]>;
