//! Command lists without a device.

use cssm_core::choose::{ChoiceReason, ConfigurationChoice};
use cssm_core::facet::{Facet, FacetRows, Selection, Tile};
use cssm_core::fit::Cut;
use cssm_core::glam::{DAffine3, DMat3, DVec2, DVec3, DVec4};
use cssm_core::light::LightPosition;
use cssm_core::plan::{DepthOrder, MapRegion, PlanBasis};
use cssm_core::remap::Remap;
use cssm_core::{BoundingBox, Light, ShadowPlan};

use super::*;

mod clusters;
mod fans;

const EYE: DVec3 = DVec3::new(5e6, 2.0, -1e3);

fn handle(index: u32) -> MeshHandle {
    MeshHandle { index, generation: 0 }
}

/// Meshes 0 and 2 share a pipeline, mesh 1 has its own and no indices; there is no mesh 3.
fn facts(mesh: MeshHandle) -> Option<MeshFacts<'static>> {
    let bounds_object = BoundingBox { min: DVec3::splat(-1.0), max: DVec3::splat(1.0) };
    let facts = |pipeline, corners, indexed| MeshFacts {
        pipeline: PipelineHandle(pipeline),
        corners,
        indexed,
        first_index: 0,
        bounds_object,
        clusters: &[],
        drawing: Drawing::Plain,
    };
    match mesh.index {
        0 => Some(facts(0, 36, true)),
        1 => Some(facts(1, 3, false)),
        2 => Some(facts(0, 12, true)),
        _ => None,
    }
}

/// A facet that casters with x in a range reach.
fn facet(index: u32, low: f64, high: f64) -> Facet {
    Facet {
        cells: vec![index],
        rows: FacetRows { x: DVec4::X, y: DVec4::Y, z: DVec4::Z, w: DVec4::W, remap: Remap::NONE },
        select: Vec::new(),
        clip: Vec::new(),
        tile: Tile { x: 10 * index, y: 0, width: 10, height: 20, gutter: 1 },
        receivers: Vec::new(),
        casters: vec![DVec4::new(1.0, 0.0, 0.0, -low), DVec4::new(-1.0, 0.0, 0.0, high)],
        depth_per_metre: 1.0,
        texel_metres_per_w: 1.0,
        receiver_plane_depth: 0.0,
        rounding_depth: 0.0,
    }
}

fn plan(facets: Vec<Facet>) -> ShadowPlan {
    ShadowPlan {
        configuration: "by hand",
        choice: ConfigurationChoice {
            position: LightPosition::General,
            configuration: "by hand",
            reason: ChoiceReason::Only,
            predictions: Vec::new(),
            complete: true,
            fallback: None,
            made_for_position: Vec::new(),
        },
        eye_world: EYE,
        camera_from_world: DMat3::IDENTITY,
        shear: DVec2::ZERO,
        pixel_metres: DVec4::ZERO,
        depth_order: DepthOrder::Standard,
        light: DVec4::Z,
        map_size_texels: (100, 20),
        region: MapRegion { x: 0, y: 0, width: 100, height: 20 },
        basis: PlanBasis {
            light: Light::Directional { toward_light_world: DVec3::Z },
            follows_camera: false,
            receivers: Vec::new(),
            cut: Cut::None,
            lit: Vec::new(),
            ground_planes: [None; 4],
            samples: 0,
            p95_pixels: 1.0,
        },
        selection: Selection::single(),
        facets,
    }
}

fn at(mesh: u32, x: f64) -> CasterInstance {
    let world_from_object = DAffine3::from_translation(EYE + DVec3::X * x);
    CasterInstance { mesh: handle(mesh), world_from_object }
}

