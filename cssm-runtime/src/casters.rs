//! Casters in world space, in f64: boxes, neighbours in blocks, equal meshes in groups; one list for all lights and views.

mod content;

pub(crate) use content::mixed;

use std::ops::Range;

use cssm_core::BoundingBox;
use cssm_core::glam::DVec3;

use crate::commands::{MeshFacts, PipelineHandle};
use crate::cull::{CentredBox, InstanceRows};
use crate::error::ServiceError;
use crate::mesh::{CasterInstance, MeshHandle};

/// Most casters of a block.
pub(crate) const BLOCK_CASTERS: usize = 16;
/// Steps along each axis into which places are told apart.
const PLACE_STEPS: f64 = 1024.0;
/// By how much the boxes of blocks may grow while casters move before neighbours are looked for anew.
const GROWTH_LIMIT: f64 = 1.5;

/// The casters of a scene, ready for any number of plans.
///
/// Nothing in it depends on an eye, a light or a plan: [`CasterScene::update`] it once a frame and build the commands of
/// all lights from it ([`crate::FrameCommands::rebuild`]). It keeps its memory; a frame in which nothing moves costs one
/// comparison for each instance.
///
/// Casters that rarely move and casters that always do are best kept in two scenes.
#[derive(Debug, Clone, Default)]
pub struct CasterScene {
    instances: Vec<CasterInstance>,
    /// In the order of groups and blocks.
    sorted: Vec<SortedCaster>,
    /// Places in `sorted`, by the number of the instance.
    places: Vec<u32>,
    blocks: Vec<Block>,
    groups: Vec<Group>,
    /// Summed extents of the blocks when they were made.
    made_extent: f64,
    revision: u64,
    /// Instances that are not as they were.
    fresh: Vec<SortedCaster>,
}

/// An instance and what culling needs of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SortedCaster {
    /// Position in the list of instances.
    pub(crate) number: u32,
    pipeline: PipelineHandle,
    /// Position along a Z-order curve.
    place: u32,
    block: u32,
    /// Hash of the mesh and the transform.
    pub(crate) content: u64,
    /// World space.
    pub(crate) bounds: CentredBox,
}

/// A few neighbours, most of which a facet refuses together.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Block {
    /// The box around their boxes, world space.
    pub(crate) bounds: CentredBox,
    start: usize,
    end: usize,
    is_stale: bool,
}

/// Casters with the same mesh.
#[derive(Debug, Clone)]
pub(crate) struct Group {
    pub(crate) mesh: MeshHandle,
    pub(crate) bounds_object: CentredBox,
    /// The box around all of them, world space.
    pub(crate) bounds: CentredBox,
    pub(crate) blocks: Range<usize>,
    /// Number of casters.
    pub(crate) count: usize,
}

