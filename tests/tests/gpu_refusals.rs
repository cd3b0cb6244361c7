//! Input that makes no sense is a typed error that says what to change, and the last good frame stays usable.

use cssm_core::View;
use cssm_core::case::DepthFormat;
use cssm_core::glam::{DAffine3, DMat3, DVec3, DVec4};
use cssm_core::plan::DepthOrder;
use cssm_core::table::{CaseTable, ShaderKind};
use cssm_runtime::{
    CasterInstance, MaskInputs, MeshDescription, MeshError, Options, ServiceError, ShadowService,
    features_and_limits, wgpu,
};
use cssm_tests::gpu::hand::{four_facet_table, plan_from_above, table};
use cssm_tests::gpu::{Geometry, TestDevice, casters, exclusive, images};

fn service(gpu: &TestDevice) -> ShadowService {
    let table = table(DepthFormat::Depth32Float);
    ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap()
}

fn view() -> View {
    View::perspective(DVec3::ZERO, DVec3::NEG_Y, DVec3::X, 1.0, 0.1, 100.0, (64, 64)).unwrap()
}

#[test]
fn meshes_that_make_no_sense() {
    let gpu = exclusive();
    let mut service = service(&gpu);
    let good = Geometry::cuboid([-1.0; 3], [1.0; 3]).upload(&gpu);
    let mut refuse = |change: &dyn Fn(&mut MeshDescription)| {
        let mut description = good.description();
        change(&mut description);
        match service.add_mesh(&description) {
            Err(ServiceError::Mesh(error)) => error,
            other => panic!("{other:?}"),
        }
    };

    assert_eq!(refuse(&|mesh| mesh.vertex_count = 0), MeshError::Empty);
    assert_eq!(refuse(&|mesh| mesh.indices.as_mut().unwrap().count = 0), MeshError::Empty);
    assert_eq!(
        refuse(&|mesh| mesh.indices.as_mut().unwrap().count = 35),
        MeshError::NotTriangles { corners: 35 }
    );
    assert_eq!(refuse(&|mesh| mesh.indices = None), MeshError::NotTriangles { corners: 8 });
    let format = wgpu::VertexFormat::Sint16x4;
    assert_eq!(refuse(&|mesh| mesh.position_format = format), MeshError::Format(format));
    for stride in [0, 8, 13, 14, 1 << 20] {
        let error = refuse(&|mesh| mesh.stride_bytes = stride);
        assert!(matches!(error, MeshError::Stride { stride_bytes, .. } if stride_bytes == stride), "{error}");
    }
    assert!(matches!(refuse(&|mesh| mesh.position_offset_bytes = u32::MAX), MeshError::Stride { .. }));
    assert!(matches!(
        refuse(&|mesh| mesh.vertices_offset_bytes = 2),
        MeshError::Alignment { what: "vertices", .. }
    ));
    let odd = |mesh: &mut MeshDescription| mesh.indices.as_mut().unwrap().offset_bytes = 6;
    assert!(matches!(refuse(&odd), MeshError::Alignment { what: "indices", .. }));
    let error = refuse(&|mesh| mesh.vertex_count = 9);
    assert_eq!(error, MeshError::OutOfRange { what: "vertices", end_bytes: 108, size_bytes: 96 });
    let far = |mesh: &mut MeshDescription| mesh.vertices_offset_bytes = u64::MAX - 3;
    assert!(matches!(refuse(&far), MeshError::OutOfRange { .. }));
    let long = |mesh: &mut MeshDescription| mesh.indices.as_mut().unwrap().count = 39;
    assert!(matches!(refuse(&long), MeshError::OutOfRange { what: "indices", .. }));
    let swapped = good.indices.clone();
    let error = match service.add_mesh(&MeshDescription { vertices: &swapped, ..good.description() }) {
        Err(ServiceError::Mesh(error)) => error,
        other => panic!("{other:?}"),
    };
    assert_eq!(error, MeshError::Usage { what: "vertices", usage: wgpu::BufferUsages::VERTEX });
    for bad in [f64::NAN, f64::INFINITY, 2.0] {
        let mut description = good.description();
        description.bounds_object.min.x = bad;
        let refused = service.add_mesh(&description);
        assert!(matches!(refused, Err(ServiceError::Mesh(MeshError::Bounds))), "{refused:?}");
    }
    service.add_mesh(&good.description()).unwrap();
}

