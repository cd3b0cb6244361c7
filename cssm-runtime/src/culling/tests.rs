//! The shaders without a device, and the boxes and lists that they read.

use std::process::Command;

use allocation_counter::measure;
use cssm_core::BoundingBox;
use cssm_core::glam::{DAffine3, DMat3, DVec3, DVec4, Vec3, Vec4};
use naga::back::spv;
use naga::valid::{Capabilities, ValidationFlags, Validator};

use super::clusters::{ClusterPool, OuterBox};
use super::device::{CLUSTERS, INSTANCES};
use super::work::{CullingWork, LeftDraw};
use crate::clusters::Cluster;
use crate::commands::{Drawing, MeshFacts, PipelineHandle};
use crate::cull::{HalfSpace, InstanceRows};
use crate::mesh::{CasterInstance, MeshHandle};

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
    let facts = |clusters| MeshFacts {
        pipeline: PipelineHandle(0),
        corners: 30,
        indexed: true,
        first_index: 100,
        bounds_object: BoundingBox { min: DVec3::ZERO, max: DVec3::ONE },
        clusters,
        drawing: Drawing::Plain,
    };
    let (clusters, fewer) = (&facts(&clusters), &facts(&clusters[..4]));
    let mut pool = ClusterPool::default();
    assert_eq!(pool.first(mesh(1, 0), clusters), 0);
    assert_eq!(pool.first(mesh(0, 0), fewer), 10);
    assert_eq!(pool.first(mesh(1, 0), clusters), 0, "known");
    assert_eq!((pool.records[11].first, pool.records[11].end), (103, 106));

    // Another mesh in the same place, until half of the records are dead.
    assert_eq!(pool.first(mesh(1, 1), clusters), 14);
    pool.tidy();
    assert_eq!((pool.records.len(), pool.generation), (24, 0));
    assert_eq!(pool.first(mesh(1, 2), clusters), 24);
    pool.tidy();
    assert_eq!((pool.records.len(), pool.generation), (0, 1));
    assert_eq!(pool.first(mesh(1, 2), clusters), 0);
}

/// The test of the shaders in f32, with a margin; whether the box is refused, and whether it is inside.
fn side_of(plane: Vec4, rows: &InstanceRows, bounds: &OuterBox, margin: f32) -> (bool, bool) {
    let [x, y, z] = rows.0.map(Vec4::from_array);
    let (centre, half) = (Vec3::from_array(bounds.centre), Vec3::from_array(bounds.half));
    let in_object = x * plane.x + y * plane.y + z * plane.z;
    let distance = in_object.truncate().dot(centre) + in_object.w + plane.w;
    let reach = in_object.truncate().abs().dot(half);
    let sizes = (x * plane.x).abs() + (y * plane.y).abs() + (z * plane.z).abs();
    let margin = margin * (sizes.truncate().dot(centre.abs() + half) + sizes.w + plane.w.abs());
    (distance + reach < -margin, distance - reach >= margin)
}

