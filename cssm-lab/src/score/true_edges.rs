//! What the truth of a frame says by itself, whatever a map makes of it: where its edges are, and how far everything lies
//! from them.

use super::bands::Bands;
use super::distance;
use super::edges::{FineEdges, Lattice, Marks};
use super::{SHALLOW_COSINES, truth_at};
use crate::truth::{Frame, Visible};

/// True shadow edges of a frame and distances from them, found once for every map that is judged on it.
#[derive(Debug, Clone)]
pub struct TrueEdges {
    pub(super) lattice: Lattice,
    /// Between pixels that face the light.
    pub(super) facing: EdgeSet,
    /// Between pixels that face the light at but a degree as well.
    pub(super) shallow: EdgeSet,
    /// Distance of each place from the nearest crease.
    pub(super) to_crease: Vec<f64>,
}

/// Edges, and the distance of each place of the lattice from the nearest, finer ones included.
#[derive(Debug, Clone)]
pub(super) struct EdgeSet {
    pub(super) edges: Marks,
    pub(super) distances: Vec<f64>,
}

impl TrueEdges {
    /// The edges of a frame; `fine` are true edges and creases finer than pixels, where surfaces are thinner than a pixel.
    pub fn of(frame: &Frame, fine: Option<&FineEdges>) -> Self {
        let lattice = Lattice::of(frame);
        let creases = Marks::creases(frame, lattice);
        let to_crease = match fine {
            None => distance::transform(&creases),
            Some(fine) => distance::transform(&creases.with(&fine.creases)),
        };
        let set = |faces: fn(&Visible) -> bool| {
            let edges = Marks::edges(frame, lattice, faces, |index| truth_at(frame, index));
            let distances = match fine {
                None => distance::transform(&edges),
                Some(fine) => distance::transform(&edges.with(&fine.edges)),
            };
            EdgeSet { edges, distances }
        };
        Self { lattice, facing: set(Visible::faces_light), shallow: set(faces_shallowly), to_crease }
    }

    /// Where pixels lie that face the light.
    pub(super) fn bands(&self) -> Bands<'_> {
        Bands::new(&self.facing.distances, &self.to_crease)
    }

    /// Where pixels lie that face the light at but a degree.
    pub(super) fn shallow_bands(&self) -> Bands<'_> {
        Bands::new(&self.shallow.distances, &self.to_crease)
    }
}

/// Whether the light reaches a surface that rises at least a degree out of its direction.
pub(super) fn faces_shallowly(pixel: &Visible) -> bool {
    pixel.reached && pixel.cosine > SHALLOW_COSINES.start
}