#[test]
fn instances_that_make_no_sense_leave_the_last_frame_usable() {
    let gpu = exclusive();
    let mut service = service(&gpu);
    let buffers = Geometry::cuboid([-1.0; 3], [1.0; 3]).upload(&gpu);
    let mesh = service.add_mesh(&buffers.description()).unwrap();
    let (view, at) = (view(), DAffine3::from_translation);
    let plan = plan_from_above(&view, 16.0, 40.0, -10.0);
    let good = CasterInstance { mesh, world_from_object: DAffine3::IDENTITY };
    let frame = service.prepare(&plan, &view, &[good]).unwrap();

    for place in [DVec3::NAN, DVec3::X * f64::INFINITY, DVec3::Y * 1e39] {
        let bad = CasterInstance { mesh, world_from_object: at(place) };
        let refused = service.prepare(&plan, &view, &[good, good, bad]);
        assert!(matches!(refused, Err(ServiceError::Transform { instance: 2 })), "{refused:?}");
    }
    let gone = service.add_mesh(&buffers.description()).unwrap();
    assert!(service.remove_mesh(gone));
    assert!(!service.remove_mesh(gone));
    let refused = service.prepare(&plan, &view, &[good, CasterInstance { mesh: gone, ..good }]);
    assert!(matches!(refused, Err(ServiceError::UnknownMesh { instance: 1 })), "{refused:?}");
    let again = service.add_mesh(&buffers.description()).unwrap();
    assert_ne!(gone, again, "the place is reused, the handle is not");

    // The good frame still draws; without its mesh it is refused before anything is recorded.
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    assert!(service.read_map().unwrap().iter().any(|depth| *depth < 1.0));
    service.remove_mesh(mesh);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    assert!(matches!(service.capture(&mut encoder, &frame, None), Err(ServiceError::StaleFrame { .. })));
    gpu.queue.submit([encoder.finish()]);
}

#[test]
fn plans_and_views_that_do_not_belong() {
    let gpu = exclusive();
    let mut service = service(&gpu);
    let view = view();
    let good = plan_from_above(&view, 16.0, 40.0, -10.0);
    service.prepare(&good, &view, &[]).unwrap();
    let changes: [&dyn Fn(&mut cssm_core::ShadowPlan); 12] = [
        &|plan| plan.map_size_texels.0 = 65,
        &|plan| plan.facets[0].cells = vec![1],
        &|plan| plan.facets.push(plan.facets[0].clone()),
        &|plan| plan.selection.borders.push(DVec4::X),
        &|plan| plan.selection.distances.push(DVec4::X),
        &|plan| plan.selection.thresholds.push(1.0),
        &|plan| plan.facets[0].tile.x = u32::MAX,
        &|plan| plan.facets[0].tile.height = 0,
        &|plan| plan.facets[0].rows.z.w = f64::NAN,
        &|plan| plan.facets[0].clip.push(DVec4::W),
        &|plan| plan.shear.x = f64::INFINITY,
        &|plan| plan.depth_order = DepthOrder::Reversed,
    ];
    for (number, change) in changes.iter().enumerate() {
        let mut plan = good.clone();
        change(&mut plan);
        let refused = service.prepare(&plan, &view, &[]);
        assert!(matches!(refused, Err(ServiceError::ForeignPlan { .. })), "change {number}: {refused:?}");
    }
    let elsewhere = View { eye_world: DVec3::X, ..view };
    assert!(matches!(service.prepare(&good, &elsewhere, &[]), Err(ServiceError::ForeignView)));
    let camera_from_world = DMat3::from_rotation_z(1e-9) * view.camera_from_world;
    let turned = View { camera_from_world, ..view };
    assert!(matches!(service.prepare(&good, &turned, &[]), Err(ServiceError::ForeignView)));
}

#[test]
fn tables_that_the_device_cannot_run() {
    let gpu = exclusive();
    let good = table(DepthFormat::Depth32Float);
    let new = |table: &CaseTable| ShadowService::new(&gpu.device, &gpu.queue, table, &Options::default());

    // Limits: told before there is a device, and again by the service.
    let mut large = good.clone();
    large.map_width = 1 << 20;
    assert!(matches!(features_and_limits(&gpu.adapter, &large), Err(ServiceError::MapTooLarge { .. })));
    let mut exceeding = good.clone();
    exceeding.map_height = gpu.device.limits().max_texture_dimension_2d + 1;
    assert!(matches!(new(&exceeding), Err(ServiceError::MapTooLarge { .. })));
    let needed = features_and_limits(&gpu.adapter, &exceeding).unwrap();
    assert_eq!(needed.limits.max_texture_dimension_2d, exceeding.map_height);
    let mut distant = good.clone();
    for group in distant.groups.to_mut() {
        group.group += 60;
    }
    assert!(matches!(features_and_limits(&gpu.adapter, &distant), Err(ServiceError::GroupTooLarge { .. })));

    // Tables that code generation has not filled, or that contradict themselves.
    let mut unfilled = good.clone();
    unfilled.shaders = Vec::new().into();
    assert!(matches!(new(&unfilled), Err(ServiceError::IncompleteTable { .. })));
    let mut passless = good.clone();
    passless.passes = Vec::new().into();
    assert!(matches!(new(&passless), Err(ServiceError::IncompleteTable { .. })));
    let mut groupless = good.clone();
    groupless.groups = Vec::new().into();
    assert!(matches!(new(&groupless), Err(ServiceError::IncompleteTable { .. })));
    let mut stretched = good.clone();
    stretched.bands = 4;
    assert!(matches!(new(&stretched), Err(ServiceError::IncompleteTable { .. })));

    // Shaders that the device refuses, at whatever stage.
    for (kind, wgsl) in [
        (ShaderKind::Capture, "not wgsl"),
        (ShaderKind::Capture, "@vertex fn another() -> @builtin(position) vec4<f32> { return vec4<f32>(); }"),
        (ShaderKind::Mask, "@fragment fn only() {}"),
    ] {
        let mut faulty = good.clone();
        for shader in faulty.shaders.to_mut() {
            if shader.kind == kind
                || (kind == ShaderKind::Capture && shader.kind == ShaderKind::CaptureClamped)
            {
                shader.wgsl = wgsl.into();
            }
        }
        let refused = new(&faulty);
        assert!(matches!(refused, Err(ServiceError::Refused { .. })), "{refused:?}");
    }

    // A mask target that cannot be rendered to.
    let options = Options { mask_format: wgpu::TextureFormat::Rgb9e5Ufloat, ..Options::default() };
    let refused = ShadowService::new(&gpu.device, &gpu.queue, &good, &options);
    assert!(matches!(refused, Err(ServiceError::Refused { .. })), "{refused:?}");
}