#[test]
fn the_margin_covers_what_f32_rounds() {
    const MARGIN: f32 = 1.0 / (1 << 19) as f32;
    assert!(INSTANCES.contains(&format!("const MARGIN: f32 = {MARGIN:.7e};")), "{MARGIN:.7e}");
    let mut state = 7_u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    };
    let mut vector = |scale: f64| DVec3::new(random(), random(), random()) * scale;
    let (mut refused, mut wrong) = (0, 0);
    for round in 0..200_000 {
        // Boxes near and far, small and large, in axes that are turned, scaled and sheared.
        let scale = 10_f64.powi(round % 7 - 2);
        let matrix = DMat3::from_cols(vector(1.0), vector(1.0), vector(scale));
        let eye_from_object = DAffine3 { matrix3: matrix, translation: vector(100.0 * scale) };
        let (one, other) = (vector(10.0), vector(10.0));
        let bounds = BoundingBox { min: one.min(other), max: one.max(other) };

        // A half-space whose border touches the outermost corner, and one that touches the innermost.
        let normal = vector(1.0).normalize();
        let own = matrix.transpose() * normal;
        let corner = |far: bool| {
            let pick = DVec3::select(own.cmpge(DVec3::ZERO), bounds.max, bounds.min);
            let other = DVec3::select(own.cmpge(DVec3::ZERO), bounds.min, bounds.max);
            eye_from_object.transform_point3(if far { pick } else { other })
        };
        let touching = |far: bool| normal.extend(-normal.dot(corner(far))).as_vec4();
        let rows = InstanceRows::rounded(&eye_from_object).unwrap();
        let outer = OuterBox::new(&bounds);
        assert!(!side_of(touching(true), &rows, &outer, MARGIN).0, "round {round}: refused");
        refused += usize::from(side_of(touching(true), &rows, &outer, 0.0).0);
        wrong += usize::from(side_of(touching(false), &rows, &outer, MARGIN).1);
    }
    assert!(refused > 1000, "without a margin only {refused} are refused");
    assert_eq!(wrong, 0, "boxes that touch a border are not inside");
}

#[test]
fn half_spaces_are_turned_with_the_axes() {
    let capture_from_world =
        DMat3::from_rotation_y(0.7) * DMat3::from_cols(DVec3::X, DVec3::Y, DVec3::new(3.0, -2.0, 1.0));
    let mut work = CullingWork::default();
    work.begin(DVec3::ZERO, capture_from_world, 1);
    let plane = DVec4::new(0.3, -2.0, 1.0, 5.0);
    let never = DVec4::new(0.0, 0.0, 0.0, -1.0);
    let instance = CasterInstance {
        mesh: MeshHandle { index: 0, generation: 0 },
        world_from_object: DAffine3::IDENTITY,
    };
    let halves = [plane, never].map(HalfSpace::new);
    work.add_block(0, [(0, &instance)].into_iter(), &halves).unwrap();
    let [turned] = work.planes[..] else { panic!("{:?}", work.planes) };
    let turned = Vec4::from_array(turned).as_dvec4();
    assert!((turned.truncate().length() - 1.0).abs() < 1e-6);
    for point in [DVec3::ZERO, DVec3::new(1.0, 2.0, -3.0), DVec3::new(-40.0, 7.0, 0.1)] {
        let there = turned.dot((capture_from_world * point).extend(1.0));
        let here = plane.dot(point.extend(1.0)) * turned.w / plane.w;
        assert!((there - here).abs() < 1e-5, "{there} for {here}");
    }
}

/// Work of two draws: an instance in both, a mesh in three clusters.
fn work() -> (CullingWork, [LeftDraw; 2]) {
    let cluster =
        |first| Cluster { first, count: 3, bounds_object: BoundingBox { min: DVec3::ZERO, max: DVec3::ONE } };
    let clusters = [cluster(0), cluster(3), cluster(6)];
    let facts = |indexed| MeshFacts {
        pipeline: PipelineHandle(0),
        corners: 9,
        indexed,
        first_index: 0,
        bounds_object: clusters[0].bounds_object,
        clusters: &clusters,
        drawing: Drawing::Plain,
    };
    let mesh = MeshHandle { index: 0, generation: 0 };
    let instance = CasterInstance { mesh, world_from_object: DAffine3::IDENTITY };
    let mut work = CullingWork::default();
    work.begin(DVec3::ZERO, DMat3::IDENTITY, 2);
    let plane = [HalfSpace::new(DVec4::X)];
    let members = || [(0, &instance), (1, &instance)].into_iter();
    work.add_block(0, members(), &plane).unwrap();
    work.add_block(1, members(), &[]).unwrap();
    let one = work.add_draw(mesh, &facts(true), 0..2);
    work.add_block(0, members(), &plane).unwrap();
    let two = work.add_draw(mesh, &facts(false), 2..3);
    (work, [one, two])
}