#[test]
fn one_draw_covers_all_instances_of_a_mesh_in_a_facet() {
    let plan = plan(vec![facet(0, 0.0, 10.0), facet(2, 10.0, 20.0)]);
    let casters = [at(1, 5.0), at(0, 15.0), at(2, 4.0), at(0, 6.0), at(1, 10.5), at(0, 3.0)];
    let (frame, statistics) = FrameCommands::build(&plan, &casters, facts).unwrap();
    let tile = |index: u32| Tile { x: 10 * index, y: 0, width: 10, height: 20, gutter: 1 };
    let draw = |count, indexed, instances| Command::Draw { first: 0, count, indexed, instances };
    let expected = [
        Command::Facet { facet: FacetHandle(0), tile: tile(0) },
        Command::Pipeline(PipelineHandle(0)),
        Command::Mesh(handle(0)),
        draw(36, true, 0..2),
        Command::Mesh(handle(2)),
        draw(12, true, 2..3),
        Command::Pipeline(PipelineHandle(1)),
        Command::Mesh(handle(1)),
        draw(3, false, 3..5),
        Command::Facet { facet: FacetHandle(1), tile: tile(2) },
        Command::Pipeline(PipelineHandle(0)),
        Command::Mesh(handle(0)),
        draw(36, true, 5..6),
        Command::Pipeline(PipelineHandle(1)),
        Command::Mesh(handle(1)),
        draw(3, false, 6..7),
    ];
    assert_eq!(frame.commands, expected);

    // Rows follow the draws; within a mesh neighbours lie side by side.
    let shifts: Vec<f32> = frame.rows.iter().map(|rows| rows.0[0][3]).collect();
    assert_eq!(shifts, [3.0, 6.0, 4.0, 5.0, 10.5, 15.0, 10.5]);
    let mut scene = CasterScene::new();
    assert!(scene.update(&casters, facts).unwrap());
    let content = |facet| FrameCommands::content(&plan, facet, &scene, &mut CommandScratch::default());
    let facets = [
        FacetStatistics { facet: 0, draws: 3, instances: 5, triangles: 2 * 12 + 4 + 2, content: content(0) },
        FacetStatistics { facet: 2, draws: 2, instances: 2, triangles: 12 + 1, content: content(1) },
    ];
    let total =
        FrameStatistics { casters: 6, draws: 5, instances: 7, triangles: 43, facets: facets.to_vec() };
    assert_eq!(statistics, total);
}

#[test]
fn neighbours_are_refused_together_but_none_too_many() {
    let step = |number: u32, prime: u32| f64::from(number * prime % 1000) * 0.04;
    let casters: Vec<_> = (0..600)
        .map(|number| {
            let place = DVec3::new(step(number, 7), step(number, 31), step(number, 173));
            CasterInstance { mesh: handle(0), world_from_object: DAffine3::from_translation(EYE + place) }
        })
        .collect();
    let mut slanted = facet(0, 5.0, 20.0);
    slanted.casters.push(DVec4::new(0.25, -1.0, 0.25, 12.3));
    let facets = vec![facet(0, 0.0, 10.0), slanted, facet(2, 39.0, 50.0)];
    let (frame, statistics) = FrameCommands::build(&plan(facets.clone()), &casters, facts).unwrap();
    for (facet, counts) in facets.iter().zip(&statistics.facets) {
        let reaches = |caster: &&CasterInstance| {
            let centre = caster.world_from_object.translation - EYE;
            facet.reached_by(&BoundingBox { min: centre - DVec3::ONE, max: centre + DVec3::ONE })
        };
        assert_eq!(counts.instances, casters.iter().filter(reaches).count() as u64);
        assert!((20..500).contains(&counts.instances), "{} of 600", counts.instances);
    }
    assert_eq!(frame.rows.len() as u64, statistics.instances);
}

#[test]
fn boxes_beyond_a_sharp_edge_are_refused() {
    // The wedge |y| <= x / 4: boxes before its edge cross both half-spaces for some length.
    let mut wedge = facet(0, 0.0, 1.0);
    wedge.casters = vec![DVec4::new(0.5, 2.0, 0.0, 0.0), DVec4::new(1.0, -4.0, 0.0, 0.0)];
    let at = |x: f64, y: f64| CasterInstance {
        mesh: handle(0),
        world_from_object: DAffine3::from_translation(EYE + DVec3::new(x, y, 0.0)),
    };
    let is_drawn =
        |caster| FrameCommands::build(&plan(vec![wedge.clone()]), &[caster], facts).unwrap().1.instances == 1;
    assert!(
        wedge.reached_by(&BoundingBox { min: DVec3::new(-4.9, -1.0, -1.0), max: DVec3::new(-2.9, 1.0, 1.0) })
    );
    assert!(!is_drawn(at(-3.9, 0.0)) && !is_drawn(at(-1.01, 0.0)));

    // What touches the wedge is drawn, on its sides too.
    assert!(is_drawn(at(-0.99, 0.0)) && is_drawn(at(4.0, 2.2)) && !is_drawn(at(4.0, 2.3)));
}

#[test]
fn what_stays_bound_is_not_bound_again() {
    let plan = plan(vec![facet(0, 0.0, 10.0), facet(1, 0.0, 10.0), facet(2, 50.0, 60.0)]);
    let (frame, statistics) = FrameCommands::build(&plan, &[at(0, 5.0)], facts).unwrap();
    let binds =
        frame.commands.iter().filter(|command| matches!(command, Command::Pipeline(_) | Command::Mesh(_)));
    assert_eq!(binds.count(), 2);
    assert_eq!(frame.meshes().collect::<Vec<_>>(), [handle(0)]);
    assert_eq!(statistics.facets.iter().map(|facet| facet.draws).collect::<Vec<_>>(), [1, 1, 0]);
}

