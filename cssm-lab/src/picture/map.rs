//! The shadow map itself, facet by facet.

use cssm_core::ShadowPlan;
use cssm_core::facet::{Facet, Tile};
use cssm_core::glam::{DMat3, DVec3, DVec4};

use super::{Colour, Picture};

const EMPTY: Colour = [14, 20, 44];
const UNUSED: Colour = [56, 12, 20];
const OUTLINE: Colour = [255, 190, 40];
const NUMBER: Colour = [255, 235, 120];

/// Smallest tile whose facets carry their numbers; a facet of a shared tile needs half its area.
const NUMBERED_PIXELS: usize = 32;

/// Depths as grey, near the light white; contrast is stretched over what each facet holds. Facets are outlined and
/// carry their number.
pub fn map_picture(plan: &ShadowPlan, depths: &[f32]) -> Picture {
    let (width, height) = plan.map_size_texels;
    map_picture_of_size(plan, depths, (width as usize, height as usize))
}

/// The same in a picture of another size, each pixel from the texel under its centre.
pub fn map_picture_of_size(plan: &ShadowPlan, depths: &[f32], size: (usize, usize)) -> Picture {
    let sampling = Sampling { size, map: plan.map_size_texels };
    let mut picture = Picture::filled(size.0, size.1, UNUSED);
    let mut painted: Vec<Tile> = Vec::new();
    for facet in &plan.facets {
        if painted.contains(&facet.tile) {
            continue;
        }
        let sharing: Vec<Part<'_>> =
            plan.facets.iter().filter(|other| other.tile == facet.tile).map(Part::of).collect();
        paint_tile(&mut picture, plan, depths, &sampling, &sharing);
        painted.push(facet.tile);
    }
    picture
}

