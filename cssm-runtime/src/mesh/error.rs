//! Meshes that make no sense, and what to do about them.

/// A mesh that makes no sense.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// There is not one triangle.
    #[error("the mesh has no triangle; leave it out")]
    Empty,
    /// The number of corners is no multiple of three.
    #[error("the mesh has {corners} corners, which is no multiple of 3; give a triangle list")]
    NotTriangles {
        /// Vertices, or indices where there are some.
        corners: u32,
    },
    /// The position format has too few components or holds integers.
    #[error(
        "positions of format {0:?} cannot be read as three floats; use a float, normalised or packed format with at least 3 components"
    )]
    Format(wgpu::VertexFormat),
    /// The stride is out of range.
    #[error(
        "a stride of {stride_bytes} bytes does not work for positions at byte {position_offset_bytes}; give a multiple of 4 that holds the position, up to {limit}"
    )]
    Stride {
        /// Distance between vertices.
        stride_bytes: u32,
        /// Where the position lies in a vertex.
        position_offset_bytes: u32,
        /// The device's largest stride.
        limit: u32,
    },
    /// An offset is not aligned.
    #[error("the {what} begin at byte {offset_bytes}, which is no multiple of {alignment}; align them")]
    Alignment {
        /// Vertices, indices or texture coordinates.
        what: &'static str,
        /// Where they begin.
        offset_bytes: u64,
        /// What is needed.
        alignment: u64,
    },
    /// The buffer ends before the mesh does.
    #[error("the {what} end at byte {end_bytes} of a buffer of {size_bytes} bytes; check offsets and counts")]
    OutOfRange {
        /// Vertices, indices or texture coordinates.
        what: &'static str,
        /// Where the mesh ends.
        end_bytes: u64,
        /// Size of the buffer.
        size_bytes: u64,
    },
    /// The buffer may not be used as such.
    #[error("the buffer of {what} lacks the usage {usage:?}; create it with that usage")]
    Usage {
        /// Vertices, indices or texture coordinates.
        what: &'static str,
        /// What is needed.
        usage: wgpu::BufferUsages,
    },
    /// The bounding box is not finite or inside out.
    #[error("the bounding box of the mesh is not finite or has max < min; give the box around its positions")]
    Bounds,
    /// A cluster is no list of triangles.
    #[error("cluster {cluster} has {count} corners; give it a multiple of 3, at least one triangle")]
    ClusterCount {
        /// Number of the cluster.
        cluster: usize,
        /// Its corners.
        count: u32,
    },
    /// A cluster ends after the mesh does.
    #[error(
        "cluster {cluster} holds {count} corners from corner {first}, but the mesh has {corners}; count from the mesh's first index"
    )]
    ClusterOutOfRange {
        /// Number of the cluster.
        cluster: usize,
        /// Its first corner.
        first: u32,
        /// Its corners.
        count: u32,
        /// Corners of the mesh.
        corners: u32,
    },
    /// A cluster overlaps the one before, or leaves triangles between them to nobody.
    #[error(
        "cluster {cluster} begins at corner {first}, but those before end at {expected}; let clusters follow one another without gap or overlap"
    )]
    ClusterOrder {
        /// Number of the cluster.
        cluster: usize,
        /// Its first corner.
        first: u32,
        /// Where the clusters before it end.
        expected: u32,
    },
    /// The clusters end before the mesh does.
    #[error(
        "the clusters end at corner {covered} of {corners}; cover every triangle, the others would cast no shadow"
    )]
    ClustersEnd {
        /// Where the last cluster ends.
        covered: u32,
        /// Corners of the mesh.
        corners: u32,
    },
    /// A cluster's box is not finite or inside out.
    #[error(
        "the bounding box of cluster {cluster} is not finite or has max < min; give the box around its positions"
    )]
    ClusterBounds {
        /// Number of the cluster.
        cluster: usize,
    },
    /// A buffer is larger than shaders may fetch from.
    #[error(
        "the {what} lie in {bytes} bytes, but shaders fetch from at most {limit}; split the mesh or request a larger max_storage_buffer_binding_size"
    )]
    TooLarge {
        /// Vertices, indices or texture coordinates.
        what: &'static str,
        /// Bytes from the first to the last, with what aligns them.
        bytes: u64,
        /// The device's largest storage binding.
        limit: u64,
    },
    /// The mesh has more corners than fans of its triangles can be numbered.
    #[error("the mesh has {corners} corners, but exact stretching draws four for each; split the mesh")]
    TooManyCorners {
        /// Vertices, or indices where there are some.
        corners: u32,
    },
    /// The case has no capture shaders that read masks.
    #[error(
        "the mesh has an alpha mask, but the case declares opaque casters; declare casters: alpha_tested or leave the mask out"
    )]
    MaskNotDeclared,
    /// The format of texture coordinates has too few components or holds integers.
    #[error(
        "texture coordinates of format {0:?} cannot be read as two floats; use a float, normalised or packed format with at least 2 components"
    )]
    MaskFormat(wgpu::VertexFormat),
    /// The stride of texture coordinates is out of range.
    #[error(
        "a stride of {stride_bytes} bytes does not work for texture coordinates of format {format:?}; give a multiple of 4 that holds them, up to {limit}"
    )]
    MaskStride {
        /// Distance between texture coordinates.
        stride_bytes: u32,
        /// Their format.
        format: wgpu::VertexFormat,
        /// The device's largest stride.
        limit: u32,
    },
    /// The cutoff is no alpha.
    #[error("an alpha cutoff of {0} is not between 0 and 1; give the alpha below which the mesh has holes")]
    MaskCutoff(f32),
    /// The texture or the sampler is of another kind.
    #[error(
        "the alpha mask cannot be sampled: {reason}; give a filterable two-dimensional texture with alpha and a sampler without comparison"
    )]
    MaskTexture {
        /// What is wrong.
        reason: String,
    },
}
