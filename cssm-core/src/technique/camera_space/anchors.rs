//! Facets spanned by three anchor points: the universal construction of every triangular facet (facet algebra, section
//! 1.4).

use glam::{DVec2, DVec3, DVec4};
use smallvec::SmallVec;

use crate::facet::Cell;
use crate::receivers::BodyPlace;
use crate::remap::Curve;
use crate::technique::{FacetDraft, Region, Sides, TileRequest};

/// Three homogeneous points, which may lie at infinity, and where each goes in a square.
#[derive(Debug, Clone, Copy)]
pub(super) struct Anchors {
    /// The points; the first goes to the tip, which the triangle shares with the square's others.
    pub(super) points: [DVec4; 3],
    /// How strongly each pulls: greater weights shrink the surroundings of the others.
    pub(super) weights: [f64; 3],
    /// Their images in the square's clip space, counter-clockwise.
    pub(super) targets: [DVec2; 3],
    /// Share of the map that the square asks for.
    pub(super) share: f64,
}

/// Determinant of the normalised anchors below which they do not span space.
const SMALLEST_DETERMINANT: f64 = 1e-9;

/// Barycentric functionals of three anchors as seen from a point light: each is 1 on its anchor, 0 on the others and on
/// the light. `None` where the four do not span space.
pub(super) fn barycentric(points: [DVec4; 3], light: DVec3) -> Option<[DVec4; 3]> {
    // Seen from the light three dimensions are left; normalise, so that the test does not depend on scale.
    let from_light = points.map(|point| point.truncate() - light * point.w);
    let lengths = from_light.map(DVec3::length);
    let [a, b, c] = from_light.map(DVec3::normalize_or_zero);
    let determinant = a.dot(b.cross(c));
    if determinant.abs() < SMALLEST_DETERMINANT {
        return None;
    }
    let functional = |normal: DVec3, length: f64| {
        let normal = normal / (determinant * length);
        normal.extend(-normal.dot(light))
    };
    Some([
        functional(b.cross(c), lengths[0]),
        functional(c.cross(a), lengths[1]),
        functional(a.cross(b), lengths[2]),
    ])
}

impl Anchors {
    /// The facet of the anchors' triangle in a square, for a set of cells whose receivers lie in half-spaces. `None` where
    /// the anchors do not span space.
    pub(super) fn facet(
        &self,
        cells: SmallVec<[Cell; 4]>,
        square: u32,
        light: DVec3,
        select: Sides,
    ) -> Option<FacetDraft> {
        let rows = barycentric(self.points, light)?;
        let weighed = |weight: &dyn Fn(usize) -> f64| {
            (0..3).fold(DVec4::ZERO, |sum, k| sum + rows[k] * (self.weights[k] * weight(k)))
        };
        Some(FacetDraft {
            cells,
            x: weighed(&|k| self.targets[k].x),
            y: weighed(&|k| self.targets[k].y),
            curve: Curve::Straight,
            w: weighed(&|_| 1.0),
            receivers: BodyPlace::default(),
            select,
            region: Region::Triangle {
                square,
                request: TileRequest::Share(self.share),
                corners: self.targets,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn functionals_annihilate_the_light_and_tell_anchors_apart() {
        let points = [
            DVec4::new(0.1, 0.2, -1.0, 1.0),
            DVec4::new(5.0, 3.0, -9.0, 1.0),
            DVec4::new(-1.0, 1.0, -1.0, 0.0),
        ];
        for light in [DVec3::new(0.0, 8.0, -2.0), DVec3::new(0.1, 0.9, 0.3) * 1e3] {
            let rows = barycentric(points, light).unwrap();
            for (k, row) in rows.iter().enumerate() {
                assert!(row.dot(light.extend(1.0)).abs() < 1e-9);
                for (j, point) in points.iter().enumerate() {
                    assert!((row.dot(*point) - f64::from(u8::from(j == k))).abs() < 1e-9);
                }
            }
        }
        assert!(barycentric([points[0], points[1], points[0] + points[1]], DVec3::Y).is_none());
    }
}
