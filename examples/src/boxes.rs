//! A scene of boxes, as the engines of the examples keep and draw it.

use cssm::BoundingBox;
use cssm::core::glam::DVec3;
use cssm::runtime::{MeshDescription, wgpu};

use crate::Gpu;

/// Boxes in one vertex buffer, which the engine's passes and the shadow service share.
#[derive(Debug)]
pub struct BoxScene {
    vertices: wgpu::Buffer,
    count: u32,
    bounds_object: BoundingBox,
}

impl BoxScene {
    /// Uploads boxes, each from its smallest corner to its largest.
    pub fn new(gpu: &Gpu, boxes: &[[[f32; 3]; 2]]) -> Self {
        let mut vertices = Vec::new();
        let (mut min, mut max) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        for corners in boxes {
            add_box(&mut vertices, corners[0], corners[1]);
            min = min.min(DVec3::from_array(corners[0].map(f64::from)));
            max = max.max(DVec3::from_array(corners[1].map(f64::from)));
        }
        Self {
            vertices: gpu.buffer(&vertices, wgpu::BufferUsages::VERTEX),
            count: vertices.len() as u32,
            bounds_object: BoundingBox { min, max },
        }
    }

    /// The boxes as a caster: the service reads positions out of the engine's own buffer.
    pub fn mesh(&self) -> MeshDescription<'_> {
        MeshDescription {
            vertices: &self.vertices,
            vertices_offset_bytes: 0,
            vertex_count: self.count,
            stride_bytes: size_of::<Vertex>() as u32,
            position_offset_bytes: 0,
            position_format: wgpu::VertexFormat::Float32x3,
            indices: None,
            bounds_object: self.bounds_object,
            clusters: &[],
            mask: None,
        }
    }

    /// How an engine's pipeline reads the buffer: position, then normal.
    pub fn layout() -> wgpu::VertexBufferLayout<'static> {
        const ATTRIBUTES: [wgpu::VertexAttribute; 2] =
            wgpu::vertex_attr_array![0 => Float32x3, 1 => Float32x3];
        wgpu::VertexBufferLayout {
            array_stride: size_of::<Vertex>() as u64,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &ATTRIBUTES,
        }
    }

    /// Draws the boxes with a pipeline and the bind group that it reads.
    pub fn draw(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &wgpu::RenderPipeline,
        group: &wgpu::BindGroup,
    ) {
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, group, &[]);
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.draw(0..self.count, 0..1);
    }
}

/// A vertex of the engines whose scenes are boxes.
#[derive(Debug, Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct Vertex {
    /// Position in object space.
    pub position: [f32; 3],
    /// Unit normal in object space.
    pub normal: [f32; 3],
}

/// A box between two corners, as triangles with flat normals.
fn add_box(vertices: &mut Vec<Vertex>, min: [f32; 3], max: [f32; 3]) {
    for (axis, end) in [(0, min), (0, max), (1, min), (1, max), (2, min), (2, max)] {
        let (across, along) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut normal = [0.0; 3];
        normal[axis] = if end == max { 1.0 } else { -1.0 };
        for (u, v) in [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)] {
            let mut position = end;
            position[across] = if u == 0 { min[across] } else { max[across] };
            position[along] = if v == 0 { min[along] } else { max[along] };
            vertices.push(Vertex { position, normal });
        }
    }
}
