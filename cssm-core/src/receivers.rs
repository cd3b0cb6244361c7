//! The receiver polytope: everything visible that may be in shadow, as homogeneous vertices and half-spaces.
//!
//! Vertices are homogeneous with w >= 0; w = 0 lies at infinity, so an infinite far plane needs no special case.
//! Every vertex remembers the planes it lies on; two vertices are joined by an edge where no third lies on all the
//! planes they share, and cutting needs nothing else.

use glam::{DMat3, DVec3, DVec4};
use smallvec::SmallVec;

mod bodies;
mod slices;

pub(crate) use self::bodies::Bodies;
pub use self::bodies::BodyPlace;
pub(crate) use self::slices::Slices;
use crate::plan::BoundingBox;
use crate::view::View;

/// Row of the depth along the view axis, camera space.
pub(crate) const DEPTH_ROW: DVec4 = DVec4::new(0.0, 0.0, -1.0, 0.0);

/// Vertices that need no allocation: more than views cut by what a light reaches have.
const FEW: usize = 48;
/// Planes that need no allocation.
const FEW_PLANES: usize = 32;

/// A convex polytope.
#[derive(Debug, PartialEq)]
pub struct Polytope {
    /// Vertices, homogeneous, w >= 0.
    pub vertices: SmallVec<[DVec4; FEW]>,
    /// Half-spaces h.X >= 0 whose meet is the polytope.
    pub planes: SmallVec<[DVec4; FEW_PLANES]>,
    /// Bit i: the vertex lies on plane i; bit 63: the vertex lies at infinity.
    incidence: SmallVec<[u64; FEW]>,
    /// Whether it is a view's frustum that nothing was cut off.
    is_frustum: bool,
}

/// A convex polytope that lies elsewhere.
#[derive(Debug, Clone, Copy)]
pub struct Body<'a> {
    /// Vertices, homogeneous, w >= 0.
    pub vertices: &'a [DVec4],
    /// Half-spaces h.X >= 0 whose meet is the polytope.
    pub planes: &'a [DVec4],
    incidence: &'a [u64],
}

/// Distance from a plane, relative to plane and point, below which a vertex counts as lying on it.
const ON_PLANE: f64 = 1e-13;
/// Value of a row, relative to its terms on the vertex, below which a vertex is a direction along the light.
const ALONG_LIGHT: f64 = 1e-12;
const AT_INFINITY: u64 = 1 << 63;
/// Plane bits end below the bit of infinity.
const PLANE_LIMIT: usize = 63;

impl Clone for Polytope {
    fn clone(&self) -> Self {
        self.copied()
    }
}

impl Polytope {
    /// The view frustum in camera space from the near plane to `far_metres` (may be infinite).
    pub fn frustum(view: &View, far_metres: f64) -> Self {
        let near = view.near_metres;
        let mut planes = SmallVec::from_slice(&[
            DVec4::new(0.0, 1.0, view.bottom, 0.0),
            DVec4::new(-1.0, 0.0, -view.right, 0.0),
            DVec4::new(0.0, -1.0, -view.top, 0.0),
            DVec4::new(1.0, 0.0, view.left, 0.0),
            DVec4::new(0.0, 0.0, -1.0, -near),
        ]);
        let far_bit = if far_metres.is_finite() {
            planes.push(DVec4::new(0.0, 0.0, 1.0, far_metres));
            1 << 5
        } else {
            AT_INFINITY
        };

        // Corner k lies on the side planes k - 1 and k.
        let (mut vertices, mut incidence) = (SmallVec::new(), SmallVec::new());
        for (k, (x, y)) in view.corner_tangents().into_iter().enumerate() {
            let sides = (1 << k) | (1 << ((k + 3) % 4));
            vertices.push(DVec4::new(x * near, y * near, -near, 1.0));
            incidence.push(sides | (1 << 4));
            vertices.push(if far_metres.is_finite() {
                DVec4::new(x * far_metres, y * far_metres, -far_metres, 1.0)
            } else {
                DVec4::new(x, y, -1.0, 0.0)
            });
            incidence.push(sides | far_bit);
        }
        Self { vertices, planes, incidence, is_frustum: true }
    }

