//! Light rays through a facet's receivers: what a texel of it spans, as a continuous function of view and light.
//!
//! Rays stand at Gauss points of the receivers' outline in the light's view. Along a ray everything that a texel spans on
//! the screen goes with the inverse depth alone, and screen and logarithm of depth, by which receivers count, are even in
//! its square: each ray stands for an interval of squares. No ray comes or goes as the facet changes, so no figure jumps.

use std::array::from_fn;

use glam::{DMat4, DVec2, DVec3, DVec4};

use crate::facet::FacetRows;
use crate::layout::Gram;
use crate::receivers::{Body, DEPTH_ROW};

/// Rays of a facet.
pub(crate) const BEAMS: usize = SIDE * SIDE;
/// Gauss points up the outline, and across it at each.
const SIDE: usize = 3;
/// Gauss points between 0 and 1, and their weights.
const GAUSS: [(f64, f64); SIDE] =
    [(0.112_701_665_379_258_3, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.887_298_334_620_741_7, 5.0 / 18.0)];
/// Sine of the angle between plane and light below which the plane cuts no ray.
const CONTAINS_LIGHT: f64 = 1e-9;
/// Length of a ray, relative to its depth, below which its middle is that of its ends.
const SHORT: f64 = 1e-6;

/// What rays through a facet's receivers span.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Beams {
    /// Gram of the facet's clip space at the inverse depth 1; depth is that of homogeneous points with w = 1.
    pub(crate) grams: [Gram; BEAMS],
    /// Smallest and largest square of the inverse depth.
    pub(crate) low: [f64; BEAMS],
    pub(crate) high: [f64; BEAMS],
    /// Screen and logarithm of depth that each stands for, in any unit; 0 where it meets no receiver.
    pub(crate) weight: [f64; BEAMS],
    /// Homogeneous w of its receivers' middle, where the facet's own w is 1.
    pub(crate) unit: [f64; BEAMS],
    /// The middle, camera space.
    pub(crate) middle: [DVec3; BEAMS],
}

/// A facet as the light sees it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Seen<'a> {
    /// Its rows.
    pub(crate) rows: &'a FacetRows,
    /// Its receivers in x/w and y/w.
    pub(crate) outline: &'a [DVec2],
    /// Its receivers.
    pub(crate) receivers: Body<'a>,
    /// The light as a homogeneous point.
    pub(crate) light: DVec4,
    /// Pixels of a tangent of 1.
    pub(crate) pixels_per_tangent: f64,
}

impl Beams {
    /// The rays of a facet.
    pub(crate) fn of(facet: &Seen<'_>) -> Self {
        let Seen { rows, light, .. } = *facet;
        let (x, k, area) = places(facet);
        let slope: [f64; BEAMS] =
            if rows.remap.is_none() { [1.0; BEAMS] } else { k.map(|k| rows.remap.slope(k)) };

        // Points on which x/w, y/w and w are what they should be: P + c light, on which the facet's own w is 1.
        let inverse = DMat4::from_cols(rows.x, rows.y, rows.w, light).transpose().inverse();
        let (low, high) = cut(facet, &inverse, &x, &k);
        let depths = [inverse.x_axis, inverse.y_axis, inverse.z_axis].map(|column| DEPTH_ROW.dot(column));
        let along = DEPTH_ROW.dot(light);
        let mut beams = Self {
            grams: [Gram { xx: 0.0, yy: 0.0, xy: 0.0 }; BEAMS],
            low: [0.0; BEAMS],
            high: [0.0; BEAMS],
            weight: [0.0; BEAMS],
            unit: [1.0; BEAMS],
            middle: [DVec3::NEG_Z; BEAMS],
        };

        // Inverse depths of both ends; either may lie at infinity.
        let start: [f64; BEAMS] = from_fn(|i| depths[0] * x[i] + depths[1] * k[i] + depths[2]);
        let inverse_depth = |c: &[f64; BEAMS]| -> [f64; BEAMS] {
            from_fn(|i| if c[i].is_finite() { 1.0 / (start[i] + c[i] * along) } else { 0.0 })
        };
        let (one, two) = (inverse_depth(&low), inverse_depth(&high));
        let squares: [f64; BEAMS] = from_fn(|i| 0.5 * (one[i] * one[i] + two[i] * two[i]));

        // Displacements across the light that change x/w alone and y/w alone are reciprocal to the gradients.
        let [row_x, row_y, row_w] = [rows.x, rows.y, rows.w].map(DVec4::truncate);
        let across: [[f64; BEAMS]; 3] = from_fn(|axis| from_fn(|i| row_x[axis] - row_w[axis] * x[i]));
        let up: [[f64; BEAMS]; 3] =
            from_fn(|axis| from_fn(|i| (row_y[axis] - row_w[axis] * k[i]) * slope[i]));
        let dot = |one: &[[f64; BEAMS]; 3], two: &[[f64; BEAMS]; 3]| -> [f64; BEAMS] {
            from_fn(|i| one[0][i] * two[0][i] + one[1][i] * two[1][i] + one[2][i] * two[2][i])
        };
        let normal: [[f64; BEAMS]; 3] = from_fn(|axis| {
            let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
            from_fn(|i| across[next][i] * up[last][i] - across[last][i] * up[next][i])
        });
        let scale = 4.0 * facet.pixels_per_tangent * facet.pixels_per_tangent;
        let area_square = dot(&normal, &normal);
        let factor: [f64; BEAMS] = from_fn(|i| scale / area_square[i]);
        let (xx, yy, xy) = (dot(&up, &up), dot(&across, &across), dot(&across, &up));

        for i in 0..BEAMS {
            let (one, two, span) = (one[i], two[i], high[i] - low[i]);
            let part = if span.is_finite() {
                0.5 * span * (one + two) * one * two
            } else {
                let most = one.max(two);
                0.5 * most * most / along.abs()
            };

            // The middle by weight.
            let middle = squares[i].sqrt();
            let from = if low[i].is_finite() { (low[i], one) } else { (high[i], two) };
            let way = 1.0 / middle - 1.0 / from.1;
            let c = if way.abs() * middle > SHORT { from.0 + way / along } else { 0.5 * (low[i] + high[i]) };
            let point = inverse.x_axis * x[i] + inverse.y_axis * k[i] + inverse.z_axis + light * c;
            let weight = part * area[i] / (point.w * slope[i].abs());
            let usable = span > 0.0 && point.w > 0.0 && weight > 0.0 && weight.is_finite();
            let gram = Gram { xx: xx[i] * factor[i], yy: yy[i] * factor[i], xy: -xy[i] * factor[i] };
            if !(usable && gram.xx.is_finite() && gram.yy.is_finite()) {
                continue;
            }
            let (one, two) = (one * one, two * two);
            beams.grams[i] = gram;
            (beams.low[i], beams.high[i]) = (one.min(two), one.max(two));
            (beams.weight[i], beams.unit[i]) = (weight, point.w);
            beams.middle[i] = point.truncate() * (1.0 / point.w);
        }
        beams
    }

