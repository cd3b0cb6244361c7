//! Casters with an alpha mask draw what the same holes cut into triangles draw, by both capture shaders; masks that make
//! no sense are refused.

use cssm_codegen::generate;
use cssm_core::case::{Casters, LightCase};
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::table::ShaderKind;
use cssm_core::twin::DepthMap;
use cssm_core::{SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{
    AlphaMask, CasterInstance, MeshDescription, MeshError, MeshHandle, Options, ServiceError, ShadowService,
    wgpu,
};
use cssm_tests::gpu::checkered::{CheckeredBuffers, CheckeredQuad, UvLayout};
use cssm_tests::gpu::depth_bracket::DepthBracket;
use cssm_tests::gpu::yard::{ORIGIN, suns, views};
use cssm_tests::gpu::{Geometry, TestDevice, Yard, dueling, exclusive, images, new_device};

/// Share of the quads' texels that may leave the bracket: samplers place texels to 1/256 of their size.
const MASK_EDGES: f64 = 2e-3;

fn case(casters: Casters) -> LightCase {
    LightCase::builder("Leaves").map_size_texels(512, 512).casters(casters).build().unwrap()
}

fn quad() -> CheckeredQuad {
    CheckeredQuad::new([-4.0, 0.5, -9.0], [8.0, 0.0, 1.0], [0.0, 6.0, -2.0])
}

/// Ground, and the quad at two places.
fn yard(quad: Geometry) -> Yard {
    let at = |x: f64, z: f64| DAffine3::from_translation(ORIGIN + DVec3::new(x, 0.0, z));
    let geometries = vec![Geometry::ground(200.0, 8), quad];
    Yard { geometries, places: vec![(0, at(0.0, 0.0)), (1, at(0.0, 0.0)), (1, at(3.0, -14.0))] }
}

fn add(
    gpu: &TestDevice,
    service: &mut ShadowService,
    quad: &MeshDescription,
) -> Result<(MeshHandle, Vec<CasterInstance>), ServiceError> {
    let quad = service.add_mesh(quad)?;
    let yard = yard(Geometry::default());
    let ground = service.add_mesh(&yard.geometries[0].upload(gpu).description())?;
    let instance = |(shape, world_from_object): &(usize, DAffine3)| CasterInstance {
        mesh: if *shape == 0 { ground } else { quad },
        world_from_object: *world_from_object,
    };
    Ok((quad, yard.places.iter().map(instance).collect()))
}

fn captured(
    gpu: &TestDevice,
    service: &mut ShadowService,
    casters: &[CasterInstance],
    plan: &ShadowPlan,
    view: &View,
) -> DepthMap {
    let frame = service.prepare(plan, view, casters).unwrap();
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    let depths = service.read_map().unwrap().into_iter().map(f64::from).collect();
    DepthMap { width: 512, height: 512, depths }
}

#[test]
fn a_mask_cuts_the_holes_that_triangles_would() {
    let (gpu, quad) = (exclusive(), quad());
    let (cut, whole) = (yard(quad.cut.clone()), yard(quad.whole.clone()));
    // Facets with tiles of their own, and facets that share one and are cut themselves.
    for (configuration, layout) in [
        ("face_columns", UvLayout::Floats),
        ("face_columns", UvLayout::Interleaved),
        ("four_plane", UvLayout::Floats),
    ] {
        let columns = configuration == "face_columns";
        let case = LightCase::builder("Leaves").configurations(&[configuration]).map_size_texels(512, 512);
        let case = case.casters(Casters::AlphaTested).build().unwrap();
        let table = generate(&case).unwrap().table;
        let buffers = quad.upload(&gpu, layout);
        for clamp_in_fragments in [false, true] {
            let options = Options { clamp_in_fragments, ..Options::default() };
            let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &options).unwrap();
            let (_, casters) = add(&gpu, &mut service, &buffers.description()).unwrap();
            let (mut wrong, mut without, mut texels) = (0, 0, 0);
            for (turn, view) in views((160, 90)).iter().enumerate() {
                let sun = if columns { suns()[turn] } else { dueling::suns(view)[turn] };
                let plan = plan(&case, view, &sun, &SceneBounds::default()).unwrap();
                let map = captured(&gpu, &mut service, &casters, &plan, view);
                wrong += DepthBracket::new(&cut, &plan, case.map.format).violations(&map);
                // Negative control: the quad without its mask.
                without += DepthBracket::new(&whole, &plan, case.map.format).violations(&map);
                texels += map.depths.len();
            }
            let what = format!(
                "{configuration} {layout:?}, clamped {clamp_in_fragments}: {wrong}, {without} of {texels}"
            );
            assert!(without > texels / 200, "{what}");
            assert!(wrong as f64 <= 1.0 + MASK_EDGES * without as f64, "{what}");
        }
    }
}

