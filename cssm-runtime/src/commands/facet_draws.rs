//! The draws of one facet after another.

use std::ops::Range;

use cssm_core::ShadowPlan;
use cssm_core::facet::Facet;
use cssm_core::glam::{DAffine3, DMat3, DVec3};

use super::bending::Bending;
use super::ranges::{Parts, merge};
use super::{
    Command, CommandScratch, Drawing, FAN_TRIANGLES, FacetHandle, FacetStatistics, FrameCommands,
    FrameStatistics, MeshFacts, PipelineHandle,
};
use crate::casters::{CasterScene, Group};
use crate::clusters::Cluster;
use crate::cull::{CentredBox, InstanceRows, capture_from_object, eye_from_object};
use crate::culling::{CullingWork, LeftClusters};
use crate::error::ServiceError;
use crate::mesh::MeshHandle;

/// The commands so far, and what is needed to add those of the next facet without allocating.
pub(super) struct FacetDraws<'a> {
    plan: &'a ShadowPlan,
    eye: Eye<'a>,
    frame: &'a mut FrameCommands,
    scratch: &'a mut CommandScratch,
    /// Takes the draws that are left to the device.
    work: Option<&'a mut CullingWork>,
    /// What the draws so far leave bound.
    bound: Option<(PipelineHandle, MeshHandle)>,
}

/// What a group's instances draw in a facet.
#[derive(Debug, Clone, Default)]
pub(super) struct Gathered {
    /// Instances drawn whole.
    whole: Vec<u32>,
    /// Instances drawn in part, each with a range of `ranges`.
    parts: Vec<(u32, Range<usize>)>,
    ranges: Vec<Range<u32>>,
    /// Corners and rows of fans.
    fans: Vec<(Range<u32>, Range<u32>)>,
    /// Corners of an instance that may bend too far.
    bent: Vec<Range<u32>>,
}

/// Brings instances to the eye of a plan.
#[derive(Clone, Copy)]
struct Eye<'a> {
    casters: &'a CasterScene,
    eye_world: DVec3,
    capture_from_world: DMat3,
}

impl Gathered {
    /// Elements for which there is room, list by list.
    pub(super) fn room(&self) -> [usize; 5] {
        let Self { whole, parts, ranges, fans, bent } = self;
        [whole.capacity(), parts.capacity(), ranges.capacity(), fans.capacity(), bent.capacity()]
    }

    /// Gives lists that have grown the same room once more.
    pub(super) fn widen(&mut self, before: [usize; 5]) {
        let Self { whole, parts, ranges, fans, bent } = self;
        widen(whole, before[0], whole.capacity());
        widen(parts, before[1], parts.capacity());
        widen(ranges, before[2], ranges.capacity());
        widen(fans, before[3], fans.capacity());
        widen(bent, before[4], bent.capacity());
    }
}

/// Gives a list that has grown twice the room that it needed: command lists that breathe stay where they are.
pub(crate) fn widen<T>(list: &mut Vec<T>, room_before: usize, needed: usize) {
    if list.capacity() > room_before {
        list.reserve((2 * needed).saturating_sub(list.len()));
    }
}

impl Eye<'_> {
    /// Transform of an instance with the eye at the origin, world axes.
    fn eye_from_object(&self, number: u32) -> DAffine3 {
        eye_from_object(&self.casters.instances()[number as usize].world_from_object, self.eye_world)
    }

    /// Rows of an instance.
    fn rows(&self, number: u32) -> Result<InstanceRows, ServiceError> {
        let capture_from_object =
            capture_from_object(&self.eye_from_object(number), &self.capture_from_world);
        let rows = InstanceRows::rounded(&capture_from_object);
        rows.ok_or(ServiceError::Transform { instance: number as usize })
    }
}

impl<'a> FacetDraws<'a> {
    /// Appends to commands, of which nothing stays bound.
    pub(super) fn new(
        plan: &'a ShadowPlan,
        casters: &'a CasterScene,
        frame: &'a mut FrameCommands,
        scratch: &'a mut CommandScratch,
        mut work: Option<&'a mut CullingWork>,
    ) -> Self {
        if let Some(work) = &mut work {
            work.begin(plan.eye_world, plan.capture_from_world(), casters.block_count());
        }
        let (eye_world, capture_from_world) = (plan.eye_world, plan.capture_from_world());
        Self { plan, eye: Eye { casters, eye_world, capture_from_world }, frame, scratch, work, bound: None }
    }

