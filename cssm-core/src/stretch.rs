//! Exact stretching of casters: what bent rows make of a triangle (camera space shadow maps, section 4).
//!
//! Where a facet has a [`Remap`], straight edges of casters become curves of the map. In (x/w, k) with
//! k = y/w they stay straight, so a texel's centre is brought there and decided by three edge functions; nothing is
//! approximated, also where a corner lies behind the eye. The shaders do the same in f32; this is their reference, with
//! what it takes to draw few texels too many: the [chord error](BentTriangle::chord_error_texels), which tells triangles
//! that ordinary rasterisation draws well enough, and a tight [cover](BentTriangle::cover) for all others.

mod chord;
mod cover;

use glam::{DVec2, DVec3, DVec4};

use crate::facet::{Facet, Tile};
use crate::remap::Remap;

pub use chord::{Bend, bend, chord_bound, chord_error};

/// A caster's triangle as one facet sees it.
#[derive(Debug, Clone, PartialEq)]
pub struct BentTriangle {
    /// Clip x, k times w, clip z and clip w of the corners.
    pub corners: [DVec4; 3],
    remap: Remap,
    tile: Tile,
    /// Rows that yield the share of each corner over w at (x/w, k, 1).
    edges: [DVec3; 3],
    /// Smallest and largest k of the tile.
    limits: (f64, f64),
}

/// What a triangle does to a texel's centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Covered {
    /// Share of each corner in the point of the triangle that the light sees there: coordinates of a mask are blended by it.
    pub shares: DVec3,
    /// Depth of that point, not clamped.
    pub depth: f64,
}

/// Determinant, relative to its factors, below which a triangle is edge-on to the light.
const EDGE_ON: f64 = 1e-14;
/// How far from the tile a corner may lie to have a place in it: tiles, and multiples of the nearest and farthest k.
const FARTHEST_CORNER: (f64, f64, f64) = (64.0, 4.0, 0.25);

impl BentTriangle {
    /// A triangle with corners relative to the eye in world axes; `None` where it is edge-on to the light.
    pub fn new(facet: &Facet, triangle: &[DVec3; 3]) -> Option<Self> {
        let rows = &facet.rows;
        let corners = triangle.map(|corner| {
            let point = corner.extend(1.0);
            DVec4::new(rows.x.dot(point), rows.y.dot(point), rows.z.dot(point), rows.w.dot(point))
        });
        let plane = corners.map(|corner| DVec3::new(corner.x, corner.y, corner.w));
        let determinant = plane[0].dot(plane[1].cross(plane[2]));
        let factors = plane.iter().map(|corner| corner.length()).product::<f64>();
        if determinant.is_nan() || determinant.abs() <= EDGE_ON * factors {
            return None;
        }
        let edges = [plane[1].cross(plane[2]), plane[2].cross(plane[0]), plane[0].cross(plane[1])];
        let (one, two) = (rows.remap.k(-1.0), rows.remap.k(1.0));
        Some(Self {
            corners,
            remap: rows.remap,
            tile: facet.tile,
            edges: edges.map(|edge| edge / determinant),
            limits: (one.min(two), one.max(two)),
        })
    }

    /// What the triangle does to a point of the tile, NDC; `None` where it does not cover it.
    pub fn at(&self, ndc: DVec2) -> Option<Covered> {
        let place = DVec3::new(ndc.x, self.remap.k(ndc.y), 1.0);
        let weights = DVec3::from(self.edges.map(|edge| edge.dot(place)));
        if weights.min_element() < 0.0 {
            return None;
        }
        // The weights add up to 1 / w of the point.
        let depths = DVec3::from(self.corners.map(|corner| corner.z));
        Some(Covered { shares: weights / weights.element_sum(), depth: weights.dot(depths) })
    }

    /// Texels by which ordinary rasterisation of the bent corners misses the triangle: the farthest that a chord gets from
    /// its bent edge, along the rows. Infinite where a corner has no place in the tile.
    pub fn chord_error_texels(&self) -> f64 {
        if !self.corners.iter().all(|corner| self.has_place(corner)) {
            return f64::INFINITY;
        }
        let k = self.corners.map(|corner| corner.y / corner.w);
        let error = |one: f64, two: f64| chord_error(&self.remap, one.min(two), one.max(two));
        let worst = error(k[0], k[1]).max(error(k[1], k[2])).max(error(k[2], k[0]));
        0.5 * f64::from(self.tile.height) * worst
    }

    /// Whether a corner has a place in the bent tile or not too far from it; none has at w = 0 and behind.
    fn has_place(&self, corner: &DVec4) -> bool {
        let (across, near, far) = FARTHEST_CORNER;
        let low = self.limits.0.min(far * self.limits.0);
        corner.w > 0.0
            && corner.x.abs() <= across * corner.w
            && corner.y >= low * corner.w
            && corner.y <= near * self.limits.1 * corner.w
    }
}

#[cfg(test)]
mod tests;