    /// The polytope of nothing.
    pub fn empty() -> Self {
        Self {
            vertices: SmallVec::new(),
            planes: SmallVec::new(),
            incidence: SmallVec::new(),
            is_frustum: false,
        }
    }

    /// Cuts with a world-space box, given the eye and the rotation to camera axes.
    pub fn cut_by_box(&mut self, bounds: &BoundingBox, eye_world: DVec3, camera_from_world: &DMat3) {
        let (min, max) = (bounds.min - eye_world, bounds.max - eye_world);
        for axis in 0..3 {
            let direction = camera_from_world.col(axis);
            self.cut(direction.extend(-min[axis]));
            self.cut((-direction).extend(max[axis]));
        }
    }

    /// Keeps the part with plane.X >= 0.
    pub fn cut(&mut self, plane: DVec4) {
        // A plane that only repeats or misses the polytope is still recorded, so that others see it.
        if self.planes.len() >= PLANE_LIMIT {
            return;
        }
        let bit = 1_u64 << self.planes.len();
        self.planes.push(plane);
        self.is_frustum = false;

        // Find where every vertex lies.
        let (vertices, incidence) = (&mut self.vertices[..], &mut self.incidence[..]);
        let mut signed: SmallVec<[f64; FEW]> = SmallVec::new();
        let mut beyond: SmallVec<[usize; FEW]> = SmallVec::new();
        let mut is_crossed = false;
        for (index, (vertex, planes)) in vertices.iter().zip(&mut *incidence).enumerate() {
            let value = signed_distance(plane, *vertex);
            signed.push(value);
            if value < 0.0 {
                beyond.push(index);
            }
            is_crossed |= value > 0.0;
            *planes |= if value == 0.0 { bit } else { 0 };
        }
        if beyond.is_empty() {
            return;
        }
        let size = finite_size(vertices);

        // Find a vertex on every edge that crosses.
        let mut crossings: SmallVec<[(DVec4, u64); 16]> = SmallVec::new();
        if is_crossed {
            for (a, inside) in signed.iter().enumerate().filter(|(_, value)| **value > 0.0) {
                for b in &beyond {
                    let Some(shared) = edge(incidence, a, *b) else { continue };
                    let point = normalised(vertices[a] * -signed[*b] + vertices[*b] * *inside);
                    crossings.push((point, shared | bit));
                }
            }
        }

        // Keep what lies inside, then add the new vertices.
        let mut kept = 0;
        for (index, value) in signed.iter().enumerate() {
            if *value >= 0.0 {
                vertices[kept] = vertices[index];
                incidence[kept] = incidence[index];
                kept += 1;
            }
        }
        self.vertices.truncate(kept);
        self.incidence.truncate(kept);
        for (point, planes) in crossings {
            match same(&self.vertices, point, size) {
                Some(same) => self.incidence[same] |= planes,
                None => {
                    self.vertices.push(point);
                    self.incidence.push(planes);
                }
            }
        }
    }

    /// The polytope cut by several half-spaces.
    pub fn cut_by(&self, planes: &[DVec4]) -> Self {
        self.body().cut_by(planes)
    }

    /// The polytope where it lies.
    pub fn body(&self) -> Body<'_> {
        Body { vertices: &self.vertices, planes: &self.planes, incidence: &self.incidence }
    }

    /// A copy: numbers are copied as a whole.
    fn copied(&self) -> Self {
        Self {
            vertices: SmallVec::from_slice(&self.vertices),
            planes: SmallVec::from_slice(&self.planes),
            incidence: SmallVec::from_slice(&self.incidence),
            is_frustum: self.is_frustum,
        }
    }

    /// Whether it is a view's frustum that nothing was cut off.
    pub(crate) fn is_frustum(&self) -> bool {
        self.is_frustum
    }

    /// Whether nothing is left that could have an area in the light's view.
    pub fn is_empty(&self) -> bool {
        self.vertices.len() < 3
    }

    /// Whether it reaches to infinity.
    pub fn is_unbounded(&self) -> bool {
        self.vertices.iter().any(|vertex| vertex.w == 0.0)
    }

    /// Whether a homogeneous point lies inside, borders included.
    pub fn contains(&self, point: DVec4) -> bool {
        self.planes.iter().all(|plane| plane.dot(point) >= 0.0)
    }

    /// [`Body::range`].
    pub fn range(&self, row: DVec4) -> (f64, f64) {
        self.body().range(row)
    }

    /// [`Body::quotient_range`].
    pub fn quotient_range(&self, row: DVec4, unit: DVec4) -> (f64, f64) {
        self.body().quotient_range(row, unit)
    }

    /// [`Body::ratio_range`].
    pub fn ratio_range(&self, row: DVec4, w: DVec4) -> (f64, f64) {
        self.body().ratio_range(row, w)
    }
}

