//! Caster geometry on both sides: triangles in f64 for twins, buffers for the device.

use cssm_core::BoundingBox;
use cssm_core::glam::{DAffine3, DMat3, DVec3};
use cssm_runtime::{IndexDescription, MeshDescription, wgpu};

use super::device::TestDevice;

/// An indexed triangle list in f32, as an engine holds it.
#[derive(Debug, Clone, Default)]
pub struct Geometry {
    /// Positions in object space.
    pub positions: Vec<[f32; 3]>,
    /// Three for each triangle.
    pub indices: Vec<u32>,
}

/// A geometry's buffers.
#[derive(Debug)]
pub struct GeometryBuffers {
    /// Positions, twelve bytes each.
    pub vertices: wgpu::Buffer,
    /// 32-bit indices.
    pub indices: wgpu::Buffer,
    /// Box around the positions.
    pub bounds: BoundingBox,
}

impl Geometry {
    /// One triangle.
    pub fn triangle(corners: [[f32; 3]; 3]) -> Self {
        Self { positions: corners.to_vec(), indices: vec![0, 1, 2] }
    }

    /// A parallelogram: a corner and two edges.
    pub fn quad(corner: [f32; 3], across: [f32; 3], along: [f32; 3]) -> Self {
        let at =
            |u: f32, v: f32| std::array::from_fn(|axis| corner[axis] + across[axis] * u + along[axis] * v);
        Self {
            positions: vec![at(0., 0.), at(1., 0.), at(1., 1.), at(0., 1.)],
            indices: vec![0, 1, 2, 0, 2, 3],
        }
    }

    /// A level square around the origin, cut into squares as engines cut terrain: a single triangle that spans a
    /// kilometre leaves f32 rasterisers little precision below the eye.
    pub fn ground(half: f32, cells: u32) -> Self {
        let corner = |index: u32| index as f32 * (2.0 * half / cells as f32) - half;
        let row = cells + 1;
        let quad = |cell: u32| {
            let first = cell / cells * row + cell % cells;
            [first, first + row, first + row + 1, first, first + row + 1, first + 1]
        };
        Self {
            positions: (0..row * row).map(|index| [corner(index % row), 0.0, corner(index / row)]).collect(),
            indices: (0..cells * cells).flat_map(quad).collect(),
        }
    }

    /// An axis-aligned box, twelve triangles.
    pub fn cuboid(min: [f32; 3], max: [f32; 3]) -> Self {
        let corner = |index: usize| {
            std::array::from_fn(|axis| if index >> axis & 1 == 0 { min[axis] } else { max[axis] })
        };
        let faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
        Self {
            positions: (0..8).map(corner).collect(),
            indices: faces.iter().flat_map(|[a, b, c, d]| [*a, *b, *c, *a, *c, *d]).collect(),
        }
    }

    /// Triangles of an occurrence relative to the eye, world axes, in f64, from the very numbers the device reads:
    /// positions and instance rows in the axes of the capture, rounded to f32.
    pub fn triangles_from_eye<'a>(
        &'a self,
        world_from_object: &DAffine3,
        eye_world: DVec3,
        capture_from_world: &DMat3,
    ) -> impl Iterator<Item = [DVec3; 3]> + 'a {
        let matrix = (*capture_from_world * world_from_object.matrix3).as_mat3().as_dmat3();
        let shift = *capture_from_world * (world_from_object.translation - eye_world);
        let (shift, world_from_capture) = (shift.as_vec3().as_dvec3(), capture_from_world.inverse());
        let corner = move |index: u32| {
            let [x, y, z] = self.positions[index as usize];
            world_from_capture * (matrix * DVec3::new(f64::from(x), f64::from(y), f64::from(z)) + shift)
        };
        self.indices.chunks_exact(3).map(move |triangle| std::array::from_fn(|k| corner(triangle[k])))
    }

    /// The box around the positions.
    pub fn bounds(&self) -> BoundingBox {
        let point = |p: &[f32; 3]| DVec3::new(f64::from(p[0]), f64::from(p[1]), f64::from(p[2]));
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for position in &self.positions {
            (min, max) = (min.min(point(position)), max.max(point(position)));
        }
        BoundingBox { min, max }
    }

    /// Uploads it.
    pub fn upload(&self, gpu: &TestDevice) -> GeometryBuffers {
        let positions: Vec<u8> =
            self.positions.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
        let indices: Vec<u8> = self.indices.iter().flat_map(|value| value.to_le_bytes()).collect();
        GeometryBuffers {
            vertices: buffer(gpu, &positions, VERTICES),
            indices: buffer(gpu, &indices, wgpu::BufferUsages::INDEX | wgpu::BufferUsages::STORAGE),
            bounds: self.bounds(),
        }
    }
}

/// Usages of buffers with vertices: pipelines fetch from them, or shaders.
pub const VERTICES: wgpu::BufferUsages = wgpu::BufferUsages::VERTEX.union(wgpu::BufferUsages::STORAGE);

impl GeometryBuffers {
    /// The mesh as the service takes it.
    pub fn description(&self) -> MeshDescription<'_> {
        MeshDescription {
            vertices: &self.vertices,
            vertices_offset_bytes: 0,
            vertex_count: (self.vertices.size() / 12) as u32,
            stride_bytes: 12,
            position_offset_bytes: 0,
            position_format: wgpu::VertexFormat::Float32x3,
            indices: Some(IndexDescription {
                buffer: &self.indices,
                offset_bytes: 0,
                count: (self.indices.size() / 4) as u32,
                format: wgpu::IndexFormat::Uint32,
            }),
            bounds_object: self.bounds,
            clusters: &[],
            mask: None,
        }
    }
}

/// A buffer with contents; contents are padded to four bytes.
pub fn buffer(gpu: &TestDevice, contents: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let mut padded = contents.to_vec();
    padded.resize(contents.len().next_multiple_of(4), 0);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: None,
        size: padded.len() as u64,
        usage: usage | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, &padded);
    buffer
}
