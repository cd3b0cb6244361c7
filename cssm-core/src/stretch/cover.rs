//! What is rasterised for a triangle that is decided texel by texel.

use glam::{DVec2, DVec4};

use super::BentTriangle;
use super::chord::bend;

/// Height in texels below which a triangle gets a box along its longest edge.
const THIN: f64 = 1.5;

impl BentTriangle {
    /// Corners, in texels from the tile's centre (x to the right, y up), of a polygon around all that the triangle covers:
    /// its bent corners and the points where the tangents of edges that bulge out meet, six at most; a box along the
    /// longest edge where that is thin; a box of the tile where a corner has no place in it. Empty where nothing is
    /// covered.
    pub fn cover(&self) -> Vec<DVec2> {
        if !self.corners.iter().all(|corner| self.has_place(corner)) {
            return self.cut_box();
        }
        let points = self.corners.map(|corner| self.bent(DVec2::new(corner.x, corner.y) / corner.w));
        let (first, last) = (points[1] - points[0], points[2] - points[0]);
        let longest = [first, last, last - first].into_iter().map(DVec2::length).fold(0.0, f64::max);
        let inner = self.inner_side();
        if first.perp_dot(last) * inner < THIN * longest {
            return self.thin_box(&points);
        }
        let mut polygon = Vec::with_capacity(6);
        for (one, two) in [(0, 1), (1, 2), (2, 0)] {
            polygon.push(points[one]);
            polygon.extend(self.outer_point(one, two, inner));
        }
        polygon
    }

    /// Area of the [cover](Self::cover)'s part of the tile, texels.
    pub fn covered_tile_texels(&self) -> f64 {
        let half = 0.5 * self.size();
        let edges = [(DVec2::X, half.x), (-DVec2::X, half.x), (DVec2::Y, half.y), (-DVec2::Y, half.y)];
        let mut polygon = self.cover();
        for (outward, limit) in edges {
            let mut kept = Vec::with_capacity(polygon.len() + 1);
            for (one, two) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
                let (start, end) = (limit - outward.dot(*one), limit - outward.dot(*two));
                if start >= 0.0 {
                    kept.push(*one);
                }
                if (start < 0.0) != (end < 0.0) {
                    kept.push(one.lerp(*two, start / (start - end)));
                }
            }
            polygon = kept;
        }
        let pairs = polygon.iter().zip(polygon.iter().cycle().skip(1));
        0.5 * pairs.map(|(one, two)| one.perp_dot(*two)).sum::<f64>().abs()
    }

    /// A place in (x/w, k) in texels from the tile's centre.
    pub(super) fn bent(&self, place: DVec2) -> DVec2 {
        0.5 * self.size() * DVec2::new(place.x, self.remap.y(place.y))
    }

    pub(super) fn size(&self) -> DVec2 {
        DVec2::new(f64::from(self.tile.width), f64::from(self.tile.height))
    }

    /// 1 where the inside lies to the left of the bent edges, -1 to the right.
    fn inner_side(&self) -> f64 {
        let places = self.corners.map(|corner| DVec2::new(corner.x, corner.y) / corner.w);
        let turn = (places[1] - places[0]).perp_dot(places[2] - places[0]);
        turn.signum() * self.remap.slope(self.limits.1).signum()
    }

    /// Where the end tangents of an edge that bulges out meet.
    fn outer_point(&self, one: usize, two: usize, inner: f64) -> Option<DVec2> {
        let places = [self.corners[one], self.corners[two]].map(|corner| corner / corner.w);
        let [start, end] = places.map(|place| self.bent(DVec2::new(place.x, place.y)));
        let (way, rise) = (end - start, places[1].y - places[0].y);
        let bend = bend(&self.remap, places[0].y.min(places[1].y), places[0].y.max(places[1].y));
        let up = inner * way.x < 0.0;
        if !(if up { bend.up } else { bend.down }) {
            return None;
        }
        let scale = 0.5 * self.size().y * rise;
        let (one, two) = (bend.least * scale, bend.most * scale);
        let (leaving, arriving) =
            if up { (one.max(two), one.min(two)) } else { (one.min(two), one.max(two)) };
        let part = (way.y - arriving) / (leaving - arriving);
        (part > 0.0 && part < 1.0).then(|| start + DVec2::new(way.x, leaving) * part)
    }

    fn thin_box(&self, points: &[DVec2; 3]) -> Vec<DVec2> {
        let edges = [points[1] - points[0], points[2] - points[1], points[0] - points[2]];
        let longest = edges
            .into_iter()
            .fold(DVec2::ZERO, |longest, edge| if edge.length() > longest.length() { edge } else { longest });
        let along = longest.try_normalize().unwrap_or(DVec2::X);
        let mut bounds = Bounds::NONE;
        let sides = [(0, 1), (1, 2), (2, 0)].into_iter().flat_map(|edge| [(edge, 1.0), (edge, -1.0)]);
        let bulges = sides.filter_map(|((one, two), inner)| self.outer_point(one, two, inner));
        for point in points.iter().copied().chain(bulges) {
            bounds.add(DVec2::new(along.dot(point), along.perp().dot(point)));
        }
        let corners = bounds.corners();
        corners.into_iter().map(|corner| along * corner.x + along.perp() * corner.y).collect()
    }

    /// The box around the tile's part of the triangle: the tile's part of each edge and the tile's corners inside.
    fn cut_box(&self) -> Vec<DVec2> {
        let (low, high) = self.limits;
        let distances = |corner: DVec4| {
            let DVec4 { x, y, w, .. } = corner;
            [w + x, w - x, y - low * w, high * w - y]
        };
        let mut bounds = Bounds::NONE;
        for (one, two) in [(0, 1), (1, 2), (2, 0)].map(|(one, two)| (self.corners[one], self.corners[two])) {
            let (mut entry, mut exit) = (0.0_f64, 1.0_f64);
            for (start, end) in distances(one).into_iter().zip(distances(two)) {
                match (start < 0.0, end < 0.0) {
                    (true, true) => exit = -1.0,
                    (true, false) => entry = entry.max(start / (start - end)),
                    (false, true) => exit = exit.min(start / (start - end)),
                    (false, false) => {}
                }
            }
            if entry <= exit {
                for part in [entry, exit] {
                    let point = one + (two - one) * part;
                    bounds.add(DVec2::new(point.x, point.y) / point.w);
                }
            }
        }
        for corner in (Bounds { low: DVec2::new(-1.0, low), high: DVec2::new(1.0, high) }).corners() {
            let inside = self.edges.iter().all(|edge| edge.dot(corner.extend(1.0)) >= 0.0);
            if inside {
                bounds.add(corner);
            }
        }
        if bounds.low.x > bounds.high.x {
            return Vec::new();
        }
        let mut bent = Bounds::NONE;
        bent.add(self.bent(bounds.low));
        bent.add(self.bent(bounds.high));
        bent.corners().to_vec()
    }
}

/// A box of two axes.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    low: DVec2,
    high: DVec2,
}

impl Bounds {
    const NONE: Self = Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };

    fn add(&mut self, point: DVec2) {
        (self.low, self.high) = (self.low.min(point), self.high.max(point));
    }

    fn corners(&self) -> [DVec2; 4] {
        let Self { low, high } = *self;
        [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)]
    }
}
