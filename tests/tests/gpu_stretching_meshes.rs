//! Casters that shaders fetch by themselves: masks cut the holes that triangles would, every vertex and index format draws
//! the same map, and what shaders cannot fetch is refused.

use cssm_codegen::generate;
use cssm_core::case::{Casters, LightCase, Stretch};
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::schema::Word;
use cssm_core::twin::DepthMap;
use cssm_core::{Light, SceneBounds, ShadowPlan, View, plan};
use cssm_runtime::{
    CasterInstance, IndexDescription, MeshDescription, MeshError, Options, ServiceError, ShadowService, wgpu,
};
use cssm_tests::gpu::casters::{VERTICES, buffer};
use cssm_tests::gpu::checkered::{CheckeredQuad, UvLayout};
use cssm_tests::gpu::depth_bracket::DepthBracket;
use cssm_tests::gpu::device::device_for;
use cssm_tests::gpu::yard::{ORIGIN, Yard, suns, views};
use cssm_tests::gpu::{Geometry, TestDevice, dueling, new_device};

/// Share of the quads' texels that may leave the bracket: samplers place texels to 1/256 of their size.
const MASK_EDGES: f64 = 2e-3;
const SIDE: u32 = 512;

fn case(configurations: &[&'static str], casters: Casters, bound_texels: f64) -> LightCase {
    LightCase::builder("Leaves")
        .configurations(configurations)
        .distribution(Word::plain("perspective"))
        .stretch(Stretch::Exact { bound_texels })
        .map_size_texels(SIDE, SIDE)
        .casters(casters)
        .build()
        .unwrap()
}

fn service(gpu: &TestDevice, case: &LightCase) -> Result<ShadowService, ServiceError> {
    ShadowService::new(&gpu.device, &gpu.queue, &generate(case).unwrap().table, &Options::default())
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
    DepthMap { width: SIDE, height: SIDE, depths }
}

fn planned(case: &LightCase, view: &View, light: &Light) -> ShadowPlan {
    plan(case, view, light, &SceneBounds::default()).unwrap()
}

/// Ground, and a quad at two places.
fn yard(quad: Geometry) -> Yard {
    let at = |x: f64, z: f64| DAffine3::from_translation(ORIGIN + DVec3::new(x, 0.0, z));
    let geometries = vec![Geometry::ground(200.0, 8), quad];
    Yard { geometries, places: vec![(0, at(0.0, 0.0)), (1, at(0.0, 0.0)), (1, at(3.0, -14.0))] }
}

#[test]
fn a_mask_cuts_the_holes_that_triangles_would() {
    let quad = CheckeredQuad::new([-4.0, 0.5, -9.0], [8.0, 0.0, 1.0], [0.0, 6.0, -2.0]);
    let (cut, whole) = (yard(quad.cut.clone()), yard(quad.whole.clone()));
    for (configurations, layout) in
        [(&["one_plane"][..], UvLayout::Floats), (&["one_plane", "four_plane"], UvLayout::Interleaved)]
    {
        // Facets that share a tile are straight and cut themselves.
        let case = case(configurations, Casters::AlphaTested, 0.0);
        let gpu = device_for(&generate(&case).unwrap().table);
        let buffers = quad.upload(&gpu, layout);
        let mut service = service(&gpu, &case).unwrap();
        let quad = service.add_mesh(&buffers.description()).unwrap();
        let ground = service.add_mesh(&cut.geometries[0].upload(&gpu).description()).unwrap();
        let instance = |(shape, world_from_object): &(usize, DAffine3)| CasterInstance {
            mesh: if *shape == 0 { ground } else { quad },
            world_from_object: *world_from_object,
        };
        let casters: Vec<_> = cut.places.iter().map(instance).collect();
        let (mut wrong, mut without, mut texels, mut shared) = (0, 0, 0, 0);
        for (turn, view) in views((160, 90)).iter().enumerate() {
            let sun = if configurations.len() == 1 { suns()[turn] } else { dueling::suns(view)[turn] };
            let plan = planned(&case, view, &sun);
            shared += plan.facets.iter().filter(|facet| !facet.clip.is_empty()).count();
            let map = captured(&gpu, &mut service, &casters, &plan, view);
            wrong += DepthBracket::new(&cut, &plan, case.map.format).violations(&map);
            // Negative control: the quad without its mask.
            without += DepthBracket::new(&whole, &plan, case.map.format).violations(&map);
            texels += map.depths.len();
        }
        let what = format!("{configurations:?} {layout:?}: {wrong}, {without} of {texels}");
        println!("{what}, {shared} facets that share tiles");
        assert!(without > texels / 400, "{what}");
        assert!(wrong as f64 <= 1.0 + MASK_EDGES * without as f64, "{what}");
        assert_eq!(shared > 0, configurations.len() > 1);
    }
}

/// A cuboid whose corners every format holds without rounding.
fn cuboid() -> Geometry {
    Geometry::cuboid([-1.0, 0.0, -1.0], [1.0, 1.0, 1.0])
}

/// Positions of the cuboid and what takes them back to it.
fn stored(format: wgpu::VertexFormat) -> (Vec<u8>, u32, DAffine3) {
    use wgpu::VertexFormat as Format;
    let corners = cuboid().positions;
    let unit = DAffine3::from_translation(DVec3::NEG_ONE) * DAffine3::from_scale(DVec3::splat(2.0));
    let pick = |low: &[u8], high: &[u8]| -> Vec<u8> {
        let component = |value: f32| if value < 0.0 { low } else { high }.to_vec();
        corners
            .iter()
            .flat_map(|corner| [corner[0], 2.0 * corner[1] - 1.0, corner[2], 1.0])
            .flat_map(component)
            .collect()
    };
    match format {
        Format::Float32x4 => {
            (pick(&(-1.0_f32).to_le_bytes(), &1.0_f32.to_le_bytes()), 16, DAffine3::IDENTITY)
        }
        Format::Float16x4 => (pick(&[0, 0xbc], &[0, 0x3c]), 8, DAffine3::IDENTITY),
        Format::Snorm16x4 => (pick(&[1, 0x80], &[0xff, 0x7f]), 8, DAffine3::IDENTITY),
        Format::Unorm16x4 => (pick(&[0, 0], &[0xff, 0xff]), 8, unit),
        Format::Snorm8x4 => (pick(&[0x81], &[0x7f]), 4, DAffine3::IDENTITY),
        Format::Unorm8x4 => (pick(&[0], &[0xff]), 4, unit),
        _ => {
            let word = |corner: &[f32; 3]| {
                let bits = |axis: usize, value: f32| if value < 0.0 { 0_u32 } else { 1023 << (10 * axis) };
                bits(0, corner[0]) | bits(1, 2.0 * corner[1] - 1.0) | bits(2, corner[2])
            };
            (corners.iter().flat_map(|corner| word(corner).to_le_bytes()).collect(), 4, unit)
        }
    }
}

#[test]
fn every_format_draws_the_same_map() {
    use wgpu::VertexFormat as Format;
    let case = case(&["one_plane"], Casters::Opaque, 0.25);
    let gpu = device_for(&generate(&case).unwrap().table);
    let view = &views((160, 90))[0];
    let plan = planned(&case, view, &suns()[0]);
    let at = DAffine3::from_translation(ORIGIN + DVec3::new(0.0, 0.0, -6.0));
    let flat = DAffine3::from_translation(DVec3::NEG_Y) * DAffine3::from_scale(DVec3::new(1.0, 2.0, 1.0));
    let draw = |description: &MeshDescription, place: DAffine3| {
        let mut service = service(&gpu, &case).unwrap();
        let mesh = service.add_mesh(description).unwrap();
        let caster = CasterInstance { mesh, world_from_object: at * place };
        captured(&gpu, &mut service, &[caster], &plan, view).depths
    };
    let plain = cuboid().upload(&gpu);
    let reference = draw(&plain.description(), flat);
    let covered = reference.iter().filter(|depth| **depth != plan.depth_order.cleared()).count();
    assert!(covered > 500, "only {covered} texels are covered");
    let same = |what: &str, map: Vec<f64>| {
        let differing =
            reference.iter().zip(&map).filter(|(one, other)| (*one - *other).abs() > 1e-6).count();
        assert!(differing <= 2, "{what}: {differing} texels differ");
    };

    // Positions in every format.
    for format in [
        Format::Float32x4,
        Format::Float16x4,
        Format::Snorm16x4,
        Format::Unorm16x4,
        Format::Snorm8x4,
        Format::Unorm8x4,
        Format::Unorm10_10_10_2,
    ] {
        let (bytes, stride_bytes, place) = stored(format);
        let vertices = buffer(&gpu, &bytes, VERTICES);
        let mut description = plain.description();
        description.vertices = &vertices;
        (description.stride_bytes, description.position_format) = (stride_bytes, format);
        same(&format!("{format:?}"), draw(&description, place));
    }

    // Indices of 16 bits behind others, and none at all, behind other vertices.
    let geometry = cuboid();
    let short: Vec<u8> = [7_u16; 3]
        .into_iter()
        .chain(geometry.indices.iter().map(|index| *index as u16))
        .flat_map(u16::to_le_bytes)
        .collect();
    let short = buffer(&gpu, &short, wgpu::BufferUsages::INDEX | wgpu::BufferUsages::STORAGE);
    let mut description = plain.description();
    let count = geometry.indices.len() as u32;
    description.indices =
        Some(IndexDescription { buffer: &short, offset_bytes: 6, count, format: wgpu::IndexFormat::Uint16 });
    same("16 bits", draw(&description, flat));
    let corners = geometry.indices.iter().map(|index| geometry.positions[*index as usize]);
    let spread: Vec<u8> =
        std::iter::repeat_n([9.0_f32; 3], 25).chain(corners).flatten().flat_map(f32::to_le_bytes).collect();
    let spread = buffer(&gpu, &spread, VERTICES);
    let mut description = plain.description();
    (description.vertices, description.vertices_offset_bytes) = (&spread, 300);
    (description.vertex_count, description.indices) = (count, None);
    same("no indices", draw(&description, flat));
}

/// A device without storage buffers.
fn lowest_device() -> TestDevice {
    let TestDevice { adapter, .. } = new_device(wgpu::Features::empty());
    let (device, queue) = pollster::block_on(adapter.request_device(&wgpu::DeviceDescriptor {
        label: Some("lowest"),
        required_limits: wgpu::Limits::downlevel_webgl2_defaults(),
        ..Default::default()
    }))
    .unwrap();
    TestDevice { adapter, device, queue }
}

#[test]
fn what_shaders_cannot_fetch_is_refused() {
    let case = case(&["one_plane"], Casters::Opaque, 0.25);
    let lowest = lowest_device();
    let refused = service(&lowest, &case).unwrap_err();
    assert!(matches!(refused, ServiceError::NoVertexStorage { needed: 2, offered: 0, .. }), "{refused}");
    assert!(refused.to_string().contains("stretch: vertex"), "{refused}");

    let gpu = device_for(&generate(&case).unwrap().table);
    let mut service = service(&gpu, &case).unwrap();
    let plain = cuboid().upload(&gpu);
    let (vertices, _, _) = stored(wgpu::VertexFormat::Float32x4);
    let vertices = buffer(&gpu, &vertices, wgpu::BufferUsages::VERTEX);
    let mut description = plain.description();
    description.vertices = &vertices;
    let refused = service.add_mesh(&description).unwrap_err();
    let is_usage = |error: &ServiceError, which: &str| {
        matches!(error, ServiceError::Mesh(MeshError::Usage { what, usage })
            if *what == which && *usage == wgpu::BufferUsages::STORAGE)
    };
    assert!(is_usage(&refused, "vertices"), "{refused}");
    let indices = buffer(&gpu, &[0; 12], wgpu::BufferUsages::INDEX);
    let mut description = plain.description();
    description.indices = Some(IndexDescription {
        buffer: &indices,
        offset_bytes: 0,
        count: 3,
        format: wgpu::IndexFormat::Uint32,
    });
    let refused = service.add_mesh(&description).unwrap_err();
    assert!(is_usage(&refused, "indices"), "{refused}");
}
