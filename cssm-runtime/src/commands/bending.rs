//! Which casters need no look at their triangles, because no edge in their box could bend too far.

use cssm_core::facet::Facet;
use cssm_core::glam::{DAffine3, DVec4};
use cssm_core::remap::{Curve, Remap};
use cssm_core::stretch::chord_bound;

use crate::cull::CentredBox;

/// Share of a limit that keeps what is decided here on its side in f32.
const SURE: f64 = 0.9;
/// Tiles, multiples of the nearest and of the farthest k that the shaders' corners may lie off a tile, and still count.
const FARTHEST_CORNER: (f64, f64, f64) = (64.0 * SURE, 4.0 * SURE, 0.25 / SURE);

/// How one facet bends the edges of casters.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Bending {
    rows: [DVec4; 3],
    remap: Remap,
    /// Smallest and largest k of the tile.
    limits: (f64, f64),
    /// The bound in NDC.
    bound: f64,
}

impl Bending {
    /// How a facet bends edges, in world axes relative to the eye; `None` where its rows are straight.
    pub(super) fn new(facet: &Facet, bound_texels: f32) -> Option<Self> {
        let remap = facet.rows.remap;
        let straight = match remap.curve {
            Curve::Straight => true,
            Curve::Perspective { push_back_metres } => push_back_metres as f32 == 0.0,
            Curve::Logarithmic { .. } => false,
        };
        let (one, two) = (remap.k(-1.0), remap.k(1.0));
        (!straight).then(|| Self {
            rows: [facet.rows.x, facet.rows.y, facet.rows.w],
            remap,
            limits: (one.min(two), one.max(two)),
            bound: 2.0 * f64::from(bound_texels) / f64::from(facet.tile.height),
        })
    }

    /// The same in the space of an instance's own positions.
    pub(super) fn in_object(&self, eye_from_object: &DAffine3) -> Self {
        let rows = self.rows.map(|row| {
            let (normal, shift) = (row.truncate(), eye_from_object.translation);
            (eye_from_object.matrix3.transpose() * normal).extend(normal.dot(shift) + row.w)
        });
        Self { rows, ..self.clone() }
    }

    /// Whether straight edges will do for all triangles in a box.
    pub(super) fn spares(&self, bounds: &CentredBox) -> bool {
        let [x, y, w] = self.rows.map(|row| {
            let (normal, centre) = (row.truncate(), bounds.centre);
            (normal.dot(centre) + row.w, normal.abs().dot(bounds.half))
        });
        let (nearest, farthest) = (w.0 - w.1, w.0 + w.1);
        if nearest.is_nan() || nearest <= 0.0 {
            return false;
        }
        let over = |value: f64, least: f64, most: f64| value / if value < 0.0 { least } else { most };
        let low = over(y.0 - y.1, nearest, farthest);
        let high = over(y.0 + y.1, farthest, nearest);
        let (across, near, far) = FARTHEST_CORNER;
        x.0.abs() + x.1 <= across * nearest
            && low >= (self.limits.0 * SURE).min(far * self.limits.0)
            && high <= near * self.limits.1
            && chord_bound(&self.remap, low, high) <= SURE * self.bound
    }
}
