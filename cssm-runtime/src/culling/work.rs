//! What the device is to cull: plain lists, written without a device.

use std::ops::Range;

use cssm_core::glam::{DAffine3, DMat3, DVec3};

use super::clusters::{ClusterPool, OuterBox};
use crate::commands::{MeshFacts, widen};
use crate::cull::{HalfSpace, InstanceRows, capture_from_object, eye_from_object};
use crate::error::ServiceError;
use crate::mesh::{CasterInstance, MeshHandle};

/// Words before the arguments of the first draw: the number of cut instances, the number of blocks, and one.
const HEAD_WORDS: u32 = 3;
/// Word that holds one.
pub(super) const ONE: u32 = 2;
/// Words of a draw's arguments and counters.
const DRAW_WORDS: u32 = 7;
/// Bytes of a cut instance.
const CUT_BYTES: u64 = 16;
/// Words of indirect arguments without indices, and with them.
const ARGUMENT_WORDS: [u32; 2] = [4, 5];

/// Candidates, half-spaces and draws of the lists of commands that [`crate::FrameCommands::append_culled`] has left to the
/// device. It keeps its memory, and the clusters of meshes, from one frame to the next.
#[derive(Debug, Clone, Default)]
pub(crate) struct CullingWork {
    pub(super) planes: Vec<[f32; 4]>,
    pub(super) candidates: Vec<InstanceRows>,
    pub(super) blocks: Vec<BlockRecord>,
    pub(super) draws: Vec<DrawRecord>,
    /// Arguments and counters as they are before culling.
    pub(super) arguments: Vec<u32>,
    pub(super) clusters: ClusterPool,
    /// Room for rows, for words of arguments of clusters, and for cut instances.
    pub(super) rows: u64,
    pub(super) cluster_words: u64,
    pub(super) cuts: u64,
    /// First candidates of the blocks of the scene in hand, if they have been written.
    written: Vec<Option<u32>>,
    eye: Eye,
}

/// Casters of a block and the half-spaces that cut through it, in the layout of the shaders.
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(super) struct BlockRecord {
    pub(super) first_plane: u32,
    pub(super) planes: u32,
    pub(super) draw: u32,
    pub(super) first_candidate: u32,
    pub(super) candidates: u32,
}

/// What a facet draws of a mesh, in the layout of the shaders.
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(super) struct DrawRecord {
    pub(super) centre: [f32; 3],
    pub(super) first_cluster: u32,
    pub(super) half: [f32; 3],
    pub(super) clusters: u32,
    pub(super) rows_start: u32,
    pub(super) rows_end: u32,
    pub(super) arguments: u32,
    pub(super) counters: u32,
    pub(super) cluster_arguments: u32,
    pub(super) is_indexed: u32,
    pub(super) unused: [u32; 2],
}

const _: () = assert!(size_of::<BlockRecord>() == 20 && size_of::<DrawRecord>() == 64);

/// Where the lists of work end.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    lengths: [usize; 5],
    room: [u64; 3],
}

/// The eye and the axes of the plan in hand.
#[derive(Debug, Clone, Copy)]
struct Eye {
    eye_world: DVec3,
    capture_from_world: DMat3,
    /// Turns normals from world axes to those of the capture.
    normals: DMat3,
}

impl Default for Eye {
    fn default() -> Self {
        let identity = DMat3::IDENTITY;
        Self { eye_world: DVec3::ZERO, capture_from_world: identity, normals: identity }
    }
}

/// A draw that culling fills.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LeftDraw {
    /// First word of its arguments.
    pub(crate) arguments: u32,
    /// Draws of clusters, if there may be any.
    pub(crate) clusters: Option<LeftClusters>,
}

/// Draws of clusters that culling fills.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LeftClusters {
    /// First word of the first draw's arguments among those of clusters.
    pub(crate) arguments: u32,
    /// Word of their number, among the arguments.
    pub(crate) count: u32,
    /// Their largest number.
    pub(crate) most: u32,
}

impl CullingWork {
    /// Nothing to cull; memory is kept.
    pub(crate) fn clear(&mut self) {
        let Self { planes, candidates, blocks, draws, arguments, clusters, .. } = self;
        planes.clear();
        candidates.clear();
        blocks.clear();
        draws.clear();
        arguments.clear();
        clusters.tidy();
        (self.rows, self.cluster_words, self.cuts) = (0, 0, 0);
    }