impl CasterScene {
    /// No casters.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes over a frame's instances; `facts` finds a mesh. Returns whether anything is not as it was.
    ///
    /// Instances are known by their position in the list. Moved ones get new boxes; neighbours are sorted anew only when
    /// the list gets longer or shorter, a mesh is exchanged, or blocks have grown by half. After an error everything is as
    /// it was.
    ///
    /// # Errors
    /// [`ServiceError::UnknownMesh`] and [`ServiceError::Transform`], each naming the instance.
    pub fn update<'m>(
        &mut self,
        instances: &[CasterInstance],
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
    ) -> Result<bool, ServiceError> {
        // Compare, and check what is new before anything is changed.
        let same_list = self.instances.len() == instances.len()
            && self.instances.iter().zip(instances).all(|(old, new)| old.mesh == new.mesh);
        self.fresh.clear();
        for (index, instance) in instances.iter().enumerate() {
            if !same_list || self.instances.get(index) != Some(instance) {
                self.fresh.push(SortedCaster::new(index, instance, &facts)?);
            }
        }
        for group in &self.groups {
            if facts(group.mesh).is_none()
                && let Some(instance) = instances.iter().position(|instance| instance.mesh == group.mesh)
            {
                return Err(ServiceError::UnknownMesh { instance });
            }
        }
        if same_list && self.fresh.is_empty() {
            return Ok(false);
        }

        // Move boxes where they are, or begin anew.
        self.revision = self.revision.wrapping_add(1);
        if same_list {
            self.move_fresh(instances);
            if self.extent() <= GROWTH_LIMIT * self.made_extent {
                self.surround_groups();
                return Ok(true);
            }
        } else {
            self.instances.clear();
            self.instances.extend_from_slice(instances);
            self.sorted.clear();
            self.sorted.append(&mut self.fresh);
        }
        self.sort(facts);
        Ok(true)
    }

    /// The instances of the last update.
    pub fn instances(&self) -> &[CasterInstance] {
        &self.instances
    }

    /// Counts the updates that changed something: as long as it stays, no facet of a held plan has to be drawn anew.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// The box around all casters, world space; `None` where there are none.
    pub fn bounds_world(&self) -> Option<BoundingBox> {
        (!self.groups.is_empty()).then(|| around(self.groups.iter().map(|group| &group.bounds)))
    }

    pub(crate) fn groups(&self) -> &[Group] {
        &self.groups
    }

    pub(crate) fn block_count(&self) -> usize {
        self.blocks.len()
    }

    pub(crate) fn blocks(&self, group: &Group) -> &[Block] {
        &self.blocks[group.blocks.clone()]
    }

    pub(crate) fn members(&self, block: &Block) -> &[SortedCaster] {
        &self.sorted[block.start..block.end]
    }

    /// Puts fresh casters where the same instances were.
    fn move_fresh(&mut self, instances: &[CasterInstance]) {
        for caster in &self.fresh {
            let number = caster.number as usize;
            self.instances[number] = instances[number];
            let slot = &mut self.sorted[self.places[number] as usize];
            let block = slot.block;
            *slot = SortedCaster { block, ..*caster };
            self.blocks[block as usize].is_stale = true;
        }
        for block in &mut self.blocks {
            if block.is_stale {
                let members = &self.sorted[block.start..block.end];
                block.bounds = CentredBox::new(&around(members.iter().map(|caster| &caster.bounds)));
                block.is_stale = false;
            }
        }
    }

    /// Puts equal pipelines and meshes side by side, and neighbours within a mesh.
    fn sort<'m>(&mut self, facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>) {
        let everything = around(self.sorted.iter().map(|caster| &caster.bounds));
        let steps = (everything.max - everything.min).recip() * PLACE_STEPS;
        for caster in &mut self.sorted {
            caster.place = place((caster.bounds.centre - everything.min) * steps);
        }
        let instances = &self.instances;
        let mesh = |caster: &SortedCaster| instances[caster.number as usize].mesh;
        self.sorted
            .sort_unstable_by_key(|caster| (caster.pipeline, mesh(caster), caster.place, caster.number));

        // Cut them into groups and blocks.
        self.blocks.clear();
        self.groups.clear();
        self.places.clear();
        self.places.resize(self.sorted.len(), 0);
        let mut start = 0;
        while let Some(first) = self.sorted.get(start) {
            let mesh_here = mesh(first);
            let count = self.sorted[start..].iter().take_while(|caster| mesh(caster) == mesh_here).count();
            let end = start + count;
            let first_block = self.blocks.len();
            for begin in (start..end).step_by(BLOCK_CASTERS) {
                let until = (begin + BLOCK_CASTERS).min(end);
                let block = self.blocks.len() as u32;
                for (at, caster) in self.sorted[begin..until].iter_mut().enumerate() {
                    caster.block = block;
                    self.places[caster.number as usize] = (begin + at) as u32;
                }
                let bounds = around(self.sorted[begin..until].iter().map(|caster| &caster.bounds));
                let bounds = CentredBox::new(&bounds);
                self.blocks.push(Block { bounds, start: begin, end: until, is_stale: false });
            }
            // The mesh was found when the instances were checked.
            if let Some(facts) = facts(mesh_here) {
                self.groups.push(Group {
                    mesh: mesh_here,
                    bounds_object: CentredBox::new(&facts.bounds_object),
                    bounds: CentredBox { centre: DVec3::ZERO, half: DVec3::ZERO },
                    blocks: first_block..self.blocks.len(),
                    count,
                });
            }
            start = end;
        }
        self.surround_groups();
        self.made_extent = self.extent();
    }

    fn surround_groups(&mut self) {
        for group in &mut self.groups {
            let blocks = &self.blocks[group.blocks.clone()];
            group.bounds = CentredBox::new(&around(blocks.iter().map(|block| &block.bounds)));
        }
    }

    fn extent(&self) -> f64 {
        self.blocks.iter().map(|block| block.bounds.half.element_sum()).sum()
    }
}

impl SortedCaster {
    /// Puts a box around an instance and checks its transform.
    fn new<'m>(
        index: usize,
        instance: &CasterInstance,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
    ) -> Result<Self, ServiceError> {
        let facts = facts(instance.mesh).ok_or(ServiceError::UnknownMesh { instance: index })?;
        let fault = || ServiceError::Transform { instance: index };
        let world_from_object = &instance.world_from_object;
        let bounds = CentredBox::new(&facts.bounds_object).transformed(world_from_object);
        if !bounds.is_finite() || InstanceRows::rounded(world_from_object).is_none() {
            return Err(fault());
        }
        Ok(Self {
            number: u32::try_from(index).map_err(|_| fault())?,
            pipeline: facts.pipeline,
            place: 0,
            block: 0,
            content: content::hash(instance),
            bounds,
        })
    }
}

/// The box around boxes.
fn around<'a>(boxes: impl Iterator<Item = &'a CentredBox>) -> BoundingBox {
    let nothing = BoundingBox { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };
    boxes.fold(nothing, |all, one| BoundingBox {
        min: all.min.min(one.centre - one.half),
        max: all.max.max(one.centre + one.half),
    })
}

/// Position along a Z-order curve of a point in steps; what is no number counts as 0.
fn place(steps: DVec3) -> u32 {
    let spread = |steps: f64| {
        let bits = (steps as u32).min(PLACE_STEPS as u32 - 1);
        (0..PLACE_STEPS.log2() as u32).fold(0, |all, bit| all | (bits >> bit & 1) << (3 * bit))
    };
    spread(steps.x) | spread(steps.y) << 1 | spread(steps.z) << 2
}

#[cfg(test)]
mod tests;