#[test]
fn no_casters_no_commands() {
    let (frame, statistics) = FrameCommands::build(&plan(vec![facet(0, 0.0, 1.0)]), &[], facts).unwrap();
    assert_eq!(frame, FrameCommands::default());
    assert_eq!((statistics.draws, statistics.facets.len()), (0, 1));
}

#[test]
fn boxes_turn_and_scale_with_their_instance() {
    let plan = plan(vec![facet(0, 0.0, 10.0)]);
    let turned = |half: f64, x: f64| {
        let turn = DMat3::from_rotation_z(std::f64::consts::FRAC_PI_4) * half;
        let world_from_object = DAffine3 { matrix3: turn, translation: EYE + DVec3::X * x };
        CasterInstance { mesh: handle(0), world_from_object }
    };
    let drawn = |caster| FrameCommands::build(&plan, &[caster], facts).unwrap().1.draws;
    // A turned cube reaches half the square root of two times its side.
    assert_eq!(drawn(turned(1.0, -1.41)), 1);
    assert_eq!(drawn(turned(1.0, -1.42)), 0);
    assert_eq!(drawn(turned(10.0, -14.1)), 1);
}

#[test]
fn the_eye_is_subtracted_before_rounding() {
    // 5e6 m from the origin f32 holds half metres; relative to the eye it holds micrometres.
    let (frame, _) =
        FrameCommands::build(&plan(vec![facet(0, 0.0, 10.0)]), &[at(0, 1.000_001)], facts).unwrap();
    assert!((f64::from(frame.rows[0].0[0][3]) - 1.000_001).abs() < 1e-6);
}

#[test]
fn casters_of_the_world_are_as_exact_as_those_of_the_eye() {
    // Ten thousand kilometres from the origin: a millimetre beside the facet is seen, in rows a micrometre.
    const FAR: DVec3 = DVec3::new(-1e7, 1e7, 1e7);
    let far = ShadowPlan { eye_world: FAR, ..plan(vec![facet(0, 0.0, 10.0)]) };
    let at = |x: f64| CasterInstance {
        mesh: handle(0),
        world_from_object: DAffine3::from_translation(FAR + DVec3::X * x),
    };
    let drawn = |x: f64| FrameCommands::build(&far, &[at(x)], facts).unwrap().0.rows;
    assert_eq!(drawn(-1.001), []);
    let rows = drawn(-0.999_001);
    assert!((f64::from(rows[0].0[0][3]) + 0.999_001).abs() < 1e-6, "{rows:?}");
}

#[test]
fn a_list_is_rebuilt_for_some_facets() {
    let plan = plan(vec![facet(0, 0.0, 10.0), facet(1, 10.0, 20.0), facet(2, 20.0, 30.0)]);
    let casters = [at(0, 5.0), at(1, 15.0), at(2, 25.0), at(0, 26.0)];
    let mut scene = CasterScene::new();
    scene.update(&casters, facts).unwrap();
    let (mut frame, mut counts) = FrameCommands::build(&plan, &casters, facts).unwrap();
    let all = frame.clone();
    let mut scratch = CommandScratch::default();
    let mut rebuild = |facets: &[usize], scene: &CasterScene| {
        let facets = facets.iter().copied();
        let rebuilt = frame.rebuild(&plan, facets, scene, facts, &mut scratch, &mut counts);
        (rebuilt, frame.clone(), counts.clone())
    };

    let (_, some, counts) = rebuild(&[2, 0, 7], &scene);
    assert_eq!(counts.facets.iter().map(|facet| facet.facet).collect::<Vec<_>>(), [2, 0]);
    assert_eq!((counts.casters, counts.instances), (4, 3));
    assert!(matches!(some.commands[0], Command::Facet { facet: FacetHandle(2), .. }));
    assert_eq!(rebuild(&[0, 1, 2], &scene).1, all);

    // Two lists of casters, one after the other.
    let mut other = CasterScene::new();
    other.update(&casters[..1], facts).unwrap();
    let (mut both, mut counts) = (FrameCommands::default(), FrameStatistics::default());
    for scene in [&scene, &other] {
        both.append(&plan, 0..1, scene, facts, &mut CommandScratch::default(), &mut counts).unwrap();
    }
    assert_eq!((both.rows.len(), both.rows[0] == both.rows[1]), (2, true));

    // A mesh that has gone since leaves nothing half built.
    let gone = |mesh: MeshHandle| facts(mesh).filter(|_| mesh.index != 2);
    let refused = frame.rebuild(&plan, 0..3, &scene, gone, &mut scratch, &mut counts);
    assert!(matches!(refused, Err(ServiceError::UnknownMesh { instance: 2 | 3 })), "{refused:?}");
    assert_eq!((frame, counts), (FrameCommands::default(), FrameStatistics::default()));
}

