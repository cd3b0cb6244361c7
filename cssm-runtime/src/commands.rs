//! What a capture pass does, as a plain list: built on the CPU, replayed on any encoder.
//!
//! [`FrameCommands::build`] needs no device. It subtracts the eye from every transform and turns it to the axes of the
//! capture in f64, asks every facet which casters' shadows can reach it, and writes the instance rows of each facet
//! behind one another, sorted by pipeline and mesh, so that one draw covers all instances of a mesh in a facet.

use std::ops::Range;

use cssm_core::facet::{Facet, Tile};
use cssm_core::glam::{DMat3, DVec3};
use cssm_core::{BoundingBox, ShadowPlan};

use crate::cull::{InstanceRows, box_from_eye, capture_from_object, eye_from_object};
use crate::error::ServiceError;
use crate::mesh::{CasterInstance, MeshHandle};

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
    /// Draws the bound mesh once for each row of the range.
    Draw {
        /// Indices, or vertices where the mesh has none.
        corners: u32,
        /// Whether they are indices.
        indexed: bool,
        /// Instance rows.
        instances: Range<u32>,
    },
}

/// What commands need to know of a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshFacts {
    /// Pipeline that reads its vertex format.
    pub pipeline: PipelineHandle,
    /// Indices, or vertices where there are none.
    pub corners: u32,
    /// Whether they are indices.
    pub indexed: bool,
    /// Box around its positions in object space.
    pub bounds_object: BoundingBox,
}

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
    /// Instances drawn over all facets.
    pub instances: u64,
    /// Triangles submitted over all facets.
    pub triangles: u64,
    /// The same for each facet of the plan, in the plan's order.
    pub facets: Vec<FacetStatistics>,
}

/// Counts of one facet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct FacetStatistics {
    /// Facet index in the selection's numbering.
    pub facet: u32,
    /// Draw calls.
    pub draws: u32,
    /// Instances drawn.
    pub instances: u64,
    /// Triangles submitted.
    pub triangles: u64,
}

/// A caster as facets see it.
struct Caster {
    mesh: MeshHandle,
    facts: MeshFacts,
    rows: InstanceRows,
    box_from_eye: BoundingBox,
}

impl FrameCommands {
    /// Builds the commands of a plan; `facts` finds a mesh.
    ///
    /// # Errors
    /// [`ServiceError::UnknownMesh`] and [`ServiceError::Transform`], each naming the instance.
    pub fn build(
        plan: &ShadowPlan,
        instances: &[CasterInstance],
        facts: impl Fn(MeshHandle) -> Option<MeshFacts>,
    ) -> Result<(Self, FrameStatistics), ServiceError> {
        // Bring every caster to the eye, then put equal pipelines and meshes side by side.
        let capture_from_world = plan.capture_from_world();
        let mut casters = instances
            .iter()
            .enumerate()
            .map(|(number, instance)| {
                Caster::new(number, instance, plan.eye_world, &capture_from_world, &facts)
            })
            .collect::<Result<Vec<_>, _>>()?;
        casters.sort_by_key(|caster| (caster.facts.pipeline, caster.mesh));

        // List each facet's draws.
        let mut frame = Self::default();
        let mut statistics = FrameStatistics { casters: instances.len() as u32, ..Default::default() };
        let mut bound = None;
        for (position, facet) in plan.facets.iter().enumerate() {
            let counts = frame.draw_facet(FacetHandle(position as u32), facet, &casters, &mut bound)?;
            statistics.draws += counts.draws;
            statistics.instances += counts.instances;
            statistics.triangles += counts.triangles;
            statistics.facets.push(counts);
        }
        Ok((frame, statistics))
    }

    /// Meshes that the commands draw, with repetitions.
    pub fn meshes(&self) -> impl Iterator<Item = MeshHandle> + '_ {
        self.commands.iter().filter_map(|command| match command {
            Command::Mesh(mesh) => Some(*mesh),
            _ => None,
        })
    }

    /// Appends the draws of one facet; `bound` is what the previous facets left bound.
    fn draw_facet(
        &mut self,
        handle: FacetHandle,
        facet: &Facet,
        casters: &[Caster],
        bound: &mut Option<(PipelineHandle, MeshHandle)>,
    ) -> Result<FacetStatistics, ServiceError> {
        let mut counts = FacetStatistics { facet: facet.index, ..Default::default() };
        for group in casters.chunk_by(|one, other| one.mesh == other.mesh) {
            // Keep the instances whose shadow can reach something visible here.
            let start = self.rows.len();
            let reaching = group.iter().filter(|caster| facet.reached_by(&caster.box_from_eye));
            self.rows.extend(reaching.map(|caster| caster.rows));
            if self.rows.len() == start {
                continue;
            }
            let rows = self.rows.len();
            let range = |row: usize| u32::try_from(row).map_err(|_| ServiceError::TooManyInstances { rows });
            let instances = range(start)?..range(rows)?;

            // Bind only what differs from the previous draw.
            let (mesh, facts) = (group[0].mesh, group[0].facts);
            if counts.draws == 0 {
                self.commands.push(Command::Facet { facet: handle, tile: facet.tile });
            }
            if bound.is_none_or(|(pipeline, _)| pipeline != facts.pipeline) {
                self.commands.push(Command::Pipeline(facts.pipeline));
            }
            if bound.is_none_or(|(_, bound)| bound != mesh) {
                self.commands.push(Command::Mesh(mesh));
            }
            *bound = Some((facts.pipeline, mesh));

            // Draw and count.
            counts.draws += 1;
            counts.instances += u64::from(instances.end - instances.start);
            counts.triangles += u64::from(instances.end - instances.start) * u64::from(facts.corners / 3);
            self.commands.push(Command::Draw { corners: facts.corners, indexed: facts.indexed, instances });
        }
        Ok(counts)
    }
}

impl Caster {
    fn new(
        number: usize,
        instance: &CasterInstance,
        eye_world: DVec3,
        capture_from_world: &DMat3,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts>,
    ) -> Result<Self, ServiceError> {
        let facts = facts(instance.mesh).ok_or(ServiceError::UnknownMesh { instance: number })?;
        let transform = eye_from_object(&instance.world_from_object, eye_world);
        let turned = capture_from_object(&transform, capture_from_world);
        let rows = InstanceRows::rounded(&turned).ok_or(ServiceError::Transform { instance: number })?;
        let box_from_eye = box_from_eye(&transform, &facts.bounds_object);
        if !(box_from_eye.min.is_finite() && box_from_eye.max.is_finite()) {
            return Err(ServiceError::Transform { instance: number });
        }
        Ok(Self { mesh: instance.mesh, facts, rows, box_from_eye })
    }
}

#[cfg(test)]
mod tests;