impl Body<'_> {
    /// Whether nothing is left that could have an area in the light's view.
    pub fn is_empty(&self) -> bool {
        self.vertices.len() < 3
    }

    /// The polytope cut by several half-spaces.
    pub fn cut_by(&self, planes: &[DVec4]) -> Polytope {
        let mut cut = Polytope::empty();
        self.cut_into(planes, &mut cut);
        cut
    }

    /// [`Self::cut_by`], in the place of another polytope.
    pub(crate) fn cut_into(&self, planes: &[DVec4], cut: &mut Polytope) {
        cut.vertices.clear();
        cut.vertices.extend_from_slice(self.vertices);
        cut.planes.clear();
        cut.planes.extend_from_slice(self.planes);
        cut.incidence.clear();
        cut.incidence.extend_from_slice(self.incidence);
        cut.is_frustum = false;
        for plane in planes {
            cut.cut(*plane);
        }
    }

    /// Smallest and largest value of row.X / X.w over the vertices; infinite where a vertex at infinity makes it so.
    pub fn range(&self, row: DVec4) -> (f64, f64) {
        self.quotient_range(row, DVec4::W)
    }

    /// Smallest and largest value of row.X / unit.X over the vertices; infinite where a vertex with a vanishing unit
    /// makes it so.
    pub fn quotient_range(&self, row: DVec4, unit: DVec4) -> (f64, f64) {
        let values = self.vertices.iter().filter_map(|vertex| {
            let (value, scale) = (row.dot(*vertex), unit.dot(*vertex));
            let vanishes = scale <= 0.0 || (unit != DVec4::W && is_negligible(scale, unit, *vertex));
            match (vanishes, is_negligible(value, row, *vertex)) {
                (false, _) => Some(value / scale),
                (true, true) => None,
                (true, false) => Some(value * f64::INFINITY),
            }
        });
        extremes(values)
    }

    /// Smallest and largest value of row.X / w.X over the vertices, where w annihilates the light and is positive inside.
    /// Vertices whose w vanishes beside their distance are passed over: they lie so far along the light that they
    /// share their image with the other end of their edge.
    pub fn ratio_range(&self, row: DVec4, w: DVec4) -> (f64, f64) {
        let values = self.vertices.iter().filter_map(|vertex| {
            let scale = w.dot(*vertex);
            (!is_negligible(scale, w, *vertex)).then(|| row.dot(*vertex) / scale)
        });
        extremes(values)
    }
}

/// The planes that two vertices share, if an edge joins them, given the planes that each vertex lies on: no third vertex
/// lies on all of them (the double description method's test, which also holds where planes repeat or the polytope is
/// flat).
fn edge(incidence: &[u64], a: usize, b: usize) -> Option<u64> {
    let shared = incidence[a] & incidence[b];
    if shared & shared.wrapping_sub(1) == 0 {
        // No plane or one.
        return None;
    }
    let mut holders = 0;
    for planes in incidence {
        holders += u32::from(planes & shared == shared);
    }
    (holders == 2).then_some(shared)
}

