//! What techniques answer, in lists that serve frame after frame.

use smallvec::SmallVec;

use super::{FacetDraft, Fallback};
use crate::facet::Selection;
use crate::plan::DominantFacet;
use crate::receivers::{Bodies, Body, Polytope};

/// What a technique answers: the walk and the facets, before tiles, depth rows and windows are found.
#[derive(Debug)]
pub struct Draft {
    /// Chosen configuration.
    pub configuration: &'static str,
    /// Which of the configuration's forms this is; empty where it has one.
    pub form: &'static str,
    /// Whether every receiver has a facet; if not, nothing is promised of the rest.
    pub complete: bool,
    /// How far the technique gives way to another near a situation that it has no answer for.
    pub fallback: Option<Fallback>,
    /// The walk from a receiver to its facet.
    pub selection: Selection,
    /// The facets.
    pub facets: Vec<FacetDraft>,
    /// Their receivers.
    pub(crate) bodies: Bodies,
}

/// Stands for the facet of what has none.
pub(crate) const NO_FACET: u32 = u32::MAX;

/// Drafts of a frame. Their memory is kept for the next.
#[derive(Debug, Default)]
pub struct Drafts {
    list: Vec<Draft>,
    count: usize,
    /// Facets that every draft has room for.
    room: usize,
}

impl Drafts {
    /// Forgets all drafts.
    pub(crate) fn clear(&mut self) {
        self.count = 0;
    }

    /// Makes room for so many drafts of so many facets.
    pub(crate) fn make_room(&mut self, drafts: usize, facets: usize) {
        self.room = facets;
        self.list.resize_with(self.list.len().max(drafts), Draft::empty);
        for draft in &mut self.list {
            draft.forget();
            draft.reserve(facets);
            draft.selection.reserve(facets);
        }
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        self.count
    }

    /// Forgets the last drafts but so many.
    pub(crate) fn truncate(&mut self, count: usize) {
        self.count = self.count.min(count);
    }

    /// The drafts.
    pub(crate) fn list(&self) -> &[Draft] {
        &self.list[..self.count]
    }

    /// The drafts, to be changed.
    pub(crate) fn list_mut(&mut self) -> &mut [Draft] {
        &mut self.list[..self.count]
    }

    /// Adds a draft of a configuration that has one form and leaves nothing out; its walk has so many sectors and bands.
    pub(crate) fn open(&mut self, configuration: &'static str, (sectors, bands): (u32, u32)) -> &mut Draft {
        if self.count == self.list.len() {
            self.list.push(Draft::empty());
        }
        let draft = &mut self.list[self.count];
        self.count += 1;
        (draft.configuration, draft.form, draft.complete, draft.fallback) = (configuration, "", true, None);
        draft.selection.begin(sectors, bands);
        draft.forget();
        draft.reserve(self.room);
        draft
    }
}

impl Draft {
    fn empty() -> Self {
        Self {
            configuration: "",
            form: "",
            complete: true,
            fallback: None,
            selection: Selection::single(),
            facets: Vec::new(),
            bodies: Bodies::default(),
        }
    }

    /// Forgets all facets.
    fn forget(&mut self) {
        self.facets.clear();
        self.bodies.clear();
    }

    /// Makes room for so many more facets.
    pub(crate) fn reserve(&mut self, count: usize) {
        if count > 0 {
            self.facets.reserve(count);
            self.bodies.reserve(count);
        }
    }

    /// Adds a facet with its receivers.
    pub(crate) fn push(&mut self, facet: FacetDraft, receivers: Body<'_>) {
        let receivers = self.bodies.add(receivers);
        self.facets.push(FacetDraft { receivers, ..facet });
    }

    /// Adds a facet whose receivers are those of all that its half-spaces leave.
    pub(crate) fn push_cut(&mut self, facet: FacetDraft, all: &Polytope) {
        let receivers = all.cut_by(&facet.select);
        self.push(facet, receivers.body());
    }

    /// A facet's receivers.
    pub(crate) fn receivers(&self, facet: &FacetDraft) -> Body<'_> {
        self.bodies.get(facet.receivers)
    }

    /// Adds a facet for receivers near a dominant plane, if there is one.
    pub(crate) fn add_dominant(&mut self, dominant: Option<&DominantFacet>) {
        self.selection.dominant = dominant.map(|dominant| dominant.rows);
        if let Some(dominant) = dominant {
            self.push(dominant.facet.clone(), dominant.receivers.body());
        }
    }

    /// The facet of each cell of the walk; [`NO_FACET`] where it has none.
    pub(crate) fn owners(&self) -> SmallVec<[u32; 136]> {
        let Selection { sectors, bands, .. } = self.selection;
        let mut owners = SmallVec::from_elem(NO_FACET, self.selection.dominant_cell() as usize + 1);
        for (index, facet) in self.facets.iter().enumerate() {
            if facet.is_dominant() {
                owners[self.selection.dominant_cell() as usize] = index as u32;
            }
            for cell in &facet.cells {
                let owner = owners.get_mut(cell.index(sectors, bands) as usize);
                owner.into_iter().for_each(|owner| *owner = index as u32);
            }
        }
        owners
    }
}
