//! What culling on the device has left, back as a plain list.

use std::ops::Range;

use super::frame::CulledFrame;
use crate::commands::{Command, FrameCommands};
use crate::cull::InstanceRows;
use crate::error::ServiceError;
use crate::mesh::MeshHandle;
use crate::read_back::buffer_bytes;

/// Commands with every draw that was left to the device replaced by what it drew; rows of culling follow the others.
pub(crate) fn drawn(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    frame: &CulledFrame,
    commands: &FrameCommands,
    first_index: impl Fn(MeshHandle) -> u32,
) -> Result<FrameCommands, ServiceError> {
    let arguments = words(&buffer_bytes(device, queue, &frame.arguments)?);
    let of_clusters = words(&buffer_bytes(device, queue, &frame.cluster_arguments)?);
    let culled = words(&buffer_bytes(device, queue, &frame.rows)?);
    let first_row = commands.rows.len() as u32;
    let mut drawn = FrameCommands { rows: commands.rows.clone(), ..Default::default() };
    drawn.rows.extend(culled.chunks_exact(12).map(|row| {
        let number = |at: usize| f32::from_bits(row[at]);
        InstanceRows(std::array::from_fn(|line| std::array::from_fn(|column| number(4 * line + column))))
    }));
    let mut base = 0;
    for command in &commands.commands {
        match *command {
            Command::Mesh(mesh) => {
                base = first_index(mesh);
                drawn.commands.push(command.clone());
            }
            Command::DrawCulled { arguments: at, indexed } => {
                drawn.commands.extend(draw(&arguments, at as usize, indexed, base, first_row));
            }
            Command::DrawCulledClusters { arguments: at, count, most, indexed } => {
                let count = arguments.get(count as usize).map_or(0, |count| *count.min(&most));
                let words = if indexed { 5 } else { 4 };
                let draws = (0..count as usize).map(|number| at as usize + words * number);
                drawn
                    .commands
                    .extend(draws.filter_map(|at| draw(&of_clusters, at, indexed, base, first_row)));
            }
            _ => drawn.commands.push(command.clone()),
        }
    }
    Ok(drawn)
}

/// The draw of indirect arguments; `None` if it draws nothing.
fn draw(words: &[u32], at: usize, indexed: bool, base: u32, first_row: u32) -> Option<Command> {
    let words = words.get(at..at + if indexed { 5 } else { 4 })?;
    let (count, copies, row) = (words[0], words[1], words.last()? + first_row);
    let first = if indexed { words[2].saturating_sub(base) } else { words[2] };
    let instances: Range<u32> = row..row + copies;
    (copies > 0).then_some(Command::Draw { first, count, indexed, instances })
}

fn words(bytes: &[u8]) -> Vec<u32> {
    bytes.chunks_exact(4).map(|word| u32::from_le_bytes([word[0], word[1], word[2], word[3]])).collect()
}