    /// Whether nothing is left to the device.
    pub(crate) fn is_empty(&self) -> bool {
        self.draws.is_empty()
    }

    /// Elements for which there is room, list by list.
    pub(crate) fn room(&self) -> [usize; 6] {
        let Self { planes, candidates, blocks, draws, arguments, written, .. } = self;
        let lists = [planes.capacity(), candidates.capacity(), blocks.capacity(), draws.capacity()];
        let [planes, candidates, blocks, draws] = lists;
        [planes, candidates, blocks, draws, arguments.capacity(), written.capacity()]
    }

    /// Gives lists that have grown twice the room that they need.
    pub(crate) fn widen(&mut self, before: [usize; 6]) {
        let Self { planes, candidates, blocks, draws, arguments, written, .. } = self;
        let lengths = [planes.len(), candidates.len(), blocks.len(), draws.len(), arguments.len()];
        widen(planes, before[0], lengths[0]);
        widen(candidates, before[1], lengths[1]);
        widen(blocks, before[2], lengths[2]);
        widen(draws, before[3], lengths[3]);
        widen(arguments, before[4], lengths[4]);
        let needed = written.len();
        widen(written, before[5], needed);
    }

    /// Where the lists end.
    pub(super) fn mark(&self) -> Mark {
        let Self { planes, candidates, blocks, draws, arguments, .. } = self;
        let lengths = [planes.len(), candidates.len(), blocks.len(), draws.len(), arguments.len()];
        Mark { lengths, room: [self.rows, self.cluster_words, self.cuts] }
    }

    /// Takes back what was added since.
    pub(super) fn take_back(&mut self, mark: &Mark) {
        let [planes, candidates, blocks, draws, arguments] = mark.lengths;
        self.planes.truncate(planes);
        self.candidates.truncate(candidates);
        self.blocks.truncate(blocks);
        self.draws.truncate(draws);
        self.arguments.truncate(arguments);
        [self.rows, self.cluster_words, self.cuts] = mark.room;
    }

    /// Bytes of the largest buffer that the work needs.
    pub(super) fn largest_bytes(&self) -> u64 {
        let lists = [
            size_of_val(self.planes.as_slice()),
            size_of_val(self.candidates.as_slice()),
            size_of_val(self.blocks.as_slice()),
            size_of_val(self.draws.as_slice()),
            size_of_val(self.arguments.as_slice()),
            size_of_val(self.clusters.records.as_slice()),
        ];
        let lists = lists.into_iter().max().unwrap_or(0) as u64;
        lists.max(self.row_bytes()).max(self.cluster_argument_bytes()).max(self.cut_bytes())
    }

    pub(super) fn row_bytes(&self) -> u64 {
        self.rows.saturating_mul(InstanceRows::BYTES)
    }

    pub(super) fn cluster_argument_bytes(&self) -> u64 {
        self.cluster_words.saturating_mul(4)
    }

    pub(super) fn cut_bytes(&self) -> u64 {
        self.cuts.saturating_mul(CUT_BYTES)
    }

    /// Takes up a plan and a scene with a number of blocks.
    pub(crate) fn begin(&mut self, eye_world: DVec3, capture_from_world: DMat3, blocks: usize) {
        let normals = capture_from_world.inverse().transpose();
        self.eye = Eye { eye_world, capture_from_world, normals };
        self.written.clear();
        self.written.resize(blocks, None);
        if self.arguments.is_empty() {
            self.arguments.extend([0; HEAD_WORDS as usize]);
        }
    }

    /// Words that arguments begin with.
    pub(super) fn head(&self) -> [u32; HEAD_WORDS as usize] {
        [0, self.blocks.len() as u32, 1]
    }

    /// Number of blocks so far.
    pub(crate) fn blocks(&self) -> usize {
        self.blocks.len()
    }

