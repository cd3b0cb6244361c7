//! Many convex polytopes in shared lists, which ask for memory together.

use glam::DVec4;

use super::{Body, same};

/// Vertices, and planes, that most polytopes have no more of.
const USUAL: usize = 14;

/// Least room for vertices, and for planes: few polytopes may be large ones.
const LEAST_ROOM: usize = 64;

/// Many convex polytopes.
#[derive(Debug, Default)]
pub(crate) struct Bodies {
    vertices: Vec<DVec4>,
    planes: Vec<DVec4>,
    incidence: Vec<u64>,
}

/// Where one of many convex polytopes lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct BodyPlace {
    vertices: [u32; 2],
    planes: [u32; 2],
}

/// A polytope that is being added.
pub(super) struct NewBody<'a> {
    bodies: &'a mut Bodies,
    vertices: usize,
}

impl Bodies {
    /// Forgets all polytopes.
    pub(crate) fn clear(&mut self) {
        self.vertices.clear();
        self.planes.clear();
        self.incidence.clear();
    }

    /// Makes room for so many polytopes.
    pub(crate) fn reserve(&mut self, count: usize) {
        let room = (count * USUAL).max(LEAST_ROOM);
        self.vertices.reserve(room);
        self.planes.reserve(room);
        self.incidence.reserve(room);
    }

    /// Adds a copy of a polytope.
    pub(crate) fn add(&mut self, body: Body<'_>) -> BodyPlace {
        let vertices = self.vertices.len();
        self.vertices.extend_from_slice(body.vertices);
        self.incidence.extend_from_slice(body.incidence);
        self.placed(vertices, body.planes, [].into_iter())
    }

    /// A polytope of these.
    pub(crate) fn get(&self, place: BodyPlace) -> Body<'_> {
        let [vertices, planes] =
            [place.vertices, place.planes].map(|[start, end]| start as usize..end as usize);
        Body {
            vertices: &self.vertices[vertices.clone()],
            planes: &self.planes[planes],
            incidence: &self.incidence[vertices],
        }
    }

    pub(super) fn begin(&mut self) -> NewBody<'_> {
        let vertices = self.vertices.len();
        NewBody { bodies: self, vertices }
    }

    fn placed(
        &mut self,
        vertices: usize,
        planes: &[DVec4],
        others: impl Iterator<Item = DVec4>,
    ) -> BodyPlace {
        let start = self.planes.len();
        self.planes.extend_from_slice(planes);
        self.planes.extend(others);
        BodyPlace {
            vertices: [vertices as u32, self.vertices.len() as u32],
            planes: [start as u32, self.planes.len() as u32],
        }
    }
}

impl NewBody<'_> {
    /// Adds a vertex and the planes that it lies on.
    pub(super) fn push(&mut self, vertex: DVec4, planes: u64) {
        self.bodies.vertices.push(vertex);
        self.bodies.incidence.push(planes);
    }

    /// Adds a vertex unless it is one that is known.
    pub(super) fn merge(&mut self, vertex: DVec4, planes: u64, size: f64) {
        match same(&self.bodies.vertices[self.vertices..], vertex, size) {
            Some(same) => self.bodies.incidence[self.vertices + same] |= planes,
            None => self.push(vertex, planes),
        }
    }

    /// Ends it with all its planes.
    pub(super) fn end(self, planes: &[DVec4], others: impl Iterator<Item = DVec4>) -> BodyPlace {
        self.bodies.placed(self.vertices, planes, others)
    }
}
