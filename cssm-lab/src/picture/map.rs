//! The shadow map itself, tile by tile.

use cssm_core::ShadowPlan;

use super::{Colour, Picture};

const EMPTY: Colour = [14, 20, 44];
const UNUSED: Colour = [56, 12, 20];
const OUTLINE: Colour = [255, 190, 40];
const NUMBER: Colour = [255, 235, 120];

/// Smallest tile that carries its facet's number.
const NUMBERED_PIXELS: u32 = 32;

/// Depths as grey, near the light white; contrast is stretched over what each tile holds. Tiles are outlined and
/// carry their facet's number.
pub fn map_picture(plan: &ShadowPlan, depths: &[f32]) -> Picture {
    let (width, height) = (plan.map_size_texels.0 as usize, plan.map_size_texels.1 as usize);
    let mut picture = Picture::filled(width, height, UNUSED);
    for facet in &plan.facets {
        let tile = facet.tile;
        let (x, y) = (tile.x as usize, tile.y as usize);
        let texels = || {
            let columns =
                move |row: usize| (x..(x + tile.width as usize).min(width)).map(move |column| (column, row));
            (y..(y + tile.height as usize).min(height)).flat_map(columns)
        };

        // Find the range of depths that were drawn.
        let drawn =
            || texels().filter_map(|(x, y)| depths.get(y * width + x).copied().filter(|depth| *depth < 1.0));
        let near = drawn().fold(1.0, f32::min);
        let far = drawn().fold(near, f32::max);
        let scale = if far > near { 200.0 / (far - near) } else { 0.0 };
        for (x, y) in texels() {
            let grey = |depth: f32| 250 - ((depth - near) * scale) as u8;
            let colour = match depths.get(y * width + x) {
                Some(depth) if *depth < 1.0 => [grey(*depth); 3],
                _ => EMPTY,
            };
            picture.set(x, y, colour);
        }
        picture.outline(x, y, tile.width as usize, tile.height as usize, OUTLINE);
        if tile.width >= NUMBERED_PIXELS && tile.height >= NUMBERED_PIXELS {
            picture.text(x + 6, y + 5, &facet.index.to_string(), NUMBER);
        }
    }
    picture
}
