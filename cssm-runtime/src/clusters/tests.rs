//! Orders of triangles, and what is refused.

use super::*;

/// A level grid of cells, two triangles each, in an order in which neighbours lie far apart.
fn grid(side: u32) -> (Vec<DVec3>, Vec<u32>) {
    let row = side + 1;
    let positions =
        (0..row * row).map(|at| DVec3::new(f64::from(at % row), 0.0, f64::from(at / row))).collect();
    let cells = side * side;
    let cell = |step: u32| {
        let cell = (u64::from(step) * 7919 % u64::from(cells)) as u32;
        let first = cell / side * row + cell % side;
        [first, first + row, first + row + 1, first, first + row + 1, first + 1]
    };
    (positions, (0..cells).flat_map(cell).collect())
}

fn clustered(positions: &[DVec3], indices: &[u32]) -> Result<ClusteredTriangles, ClusterError> {
    cluster_triangles(|index| positions.get(index as usize).copied(), indices)
}

/// Triangles as they are, in an order of their own.
fn sorted(indices: &[u32]) -> Vec<&[u32]> {
    let mut triangles: Vec<&[u32]> = indices.chunks_exact(3).collect();
    triangles.sort_unstable();
    triangles
}

#[test]
fn clusters_hold_every_triangle_once_and_fit_tightly() {
    let (positions, indices) = grid(61);
    let found = clustered(&positions, &indices).unwrap();
    assert_eq!(sorted(&found.indices), sorted(&indices));
    assert_ne!(found.indices, indices);
    check(&found.clusters, indices.len() as u32).unwrap();
    for cluster in &found.clusters {
        assert!(cluster.count <= 3 * CLUSTER_TRIANGLES as u32);
        let corners = &found.indices[cluster.first as usize..][..cluster.count as usize];
        let at = |index: &u32| positions[*index as usize];
        let min = corners.iter().map(at).fold(DVec3::INFINITY, DVec3::min);
        let max = corners.iter().map(at).fold(DVec3::NEG_INFINITY, DVec3::max);
        assert_eq!(cluster.bounds_object, BoundingBox { min, max });
    }
}

#[test]
fn clusters_are_compact() {
    let (positions, indices) = grid(64);
    let found = clustered(&positions, &indices).unwrap();
    let area = |bounds: &BoundingBox| {
        let sides = bounds.max - bounds.min;
        sides.x * sides.z
    };
    let covered: f64 = found.clusters.iter().map(|cluster| area(&cluster.bounds_object)).sum();
    let least = 64.0 * 64.0;
    assert!(covered < 1.5 * least, "the boxes cover {covered} for {least}");
    let full = (2.0 * least / CLUSTER_TRIANGLES as f64) as usize;
    assert!(found.clusters.len() < 2 * full, "{} clusters where {full} would do", found.clusters.len());

    // The order given would not do.
    let unordered = indices.chunks(3 * CLUSTER_TRIANGLES).map(|chunk| {
        let at = |index: &u32| positions[*index as usize];
        let min = chunk.iter().map(at).fold(DVec3::INFINITY, DVec3::min);
        area(&BoundingBox { min, max: chunk.iter().map(at).fold(DVec3::NEG_INFINITY, DVec3::max) })
    });
    assert!(unordered.sum::<f64>() > 10.0 * least);
}

#[test]
fn triangles_in_one_place_end_in_clusters_too() {
    let positions = [DVec3::ZERO, DVec3::X, DVec3::Y];
    let indices = [0, 1, 2].repeat(1000);
    let found = clustered(&positions, &indices).unwrap();
    assert_eq!(found.indices, indices);
    check(&found.clusters, 3000).unwrap();
    assert!(found.clusters.len() >= 8);
    assert_eq!(clustered(&positions, &[]).unwrap(), ClusteredTriangles::default());
}

#[test]
fn indices_that_make_no_sense() {
    let positions = [DVec3::ZERO, DVec3::X, DVec3::new(0.0, f64::NAN, 0.0)];
    let refused = |indices: &[u32]| clustered(&positions, indices).unwrap_err();
    assert_eq!(refused(&[0, 1]), ClusterError::NotTriangles { indices: 2 });
    assert_eq!(refused(&[0, 1, 3]), ClusterError::Position { index: 3 });
    assert_eq!(refused(&[0, 1, 2]), ClusterError::Position { index: 2 });
}

#[test]
fn clusters_that_make_no_sense() {
    let bounds_object = BoundingBox { min: DVec3::ZERO, max: DVec3::ONE };
    let cluster = |first, count| Cluster { first, count, bounds_object };
    let refused = |clusters: &[Cluster]| check(clusters, 12).unwrap_err();
    assert_eq!(check(&[], 12), Ok(()));
    assert_eq!(check(&[cluster(0, 6), cluster(6, 6)], 12), Ok(()));

    for count in [0, 4] {
        assert_eq!(
            refused(&[cluster(0, 6), cluster(6, count)]),
            MeshError::ClusterCount { cluster: 1, count }
        );
    }
    for first in [9, u32::MAX] {
        let error = MeshError::ClusterOutOfRange { cluster: 1, first, count: 6, corners: 12 };
        assert_eq!(refused(&[cluster(0, 6), cluster(first, 6)]), error);
    }
    let (overlap, gap) = (cluster(3, 6), cluster(9, 3));
    for wrong in [overlap, gap] {
        let error = MeshError::ClusterOrder { cluster: 1, first: wrong.first, expected: 6 };
        assert_eq!(refused(&[cluster(0, 6), wrong]), error);
    }
    assert_eq!(refused(&[cluster(0, 9)]), MeshError::ClustersEnd { covered: 9, corners: 12 });
    for bad in [f64::NAN, f64::NEG_INFINITY, -1.0] {
        let mut wrong = cluster(6, 6);
        wrong.bounds_object.max.y = bad;
        assert_eq!(refused(&[cluster(0, 6), wrong]), MeshError::ClusterBounds { cluster: 1 });
    }
}