#[test]
fn masks_that_are_not_declared_or_get_other_textures() {
    let gpu = exclusive();
    let view = view();
    let target =
        images::target(&gpu, (64, 64), wgpu::TextureFormat::R8Unorm).create_view(&Default::default());
    let depth =
        images::target(&gpu, (64, 64), wgpu::TextureFormat::R32Float).create_view(&Default::default());
    let inputs = MaskInputs { depth: &depth, normal: None };
    let mut encoder = gpu.device.create_command_encoder(&Default::default());

    // The texture has no TEXTURE_BINDING usage.
    let mut with_mask = service(&gpu);
    let frame = with_mask.prepare(&plan_from_above(&view, 16.0, 40.0, -10.0), &view, &[]).unwrap();
    let refused = with_mask.mask(&mut encoder, &frame, &inputs, &target, None);
    assert!(matches!(refused, Err(ServiceError::Refused { .. })), "{refused:?}");

    // The case declares no mask.
    let table = four_facet_table();
    let mut without = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let mut plan = plan_from_above(&view, 16.0, 40.0, -10.0);
    plan.selection.distances = vec![DVec4::X];
    plan.selection.thresholds = vec![1.0, 2.0, 3.0];
    plan.selection.bands = 4;
    let frame = without.prepare(&plan, &view, &[]).unwrap();
    let refused = without.mask(&mut encoder, &frame, &inputs, &target, None);
    assert!(matches!(refused, Err(ServiceError::NotDeclared { .. })), "{refused:?}");
    gpu.queue.submit([encoder.finish()]);
}

#[test]
fn a_buffer_of_vertices_may_start_anywhere_in_the_engines_own_buffer() {
    let gpu = exclusive();
    let mut service = service(&gpu);

    // Twenty bytes of something else, then vertices of 24 bytes with the position at byte 8, not indexed.
    let corners = [[0.0_f32, 5.0, -8.0], [8.0, 5.0, -8.0], [0.0, 5.0, 0.0]];
    let mut bytes = vec![0xFF; 20];
    for corner in corners {
        bytes.extend([0xFF; 8]);
        bytes.extend(corner.iter().flat_map(|value| value.to_le_bytes()));
        bytes.extend([0xFF; 4]);
    }
    let vertices = casters::buffer(&gpu, &bytes, wgpu::BufferUsages::VERTEX);
    let mesh = service.add_mesh(&MeshDescription {
        vertices: &vertices,
        vertices_offset_bytes: 20,
        vertex_count: 3,
        stride_bytes: 24,
        position_offset_bytes: 8,
        position_format: wgpu::VertexFormat::Float32x3,
        indices: None,
        bounds_object: Geometry::triangle(corners).bounds(),
        clusters: &[],
        mask: None,
    });
    let view = view();
    let plan = plan_from_above(&view, 16.0, 40.0, -10.0);
    let casters = [CasterInstance { mesh: mesh.unwrap(), world_from_object: DAffine3::IDENTITY }];
    let frame = service.prepare(&plan, &view, &casters).unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    let map = service.read_map().unwrap();
    let covered = map.iter().filter(|depth| **depth < 1.0).count();
    assert_eq!(
        covered,
        16 * 15 / 2 + 16 - 16 / 2 - 8,
        "half of 16 by 16 texels, the diagonal's centres aside"
    );
    assert!(map.iter().all(|depth| *depth == 1.0 || (depth - 0.7).abs() < 1e-6));
}