    /// Appends the draws of some of the plan's facets, and leaves room for lists that draw up to twice as much.
    pub(super) fn add_all<'m>(
        &mut self,
        facets: impl IntoIterator<Item = usize>,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        statistics: &mut FrameStatistics,
    ) -> Result<(), ServiceError> {
        let FrameCommands { commands, rows } = &*self.frame;
        let room = (commands.capacity(), rows.capacity(), self.scratch.gathered.room());
        let room_of_work = self.work.as_ref().map(|work| work.room());
        statistics.casters += self.eye.casters.instances().len() as u32;
        let plan = self.plan;
        for position in facets {
            let Some(facet) = plan.facets.get(position) else { continue };
            let counts = self.add(FacetHandle(position as u32), facet, &facts)?;
            statistics.draws += counts.draws;
            statistics.instances += counts.instances;
            statistics.triangles += counts.triangles;
            statistics.facets.push(counts);
        }

        let FrameCommands { commands, rows } = &mut *self.frame;
        let needed = (commands.len(), rows.len());
        widen(commands, room.0, needed.0);
        widen(rows, room.1, needed.1);
        self.scratch.gathered.widen(room.2);
        if let (Some(work), Some(room)) = (&mut self.work, room_of_work) {
            work.widen(room);
        }
        Ok(())
    }

    /// Appends the draws of a facet; `facts` finds a mesh.
    fn add<'m>(
        &mut self,
        handle: FacetHandle,
        facet: &Facet,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
    ) -> Result<FacetStatistics, ServiceError> {
        self.scratch.reach.begin(self.plan, facet);
        let mut counts = FacetStatistics { facet: facet.first_cell(), ..Default::default() };
        for group in self.eye.casters.groups() {
            if self.leave(group, handle, facet, &facts, &mut counts)? {
                continue;
            }
            let start = self.frame.rows.len();
            let Some(facts) = self.gather(group, &facts, &mut counts)? else { continue };
            let whole = start..self.frame.rows.len();
            self.bind(group, facts.pipeline, handle, facet, &counts);
            let plain = self.draw(&facts, whole.clone(), &mut counts)?;
            self.draw_fans(group, &facts, facet, whole, plain, &mut counts);
        }
        Ok(counts)
    }

    /// Appends the rows of the group's instances that are drawn whole, and lists in `parts` what is drawn of the others;
    /// returns what is known of the mesh, or nothing if nothing of it is drawn.
    fn gather<'m>(
        &mut self,
        group: &Group,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        counts: &mut FacetStatistics,
    ) -> Result<Option<MeshFacts<'m>>, ServiceError> {
        let CommandScratch { reach, gathered } = &mut *self.scratch;
        let Gathered { whole, parts, ranges, .. } = gathered;
        whole.clear();
        parts.clear();
        ranges.clear();
        let (eye, rows) = (self.eye, &mut self.frame.rows);
        let mut found = None;
        let mut outcome = Ok(());
        reach.each(eye.casters, group, |caster, cutting| {
            if outcome.is_err() {
                return;
            }
            // Look for the mesh when its first instance reaches.
            let number = caster.number;
            if found.is_none() {
                found = facts(group.mesh);
            }
            let Some(facts) = &found else {
                outcome = Err(ServiceError::UnknownMesh { instance: number as usize });
                return;
            };
            counts.content = counts.content.wrapping_add(caster.content);
            let drawn = if cutting.is_empty() || facts.clusters.len() < 2 {
                Parts::Whole
            } else {
                let reaches = |cluster: &Cluster| {
                    let bounds = CentredBox::new(&cluster.bounds_object);
                    !cutting.iter().any(|plane| plane.is_outside(&bounds))
                };
                merge(facts.clusters, group.count > 1, reaches, ranges)
            };
            match drawn {
                Parts::Whole => {
                    outcome = eye.rows(number).map(|row| rows.push(row));
                    whole.push(number);
                }
                Parts::Ranges(ranges) if ranges.is_empty() => {}
                Parts::Ranges(ranges) => parts.push((number, ranges)),
            }
        });
        outcome?;
        Ok(found.filter(|_| !whole.is_empty() || !parts.is_empty()))
    }

    /// Leaves a group to the device, if there is work for it and the group's triangles are drawn plainly.
    fn leave<'m>(
        &mut self,
        group: &Group,
        handle: FacetHandle,
        facet: &Facet,
        facts: impl Fn(MeshHandle) -> Option<MeshFacts<'m>>,
        counts: &mut FacetStatistics,
    ) -> Result<bool, ServiceError> {
        let reach = &mut self.scratch.reach;
        let Some(work) = &mut self.work else { return Ok(false) };
        if reach.refuses(group) {
            return Ok(true);
        }
        let Some(facts) = facts(group.mesh).filter(|facts| facts.drawing == Drawing::Plain) else {
            return Ok(false);
        };

        // Write down every block that is not refused.
        let (scene, start) = (self.eye.casters, work.blocks());
        let (mut candidates, mut content) = (0, 0_u64);
        for (number, block) in group.blocks.clone().zip(scene.blocks(group)) {
            let Some(cutting) = reach.cutting_block(block) else { continue };
            let members = scene.members(block);
            let instances = members.iter().map(|caster| {
                let number = caster.number;
                (number, &scene.instances()[number as usize])
            });
            work.add_block(number, instances, cutting)?;
            candidates += members.len() as u64;
            content = members.iter().fold(content, |content, caster| content.wrapping_add(caster.content));
        }
        if candidates == 0 {
            return Ok(true);
        }
        let left = work.add_draw(group.mesh, &facts, start..work.blocks());

        // Draw what culling leaves of them.
        self.bind(group, facts.pipeline, handle, facet, counts);
        let indexed = facts.indexed;
        let commands = &mut self.frame.commands;
        commands.push(Command::DrawCulled { arguments: left.arguments, indexed });
        if let Some(LeftClusters { arguments, count, most }) = left.clusters {
            commands.push(Command::DrawCulledClusters { arguments, count, most, indexed });
            counts.draws += 1;
        }
        counts.draws += 1;
        counts.instances += candidates;
        counts.triangles += candidates * u64::from(facts.corners / 3);
        counts.content = counts.content.wrapping_add(content);
        Ok(true)
    }

    /// Binds what differs from the previous draw, and the facet before its first one.
    fn bind(
        &mut self,
        group: &Group,
        pipeline: PipelineHandle,
        handle: FacetHandle,
        facet: &Facet,
        counts: &FacetStatistics,
    ) {
        if counts.draws == 0 {
            self.frame.commands.push(Command::Facet { facet: handle, tile: facet.tile });
        }
        if self.bound.is_none_or(|(bound, _)| bound != pipeline) {
            self.frame.commands.push(Command::Pipeline(pipeline));
        }
        if self.bound.is_none_or(|(_, bound)| bound != group.mesh) {
            self.frame.commands.push(Command::Mesh(group.mesh));
        }
        self.bound = Some((pipeline, group.mesh));
    }

    /// Draws the rows of `whole` together and everything in `parts` after them.
    fn draw(
        &mut self,
        facts: &MeshFacts,
        whole: Range<usize>,
        counts: &mut FacetStatistics,
    ) -> Result<Range<usize>, ServiceError> {
        let indexed = facts.indexed;
        let FrameCommands { commands, rows } = &mut *self.frame;
        let Gathered { parts, ranges, .. } = &self.scratch.gathered;
        let total = rows.len() + parts.len();
        let row = |row: usize| u32::try_from(row).map_err(|_| ServiceError::TooManyInstances { rows: total });
        let start = commands.len();
        let mut draw = |first: u32, count: u32, instances: Range<u32>| {
            counts.triangles += u64::from(instances.end - instances.start) * u64::from(count / 3);
            commands.push(Command::Draw { first, count, indexed, instances });
        };
        counts.instances += (whole.len() + parts.len()) as u64;
        if !whole.is_empty() {
            draw(0, facts.corners, row(whole.start)?..row(whole.end)?);
        }
        for (number, own) in parts {
            let instance = row(rows.len())?;
            let instances = instance..row(rows.len() + 1)?;
            rows.push(self.eye.rows(*number)?);
            for range in &ranges[own.clone()] {
                draw(range.start, range.end.saturating_sub(range.start), instances.clone());
            }
        }

        let plain = start..commands.len();
        counts.draws += plain.len() as u32;
        Ok(plain)
    }

    /// Draws fans for the triangles of `plain` draws: in their place, or beside them where bent rows bend too far.
    fn draw_fans(
        &mut self,
        group: &Group,
        facts: &MeshFacts,
        facet: &Facet,
        whole: Range<usize>,
        plain: Range<usize>,
        counts: &mut FacetStatistics,
    ) {
        let (fans, bound_texels) = match facts.drawing {
            Drawing::Plain => return,
            Drawing::Fans => {
                for command in &mut self.frame.commands[plain] {
                    if let Some(fan) = fan_draw(command) {
                        *command = fan;
                    }
                }
                return;
            }
            Drawing::Both { fans, bound_texels } => (fans, bound_texels),
        };
        let Some(bending) = Bending::new(facet, bound_texels) else { return };

        // Rows of instances drawn whole come first, those drawn in part after them.
        let everything = 0..facts.corners;
        let everything = std::slice::from_ref(&everything);
        let Gathered { whole: wholes, parts, ranges, fans: draws, bent } = &mut self.scratch.gathered;
        let first_part = whole.end;
        let wholes = wholes.iter().zip(whole).map(|(number, row)| (*number, row, everything));
        let parts = parts.iter().zip(first_part..);
        let parts = parts.map(|((number, own), row)| (*number, row, &ranges[own.clone()]));
        draws.clear();
        for (number, row, ranges) in wholes.chain(parts) {
            let bending = bending.in_object(&self.eye.eye_from_object(number));
            if bending.spares(&group.bounds_object) {
                continue;
            }
            // The plain draws have numbered this row.
            let row = row as u32;
            bent_ranges(&bending, facts.clusters, ranges, bent);
            for corners in bent.iter() {
                match draws.last_mut() {
                    Some((same, rows)) if same == corners && rows.end == row => rows.end = row + 1,
                    _ => draws.push((corners.clone(), row..row + 1)),
                }
            }
        }
        if draws.is_empty() {
            return;
        }
        counts.draws += draws.len() as u32;
        self.frame.commands.push(Command::Pipeline(fans));
        self.bound = Some((fans, group.mesh));
        let plain = draws.drain(..).map(|(corners, instances)| Command::Draw {
            first: corners.start,
            count: corners.end.saturating_sub(corners.start),
            indexed: false,
            instances,
        });
        self.frame.commands.extend(plain.filter_map(|draw| fan_draw(&draw)));
    }
}

/// Lists the parts of ranges whose triangles may bend too far, so far as clusters tell them apart.
fn bent_ranges(bending: &Bending, clusters: &[Cluster], ranges: &[Range<u32>], bent: &mut Vec<Range<u32>>) {
    bent.clear();
    if clusters.len() < 2 {
        bent.extend_from_slice(ranges);
        return;
    }
    for range in ranges {
        let reaches = |cluster: &Cluster| {
            range.contains(&cluster.first) && !bending.spares(&CentredBox::new(&cluster.bounds_object))
        };
        if let Parts::Whole = merge(clusters, false, reaches, bent) {
            bent.push(range.clone());
        }
    }
}

/// The draw of the fans of a draw's triangles; [`crate::mesh`] refuses meshes whose fans could not be numbered.
fn fan_draw(command: &Command) -> Option<Command> {
    let Command::Draw { first, count, indexed, instances } = command else { return None };
    Some(Command::Draw {
        first: first.saturating_mul(FAN_TRIANGLES),
        count: count.saturating_mul(FAN_TRIANGLES),
        indexed: *indexed,
        instances: instances.clone(),
    })
}
