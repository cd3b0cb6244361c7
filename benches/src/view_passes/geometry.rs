//! A scene's triangles where a view sees them.

use std::ops::Range;

use cssm_core::View;
use cssm_core::glam::{DMat3, DVec3};
use cssm_lab::gpu::{Gpu, GpuError};
use cssm_lab::scene::Scene;

/// Bytes of a vertex: its position.
pub(super) const VERTEX_BYTES: u64 = 12;

/// Bytes of an instance: three rows to camera axes, and a colour.
pub(super) const INSTANCE_BYTES: u64 = 64;

/// Vertices, indices and instances of a scene.
#[derive(Debug)]
pub(super) struct Geometry {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    instances: wgpu::Buffer,
    draws: Vec<Draw>,
    /// The view and the light.
    pub(super) record: wgpu::Buffer,
}

/// All instances of a mesh.
#[derive(Debug)]
struct Draw {
    indices: Range<u32>,
    base_vertex: i32,
    instances: Range<u32>,
}

impl Geometry {
    /// Uploads a scene; transforms are turned to camera axes relative to the eye in f64.
    pub(super) fn new(gpu: &Gpu, scene: &Scene, view: &View, toward_light: DVec3) -> Result<Self, GpuError> {
        let (mut vertices, mut indices, mut instances, mut draws) =
            (Vec::<[f32; 3]>::new(), Vec::<u32>::new(), Vec::<[f32; 16]>::new(), Vec::new());
        for (number, mesh) in scene.meshes.iter().enumerate() {
            let (first_index, first_instance) = (indices.len() as u32, instances.len() as u32);
            let base_vertex = vertices.len() as i32;
            vertices.extend(&mesh.positions);
            indices.extend(&mesh.indices);
            for instance in scene.instances.iter().filter(|instance| instance.mesh == number) {
                let turned: DMat3 = view.camera_from_world * instance.world_from_object.matrix3;
                let moved =
                    view.camera_from_world * (instance.world_from_object.translation - view.eye_world);
                let mut values = [1.0; 16];
                for row in 0..3 {
                    values[4 * row..4 * row + 3].copy_from_slice(&turned.row(row).as_vec3().to_array());
                    values[4 * row + 3] = moved[row] as f32;
                }
                values[12..15].copy_from_slice(&instance.colour);
                instances.push(values);
            }
            draws.push(Draw {
                indices: first_index..indices.len() as u32,
                base_vertex,
                instances: first_instance..instances.len() as u32,
            });
        }
        let upload = |label, usage, contents: &[u8]| {
            gpu.checked("the view's buffers", || {
                let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(label),
                    size: (contents.len() as u64).max(VERTEX_BYTES),
                    usage: usage | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                });
                gpu.queue.write_buffer(&buffer, 0, contents);
                buffer
            })
        };
        let record = record(view, toward_light);
        Ok(Self {
            vertices: upload("vertices", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&vertices))?,
            indices: upload("indices", wgpu::BufferUsages::INDEX, bytemuck::cast_slice(&indices))?,
            instances: upload("instances", wgpu::BufferUsages::VERTEX, bytemuck::cast_slice(&instances))?,
            draws,
            record: upload("view", wgpu::BufferUsages::UNIFORM, bytemuck::cast_slice(&record))?,
        })
    }

    /// Draws everything.
    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_vertex_buffer(0, self.vertices.slice(..));
        pass.set_vertex_buffer(1, self.instances.slice(..));
        pass.set_index_buffer(self.indices.slice(..), wgpu::IndexFormat::Uint32);
        for draw in &self.draws {
            pass.draw_indexed(draw.indices.clone(), draw.base_vertex, draw.instances.clone());
        }
    }
}

/// Rows to clip space, the near plane and the light, in camera axes.
fn record(view: &View, toward_light: DVec3) -> [[f32; 4]; 4] {
    let across = |low: f64, high: f64| (2.0 / (high - low), (high + low) / (high - low));
    let (scale_x, offset_x) = across(view.left, view.right);
    let (scale_y, offset_y) = across(view.bottom, view.top);
    let light = view.camera_from_world * toward_light;
    [
        DVec3::new(scale_x, 0.0, offset_x),
        DVec3::new(0.0, scale_y, offset_y),
        DVec3::new(view.near_metres, 0.0, 0.0),
        light,
    ]
    .map(|row| row.as_vec3().extend(0.0).to_array())
}