#[test]
fn content_changes_when_a_facet_has_to_be_drawn_anew() {
    let plan = plan(vec![facet(0, 0.0, 10.0), facet(1, 10.0, 20.0)]);
    let content = |casters: &[CasterInstance]| {
        let mut scene = CasterScene::new();
        scene.update(casters, facts).unwrap();
        [0, 1].map(|facet| FrameCommands::content(&plan, facet, &scene, &mut CommandScratch::default()))
    };
    let before = content(&[at(0, 5.0), at(0, 15.0), at(0, 6.0)]);
    assert_eq!(content(&[at(0, 6.0), at(0, 5.0), at(0, 15.0)]), before, "order tells nothing");
    assert_eq!(content(&[at(0, 5.0), at(0, 15.0), at(0, 6.0), at(1, 50.0)]), before, "out of reach");
    let moved = content(&[at(0, 5.0), at(0, 15.0), at(0, 6.0 + 1e-9)]);
    assert!(moved[0] != before[0] && moved[1] == before[1]);
    let exchanged = content(&[at(0, 5.0), at(2, 15.0), at(0, 6.0)]);
    assert!(exchanged[0] == before[0] && exchanged[1] != before[1]);
    let twice = content(&[at(0, 5.0), at(0, 15.0), at(0, 6.0), at(0, 6.0)]);
    assert!(twice[0] != before[0]);
    assert_eq!(content(&[at(0, 50.0)]), [0, 0]);

    // Another mesh in the same place of the service's list is another mesh.
    let facts = |mesh: MeshHandle| facts(MeshHandle { generation: 0, ..mesh });
    let of_generation = |generation| {
        let mesh = MeshHandle { index: 0, generation };
        let mut scene = CasterScene::new();
        scene.update(&[CasterInstance { mesh, ..at(0, 5.0) }], facts).unwrap();
        FrameCommands::content(&plan, 0, &scene, &mut CommandScratch::default())
    };
    assert_ne!(of_generation(0), of_generation(1));
}

#[test]
fn rows_are_in_camera_axes_and_culling_is_not() {
    // A camera that looks along world x, with y up: camera x is world z, camera z is world -x.
    let camera_from_world = DMat3::from_cols(DVec3::NEG_Z, DVec3::Y, DVec3::X);
    let shear = DVec2::new(0.5, -2.0);
    let plan = ShadowPlan { camera_from_world, shear, ..plan(vec![facet(0, 0.0, 10.0)]) };
    let turn = DMat3::from_rotation_y(0.3) * 2.0;
    let place = DAffine3 { matrix3: turn, translation: EYE + DVec3::new(9.0, 1.0, 2.0) };
    let caster = CasterInstance { mesh: handle(0), world_from_object: place };
    let (frame, statistics) = FrameCommands::build(&plan, &[caster, at(0, -9.0)], facts).unwrap();
    assert_eq!(statistics.instances, 1, "the facet's own range of x is the world's");

    let rows = frame.rows[0].0.map(|row| DVec4::from_array(row.map(f64::from)));
    let object = DVec3::new(0.5, -0.25, 1.0);
    let from_eye = place.transform_point3(object) - EYE;
    let seen = camera_from_world * from_eye;
    assert!((seen - DVec3::new(from_eye.z, from_eye.y, -from_eye.x)).length() < 1e-9);
    let expected = seen + (shear * seen.z).extend(0.0);
    let device = DVec3::from_array(rows.map(|row| row.dot(object.extend(1.0))));
    assert!(device.distance(expected) < 1e-6, "{device} for {expected}");
}

#[test]
fn the_instance_at_fault_is_named() {
    let plan = plan(vec![facet(0, 0.0, 10.0)]);
    let unknown = FrameCommands::build(&plan, &[at(0, 1.0), at(3, 1.0)], facts);
    assert!(matches!(unknown, Err(ServiceError::UnknownMesh { instance: 1 })));
    for x in [f64::NAN, f64::NEG_INFINITY, 1e300] {
        let bad = FrameCommands::build(&plan, &[at(0, 1.0), at(1, 1.0), at(2, x)], facts);
        assert!(matches!(bad, Err(ServiceError::Transform { instance: 2 })), "{x}");
    }
}
