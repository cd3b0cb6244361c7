//! Foliage: cards cut out by alpha masks that are drawn leaf by leaf.

use std::f64::consts::TAU;

use cssm_core::glam::{DVec2, DVec3};

use super::random::Random;
use super::{AlphaMask, Mesh};

/// Side of a mask in texels.
const MASK_TEXELS: u32 = 64;

/// Leaves on a card.
const LEAVES: u32 = 34;

/// Alpha below which a texel of foliage is a hole.
const CUTOFF: f32 = 0.5;

/// The drawing on a card.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Drawing {
    /// A twig with broad leaves all around it.
    Leaves,
    /// A branch along u with needles to both sides.
    Needles,
    /// Blades of grass that grow from v = 1.
    Blades,
}

/// Collects cards with one drawing into one mesh.
pub(super) struct Cards {
    positions: Vec<[f32; 3]>,
    indices: Vec<u32>,
    uvs: Vec<[f32; 2]>,
}

impl Cards {
    pub(super) const fn new() -> Self {
        Self { positions: Vec::new(), indices: Vec::new(), uvs: Vec::new() }
    }

    /// Adds a card: two triangles from its middle, half its width along u and half its height against v.
    pub(super) fn card(&mut self, middle: DVec3, half_width: DVec3, half_height: DVec3) {
        let first = self.positions.len() as u32;
        for (x, y) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            self.positions.push((middle + half_width * x + half_height * y).as_vec3().to_array());
            self.uvs.push([0.5 + 0.5 * x as f32, 0.5 - 0.5 * y as f32]);
        }
        self.indices.extend([0, 1, 2, 0, 2, 3].map(|index| first + index));
    }

    pub(super) fn build(self, name: &str, drawing: Drawing, random: &mut Random) -> Mesh {
        let mask = AlphaMask {
            uvs: self.uvs,
            width: MASK_TEXELS,
            height: MASK_TEXELS,
            alpha: drawn(drawing, random),
            cutoff: CUTOFF,
        };
        Mesh { name: name.to_owned(), positions: self.positions, indices: self.indices, mask: Some(mask) }
    }
}

/// A stroke of a drawing: a lens from one point to another, in texture coordinates.
struct Stroke {
    from: DVec2,
    to: DVec2,
    half_width: f64,
}

impl Stroke {
    /// Distance past the stroke's outline in texture coordinates, negative within.
    fn outside(&self, point: DVec2) -> f64 {
        let along = self.to - self.from;
        let share = ((point - self.from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        // Broad in the middle, pointed at both ends.
        let half_width = self.half_width * libm::sqrt(libm::sin(share * 0.5 * TAU).max(0.0));
        (point - self.from - along * share).length() - half_width
    }
}

/// Alpha of every texel: 255 within a stroke, falling to 0 over a texel around its outline.
fn drawn(drawing: Drawing, random: &mut Random) -> Vec<u8> {
    let strokes = match drawing {
        Drawing::Leaves => leaves(random),
        Drawing::Needles => needles(random),
        Drawing::Blades => blades(random),
    };
    let size = f64::from(MASK_TEXELS);
    (0..MASK_TEXELS * MASK_TEXELS)
        .map(|texel| {
            let (column, row) = (texel % MASK_TEXELS, texel / MASK_TEXELS);
            let centre = DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5) / size;
            let outside = strokes.iter().map(|stroke| stroke.outside(centre)).fold(f64::INFINITY, f64::min);
            ((0.5 - outside * size).clamp(0.0, 1.0) * 255.0).round() as u8
        })
        .collect()
}

fn towards(turn: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(turn);
    DVec2::new(cos, sin)
}

fn leaves(random: &mut Random) -> Vec<Stroke> {
    let middle = DVec2::splat(0.5);
    let mut strokes = Vec::new();
    for index in 0..LEAVES {
        // Spread roots evenly over a disc, leaves pointing away from its middle.
        let turn = f64::from(index) * 2.399_963; // golden angle
        let root = middle + towards(turn) * 0.34 * libm::sqrt((f64::from(index) + 0.5) / f64::from(LEAVES));
        let length = random.between(0.13, 0.19);
        let to = root + towards(turn + random.between(-0.9, 0.9)) * length;
        strokes.push(Stroke { from: root, to, half_width: length * random.between(0.24, 0.32) });
    }
    for turn in [0.4, 2.5, 4.4] {
        strokes.push(Stroke { from: middle, to: middle + towards(turn) * 0.36, half_width: 0.008 });
    }
    strokes
}

fn needles(random: &mut Random) -> Vec<Stroke> {
    let mut strokes =
        vec![Stroke { from: DVec2::new(-0.3, 0.5), to: DVec2::new(1.0, 0.5), half_width: 0.022 }];
    for index in 0..22 {
        let along = 0.03 + 0.88 * f64::from(index) / 22.0;
        for side in [-1.0, 1.0] {
            let from = DVec2::new(along + random.between(-0.01, 0.01), 0.5);
            let length = (0.46 - 0.38 * along) * random.between(0.85, 1.1);
            let to = from + DVec2::new(0.55, side).normalize() * length;
            strokes.push(Stroke { from, to, half_width: 0.021 });
        }
    }
    strokes
}

fn blades(random: &mut Random) -> Vec<Stroke> {
    (0..15)
        .map(|index| {
            let from = DVec2::new(0.06 + 0.88 * f64::from(index) / 14.0, 1.1);
            let to = DVec2::new(from.x + random.between(-0.16, 0.16), random.between(0.05, 0.55));
            Stroke { from, to, half_width: random.between(0.02, 0.032) }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn drawings_leave_leaves_and_holes() {
        for drawing in [Drawing::Leaves, Drawing::Needles, Drawing::Blades] {
            let mut cards = Cards::new();
            cards.card(DVec3::ZERO, DVec3::X, DVec3::Y);
            let mesh = cards.build("card", drawing, &mut Random::new(3));
            let mask = mesh.mask.unwrap();
            let holes = mask.hole_share();
            assert!((0.35..0.8).contains(&holes), "{drawing:?}: {holes:.2} holes");
            // The upper corners are holes in each of them.
            assert!(mask.is_hole(0.01, 0.01) && mask.is_hole(0.99, 0.01), "{drawing:?}");
            assert_eq!(mask.uvs.len(), mesh.positions.len());
        }
    }

    #[test]
    fn cards_stand_upright_in_their_texture() {
        let mut cards = Cards::new();
        cards.card(DVec3::ZERO, DVec3::X, DVec3::Y);
        let mesh = cards.build("card", Drawing::Blades, &mut Random::new(3));
        let uvs = mesh.mask.unwrap().uvs;
        for (position, uv) in mesh.positions.iter().zip(uvs) {
            assert_eq!(uv, [0.5 + 0.5 * position[0], 0.5 - 0.5 * position[1]]);
        }
    }
}