    /// Follows a quarter turn of the facet's clip space.
    pub(crate) fn turn(&mut self) {
        for gram in &mut self.grams {
            *gram = gram.turned();
        }
    }

    /// How many texels the facet's clip space wants at a footprint of one pixel, in the mean.
    pub(crate) fn mean_texels(&self) -> f64 {
        let squares = |i: usize| 0.5 * (self.low[i] + self.high[i]) * self.weight[i];
        let texels = (0..BEAMS).map(|i| (self.grams[i].xx * self.grams[i].yy).sqrt() * squares(i));
        texels.sum::<f64>() / self.weight.iter().sum::<f64>().max(f64::MIN_POSITIVE)
    }

    /// Middles of rays that meet receivers, and what the facet's clip space spans there.
    pub(crate) fn middles(&self) -> impl Iterator<Item = (DVec3, Gram)> + '_ {
        let met = (0..BEAMS).filter(|i| self.weight[*i] > 0.0);
        met.map(|i| {
            let square = 0.5 * (self.low[i] + self.high[i]);
            let Gram { xx, yy, xy } = self.grams[i];
            (self.middle[i], Gram { xx: xx * square, yy: yy * square, xy: xy * square })
        })
    }
}

/// x/w and y/w of each ray, and the part of the outline, or of the bent tile, that it stands for.
fn places(facet: &Seen<'_>) -> ([f64; BEAMS], [f64; BEAMS], [f64; BEAMS]) {
    let remap = &facet.rows.remap;
    let bent = |k: f64| if remap.is_none() { k } else { remap.y(k) };
    let corners = facet.outline.iter().map(|corner| bent(corner.y));
    let (low, high) = crate::receivers::extremes(corners);
    let levels = GAUSS.map(|(part, _)| {
        let y = low + (high - low) * part;
        if remap.is_none() { y } else { remap.k(y) }
    });

    // Where each level enters and leaves the outline.
    let mut ends = [(f64::INFINITY, f64::NEG_INFINITY); SIDE];
    for (one, two) in facet.outline.iter().zip(facet.outline.iter().cycle().skip(1)) {
        let lean = (two.x - one.x) / (two.y - one.y);
        for (level, ends) in levels.iter().zip(&mut ends) {
            if (one.y <= *level) != (two.y <= *level) {
                let x = one.x + (level - one.y) * lean;
                *ends = (ends.0.min(x), ends.1.max(x));
            }
        }
    }
    let left = |i: usize| ends[i / SIDE].0;
    let width = |i: usize| (ends[i / SIDE].1 - ends[i / SIDE].0).max(0.0);
    let x = from_fn(|i| left(i) + width(i) * GAUSS[i % SIDE].0);
    let area = from_fn(|i| width(i) * GAUSS[i % SIDE].1 * GAUSS[i / SIDE].1);
    (x, from_fn(|i| levels[i / SIDE]), area)
}

/// Where each ray P + c light enters and leaves the receivers: every plane's c is affine in x/w and y/w.
fn cut(
    facet: &Seen<'_>,
    inverse: &DMat4,
    x: &[f64; BEAMS],
    k: &[f64; BEAMS],
) -> ([f64; BEAMS], [f64; BEAMS]) {
    let (mut low, mut high) = ([f64::NEG_INFINITY; BEAMS], [f64::INFINITY; BEAMS]);
    let at_infinity = (facet.light.w > 0.0).then_some(DVec4::W);
    for plane in facet.receivers.planes.iter().copied().chain(at_infinity) {
        let along = plane.dot(facet.light);
        // Sums of components are no less than lengths and cost no roots.
        let size = plane.truncate().abs().element_sum().max(plane.w.abs());
        if along.abs() <= CONTAINS_LIGHT * size
            && along.abs() <= CONTAINS_LIGHT * plane.truncate().length().max(plane.w.abs())
        {
            continue;
        }
        let scale = -1.0 / along;
        let [a, b, c] =
            [inverse.x_axis, inverse.y_axis, inverse.z_axis].map(|column| plane.dot(column) * scale);
        let limit = |i: usize| a * x[i] + b * k[i] + c;
        if along > 0.0 {
            low = from_fn(|i| if limit(i) > low[i] { limit(i) } else { low[i] });
        } else {
            high = from_fn(|i| if limit(i) < high[i] { limit(i) } else { high[i] });
        }
    }
    (low, high)
}
