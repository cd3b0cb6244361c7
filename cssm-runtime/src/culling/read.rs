//! What culling on the device has left, back as plain lists.

use std::ops::Range;

use super::frame::CulledFrame;
use crate::commands::{Command, FrameCommands};
use crate::cull::InstanceRows;
use crate::error::ServiceError;
use crate::mesh::MeshHandle;
use crate::read_back::buffer_bytes;

/// Words of an instance's rows.
const ROW_WORDS: usize = InstanceRows::BYTES as usize / 4;

/// What a frame's culling has written, for any number of its lists of commands.
#[derive(Debug)]
pub(crate) struct CulledWords {
    arguments: Vec<u32>,
    of_clusters: Vec<u32>,
    rows: Vec<u32>,
}

impl CulledWords {
    /// Reads a frame's buffers. Blocks.
    pub(crate) fn read(
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        frame: &CulledFrame,
    ) -> Result<Self, ServiceError> {
        let read = |buffer| Ok::<_, ServiceError>(words(&buffer_bytes(device, queue, buffer)?));
        Ok(Self {
            arguments: read(&frame.arguments)?,
            of_clusters: read(&frame.cluster_arguments)?,
            rows: read(&frame.rows)?,
        })
    }

    /// Commands with every draw that was left to the device replaced by what it drew; its rows follow the others.
    pub(crate) fn drawn(
        &self,
        commands: &FrameCommands,
        first_index: impl Fn(MeshHandle) -> u32,
    ) -> FrameCommands {
        let mut drawn = FrameCommands { rows: commands.rows.clone(), ..Default::default() };
        let mut base = 0;
        for command in &commands.commands {
            match *command {
                Command::Mesh(mesh) => {
                    base = first_index(mesh);
                    drawn.commands.push(command.clone());
                }
                Command::DrawCulled { arguments, indexed } => {
                    self.append(&mut drawn, &self.arguments, arguments as usize, indexed, base);
                }
                Command::DrawCulledClusters { arguments, count, most, indexed } => {
                    let count = self.arguments.get(count as usize).map_or(0, |count| *count.min(&most));
                    let words = if indexed { 5 } else { 4 };
                    for number in 0..count as usize {
                        let at = arguments as usize + words * number;
                        self.append(&mut drawn, &self.of_clusters, at, indexed, base);
                    }
                }
                _ => drawn.commands.push(command.clone()),
            }
        }
        drawn
    }

    /// Appends the draw of indirect arguments, unless it draws nothing, and its rows.
    fn append(&self, drawn: &mut FrameCommands, words: &[u32], at: usize, indexed: bool, base: u32) {
        let Some(words) = words.get(at..at + if indexed { 5 } else { 4 }) else { return };
        let (count, copies, row) = (words[0], words[1], words[if indexed { 4 } else { 3 }]);
        if copies == 0 {
            return;
        }
        let first = if indexed { words[2].saturating_sub(base) } else { words[2] };
        let start = drawn.rows.len() as u32;
        let rows = self.rows.chunks_exact(ROW_WORDS).skip(row as usize).take(copies as usize);
        drawn.rows.extend(rows.map(|row| {
            let number = |at: usize| f32::from_bits(row[at]);
            InstanceRows(std::array::from_fn(|line| std::array::from_fn(|column| number(4 * line + column))))
        }));
        let instances: Range<u32> = start..drawn.rows.len() as u32;
        drawn.commands.push(Command::Draw { first, count, indexed, instances });
    }
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
}
