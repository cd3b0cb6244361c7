//! What a capture pass does, as a plain list: built on the CPU, replayed on any encoder.
//!
//! [`FrameCommands::rebuild`] needs no device. It asks every facet which casters of a [`CasterScene`] have shadows that can
//! reach it, subtracts the eye from their transforms and turns them to the axes of the capture in f64, and writes the
//! instance rows of each facet behind one another, sorted by pipeline and mesh, so that one draw covers all instances of a
//! mesh that a facet draws whole. Instances of which it draws only some clusters follow, with a draw for each range of
//! clusters.

mod bending;
mod facet_draws;
mod ranges;
mod reach;

use std::ops::Range;

use cssm_core::facet::Tile;
use cssm_core::{BoundingBox, ShadowPlan};

use crate::casters::CasterScene;
use crate::clusters::Cluster;
use crate::cull::InstanceRows;
use crate::culling::CullingWork;
use crate::error::ServiceError;
use crate::mesh::{CasterInstance, MeshHandle};
pub(crate) use facet_draws::widen;
use facet_draws::{FacetDraws, Gathered};
use reach::FacetReach;

/// A capture pipeline of the service.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct PipelineHandle(pub u32);

/// A facet of the frame: its position in the plan's list, which is also the slot of its record.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FacetHandle(pub u32);

/// One step of a capture pass.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Command {
    /// Binds the facet's record and confines viewport and scissor to its tile.
    Facet {
        /// The facet.
        facet: FacetHandle,
        /// Its rectangle of the map.
        tile: Tile,
    },
    /// Binds a pipeline.
    Pipeline(PipelineHandle),
    /// Binds a mesh's vertices and indices, and its alpha mask if it has one.
    Mesh(MeshHandle),
    /// Draws a range of the bound mesh once for each row of `instances`.
    Draw {
        /// First index of the mesh, or first vertex where it has none.
        first: u32,
        /// Number of indices or vertices.
        count: u32,
        /// Whether they are indices.
        indexed: bool,
        /// Instance rows.
        instances: Range<u32>,
    },
    /// Draws the bound mesh once for each row that culling on the device has found; its arguments follow a word of the
    /// frame's arguments, and its rows are those of culling.
    DrawCulled {
        /// First word of its arguments.
        arguments: u32,
        /// Whether the mesh is drawn by indices.
        indexed: bool,
    },
    /// Draws the clusters of the bound mesh that culling on the device has found.
    DrawCulledClusters {
        /// First word of the first draw's arguments, among the arguments of clusters.
        arguments: u32,
        /// Word of the number of draws, among the frame's arguments.
        count: u32,
        /// Their largest number; the arguments of those that are not there are zero.
        most: u32,
        /// Whether the mesh is drawn by indices.
        indexed: bool,
    },
}

/// What commands need to know of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshFacts<'m> {
    /// Pipeline that reads its vertex format.
    pub pipeline: PipelineHandle,
    /// Indices, or vertices where there are none.
    pub corners: u32,
    /// Whether they are indices.
    pub indexed: bool,
    /// Number of the mesh's first index in its buffer. Draws that are left to the device count from the buffer's start:
    /// lavapipe takes no notice of where bound indices begin when it draws indirectly.
    pub first_index: u32,
    /// Box around its positions in object space.
    pub bounds_object: BoundingBox,
    /// Ranges that facets accept or refuse one by one, one after another over all corners; empty: the whole mesh is one.
    pub clusters: &'m [Cluster],
    /// How its triangles are drawn.
    pub drawing: Drawing,
}

/// How a mesh's triangles are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Drawing {
    /// By the mesh's pipeline.
    #[default]
    Plain,
    /// By the mesh's pipeline, which leaves out what bent rows bend too far; then, where a facet may do that, by another
    /// that draws a fan of four triangles for each that was left out.
    Both {
        /// The other pipeline.
        fans: PipelineHandle,
        /// Texels by which straight edges may miss bent ones.
        bound_texels: f32,
    },
    /// By the mesh's pipeline, which draws a fan of four triangles for each.
    Fans,
}

/// Triangles of the fan that stands for one.
pub(crate) const FAN_TRIANGLES: u32 = 4;

/// The capture pass of one frame.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FrameCommands {
    /// Steps in order.
    pub commands: Vec<Command>,
    /// Instance rows that the draws refer to.
    pub rows: Vec<InstanceRows>,
}

/// Counts of one prepared frame; they do not depend on the machine.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct FrameStatistics {
    /// Caster instances passed in.
    pub casters: u32,
    /// Draw calls over all facets.
    pub draws: u32,
    /// Instances drawn over all facets, whole or in part.
    pub instances: u64,
    /// Triangles submitted over all facets.
    pub triangles: u64,
    /// The same for each facet of the plan, in the plan's order.
    pub facets: Vec<FacetStatistics>,
}

/// Counts of one facet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FacetStatistics {
    /// First of the facet's cells in the selection's numbering.
    pub facet: u32,
    /// Draw calls.
    pub draws: u32,
    /// Instances drawn, whole or in part.
    pub instances: u64,
    /// Triangles submitted.
    pub triangles: u64,
    /// What the facet draws, as [`FrameCommands::content`] tells it.
    pub content: u64,
}

