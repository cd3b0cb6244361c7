//! Clusters: contiguous ranges of a mesh's triangles that facets accept or refuse one by one.
//!
//! A facet sees a slice of the scene. Small meshes are accepted or refused whole; a large one would be drawn whole into
//! every facet that it touches anywhere. Its clusters, boxes around at most [`CLUSTER_TRIANGLES`] neighbouring
//! triangles each, are refused where they cannot reach. Only the order of the triangles has to allow it:
//! [`cluster_triangles`] finds one, once, before indices are uploaded. Vertices stay as they are.

mod split;

use cssm_core::BoundingBox;
use cssm_core::glam::DVec3;

use crate::mesh::MeshError;

/// Most triangles that [`cluster_triangles`] puts into one cluster.
pub const CLUSTER_TRIANGLES: usize = 128;

/// A contiguous range of a mesh's triangles and the box around them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cluster {
    /// First corner: an index of the mesh, or a vertex where the mesh has no indices.
    pub first: u32,
    /// Corners, three for each triangle.
    pub count: u32,
    /// Box around the range's positions in object space.
    pub bounds_object: BoundingBox,
}

/// Triangles in an order in which neighbours lie side by side.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ClusteredTriangles {
    /// The same triangles, each with its corners in the order given.
    pub indices: Vec<u32>,
    /// Ranges of `indices`, one after another, that cover all of them.
    pub clusters: Vec<Cluster>,
}

/// Triangles that cannot be put into an order.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ClusterError {
    /// The number of indices is no multiple of three.
    #[error("{indices} indices are no multiple of 3; give a triangle list")]
    NotTriangles {
        /// Number of indices.
        indices: usize,
    },
    /// There are more indices than a draw can name.
    #[error("{indices} indices are more than a draw can name; split the mesh")]
    TooMany {
        /// Number of indices.
        indices: usize,
    },
    /// An index leads nowhere, or to a position that is not finite.
    #[error("index {index} leads to no finite position; check the indices against the vertices")]
    Position {
        /// The index.
        index: u32,
    },
}

/// Orders a triangle list so that each cluster is a compact, contiguous range of at most [`CLUSTER_TRIANGLES`].
///
/// `position` reads a vertex in object space, exactly as the vertex fetch yields it; `None` where there is no such
/// vertex. Equal input gives equal output on every machine. A mesh without indices is clustered with the indices 0, 1, 2..,
/// which it then needs.
///
/// ```
/// use cssm_runtime::cluster_triangles;
/// use cssm_runtime::cssm_core::glam::DVec3;
///
/// let positions = [[0.0_f32, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
/// let position = |index: u32| {
///     positions.get(index as usize).map(|at| DVec3::from_array(at.map(f64::from)))
/// };
/// let clustered = cluster_triangles(position, &[0, 1, 2])?;
/// assert_eq!(clustered.clusters[0].count, 3);
/// # Ok::<(), cssm_runtime::ClusterError>(())
/// ```
///
/// # Errors
/// A [`ClusterError`] that names what is wrong with the indices.
pub fn cluster_triangles(
    position: impl Fn(u32) -> Option<DVec3>,
    indices: &[u32],
) -> Result<ClusteredTriangles, ClusterError> {
    if !indices.len().is_multiple_of(3) {
        return Err(ClusterError::NotTriangles { indices: indices.len() });
    }
    if u32::try_from(indices.len()).is_err() {
        return Err(ClusterError::TooMany { indices: indices.len() });
    }

    // Put a box around every triangle.
    let finite = |index: u32| {
        position(index).filter(|position| position.is_finite()).ok_or(ClusterError::Position { index })
    };
    let mut boxes = Vec::with_capacity(indices.len() / 3);
    for corners in indices.chunks_exact(3) {
        let [a, b, c] = [finite(corners[0])?, finite(corners[1])?, finite(corners[2])?];
        boxes.push(BoundingBox { min: a.min(b).min(c), max: a.max(b).max(c) });
    }

    // Cut the list into ranges and write each down.
    let mut order: Vec<u32> = (0..boxes.len() as u32).collect();
    let mut clustered =
        ClusteredTriangles { indices: Vec::with_capacity(indices.len()), clusters: Vec::new() };
    split::ranges(&boxes, &mut order, &mut |range, bounds_object| {
        let first = clustered.indices.len() as u32;
        for triangle in range {
            let start = *triangle as usize * 3;
            clustered.indices.extend_from_slice(&indices[start..start + 3]);
        }
        clustered.clusters.push(Cluster { first, count: range.len() as u32 * 3, bounds_object });
    });
    Ok(clustered)
}

/// Checks that clusters are whole triangles with sound boxes that cover a mesh's corners one after another.
pub(crate) fn check(clusters: &[Cluster], corners: u32) -> Result<(), MeshError> {
    let mut covered = 0;
    for (number, cluster) in clusters.iter().enumerate() {
        let Cluster { first, count, bounds_object } = *cluster;
        if count == 0 || !count.is_multiple_of(3) {
            return Err(MeshError::ClusterCount { cluster: number, count });
        }
        let end = first.checked_add(count).filter(|end| *end <= corners);
        let Some(end) = end else {
            return Err(MeshError::ClusterOutOfRange { cluster: number, first, count, corners });
        };
        if first != covered {
            return Err(MeshError::ClusterOrder { cluster: number, first, expected: covered });
        }
        if !is_sound(&bounds_object) {
            return Err(MeshError::ClusterBounds { cluster: number });
        }
        covered = end;
    }
    if !clusters.is_empty() && covered != corners {
        return Err(MeshError::ClustersEnd { covered, corners });
    }
    Ok(())
}

/// Whether a box is finite and not inside out.
pub(crate) fn is_sound(bounds: &BoundingBox) -> bool {
    bounds.min.is_finite() && bounds.max.is_finite() && bounds.min.cmple(bounds.max).all()
}

#[cfg(test)]
mod tests;