/// Paints the facets that share one tile.
fn paint_tile(
    picture: &mut Picture,
    plan: &ShadowPlan,
    depths: &[f32],
    sampling: &Sampling,
    sharing: &[Part<'_>],
) {
    let Some(tile) = sharing.first().map(|part| part.facet.tile) else {
        return;
    };
    let (left, right) = sampling.pixels(tile.x, tile.width, 0);
    let (top, bottom) = sampling.pixels(tile.y, tile.height, 1);
    let (columns, rows) = (right - left, bottom - top);
    let place = |pixel: usize| (left + pixel % columns, top + pixel / columns);

    // Find whose each pixel is, and the depth there; the sign makes depth grow away from the light.
    let owners: Vec<usize> = (0..columns * rows)
        .map(|pixel| {
            let (x, y) = sampling.texel(place(pixel));
            owner(sharing, x, y)
        })
        .collect();
    let sign = plan.depth_order.sign() as f32;
    let cleared = plan.depth_order.cleared() as f32;
    let depth = |pixel: usize| {
        let (x, y) = sampling.texel(place(pixel));
        let texel = y as usize * plan.map_size_texels.0 as usize + x as usize;
        depths.get(texel).filter(|depth| **depth != cleared).map(|depth| sign * depth)
    };

    for (number, part) in sharing.iter().enumerate() {
        let own = || (0..owners.len()).filter(|pixel| owners[*pixel] == number);
        // Find the range of depths that were drawn.
        let near = own().filter_map(depth).fold(f32::INFINITY, f32::min);
        let far = own().filter_map(depth).fold(near, f32::max);
        let scale = if far > near { 200.0 / (far - near) } else { 0.0 };
        let mut middle = (0, 0, 0);
        for pixel in own() {
            let (x, y) = place(pixel);
            let colour = depth(pixel).map_or(EMPTY, |depth| [250 - ((depth - near) * scale) as u8; 3]);
            // Draw the border between facets of the tile.
            let differs = |other: Option<usize>| {
                other.and_then(|other| owners.get(other)).is_some_and(|other| *other > number)
            };
            let right = (pixel % columns + 1 < columns).then_some(pixel + 1);
            let left = (pixel % columns > 0).then(|| pixel - 1);
            let beside =
                [right, left, Some(pixel + columns), pixel.checked_sub(columns)].into_iter().any(differs);
            picture.set(x, y, if beside { OUTLINE } else { colour });
            middle = (middle.0 + x, middle.1 + y, middle.2 + 1);
        }
        if columns.min(rows) >= NUMBERED_PIXELS && 2 * middle.2 > NUMBERED_PIXELS * NUMBERED_PIXELS {
            let (x, y) = match sharing.len() {
                1 => (left + 6, top + 5),
                _ => ((middle.0 / middle.2).saturating_sub(4), (middle.1 / middle.2).saturating_sub(7)),
            };
            part.write_number(picture, x, y);
        }
    }
    picture.outline(left, top, columns, rows, OUTLINE);
}

/// Which of the facets that share a tile holds a texel: the one that it lies deepest in.
fn owner(sharing: &[Part<'_>], x: f64, y: f64) -> usize {
    if sharing.len() == 1 {
        return 0;
    }
    let depths = sharing.iter().map(|part| part.depth(x, y)).enumerate();
    depths.max_by(|one, two| one.1.total_cmp(&two.1)).map_or(0, |(number, _)| number)
}

/// A facet and its clip half-spaces in its tile.
struct Part<'a> {
    facet: &'a Facet,
    /// Half-planes (a, b, c) with a x + b y + c >= 0 in the tile's clip coordinates.
    half_planes: Vec<DVec3>,
}

impl<'a> Part<'a> {
    fn of(facet: &'a Facet) -> Self {
        // A clip row annihilates the light, as the x, y and w rows do: it is a sum of these.
        let rows = [facet.rows.x, facet.rows.y, facet.rows.w];
        let half_plane = |clip: &DVec4| {
            let products = |row: DVec4| DVec3::new(rows[0].dot(row), rows[1].dot(row), rows[2].dot(row));
            let normal = DMat3::from_cols(products(rows[0]), products(rows[1]), products(rows[2]));
            let plane = normal.inverse() * products(*clip);
            plane / plane.truncate().length().max(f64::MIN_POSITIVE)
        };
        Self { facet, half_planes: facet.clip.iter().map(half_plane).collect() }
    }

    /// How far a texel lies inside the facet, in the tile's clip coordinates.
    fn depth(&self, x: f64, y: f64) -> f64 {
        let tile = self.facet.tile;
        let point = DVec3::new(
            2.0 * (x - f64::from(tile.x)) / f64::from(tile.width) - 1.0,
            1.0 - 2.0 * (y - f64::from(tile.y)) / f64::from(tile.height),
            1.0,
        );
        self.half_planes.iter().map(|plane| plane.dot(point)).fold(f64::INFINITY, f64::min)
    }

    fn write_number(&self, picture: &mut Picture, x: usize, y: usize) {
        picture.text(x, y, &self.facet.first_cell().to_string(), NUMBER);
    }
}

/// Between the pixels of a picture and the texels of a map.
struct Sampling {
    size: (usize, usize),
    map: (u32, u32),
}

impl Sampling {
    /// Texel coordinates of a pixel's centre.
    fn texel(&self, (x, y): (usize, usize)) -> (f64, f64) {
        let along = |pixel: usize, pixels: usize, texels: u32| {
            (pixel as f64 + 0.5) * f64::from(texels) / pixels as f64
        };
        (along(x, self.size.0, self.map.0), along(y, self.size.1, self.map.1))
    }

    /// First pixel of a run of texels and the first past it, along x (0) or y (1).
    fn pixels(&self, first: u32, count: u32, axis: usize) -> (usize, usize) {
        let (pixels, texels) = if axis == 0 { (self.size.0, self.map.0) } else { (self.size.1, self.map.1) };
        let pixel = |texel: u32| {
            ((f64::from(texel) * pixels as f64 / f64::from(texels) - 0.5).ceil().max(0.0) as usize)
                .min(pixels)
        };
        (pixel(first), pixel(first + count))
    }
}

#[cfg(test)]
mod tests;
