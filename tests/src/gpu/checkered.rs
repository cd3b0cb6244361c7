//! A quad with a checkerboard mask, and the same holes cut into triangles.

use cssm_runtime::{AlphaMask, MeshDescription, wgpu};

use super::casters::{Geometry, GeometryBuffers, VERTICES, buffer};
use super::device::TestDevice;
use super::images;

/// Squares along a side of the checkerboard.
pub const CELLS: u32 = 8;
/// Alpha of squares that are there.
const SOLID: u8 = 230;
/// Alpha of holes.
const HOLE: u8 = 20;

/// How texture coordinates are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UvLayout {
    /// Two floats in a buffer of their own.
    Floats,
    /// Two normalised 16-bit integers in front of each position, in one buffer.
    Interleaved,
}

/// A quad with holes.
#[derive(Debug, Clone)]
pub struct CheckeredQuad {
    /// The quad, to be drawn with the mask.
    pub whole: Geometry,
    /// Only the squares that are there.
    pub cut: Geometry,
}

/// The quad's buffers.
#[derive(Debug)]
pub struct CheckeredBuffers {
    geometry: GeometryBuffers,
    uvs: wgpu::Buffer,
    layout: UvLayout,
    texture: wgpu::TextureView,
    sampler: wgpu::Sampler,
}

/// Whether the square of a column and a row is there.
const fn is_solid(column: u32, row: u32) -> bool {
    (column + row).is_multiple_of(2)
}

impl CheckeredQuad {
    /// A parallelogram: a corner and two edges.
    pub fn new(corner: [f32; 3], across: [f32; 3], along: [f32; 3]) -> Self {
        let at = |column: u32, row: u32| {
            let (u, v) = (column as f32 / CELLS as f32, row as f32 / CELLS as f32);
            std::array::from_fn(|axis| corner[axis] + across[axis] * u + along[axis] * v)
        };
        let side = CELLS + 1;
        let square = |cell: u32| {
            let first = cell / CELLS * side + cell % CELLS;
            [first, first + 1, first + side + 1, first, first + side + 1, first + side]
        };
        let solid = (0..CELLS * CELLS).filter(|cell| is_solid(cell % CELLS, cell / CELLS));
        let cut = Geometry {
            positions: (0..side * side).map(|index| at(index % side, index / side)).collect(),
            indices: solid.flat_map(square).collect(),
        };
        Self { whole: Geometry::quad(corner, across, along), cut }
    }

    /// Uploads the quad, its texture coordinates and the mask.
    pub fn upload(&self, gpu: &TestDevice, layout: UvLayout) -> CheckeredBuffers {
        let corners = [(0_u16, 0_u16), (u16::MAX, 0), (u16::MAX, u16::MAX), (0, u16::MAX)];
        let mut geometry = self.whole.upload(gpu);
        let bytes: Vec<u8> = match layout {
            UvLayout::Floats => {
                let unit = |value: u16| (f32::from(value) / f32::from(u16::MAX)).to_le_bytes();
                corners.iter().flat_map(|(u, v)| [unit(*u), unit(*v)].concat()).collect()
            }
            UvLayout::Interleaved => {
                let vertices = corners.iter().zip(&self.whole.positions);
                let vertex = |((u, v), position): (&(u16, u16), &[f32; 3])| {
                    let position: Vec<u8> = position.iter().flat_map(|value| value.to_le_bytes()).collect();
                    [&u.to_le_bytes()[..], &v.to_le_bytes()[..], &position[..]].concat()
                };
                vertices.flat_map(vertex).collect()
            }
        };
        let uvs = buffer(gpu, &bytes, VERTICES);
        if layout == UvLayout::Interleaved {
            geometry.vertices = uvs.clone();
        }
        let alpha: Vec<u8> = (0..CELLS * CELLS)
            .map(|texel| if is_solid(texel % CELLS, texel / CELLS) { SOLID } else { HOLE })
            .collect();
        let texture = images::alpha_texture(gpu, (CELLS, CELLS), &alpha);
        let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor::default());
        CheckeredBuffers { geometry, uvs, layout, texture: texture.create_view(&Default::default()), sampler }
    }
}

impl CheckeredBuffers {
    /// The mesh as the service takes it, with a cutoff between the two alphas.
    pub fn description(&self) -> MeshDescription<'_> {
        let (format, stride_bytes) = match self.layout {
            UvLayout::Floats => (wgpu::VertexFormat::Float32x2, 8),
            UvLayout::Interleaved => (wgpu::VertexFormat::Unorm16x2, 16),
        };
        let mask = AlphaMask {
            uvs: &self.uvs,
            offset_bytes: 0,
            stride_bytes,
            format,
            texture: &self.texture,
            sampler: &self.sampler,
            cutoff: 0.5,
        };
        let plain = self.geometry.description();
        match self.layout {
            UvLayout::Floats => MeshDescription { mask: Some(mask), ..plain },
            UvLayout::Interleaved => MeshDescription {
                vertex_count: 4,
                stride_bytes,
                position_offset_bytes: 4,
                mask: Some(mask),
                ..plain
            },
        }
    }
}