#[test]
fn both_capture_shaders_cut_the_same_holes() {
    let (gpu, quad) = (exclusive(), quad());
    let case = case(Casters::AlphaTested);
    let table = generate(&case).unwrap().table;
    let buffers = quad.upload(&gpu, UvLayout::Floats);
    let view = &views((160, 90))[0];
    let mut maps = Vec::new();
    for clamp_in_fragments in [false, true] {
        let options = Options { clamp_in_fragments, ..Options::default() };
        let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &options).unwrap();
        if gpu.device.features().contains(wgpu::Features::DEPTH_CLIP_CONTROL) {
            assert_eq!(service.capture_shader() == ShaderKind::CaptureClamped, clamp_in_fragments);
        }
        let (_, casters) = add(&gpu, &mut service, &buffers.description()).unwrap();
        let plan = plan(&case, view, &suns()[0], &SceneBounds::default()).unwrap();
        maps.push(captured(&gpu, &mut service, &casters, &plan, view).depths);
    }
    let differing = maps[0].iter().zip(&maps[1]).filter(|(one, other)| (*one - *other).abs() > 2e-6).count();
    assert!(differing * 10_000 <= maps[0].len(), "{differing} texels differ");
}

#[test]
fn masked_meshes_are_removed_and_rebuilt_as_others_are() {
    let first = new_device(wgpu::Features::all());
    let case = case(Casters::AlphaTested);
    let table = generate(&case).unwrap().table;
    let view = &views((160, 90))[0];
    let plan = plan(&case, view, &suns()[0], &SceneBounds::default()).unwrap();
    let mut service = ShadowService::new(&first.device, &first.queue, &table, &Options::default()).unwrap();
    let upload = |gpu: &TestDevice| quad().upload(gpu, UvLayout::Floats);
    let (mesh, casters) = add(&first, &mut service, &upload(&first).description()).unwrap();
    let before = captured(&first, &mut service, &casters, &plan, view);

    // Removing makes the handle unknown and its frames stale; a mesh without a mask may take the place.
    let frame = service.prepare(&plan, view, &casters).unwrap();
    assert!(service.remove_mesh(mesh));
    let mut encoder = first.device.create_command_encoder(&Default::default());
    assert!(matches!(service.capture(&mut encoder, &frame, None), Err(ServiceError::StaleFrame { .. })));
    drop(encoder);
    let plain = quad().whole.upload(&first);
    let (_, unmasked) = add(&first, &mut service, &plain.description()).unwrap();
    assert_ne!(captured(&first, &mut service, &unmasked, &plan, view), before);

    // Another device draws the same map.
    let late = upload(&first);
    first.device.destroy();
    assert!(matches!(service.add_mesh(&late.description()), Err(ServiceError::DeviceLost)));
    let second = new_device(wgpu::Features::all());
    service.rebuild(&second.device, &second.queue).unwrap();
    assert!(matches!(service.prepare(&plan, view, &casters), Err(ServiceError::UnknownMesh { .. })));
    let (_, casters) = add(&second, &mut service, &upload(&second).description()).unwrap();
    assert_eq!(captured(&second, &mut service, &casters, &plan, view), before);
}

