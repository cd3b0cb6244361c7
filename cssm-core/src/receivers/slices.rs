//! A polytope cut into slices that lie one behind the other: its edges are found once, and neighbours share the vertices
//! between them.

use glam::DVec4;
use smallvec::SmallVec;

use super::{Bodies, Body, BodyPlace, FEW, PLANE_LIMIT, edge, finite_size, normalised, signed_distance};

/// Edges of a polytope that need no allocation.
const FEW_EDGES: usize = 64;
/// Vertices on a plane between two slices that need no allocation.
const FEW_CROSSINGS: usize = 24;

/// A polytope that is being cut at ascending limits of a quotient of two rows.
pub(crate) struct Slices<'a> {
    whole: Body<'a>,
    distance: DVec4,
    unit: DVec4,
    /// Two vertices and the planes that they share.
    edges: SmallVec<[(u8, u8, u64); FEW_EDGES]>,
    /// The planes on either side of a slice, in turn.
    borders: [Border; 2],
    is_flipped: bool,
    /// See [`finite_size`].
    size: f64,
}

/// A plane between two slices.
struct Border {
    /// Whether there is one.
    is_there: bool,
    /// Positive beyond.
    plane: DVec4,
    /// Its value on each vertex.
    values: SmallVec<[f64; FEW]>,
    /// Vertices on edges that cross it.
    crossings: SmallVec<[Crossing; FEW_CROSSINGS]>,
}

/// A vertex on an edge that crosses a plane.
struct Crossing {
    point: DVec4,
    /// Planes of the edge.
    planes: u64,
    /// The edge's end before the plane.
    before: u8,
}

impl<'a> Slices<'a> {
    /// Cuts a polytope by the quotient of two rows; `None` where the second is negative somewhere, so that slices would
    /// not lie one behind the other.
    pub(crate) fn of(whole: Body<'a>, distance: DVec4, unit: DVec4) -> Option<Self> {
        let count = whole.vertices.len();
        let fits = whole.planes.len() + 2 <= PLANE_LIMIT && count <= usize::from(u8::MAX);
        if !fits || whole.vertices.iter().any(|vertex| unit.dot(*vertex) < 0.0) {
            return None;
        }
        let mut edges = SmallVec::new();
        for a in 0..count {
            for b in a + 1..count {
                if let Some(shared) = edge(whole.incidence, a, b) {
                    edges.push((a as u8, b as u8, shared));
                }
            }
        }
        let borders = [Border::none(), Border::none()];
        let size = finite_size(whole.vertices);
        Some(Self { whole, distance, unit, edges, borders, is_flipped: false, size })
    }

    /// Adds the next slice, up to a limit above the last one or to the end, and says where it lies.
    pub(crate) fn next(&mut self, limit: Option<f64>, bodies: &mut Bodies) -> BodyPlace {
        let [one, two] = &mut self.borders;
        let (lower, upper) = if self.is_flipped { (two, one) } else { (one, two) };
        match limit {
            Some(limit) => upper.lay(self.distance - self.unit * limit, &self.whole, &self.edges),
            None => upper.is_there = false,
        }
        self.is_flipped = !self.is_flipped;

        // Keep vertices between both planes, or on one of them.
        let planes = self.whole.planes.len();
        let (lower_bit, upper_bit) = (1_u64 << planes, 1_u64 << (planes + usize::from(lower.is_there)));
        let mut slice = bodies.begin();
        for (index, vertex) in self.whole.vertices.iter().enumerate() {
            let mut own = self.whole.incidence[index];
            if lower.is_there {
                let value = lower.values[index];
                if value < 0.0 {
                    continue;
                }
                own |= if value == 0.0 { lower_bit } else { 0 };
            }
            if upper.is_there {
                let value = upper.values[index];
                if value > 0.0 {
                    continue;
                }
                own |= if value == 0.0 { upper_bit } else { 0 };
            }
            slice.push(*vertex, own);
        }

        // Add vertices on edges that cross either plane: first those of edges that begin in the slice.
        if lower.is_there {
            for Crossing { point, planes, .. } in &lower.crossings {
                slice.merge(*point, planes | lower_bit, self.size);
            }
        }
        if upper.is_there {
            let begins =
                |crossing: &Crossing| !lower.is_there || lower.values[usize::from(crossing.before)] >= 0.0;
            for is_first in [true, false] {
                for crossing in upper.crossings.iter().filter(|crossing| begins(crossing) == is_first) {
                    let Crossing { point, planes, .. } = crossing;
                    slice.merge(*point, planes | upper_bit, self.size);
                }
            }
        }
        let ends = [lower.is_there.then_some(lower.plane), upper.is_there.then_some(-upper.plane)];
        slice.end(self.whole.planes, ends.into_iter().flatten())
    }
}

impl Border {
    fn none() -> Self {
        Self { is_there: false, plane: DVec4::ZERO, values: SmallVec::new(), crossings: SmallVec::new() }
    }

    /// Makes it the plane of a polytope with these edges.
    fn lay(&mut self, plane: DVec4, whole: &Body<'_>, edges: &[(u8, u8, u64)]) {
        (self.is_there, self.plane) = (true, plane);
        self.values.clear();
        self.crossings.clear();
        self.values.extend(whole.vertices.iter().map(|vertex| signed_distance(plane, *vertex)));
        for (a, b, planes) in edges {
            let (one, two) = (self.values[usize::from(*a)], self.values[usize::from(*b)]);
            if one * two < 0.0 {
                let (before, beyond) = if one < 0.0 { (*a, *b) } else { (*b, *a) };
                let (inner, outer) = (one.max(two), one.min(two));
                let [from, to] = [beyond, before].map(|index| whole.vertices[usize::from(index)]);
                let point = normalised(from * -outer + to * inner);
                self.crossings.push(Crossing { point, planes: *planes, before });
            }
        }
    }
}
