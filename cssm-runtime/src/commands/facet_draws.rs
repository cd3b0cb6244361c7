//! The draws of one facet after another.

use std::ops::Range;

use cssm_core::facet::Facet;
use cssm_core::remap::Curve;

use super::casters::{Casters, Group};
use super::ranges::{Parts, merge};
use super::{
    Command, Drawing, FAN_TRIANGLES, FacetHandle, FacetStatistics, FrameCommands, PipelineHandle,
};
use crate::clusters::Cluster;
use crate::cull::{CentredBox, HalfSpace, Side};
use crate::error::ServiceError;
use crate::mesh::MeshHandle;

/// The commands so far, and what is needed to add those of the next facet without allocating.
pub(super) struct FacetDraws<'c, 'a, 'm> {
    casters: &'c Casters<'a, 'm>,
    /// Commands and rows.
    pub(super) frame: FrameCommands,
    /// What the draws so far leave bound.
    bound: Option<(PipelineHandle, MeshHandle)>,
    /// The facet's half-spaces.
    planes: Vec<HalfSpace>,
    /// Those that cut through a block's box.
    near: Vec<HalfSpace>,
    /// Those that cut through an instance's box, in the instance's own space.
    cutting: Vec<HalfSpace>,
    /// Instances drawn in part, each with a range of `ranges`.
    parts: Vec<(u32, Range<usize>)>,
    ranges: Vec<Range<u32>>,
}

/// What a facet draws of an instance.
enum Reach {
    Nothing,
    Whole,
    /// What the half-spaces in `cutting` leave.
    Cut,
}

impl<'c, 'a, 'm> FacetDraws<'c, 'a, 'm> {
    /// Nothing drawn yet.
    pub(super) fn new(casters: &'c Casters<'a, 'm>) -> Self {
        Self {
            casters,
            frame: FrameCommands::default(),
            bound: None,
            planes: Vec::new(),
            near: Vec::new(),
            cutting: Vec::new(),
            parts: Vec::new(),
            ranges: Vec::new(),
        }
    }

    /// Appends the draws of a facet.
    pub(super) fn add(
        &mut self,
        handle: FacetHandle,
        facet: &Facet,
    ) -> Result<FacetStatistics, ServiceError> {
        self.planes.clear();
        self.planes.extend(facet.casters.iter().map(|plane| HalfSpace::new(*plane)));
        let mut counts = FacetStatistics { facet: facet.first_cell(), ..Default::default() };
        let casters = self.casters;
        for group in &casters.groups {
            let start = self.frame.rows.len();
            self.gather(group);
            let whole = start..self.frame.rows.len();
            if whole.is_empty() && self.parts.is_empty() {
                continue;
            }
            if counts.draws == 0 {
                self.frame.commands.push(Command::Facet { facet: handle, tile: facet.tile });
            }
            self.bind(group);
            self.draw(group, whole, bends(facet), &mut counts)?;
        }
        Ok(counts)
    }

    /// Appends the rows of the group's instances that are drawn whole, and lists in `parts` what is drawn of the others.
    fn gather(&mut self, group: &Group) {
        self.parts.clear();
        self.ranges.clear();
        let casters = self.casters;
        for block in &casters.blocks[group.blocks.clone()] {
            // Most are refused: begin with the half-space that refused last.
            if let Some(refusing) = self.planes.iter().position(|plane| plane.is_outside(&block.bounds)) {
                self.planes[..=refusing].rotate_right(1);
                continue;
            }
            self.near.clear();
            self.near.extend(self.planes.iter().filter(|plane| plane.side(&block.bounds) == Side::Crossing));
            for index in block.members.clone() {
                let (number, bounds) = &casters.casters[index];
                self.gather_caster(group, *number, bounds);
            }
        }
    }