#[test]
fn draws_have_room_of_their_own() {
    let (work, [one, two]) = work();
    assert_eq!(work.candidates.len(), 4, "rows are written once");
    let first: Vec<_> = work.blocks.iter().map(|block| (block.draw, block.first_candidate)).collect();
    assert_eq!(first, [(0, 0), (0, 2), (1, 0)]);
    let rows: Vec<_> = work.draws.iter().map(|draw| draw.rows_start..draw.rows_end).collect();
    assert_eq!(rows, [0..4, 4..6]);
    assert_eq!((work.rows, work.cuts), (6, 4), "a block that nothing cuts has no cut instance");

    // Two cut instances with every other of three clusters, with indices and without.
    let [first, second] = [one, two].map(|draw| draw.clusters.unwrap());
    assert_eq!((first.arguments, first.most, second.arguments, second.most), (0, 4, 20, 4));
    assert_eq!(work.cluster_words, 20 + 16);
    assert_eq!((one.arguments, first.count, two.arguments, second.count), (3, 8, 10, 15));
    assert_eq!(work.arguments, [0, 0, 0, 9, 0, 0, 0, 0, 0, 0, 9, 0, 0, 4, 0, 0, 0]);
    assert_eq!(work.head(), [0, 3, 1]);
    assert_eq!((work.draws[0].first_cluster, work.draws[1].first_cluster), (0, 0));
}

#[test]
fn what_does_not_fit_is_taken_back() {
    let (mut work, _) = work();
    let (before, mark) = (work.largest_bytes(), work.mark());
    work.begin(DVec3::ONE, DMat3::IDENTITY, 1);
    let mesh = MeshHandle { index: 0, generation: 0 };
    let instance = CasterInstance { mesh, world_from_object: DAffine3::IDENTITY };
    for _ in 0..20 {
        work.add_block(0, [(0, &instance)].into_iter(), &[]).unwrap();
    }
    assert!(work.largest_bytes() > before);
    work.take_back(&mark);
    let (fresh, _) = self::work();
    assert_eq!(work.largest_bytes(), before);
    assert_eq!((&work.blocks, &work.planes), (&fresh.blocks, &fresh.planes));
    assert_eq!((&work.candidates, &work.arguments), (&fresh.candidates, &fresh.arguments));
}

#[test]
fn work_is_written_without_allocating() {
    let members: Vec<_> = (0..600_u32)
        .map(|number| {
            let place = DVec3::new(f64::from(number % 25), f64::from(number / 25), 0.0);
            let world_from_object = DAffine3::from_translation(place);
            (number, CasterInstance { mesh: MeshHandle { index: 0, generation: 0 }, world_from_object })
        })
        .collect();
    let facts = MeshFacts {
        pipeline: PipelineHandle(0),
        corners: 36,
        indexed: true,
        first_index: 0,
        bounds_object: BoundingBox { min: -DVec3::ONE, max: DVec3::ONE },
        clusters: &[],
        drawing: Drawing::Plain,
    };
    let mut work = CullingWork::default();
    let mut write = |blocks: usize| {
        let room = work.room();
        work.clear();
        work.begin(DVec3::ONE, DMat3::IDENTITY, 100);
        for (number, block) in members.chunks(16).take(blocks).enumerate() {
            let instances = block.iter().map(|(number, instance)| (*number, instance));
            work.add_block(number, instances, &[HalfSpace::new(DVec4::X)]).unwrap();
        }
        work.add_draw(MeshHandle { index: 0, generation: 0 }, &facts, 0..work.blocks());
        work.widen(room);
    };
    assert!(measure(|| write(15)).count_total > 0, "the counter counts");
    for blocks in [20, 10, 30, 1] {
        assert_eq!(measure(|| write(blocks)).count_total, 0, "{blocks} blocks");
    }
    assert!(measure(|| write(37)).count_total > 0, "more than twice as much");
}