    /// Adds a block of the draw that comes next: the instances of its members and the half-spaces that cut through it.
    pub(crate) fn add_block<'i>(
        &mut self,
        block: usize,
        members: impl ExactSizeIterator<Item = (u32, &'i CasterInstance)>,
        cutting: &[HalfSpace],
    ) -> Result<(), ServiceError> {
        let first_plane = self.planes.len() as u32;
        self.planes.extend(cutting.iter().filter_map(|plane| self.eye.plane(plane)));
        let candidates = members.len() as u32;
        let first_candidate = match self.written.get(block) {
            Some(Some(first)) => *first,
            _ => self.write(block, members)?,
        };
        let planes = self.planes.len() as u32 - first_plane;
        let draw = self.draws.len() as u32;
        self.blocks.push(BlockRecord { first_plane, planes, draw, first_candidate, candidates });
        Ok(())
    }

    /// Writes the rows of a block's members.
    fn write<'i>(
        &mut self,
        block: usize,
        members: impl Iterator<Item = (u32, &'i CasterInstance)>,
    ) -> Result<u32, ServiceError> {
        let first = self.candidates.len() as u32;
        for (number, instance) in members {
            let rows = InstanceRows::rounded(&self.eye.capture_from_object(instance));
            self.candidates.push(rows.ok_or(ServiceError::Transform { instance: number as usize })?);
        }
        if let Some(written) = self.written.get_mut(block) {
            *written = Some(first);
        }
        Ok(first)
    }

    /// Adds the draw of some blocks.
    pub(crate) fn add_draw(&mut self, mesh: MeshHandle, facts: &MeshFacts, blocks: Range<usize>) -> LeftDraw {
        // Make room for all rows, and for every other cluster of what may be cut.
        let blocks = &self.blocks[blocks];
        let count = |blocks: &mut dyn Iterator<Item = &BlockRecord>| -> u64 {
            blocks.map(|block| u64::from(block.candidates)).sum()
        };
        let candidates = count(&mut blocks.iter());
        let (rows_start, rows_end) = (self.rows, self.rows + candidates);
        let is_in_parts = facts.clusters.len() > 1;
        let cut = if is_in_parts { count(&mut blocks.iter().filter(|block| block.planes > 0)) } else { 0 };
        let most = cut * facts.clusters.len().div_ceil(2) as u64;
        let cluster_arguments = self.cluster_words;
        self.rows = rows_end;
        self.cuts += cut;
        self.cluster_words += most * u64::from(ARGUMENT_WORDS[usize::from(facts.indexed)]);

        // Begin with arguments of no instance. Work with numbers too large for a word exceeds every buffer.
        let arguments = self.arguments.len() as u32;
        let first_row = rows_start as u32;
        self.arguments.extend(match facts.indexed {
            true => [facts.corners, 0, facts.first_index, 0, first_row, 0, 0],
            false => [facts.corners, 0, 0, first_row, 0, 0, 0],
        });
        let counters = arguments + DRAW_WORDS - 2;
        let OuterBox { centre, half } = OuterBox::new(&facts.bounds_object);
        let first_cluster = if is_in_parts { self.clusters.first(mesh, facts) } else { 0 };
        self.draws.push(DrawRecord {
            centre,
            first_cluster,
            half,
            clusters: facts.clusters.len() as u32,
            rows_start: first_row,
            rows_end: rows_end as u32,
            arguments,
            counters,
            cluster_arguments: cluster_arguments as u32,
            is_indexed: u32::from(facts.indexed),
            unused: [0; 2],
        });
        let clusters = (cut > 0).then_some(LeftClusters {
            arguments: cluster_arguments as u32,
            count: counters,
            most: u32::try_from(most).unwrap_or(u32::MAX),
        });
        LeftDraw { arguments, clusters }
    }
}

impl Eye {
    fn capture_from_object(&self, instance: &CasterInstance) -> DAffine3 {
        let eye_from_object = eye_from_object(&instance.world_from_object, self.eye_world);
        capture_from_object(&eye_from_object, &self.capture_from_world)
    }

    /// A half-space in the axes of the capture with a unit normal; `None` where it has none, and refuses all or nothing.
    fn plane(&self, plane: &HalfSpace) -> Option<[f32; 4]> {
        let plane = plane.turned(&self.normals);
        let unit = (plane / plane.truncate().length()).as_vec4();
        unit.is_finite().then(|| unit.to_array())
    }
}