/// Whether a row vanishes on a vertex, beside the sizes of its terms; at any scale of the world.
pub(crate) fn is_negligible(value: f64, row: DVec4, vertex: DVec4) -> bool {
    // Sums of components are no less than lengths and cost no roots.
    let sums = row.truncate().abs().element_sum() * vertex.truncate().abs().element_sum();
    if value.abs() > ALONG_LIGHT * (sums + (row.w * vertex.w).abs()) {
        return false;
    }
    let terms = row.truncate().length() * vertex.truncate().length() + (row.w * vertex.w).abs();
    value.abs() <= ALONG_LIGHT * terms
}

/// Value of a plane on a vertex; zero where the vertex counts as lying on it.
fn signed_distance(plane: DVec4, vertex: DVec4) -> f64 {
    let value = plane.dot(vertex);

    // Sums of components are no less than lengths and cost no roots.
    let sums = plane.truncate().abs().element_sum() * vertex.truncate().abs().element_sum();
    let offsets = (plane.w * vertex.w).abs();
    if value.abs() > ON_PLANE * (sums + offsets) {
        return value;
    }
    let lengths = plane.truncate().length() * vertex.truncate().length();
    if value.abs() <= ON_PLANE * (lengths + offsets) { 0.0 } else { value }
}

/// Smallest and largest of some values; infinite, the wrong way round, where there are none.
pub(crate) fn extremes(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |range, value| (range.0.min(value), range.1.max(value)))
}

/// Size within whose rounding points count as one: a metre, or the whole where that is smaller.
fn finite_size(vertices: &[DVec4]) -> f64 {
    let finite = vertices.iter().filter(|vertex| vertex.w > 0.0);
    finite.map(|vertex| vertex.truncate().abs().max_element()).fold(0.0, f64::max).min(1.0)
}

/// Which of some normalised points is the same as another up to rounding.
fn same(points: &[DVec4], point: DVec4, size: f64) -> Option<usize> {
    // Most are far apart along the first axis.
    let near = ON_PLANE * (2.0 * point.truncate().abs().max_element()).max(size);
    points.iter().position(|known| (known.x - point.x).abs() <= near && coincide(*known, point, size))
}

/// Whether two normalised points are the same up to rounding.
fn coincide(one: DVec4, two: DVec4, size: f64) -> bool {
    let largest = one.truncate().abs().max_element().max(size);
    (one.w > 0.0) == (two.w > 0.0) && (one - two).abs().max_element() <= ON_PLANE * largest
}

/// The same homogeneous point with w = 1, or with unit length at infinity.
fn normalised(point: DVec4) -> DVec4 {
    let scaled = point.truncate() * (1.0 / point.w);
    if point.w > 0.0 && scaled.is_finite() {
        scaled.extend(1.0)
    } else {
        (point.truncate() / point.truncate().abs().max_element()).normalize().extend(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(far: f64) -> View {
        View::perspective(DVec3::ZERO, -DVec3::Z, DVec3::Y, 1.0, 0.5, far, (16, 9)).unwrap()
    }

    #[test]
    fn frustum_vertices_satisfy_every_plane() {
        for far in [100.0, f64::INFINITY] {
            let frustum = Polytope::frustum(&view(far), far);
            for vertex in &frustum.vertices {
                assert!(frustum.planes.iter().all(|plane| plane.dot(*vertex) >= -1e-12));
            }
        }
    }

    #[test]
    fn cutting_at_a_depth_leaves_a_box_of_eight_vertices() {
        let mut frustum = Polytope::frustum(&view(f64::INFINITY), f64::INFINITY);
        frustum.cut(DVec4::new(0.0, 0.0, 1.0, 10.0));
        assert_eq!(frustum.vertices.len(), 8);
        assert!(!frustum.is_unbounded());
        let (near, far) = frustum.range(DEPTH_ROW);
        assert!((near - 0.5).abs() < 1e-12 && (far - 10.0).abs() < 1e-12);
    }

    #[test]
    fn a_box_behind_the_eye_leaves_nothing() {
        let mut frustum = Polytope::frustum(&view(100.0), 100.0);
        let bounds = BoundingBox { min: DVec3::new(-1.0, -1.0, 1.0), max: DVec3::new(1.0, 1.0, 3.0) };
        frustum.cut_by_box(&bounds, DVec3::ZERO, &DMat3::IDENTITY);
        assert!(frustum.is_empty());
    }
}