    /// The same for one instance.
    fn gather_caster(&mut self, group: &Group, number: u32, bounds: &CentredBox) {
        let parts = match self.reach(group, number, bounds) {
            Reach::Nothing => return,
            Reach::Whole => Parts::Whole,
            Reach::Cut => {
                let reaches = |cluster: &Cluster| {
                    let bounds = CentredBox::new(&cluster.bounds_object);
                    !self.cutting.iter().any(|plane| plane.is_outside(&bounds))
                };
                merge(group.facts.clusters, group.count > 1, reaches, &mut self.ranges)
            }
        };
        match parts {
            Parts::Whole => self.frame.rows.extend(self.casters.rows(number)),
            Parts::Ranges(ranges) if ranges.is_empty() => {}
            Parts::Ranges(ranges) => self.parts.push((number, ranges)),
        }
    }

    /// Tests an instance against the half-spaces that cut through its block, first with its box in world axes, which
    /// decides most of them, then with the box of its own space, which is tighter where it is turned.
    fn reach(&mut self, group: &Group, number: u32, bounds: &CentredBox) -> Reach {
        if self.near.iter().any(|plane| plane.is_outside(bounds)) {
            return Reach::Nothing;
        }
        self.cutting.clear();
        self.cutting.extend(self.near.iter().filter(|plane| plane.side(bounds) == Side::Crossing));

        // Turn only those that cut through the instance.
        if self.cutting.is_empty() {
            return Reach::Whole;
        }
        let eye_from_object = self.casters.eye_from_object(number);
        let mut outside = false;
        self.cutting.retain_mut(|plane| {
            *plane = plane.in_object(&eye_from_object);
            let side = plane.side(&group.bounds_object);
            outside |= side == Side::Outside;
            side == Side::Crossing
        });
        match (outside, self.cutting.is_empty() || group.facts.clusters.len() < 2) {
            (true, _) => Reach::Nothing,
            (false, true) => Reach::Whole,
            (false, false) => Reach::Cut,
        }
    }

    /// Binds what differs from the previous draw.
    fn bind(&mut self, group: &Group) {
        let pipeline = group.facts.pipeline;
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
        group: &Group,
        whole: Range<usize>,
        bends: bool,
        counts: &mut FacetStatistics,
    ) -> Result<(), ServiceError> {
        let indexed = group.facts.indexed;
        let FrameCommands { commands, rows } = &mut self.frame;
        let total = rows.len() + self.parts.len();
        let row = |row: usize| u32::try_from(row).map_err(|_| ServiceError::TooManyInstances { rows: total });
        let start = commands.len();
        let mut draw = |first: u32, count: u32, instances: Range<u32>| {
            counts.triangles += u64::from(instances.end - instances.start) * u64::from(count / 3);
            commands.push(Command::Draw { first, count, indexed, instances });
        };
        counts.instances += (whole.len() + self.parts.len()) as u64;
        if !whole.is_empty() {
            draw(0, group.facts.corners, row(whole.start)?..row(whole.end)?);
        }
        for (number, ranges) in &self.parts {
            let instance = row(rows.len())?;
            let instances = instance..row(rows.len() + 1)?;
            rows.extend(self.casters.rows(*number));
            for range in &self.ranges[ranges.clone()] {
                draw(range.start, range.end.saturating_sub(range.start), instances.clone());
            }
        }

        // Draw fans of the same triangles, beside them or in their place.
        let plain = start..commands.len();
        match group.facts.drawing {
            Drawing::Both(fans) if bends => {
                commands.push(Command::Pipeline(fans));
                for command in plain.clone() {
                    commands.extend(fan_draw(&commands[command]));
                }
                counts.draws += plain.len() as u32;
                self.bound = Some((fans, group.mesh));
            }
            Drawing::Plain | Drawing::Both(_) => {}
            Drawing::Fans => {
                for command in &mut commands[plain.clone()] {
                    if let Some(fan) = fan_draw(command) {
                        *command = fan;
                    }
                }
            }
        }
        counts.draws += plain.len() as u32;
        Ok(())
    }
}

/// Whether a facet bends rows, so that straight edges may miss bent ones.
fn bends(facet: &Facet) -> bool {
    match facet.rows.remap.curve {
        Curve::Straight => false,
        Curve::Perspective { push_back_metres } => push_back_metres as f32 != 0.0,
        Curve::Logarithmic { .. } => true,
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
