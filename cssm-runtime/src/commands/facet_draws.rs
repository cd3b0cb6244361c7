//! The draws of one facet after another.

use std::ops::Range;

use cssm_core::facet::Facet;

use super::bending::Bending;
use super::casters::{Casters, Group};
use super::ranges::{Parts, merge};
use super::{Command, Drawing, FAN_TRIANGLES, FacetHandle, FacetStatistics, FrameCommands, PipelineHandle};
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
    /// Instances drawn whole.
    whole: Vec<u32>,
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
            whole: Vec::new(),
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
            let plain = self.draw(group, whole.clone(), &mut counts)?;
            self.draw_fans(group, facet, whole, plain, &mut counts);
        }
        Ok(counts)
    }

    /// Appends the rows of the group's instances that are drawn whole, and lists in `parts` what is drawn of the others.
    fn gather(&mut self, group: &Group) {
        self.whole.clear();
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
            Parts::Whole => {
                self.frame.rows.extend(self.casters.rows(number));
                self.whole.push(number);
            }
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
        counts: &mut FacetStatistics,
    ) -> Result<Range<usize>, ServiceError> {
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

        let plain = start..commands.len();
        counts.draws += plain.len() as u32;
        Ok(plain)
    }

    /// Draws fans for the triangles of `plain` draws: in their place, or beside them where bent rows bend too far.
    fn draw_fans(
        &mut self,
        group: &Group,
        facet: &Facet,
        whole: Range<usize>,
        plain: Range<usize>,
        counts: &mut FacetStatistics,
    ) {
        let (fans, bound_texels) = match group.facts.drawing {
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
        let everything = 0..group.facts.corners;
        let everything = std::slice::from_ref(&everything);
        let first_part = whole.end;
        let wholes = self.whole.iter().zip(whole).map(|(number, row)| (*number, row, everything));
        let parts = self.parts.iter().zip(first_part..);
        let parts = parts.map(|((number, ranges), row)| (*number, row, &self.ranges[ranges.clone()]));
        let mut draws: Vec<(Range<u32>, Range<u32>)> = Vec::new();
        for (number, row, ranges) in wholes.chain(parts) {
            let bending = bending.in_object(&self.casters.eye_from_object(number));
            if bending.spares(&group.bounds_object) {
                continue;
            }
            // The plain draws have numbered this row.
            let row = row as u32;
            for corners in bent_ranges(&bending, group.facts.clusters, ranges) {
                match draws.last_mut() {
                    Some((same, rows)) if *same == corners && rows.end == row => rows.end = row + 1,
                    _ => draws.push((corners, row..row + 1)),
                }
            }
        }
        if draws.is_empty() {
            return;
        }
        counts.draws += draws.len() as u32;
        self.frame.commands.push(Command::Pipeline(fans));
        self.bound = Some((fans, group.mesh));
        let plain = draws.into_iter().map(|(corners, instances)| Command::Draw {
            first: corners.start,
            count: corners.end.saturating_sub(corners.start),
            indexed: false,
            instances,
        });
        self.frame.commands.extend(plain.filter_map(|draw| fan_draw(&draw)));
    }
}

/// The parts of ranges whose triangles may bend too far, so far as clusters tell them apart.
fn bent_ranges(bending: &Bending, clusters: &[Cluster], ranges: &[Range<u32>]) -> Vec<Range<u32>> {
    if clusters.len() < 2 {
        return ranges.to_vec();
    }
    let mut bent = Vec::new();
    for range in ranges {
        let reaches = |cluster: &Cluster| {
            range.contains(&cluster.first) && !bending.spares(&CentredBox::new(&cluster.bounds_object))
        };
        if let Parts::Whole = merge(clusters, false, reaches, &mut bent) {
            bent.push(range.clone());
        }
    }
    bent
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
