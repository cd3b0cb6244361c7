//! Which casters' shadows can reach a facet.

use cssm_core::ShadowPlan;
use cssm_core::facet::Facet;
use cssm_core::glam::DVec3;

use crate::casters::{Block, CasterScene, Group, SortedCaster};
use crate::cull::{HalfSpace, Side, eye_from_object};

/// The half-spaces of one facet after another. Boxes are brought to the eye, not half-spaces to the world: what lies far
/// from the origin keeps its bits.
#[derive(Debug, Clone, Default)]
pub(super) struct FacetReach {
    eye_world: DVec3,
    /// The facet's half-spaces, relative to the eye, world axes.
    planes: Vec<HalfSpace>,
    /// Those that cut through a block's box.
    near: Vec<HalfSpace>,
    /// Those that cut through an instance's box, in the instance's own space.
    cutting: Vec<HalfSpace>,
}

impl FacetReach {
    /// Takes up a facet.
    pub(super) fn begin(&mut self, plan: &ShadowPlan, facet: &Facet) {
        self.eye_world = plan.eye_world;
        self.planes.clear();
        self.planes.extend(facet.casters.iter().map(|plane| HalfSpace::new(*plane).in_metres()));
        for subset in [&mut self.near, &mut self.cutting] {
            subset.clear();
            subset.reserve(self.planes.capacity());
        }
    }

    /// Calls `take` with every caster of a group that reaches the facet and with the half-spaces that cut through it, in
    /// its own space: none where it reaches as a whole.
    pub(super) fn each(
        &mut self,
        scene: &CasterScene,
        group: &Group,
        mut take: impl FnMut(&SortedCaster, &[HalfSpace]),
    ) {
        if self.refuses(group) {
            return;
        }
        for block in scene.blocks(group) {
            if self.cutting_block(block).is_none() {
                continue;
            }
            for caster in scene.members(block) {
                if self.is_reached(scene, group, caster) {
                    take(caster, &self.cutting);
                }
            }
        }
    }

    /// The half-spaces that cut through a block's box, relative to the eye, world axes; `None` where the block is refused.
    pub(super) fn cutting_block(&mut self, block: &Block) -> Option<&[HalfSpace]> {
        // Most are refused: begin with the half-space that refused last.
        let bounds = block.bounds.seen_from(self.eye_world);
        if let Some(refusing) = self.planes.iter().position(|plane| plane.is_outside(&bounds)) {
            self.planes[..=refusing].rotate_right(1);
            return None;
        }
        self.near.clear();
        self.near.extend(self.planes.iter().filter(|plane| plane.side(&bounds) == Side::Crossing));

        // Test what is left beside sharp edges.
        let crossing = self.near.len();
        for (one, other) in (0..crossing).flat_map(|one| (0..one).map(move |other| (one, other))) {
            for sum in self.near[one].sums_beside_sharp_edge(self.near[other]) {
                match sum.side(&bounds) {
                    Side::Outside => return None,
                    Side::Crossing => self.near.push(sum),
                    Side::Inside => {}
                }
            }
        }
        Some(&self.near)
    }

    /// Whether nothing of a group can reach the facet.
    pub(super) fn refuses(&self, group: &Group) -> bool {
        let bounds = group.bounds.seen_from(self.eye_world);
        self.planes.iter().any(|plane| plane.is_outside(&bounds))
    }

    /// Tests an instance against the half-spaces that cut through its block, first with its box in world axes, which
    /// decides most of them, then with the box of its own space, which is tighter where it is turned.
    fn is_reached(&mut self, scene: &CasterScene, group: &Group, caster: &SortedCaster) -> bool {
        let bounds = caster.bounds.seen_from(self.eye_world);
        if self.near.iter().any(|plane| plane.is_outside(&bounds)) {
            return false;
        }
        self.cutting.clear();
        self.cutting.extend(self.near.iter().filter(|plane| plane.side(&bounds) == Side::Crossing));
        if self.cutting.is_empty() {
            return true;
        }

        // Turn only those that cut through the instance.
        let world_from_object = &scene.instances()[caster.number as usize].world_from_object;
        let eye_from_object = eye_from_object(world_from_object, self.eye_world);
        let mut outside = false;
        self.cutting.retain_mut(|plane| {
            *plane = plane.in_object(&eye_from_object);
            let side = plane.side(&group.bounds_object);
            outside |= side == Side::Outside;
            side == Side::Crossing
        });
        !outside
    }
}