#[test]
fn masks_that_make_no_sense() {
    let gpu = exclusive();
    let buffers = quad().upload(&gpu, UvLayout::Floats);
    let table = generate(&case(Casters::AlphaTested)).unwrap().table;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let refuse = |service: &mut ShadowService, change: &dyn Fn(&mut AlphaMask)| {
        let mut description = buffers.description();
        change(description.mask.as_mut().unwrap());
        match service.add_mesh(&description) {
            Err(ServiceError::Mesh(error)) => error,
            other => panic!("{other:?}"),
        }
    };

    // Texture coordinates.
    for format in [wgpu::VertexFormat::Float32, wgpu::VertexFormat::Uint32x2, wgpu::VertexFormat::Sint16x2] {
        assert_eq!(refuse(&mut service, &|mask| mask.format = format), MeshError::MaskFormat(format));
    }
    for stride in [0, 4, 9, 10, 1 << 20] {
        let error = refuse(&mut service, &|mask| mask.stride_bytes = stride);
        assert!(matches!(error, MeshError::MaskStride { stride_bytes, .. } if stride_bytes == stride));
    }
    let error = refuse(&mut service, &|mask| mask.offset_bytes = 2);
    assert!(matches!(error, MeshError::Alignment { what: "texture coordinates", .. }), "{error}");
    for offset in [4, u64::MAX - 3] {
        let error = refuse(&mut service, &|mask| mask.offset_bytes = offset);
        assert!(matches!(error, MeshError::OutOfRange { what: "texture coordinates", .. }), "{error}");
    }
    let indices = buffers.description().indices.unwrap().buffer.clone();
    let mut description = buffers.description();
    description.mask.as_mut().unwrap().uvs = &indices;
    let refused = service.add_mesh(&description);
    assert!(matches!(refused, Err(ServiceError::Mesh(MeshError::Usage { .. }))), "{refused:?}");

    // Cutoffs; both ends of the range are fine.
    for cutoff in [-0.1, 1.1, f32::NAN, f32::INFINITY] {
        let error = refuse(&mut service, &|mask| mask.cutoff = cutoff);
        assert!(matches!(error, MeshError::MaskCutoff(_)), "{error}");
    }
    for cutoff in [0.0, 1.0] {
        let mut description = buffers.description();
        description.mask.as_mut().unwrap().cutoff = cutoff;
        service.add_mesh(&description).unwrap();
    }

    // The case has no shaders for masks.
    let opaque = generate(&case(Casters::Opaque)).unwrap().table;
    let mut opaque = ShadowService::new(&gpu.device, &gpu.queue, &opaque, &Options::default()).unwrap();
    let error = refuse(&mut opaque, &|_| {});
    assert_eq!(error, MeshError::MaskNotDeclared);
    assert!(error.to_string().contains("casters: alpha_tested"));
}

#[test]
fn textures_and_samplers_of_another_kind() {
    let gpu = exclusive();
    let buffers = quad().upload(&gpu, UvLayout::Floats);
    let table = generate(&case(Casters::AlphaTested)).unwrap().table;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let texture = |format, usage, layers, view: &wgpu::TextureViewDescriptor| {
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width: 8, height: 8, depth_or_array_layers: layers },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage,
            view_formats: &[],
        });
        texture.create_view(view)
    };
    let (sampled, target) = (wgpu::TextureUsages::TEXTURE_BINDING, wgpu::TextureUsages::RENDER_ATTACHMENT);
    let (plain, rgba) = (wgpu::TextureViewDescriptor::default(), wgpu::TextureFormat::Rgba8Unorm);
    let array = wgpu::TextureViewDescriptor { dimension: Some(wgpu::TextureViewDimension::D2Array), ..plain };
    let textures = [
        ("no usage", texture(rgba, target, 1, &plain)),
        ("integers", texture(wgpu::TextureFormat::Rgba8Uint, sampled, 1, &plain)),
        ("not filtered", texture(wgpu::TextureFormat::Rgba32Float, sampled, 1, &plain)),
        ("no alpha", texture(wgpu::TextureFormat::R8Unorm, sampled, 1, &plain)),
        ("depth", texture(wgpu::TextureFormat::Depth32Float, sampled, 1, &plain)),
        ("an array", texture(rgba, sampled, 2, &array)),
    ];
    fn given<'a>(
        buffers: &'a CheckeredBuffers,
        texture: Option<&'a wgpu::TextureView>,
        sampler: Option<&'a wgpu::Sampler>,
    ) -> MeshDescription<'a> {
        let mut description = buffers.description();
        if let Some(mask) = &mut description.mask {
            mask.texture = texture.unwrap_or(mask.texture);
            mask.sampler = sampler.unwrap_or(mask.sampler);
        }
        description
    }
    for (what, texture) in &textures {
        let refused = service.add_mesh(&given(&buffers, Some(texture), None));
        let told = matches!(refused, Err(ServiceError::Mesh(MeshError::MaskTexture { .. })));
        assert!(told, "{what}: {refused:?}");
    }
    let compares = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        compare: Some(wgpu::CompareFunction::Less),
        ..Default::default()
    });
    let refused = service.add_mesh(&given(&buffers, None, Some(&compares)));
    assert!(matches!(refused, Err(ServiceError::Mesh(MeshError::MaskTexture { .. }))), "{refused:?}");

    // A filtering sampler, and a texture in sRGB, are fine.
    let linear = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        mag_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });
    let srgb = texture(wgpu::TextureFormat::Rgba8UnormSrgb, sampled, 1, &plain);
    service.add_mesh(&given(&buffers, Some(&srgb), Some(&linear))).unwrap();
    let whole = images::alpha_texture(&gpu, (1, 1), &[255]).create_view(&plain);
    service.add_mesh(&given(&buffers, Some(&whole), None)).unwrap();
}
