//! The shaders without a device, and the boxes and lists that they read.

use std::process::Command;

use cssm_core::BoundingBox;
use cssm_core::glam::DVec3;
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

use super::clusters::{ClusterPool, OuterBox};
use super::device::{CLUSTERS, INSTANCES};
use crate::clusters::Cluster;
use crate::mesh::MeshHandle;

#[test]
fn shaders_are_valid() {
    for (source, entry) in [(INSTANCES, "cull_instances"), (CLUSTERS, "cull_clusters")] {
        let module = naga::front::wgsl::parse_str(source).unwrap();
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        let info = validator.validate(&module).unwrap();
        let words = spv::write_vec(&module, &info, &spv::Options::default(), None).unwrap();
        assert_eq!(module.entry_points[0].name, entry);
        assert!(source.lines().all(|line| line.len() <= 120), "a line of {entry} is too long");

        // Ask the Khronos validator too, where there is one.
        let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
        let path = std::env::temp_dir().join(format!("cssm-{entry}-{}.spv", std::process::id()));
        std::fs::write(&path, bytes).unwrap();
        if let Ok(output) = Command::new("spirv-val").arg("--target-env").arg("vulkan1.1").arg(&path).output()
        {
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        }
        std::fs::remove_file(path).unwrap();
    }
}

#[test]
fn boxes_are_rounded_outward() {
    let number = |seed: u32| f64::from(seed.wrapping_mul(2_654_435_761)) / f64::from(u32::MAX) * 2e3 - 1e3;
    for seed in 0..3000 {
        let one = DVec3::new(number(seed), number(seed + 7), number(seed + 13));
        let other = DVec3::new(number(seed + 1), number(seed + 8), number(seed + 14));
        let bounds = BoundingBox { min: one.min(other), max: one.max(other) };
        let outer = OuterBox::new(&bounds);
        let (centre, half) = (outer.centre.map(f64::from), outer.half.map(f64::from));
        let (centre, half) = (DVec3::from_array(centre), DVec3::from_array(half));
        assert!((centre - half).cmple(bounds.min).all() && (centre + half).cmpge(bounds.max).all());
        let slack = half * 2.0 - (bounds.max - bounds.min);
        assert!(slack.max_element() < 1e-3, "{slack} too much");
    }
    let point = BoundingBox { min: DVec3::splat(0.1), max: DVec3::splat(0.1) };
    assert!(OuterBox::new(&point).half[0] > 0.0, "a tenth is no f32");
}

#[test]
fn clusters_of_meshes_that_are_no_more_are_forgotten() {
    let cluster =
        |first| Cluster { first, count: 3, bounds_object: BoundingBox { min: DVec3::ZERO, max: DVec3::ONE } };
    let clusters: Vec<_> = (0..10).map(|number| cluster(3 * number)).collect();
    let mesh = |index, generation| MeshHandle { index, generation };
    let mut pool = ClusterPool::default();
    assert_eq!(pool.first(mesh(1, 0), &clusters), 0);
    assert_eq!(pool.first(mesh(0, 0), &clusters[..4]), 10);
    assert_eq!(pool.first(mesh(1, 0), &clusters), 0, "known");
    assert_eq!((pool.records[11].first, pool.records[11].end), (3, 6));

    // Another mesh in the same place, until half of the records are dead.
    assert_eq!(pool.first(mesh(1, 1), &clusters), 14);
    pool.tidy();
    assert_eq!((pool.records.len(), pool.generation), (24, 0));
    assert_eq!(pool.first(mesh(1, 2), &clusters), 24);
    pool.tidy();
    assert_eq!((pool.records.len(), pool.generation), (0, 1));
    assert_eq!(pool.first(mesh(1, 2), &clusters), 0);
}
