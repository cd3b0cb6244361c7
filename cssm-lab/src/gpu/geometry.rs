//! A scene's meshes in two buffers, and its alpha masks.

use cssm_core::BoundingBox;
use cssm_core::glam::DVec3;
use cssm_runtime::{
    CasterInstance, Cluster, ClusterError, ClusteredTriangles, IndexDescription, MeshDescription, MeshHandle,
    ServiceError, ShadowService, cluster_triangles,
};

use super::alpha_mask::MaskBuffers;
use super::{Gpu, GpuError};
use crate::scene::Scene;

const POSITION_BYTES: u64 = 12;
const INDEX_BYTES: u64 = 4;

/// All vertices and all indices of a scene, ordered in clusters, and the alpha masks of its meshes.
#[derive(Debug)]
pub struct SceneBuffers {
    vertices: wgpu::Buffer,
    indices: wgpu::Buffer,
    clusters: Vec<Vec<Cluster>>,
    masks: Vec<Option<MaskBuffers>>,
}

impl SceneBuffers {
    /// Uploads a scene; the triangles of each mesh are put into clusters on the way.
    ///
    /// # Errors
    /// When it does not fit a buffer, or an index leads to no vertex.
    pub fn new(gpu: &Gpu, scene: &Scene) -> Result<Self, GpuError> {
        let count =
            |items: fn(&crate::scene::Mesh) -> usize| scene.meshes.iter().map(items).sum::<usize>() as u64;
        let vertex_bytes = count(|mesh| mesh.positions.len()) * POSITION_BYTES;
        let index_bytes = count(|mesh| mesh.indices.len()) * INDEX_BYTES;
        if vertex_bytes.max(index_bytes) > gpu.device.limits().max_buffer_size {
            return Err(GpuError::SceneTooLarge);
        }
        let buffer = |label, size: u64, usage| {
            gpu.checked("the scene's buffers", || {
                gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some(label),
                    size: size.max(POSITION_BYTES),
                    usage: usage | wgpu::BufferUsages::COPY_DST,
                    mapped_at_creation: false,
                })
            })
        };
        let vertices =
            buffer("scene vertices", vertex_bytes, wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::STORAGE)?;
        let indices =
            buffer("scene indices", index_bytes, wgpu::BufferUsages::INDEX | wgpu::BufferUsages::STORAGE)?;
        let clustered = scene.meshes.iter().map(clustered).collect::<Result<Vec<_>, _>>()?;
        gpu.checked("the scene's contents", || {
            let (mut vertex, mut index) = (0, 0);
            for (mesh, clustered) in scene.meshes.iter().zip(&clustered) {
                gpu.queue.write_buffer(&vertices, vertex, bytemuck::cast_slice(&mesh.positions));
                gpu.queue.write_buffer(&indices, index, bytemuck::cast_slice(&clustered.indices));
                vertex += mesh.positions.len() as u64 * POSITION_BYTES;
                index += mesh.indices.len() as u64 * INDEX_BYTES;
            }
        })?;
        let mask = |mesh: &crate::scene::Mesh| {
            mesh.mask.as_ref().map(|mask| MaskBuffers::new(gpu, mask)).transpose()
        };
        let masks = scene.meshes.iter().map(mask).collect::<Result<_, _>>()?;
        let clusters = clustered.into_iter().map(|clustered| clustered.clusters).collect();
        Ok(Self { vertices, indices, clusters, masks })
    }

    /// Forgets the clusters, for comparisons: every mesh is accepted or refused whole.
    pub fn without_clusters(mut self) -> Self {
        self.clusters.iter_mut().for_each(Vec::clear);
        self
    }

    /// Registers the scene's meshes with a service and returns its instances as casters.
    ///
    /// # Errors
    /// What the service says of a mesh.
    pub fn add_to(
        &self,
        service: &mut ShadowService,
        scene: &Scene,
    ) -> Result<Vec<CasterInstance>, GpuError> {
        self.add_by(&mut |description| service.add_mesh(description), scene)
    }

    /// The same with whatever registers a mesh; instances without triangles are left out.
    ///
    /// # Errors
    /// What it says of a mesh.
    pub fn add_by(
        &self,
        add_mesh: &mut dyn FnMut(&MeshDescription) -> Result<MeshHandle, ServiceError>,
        scene: &Scene,
    ) -> Result<Vec<CasterInstance>, GpuError> {
        let (mut vertex, mut index) = (0, 0);
        let mut handles = Vec::with_capacity(scene.meshes.len());
        for ((mesh, mask), clusters) in scene.meshes.iter().zip(&self.masks).zip(&self.clusters) {
            let handle = match mesh.bounds().filter(|_| !mesh.indices.is_empty()) {
                None => None,
                Some((min, max)) => Some(add_mesh(&MeshDescription {
                    vertices: &self.vertices,
                    vertices_offset_bytes: vertex,
                    vertex_count: mesh.positions.len() as u32,
                    stride_bytes: POSITION_BYTES as u32,
                    position_offset_bytes: 0,
                    position_format: wgpu::VertexFormat::Float32x3,
                    indices: Some(IndexDescription {
                        buffer: &self.indices,
                        offset_bytes: index,
                        count: mesh.indices.len() as u32,
                        format: wgpu::IndexFormat::Uint32,
                    }),
                    bounds_object: BoundingBox { min: DVec3::from_array(min), max: DVec3::from_array(max) },
                    clusters,
                    mask: mask.as_ref().map(MaskBuffers::description),
                })?),
            };
            handles.push(handle);
            vertex += mesh.positions.len() as u64 * POSITION_BYTES;
            index += mesh.indices.len() as u64 * INDEX_BYTES;
        }
        let casters = scene.instances.iter().filter_map(|instance| {
            let mesh = handles[instance.mesh]?;
            Some(CasterInstance { mesh, world_from_object: instance.world_from_object })
        });
        Ok(casters.collect())
    }
}

/// A mesh's triangles in the order of its clusters.
fn clustered(mesh: &crate::scene::Mesh) -> Result<ClusteredTriangles, ClusterError> {
    let position = |index: u32| {
        mesh.positions.get(index as usize).map(|position| DVec3::from_array(position.map(f64::from)))
    };
    cluster_triangles(position, &mesh.indices)
}
