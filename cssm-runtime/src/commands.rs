//! What a capture pass does, as a plain list: built on the CPU, replayed on any encoder.
//!
//! [`FrameCommands::build`] needs no device. It subtracts the eye from every transform and turns it to the axes of the
//! capture in f64, asks every facet which casters' shadows can reach it, and writes the instance rows of each facet
//! behind one another, sorted by pipeline and mesh, so that one draw covers all instances of a mesh that a facet draws
//! whole. Instances of which it draws only some clusters follow, with a draw for each range of clusters.

mod bending;
mod casters;
mod facet_draws;
mod ranges;

use std::ops::Range;

use cssm_core::facet::Tile;
use cssm_core::{BoundingBox, ShadowPlan};

use crate::clusters::Cluster;
use crate::cull::InstanceRows;
use crate::error::ServiceError;
use crate::mesh::{CasterInstance, MeshHandle};
use casters::Casters;
use facet_draws::FacetDraws;

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
}

impl FrameCommands {
    /// Builds the commands of a plan; `facts` finds a mesh.
    ///
    /// # Errors
    /// [`ServiceError::UnknownMesh`] and [`ServiceError::Transform`], each naming the instance.
    pub fn build<'m>(
        plan: &ShadowPlan,
        instances: &[CasterInstance],
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
    ) -> Result<(Self, FrameStatistics), ServiceError> {
        let casters = Casters::new(plan, instances, facts)?;
        let mut draws = FacetDraws::new(&casters);
        let mut statistics = FrameStatistics { casters: instances.len() as u32, ..Default::default() };
        for (position, facet) in plan.facets.iter().enumerate() {
            let counts = draws.add(FacetHandle(position as u32), facet)?;
            statistics.draws += counts.draws;
            statistics.instances += counts.instances;
            statistics.triangles += counts.triangles;
            statistics.facets.push(counts);
        }
        Ok((draws.frame, statistics))
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
