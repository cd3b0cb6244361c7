//! Lists that fitting drafts to the map works in.

use smallvec::SmallVec;

use super::texels::Texels;
use super::window::Sample;
use crate::layout::{Gram, Layout, Placements, TileDemand};
use crate::samples;

/// What fitting one draft after the other works in.
#[derive(Debug, Default)]
pub(crate) struct Fitting {
    /// Facets that its lists have room for.
    pub(super) room: usize,
    pub(super) known: Known,
    pub(super) layout: Layout,
    /// What each tile asks for.
    pub(super) demands: SmallVec<[TileDemand; 4]>,
    /// The demand of each window.
    pub(super) sharing: SmallVec<[u32; 32]>,
    pub(super) placed: Placements,
    /// Texels of each window.
    pub(super) texels: SmallVec<[Texels; 4]>,
    pub(super) squares: SmallVec<[f64; 128]>,
    pub(super) weighted: Vec<(f64, f64)>,
}

impl Fitting {
    /// Makes room for so many facets.
    pub(super) fn make_room(&mut self, most: usize) {
        self.room = most;
        self.layout.make_room(most);
    }

    /// Empties its lists of facets, with room for so many.
    pub(super) fn begin(&mut self) {
        let room = self.room;
        self.demands.clear();
        self.demands.reserve(room);
        self.sharing.clear();
        self.sharing.reserve(room);
        self.placed.clear();
        self.placed.reserve(room);
        self.texels.clear();
        self.texels.reserve(room);
        self.squares.clear();
        if room > 0 {
            self.squares.reserve(samples::MOST);
        }
    }
}

/// What samples of the view tell of one window.
#[derive(Debug, Default)]
pub(super) struct Known {
    pub(super) samples: Vec<Sample>,
    pub(super) grams: Vec<Gram>,
    pub(super) values: Vec<f64>,
}
