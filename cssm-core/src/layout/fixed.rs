//! Tiles of declared sizes: rows of falling height.

use smallvec::SmallVec;

use super::MapArea;
use super::strips::Few;
use crate::facet::Tile;
use crate::plan::PlanError;

pub(super) fn place(sizes: &[(u32, u32)], area: &MapArea, tiles: &mut Few<Tile>) -> Result<(), PlanError> {
    let mut order: SmallVec<[usize; 16]> = (0..sizes.len()).collect();
    order.sort_unstable_by_key(|index| {
        (std::cmp::Reverse(sizes[*index].1), std::cmp::Reverse(sizes[*index].0), *index)
    });

    // Fill a row from left to right; open the next below its tallest tile.
    tiles.clear();
    tiles.resize(sizes.len(), Tile { x: 0, y: 0, width: 0, height: 0, gutter: area.gutter });
    let (mut x, mut y, mut row_height) = (0, 0, 0);
    for index in order {
        let (width, height) = sizes[index];
        if x + width > area.width {
            (x, y, row_height) = (0, y + row_height, 0);
        }
        let fits = x + width <= area.width && y + height <= area.height;
        if !fits || width.min(height) < area.smallest_side() {
            return Err(area.too_small(sizes.len()));
        }
        tiles[index] = Tile { x, y, width, height, gutter: area.gutter };
        x += width;
        row_height = row_height.max(height);
    }
    Ok(())
}