/// Memory for building commands, kept from one list to the next.
#[derive(Debug, Clone, Default)]
pub struct CommandScratch {
    reach: FacetReach,
    gathered: Gathered,
}

impl FrameStatistics {
    /// Counts nothing any more, and keeps its memory.
    pub fn clear(&mut self) {
        let Self { casters, draws, instances, triangles, facets } = self;
        (*casters, *draws, *instances, *triangles) = (0, 0, 0, 0);
        facets.clear();
    }
}

impl FrameCommands {
    /// Forgets all commands, and keeps their memory.
    pub fn clear(&mut self) {
        self.commands.clear();
        self.rows.clear();
    }

    /// Replaces the commands by those of some of a plan's facets, given by their positions in its list; `facts` finds a
    /// mesh. Positions beyond the list are passed over. Nothing is allocated unless a
    /// list draws more than twice as much as any before.
    ///
    /// # Errors
    /// [`ServiceError::UnknownMesh`] and [`ServiceError::Transform`], each naming the instance, and
    /// [`ServiceError::TooManyInstances`]. The list is empty then.
    pub fn rebuild<'m>(
        &mut self,
        plan: &ShadowPlan,
        facets: impl IntoIterator<Item = usize>,
        casters: &CasterScene,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        scratch: &mut CommandScratch,
        statistics: &mut FrameStatistics,
    ) -> Result<(), ServiceError> {
        self.clear();
        statistics.clear();
        let appended = self.append(plan, facets, casters, facts, scratch, statistics);
        appended.inspect_err(|_| {
            self.clear();
            statistics.clear();
        })
    }

    /// Appends the commands of some of a plan's facets, as [`FrameCommands::rebuild`] makes them: for another scene of
    /// casters in the same facets, or another plan of the same pass. Statistics are added, with further entries for facets.
    ///
    /// # Errors
    /// As [`FrameCommands::rebuild`]; what was appended up to the fault stays.
    pub fn append<'m>(
        &mut self,
        plan: &ShadowPlan,
        facets: impl IntoIterator<Item = usize>,
        casters: &CasterScene,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        scratch: &mut CommandScratch,
        statistics: &mut FrameStatistics,
    ) -> Result<(), ServiceError> {
        let mut draws = FacetDraws::new(plan, casters, self, scratch, None);
        draws.add_all(facets, facts, statistics)
    }

    /// Appends commands as [`FrameCommands::append`] does, but leaves casters to the device to be culled, except those that
    /// shaders fetch by themselves. Statistics count candidates then, draws and triangles as if all of them were drawn
    /// whole, and [`FacetStatistics::content`] is that of the candidates.
    ///
    /// # Errors
    /// As [`FrameCommands::append`]; clear the work after one.
    #[expect(clippy::too_many_arguments, reason = "three inputs, and four lists that keep their memory")]
    pub(crate) fn append_culled<'m>(
        &mut self,
        plan: &ShadowPlan,
        facets: impl IntoIterator<Item = usize>,
        casters: &CasterScene,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        scratch: &mut CommandScratch,
        statistics: &mut FrameStatistics,
        work: &mut CullingWork,
    ) -> Result<(), ServiceError> {
        let mut draws = FacetDraws::new(plan, casters, self, scratch, Some(work));
        draws.add_all(facets, facts, statistics)
    }

    /// What one facet of a plan draws, as a number that does not depend on the order of casters: as long as neither it nor
    /// the plan changes, the facet's tile need not be drawn anew. It sums hashes of the meshes and transforms of all
    /// casters whose boxes the facet's half-spaces reach. Nothing is written and nothing allocated.
    pub fn content(
        plan: &ShadowPlan,
        facet: usize,
        casters: &CasterScene,
        scratch: &mut CommandScratch,
    ) -> u64 {
        let Some(facet) = plan.facets.get(facet) else { return 0 };
        let mut content: u64 = 0;
        scratch.reach.begin(plan, facet);
        for group in casters.groups() {
            let mut add = |hash: u64| content = content.wrapping_add(hash);
            scratch.reach.each(casters, group, |caster, _| add(caster.content));
        }
        content
    }

    /// Builds the commands of a whole plan from a list of instances, without keeping anything; `facts` finds a mesh.
    ///
    /// # Errors
    /// As [`FrameCommands::rebuild`].
    pub fn build<'m>(
        plan: &ShadowPlan,
        instances: &[CasterInstance],
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
    ) -> Result<(Self, FrameStatistics), ServiceError> {
        let mut casters = CasterScene::new();
        casters.update(instances, &facts)?;
        let (mut frame, mut statistics) = (Self::default(), FrameStatistics::default());
        let facets = 0..plan.facets.len();
        let mut scratch = CommandScratch::default();
        frame.rebuild(plan, facets, &casters, facts, &mut scratch, &mut statistics)?;
        Ok((frame, statistics))
    }

    /// Meshes that the commands draw, with repetitions.
    pub fn meshes(&self) -> impl Iterator<Item = MeshHandle> + '_ {
        self.commands.iter().filter_map(|command| match command {
            Command::Mesh(mesh) => Some(*mesh),
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests;
