//! Casters as facets see them: relative to the eye, equal pipelines and meshes side by side, neighbours in blocks.

use std::ops::Range;

use cssm_core::glam::{DAffine3, DMat3, DVec3};
use cssm_core::{BoundingBox, ShadowPlan};

use super::{MeshFacts, PipelineHandle};
use crate::cull::{CentredBox, InstanceRows, capture_from_object, eye_from_object};
use crate::error::ServiceError;
use crate::mesh::{CasterInstance, MeshHandle};

/// Most casters of a block.
const BLOCK_CASTERS: usize = 16;
/// Steps along each axis into which places are told apart.
const PLACE_STEPS: f64 = 1024.0;

/// All casters of a frame. What facets rarely need is computed when they do: memory that is fresh in every frame costs
/// more than arithmetic.
pub(super) struct Casters<'a, 'm> {
    instances: &'a [CasterInstance],
    eye_world: DVec3,
    capture_from_world: DMat3,
    /// Numbers of the instances and their boxes relative to the eye, world axes.
    pub(super) casters: Vec<(u32, CentredBox)>,
    /// Neighbours with the same mesh.
    pub(super) blocks: Vec<Block>,
    /// Runs of blocks with the same mesh.
    pub(super) groups: Vec<Group<'m>>,
}

/// A few neighbours, most of which a facet refuses together.
pub(super) struct Block {
    /// The box around their boxes.
    pub(super) bounds: CentredBox,
    pub(super) members: Range<usize>,
}

/// Casters with the same mesh.
pub(super) struct Group<'m> {
    pub(super) mesh: MeshHandle,
    pub(super) facts: MeshFacts<'m>,
    pub(super) bounds_object: CentredBox,
    pub(super) blocks: Range<usize>,
    /// Number of casters.
    pub(super) count: usize,
}

/// What casters are sorted by.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    pipeline: PipelineHandle,
    mesh: MeshHandle,
    place: u32,
    number: u32,
}

impl<'a, 'm> Casters<'a, 'm> {
    /// Brings every instance to the eye; `facts` finds a mesh.
    pub(super) fn new(
        plan: &ShadowPlan,
        instances: &'a [CasterInstance],
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
    ) -> Result<Self, ServiceError> {
        let mut all = Self {
            instances,
            eye_world: plan.eye_world,
            capture_from_world: plan.capture_from_world(),
            casters: Vec::with_capacity(instances.len()),
            blocks: Vec::with_capacity(instances.len() / BLOCK_CASTERS + 1),
            groups: Vec::new(),
        };

        // Put a box around every instance and check its transform.
        let mut boxes = Vec::with_capacity(instances.len());
        let mut keys = Vec::with_capacity(instances.len());
        for (index, instance) in instances.iter().enumerate() {
            let facts = facts(instance.mesh).ok_or(ServiceError::UnknownMesh { instance: index })?;
            let fault = || ServiceError::Transform { instance: index };
            let number = u32::try_from(index).map_err(|_| fault())?;
            let eye_from_object = all.eye_from_object(number);
            let bounds = CentredBox::new(&facts.bounds_object).transformed(&eye_from_object);
            let rounds = all.rounded(&eye_from_object).is_some();
            boxes.push(Some(bounds).filter(|bounds| rounds && bounds.is_finite()).ok_or_else(fault)?);
            keys.push(Key { pipeline: facts.pipeline, mesh: instance.mesh, place: 0, number });
        }

        // Put equal pipelines and meshes side by side, and neighbours within a mesh.
        let everything = around(boxes.iter());
        let steps = (everything.max - everything.min).recip() * PLACE_STEPS;
        for (key, bounds) in keys.iter_mut().zip(&boxes) {
            key.place = place((bounds.centre - everything.min) * steps);
        }
        keys.sort_unstable();

        for run in keys.chunk_by(|one, other| one.mesh == other.mesh) {
            let Some(facts) = facts(run[0].mesh) else { continue };
            let start = all.blocks.len();
            for block in run.chunks(BLOCK_CASTERS) {
                let first = all.casters.len();
                all.casters.extend(block.iter().map(|key| (key.number, boxes[key.number as usize])));
                let members = first..all.casters.len();
                let bounds = around(all.casters[members.clone()].iter().map(|(_, bounds)| bounds));
                all.blocks.push(Block { bounds: CentredBox::new(&bounds), members });
            }
            all.groups.push(Group {
                mesh: run[0].mesh,
                facts,
                bounds_object: CentredBox::new(&facts.bounds_object),
                blocks: start..all.blocks.len(),
                count: run.len(),
            });
        }
        Ok(all)
    }

    /// Transform of an instance with the eye at the origin, world axes.
    pub(super) fn eye_from_object(&self, number: u32) -> DAffine3 {
        eye_from_object(&self.instances[number as usize].world_from_object, self.eye_world)
    }

    /// Rows of an instance; [`Casters::new`] has found that f32 can hold them.
    pub(super) fn rows(&self, number: u32) -> Option<InstanceRows> {
        self.rounded(&self.eye_from_object(number))
    }

    fn rounded(&self, eye_from_object: &DAffine3) -> Option<InstanceRows> {
        InstanceRows::rounded(&capture_from_object(eye_from_object, &self.capture_from_world))
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
