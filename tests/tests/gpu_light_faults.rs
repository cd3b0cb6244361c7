//! What can go wrong with many lights: typed errors, the last good frame kept, the service goes on.

use cssm_codegen::generate;
use cssm_core::glam::{DAffine3, DVec3};
use cssm_core::table::{CaseTable, ShaderKind};
use cssm_core::{BoundingBox, Light, LightCase, SceneBounds, View};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_runtime::lights::{CaseHandle, LightDescription, LightFrame, LightOptions, LightState, ViewId};
use cssm_runtime::{CasterInstance, LightService, MeshHandle, PreparedLights, ServiceError, read_back, wgpu};
use cssm_tests::gpu::{Geometry, TestDevice, exclusive, new_device};
use shaders_gen::shipped;

const SIDE: u32 = 512;

fn declared(name: &str, text: &str) -> (LightCase, CaseTable) {
    let case = pick_case(std::path::Path::new("case.cssm"), text, Some(name)).unwrap();
    let case = with_map_size(case, (SIDE, SIDE)).unwrap();
    let table = generate(&case).unwrap().table;
    (case, table)
}

fn cases() -> [(LightCase, CaseTable); 2] {
    [declared("Sun", shipped::SUN), declared("Lamp", shipped::LAMP)]
}

fn service(gpu: &TestDevice, cases: &[(LightCase, CaseTable)]) -> LightService {
    let tables: Vec<_> = cases.iter().map(|(case, table)| (case, table)).collect();
    LightService::new(&gpu.device, &gpu.queue, &tables, &LightOptions::default()).unwrap()
}

fn view() -> View {
    let eye = DVec3::new(0.0, 2.0, 8.0);
    View::perspective(eye, DVec3::ZERO, DVec3::Y, 1.0, 0.1, 100.0, (64, 64)).unwrap()
}

fn sun() -> LightDescription {
    let light = Light::directional_travelling(DVec3::new(0.3, -1.0, -0.2)).unwrap();
    LightDescription::new(CaseHandle(0), light)
}

fn lamp(place: DVec3) -> LightDescription {
    LightDescription::new(CaseHandle(1), Light::omni(place, 10.0).unwrap())
}

fn box_mesh(gpu: &TestDevice, service: &mut LightService) -> MeshHandle {
    let buffers = Geometry::cuboid([-1.0; 3], [1.0; 3]).upload(gpu);
    service.add_mesh(&buffers.description()).unwrap()
}

/// A frame of static casters alone.
fn frame<'a>(view: &'a View, casters: &'a [CasterInstance]) -> LightFrame<'a> {
    LightFrame::new(view, casters, &[])
}

fn draw(gpu: &TestDevice, service: &mut LightService, prepared: &PreparedLights) -> Vec<u8> {
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, prepared, None).unwrap();
    gpu.queue.submit([encoder.finish()]);
    read_back::texture_bytes(&gpu.device, &gpu.queue, service.map()).unwrap()
}

#[test]
fn lights_survive_the_loss_of_the_device() {
    let (first, cases) = (new_device(wgpu::Features::all()), cases());
    let mut service = service(&first, &cases);
    let light = service.add_light(&sun()).unwrap();
    let (view, mesh) = (view(), box_mesh(&first, &mut service));
    let casters = [CasterInstance { mesh, world_from_object: DAffine3::IDENTITY }];
    let mut prepared = PreparedLights::new();
    service.prepare(&frame(&view, &casters), &mut prepared).unwrap();
    let before = draw(&first, &mut service, &prepared);

    first.device.destroy();
    assert!(service.device_lost());
    assert!(matches!(
        service.prepare(&frame(&view, &casters), &mut prepared),
        Err(ServiceError::DeviceLost | ServiceError::Refused { .. })
    ));
    assert!(prepared.shadow_bind_group(light).is_some(), "the frame of before is still there");

    // On another device the light keeps its handle; meshes are added again.
    let second = new_device(wgpu::Features::all());
    service.rebuild(&second.device, &second.queue).unwrap();
    let unknown = service.prepare(&frame(&view, &casters), &mut prepared);
    assert!(matches!(unknown, Err(ServiceError::Casters { list: "static", .. })), "{unknown:?}");
    let casters = [CasterInstance { mesh: box_mesh(&second, &mut service), ..casters[0] }];
    let mut again = PreparedLights::new();
    service.prepare(&frame(&view, &casters), &mut again).unwrap();
    assert!(service.light(light).is_some());
    assert!(draw(&second, &mut service, &again) == before);

    // A frame of the lost device is refused.
    let mut encoder = second.device.create_command_encoder(&Default::default());
    let stale = service.capture(&mut encoder, &prepared, None);
    assert!(matches!(stale, Err(ServiceError::StaleFrame { .. })), "{stale:?}");
}

#[test]
fn bad_casters_are_named_and_the_last_good_frame_stays() {
    let gpu = exclusive();
    let cases = cases();
    let mut service = service(&gpu, &cases);
    let light = service.add_light(&sun()).unwrap();
    let (view, mesh) = (view(), box_mesh(&gpu, &mut service));
    let good = [CasterInstance { mesh, world_from_object: DAffine3::IDENTITY }];
    let mut prepared = PreparedLights::new();
    service.prepare(&frame(&view, &good), &mut prepared).unwrap();
    let before = draw(&gpu, &mut service, &prepared);

    let nan = [good[0], CasterInstance { mesh, world_from_object: DAffine3::from_translation(DVec3::NAN) }];
    let error = service.prepare(&frame(&view, &nan), &mut prepared).unwrap_err();
    assert!(
        error.to_string().contains("static casters") && error.to_string().contains("instance 1"),
        "{error}"
    );
    assert_eq!(prepared.report().lights.len(), 1);
    assert!(prepared.shadow_bind_group(light).is_some());

    // The service goes on as if nothing had happened.
    service.prepare(&frame(&view, &good), &mut prepared).unwrap();
    assert_eq!(prepared.report().redrawn_texels, 0);
    assert!(draw(&gpu, &mut service, &prepared) == before);

    // No casters at all is a frame too: everything is lit.
    service.prepare(&frame(&view, &[]), &mut prepared).unwrap();
    assert!(prepared.report().redrawn_texels > 0);
    assert!(draw(&gpu, &mut service, &prepared) != before);
}

#[test]
fn a_bad_shader_changes_nothing() {
    let gpu = exclusive();
    let cases = cases();
    let mut service = service(&gpu, &cases);
    service.add_light(&sun()).unwrap();
    let (view, mesh) = (view(), box_mesh(&gpu, &mut service));
    let casters = [CasterInstance { mesh, world_from_object: DAffine3::IDENTITY }];
    let mut prepared = PreparedLights::new();
    service.prepare(&frame(&view, &casters), &mut prepared).unwrap();
    let before = draw(&gpu, &mut service, &prepared);

    let (case, table) = &cases[0];
    let mut broken = table.clone();
    for shader in broken.shaders.to_mut().iter_mut().filter(|shader| shader.kind == ShaderKind::Capture) {
        shader.wgsl = shader.wgsl.replace("dot(", "dat(").into();
    }
    let refused = service.replace_case(CaseHandle(0), case, &broken);
    assert!(matches!(refused, Err(ServiceError::Refused { .. })), "{refused:?}");
    service.prepare(&frame(&view, &casters), &mut prepared).unwrap();
    assert_eq!(prepared.report().redrawn_texels, 0);

    // A sound one takes over and draws the same.
    service.replace_case(CaseHandle(0), case, table).unwrap();
    service.prepare(&frame(&view, &casters), &mut prepared).unwrap();
    assert!(prepared.report().redrawn_texels > 0);
    assert!(draw(&gpu, &mut service, &prepared) == before);
    assert!(matches!(
        service.replace_case(CaseHandle(7), case, table),
        Err(ServiceError::UnknownCase { case: 7 })
    ));
}

#[test]
fn thousands_of_lights_are_served_as_far_as_texels_go() {
    let gpu = exclusive();
    let cases = cases();
    let mut service = service(&gpu, &cases);
    let view = view();
    let handles: Vec<_> = (0..2000)
        .map(|index| {
            let place = DVec3::new(f64::from(index % 50) * 0.2 - 5.0, 1.0, f64::from(index / 50) * -0.3);
            service.add_light(&lamp(place)).unwrap()
        })
        .collect();
    let mut prepared = PreparedLights::new();
    service.prepare(&frame(&view, &[]), &mut prepared).unwrap();
    let report = prepared.report();
    assert_eq!(report.lights.len(), 2000);
    assert!(report.owned_texels <= report.map_texels);
    let served = report.lights.iter().filter(|light| light.state == LightState::Current).count();
    let without = report.lights.iter().filter(|light| light.state == LightState::NoTexels).count();
    assert!(served > 10 && without > 1000, "{served} served, {without} without texels");

    // Removed lights give their texels to others, and their handles are refused.
    for handle in &handles[..1990] {
        assert!(service.remove_light(*handle));
    }
    assert!(!service.remove_light(handles[0]));
    assert!(matches!(service.update_light(handles[0], &lamp(DVec3::Y)), Err(ServiceError::UnknownLight)));
    service.prepare(&frame(&view, &[]), &mut prepared).unwrap();
    let report = prepared.report();
    assert_eq!(report.lights.len(), 10);
    assert!(report.lights.iter().all(|light| light.state == LightState::Current), "{report:?}");
}

#[test]
fn descriptions_that_make_no_sense_are_refused() {
    let gpu = exclusive();
    let cases = cases();
    let mut service = service(&gpu, &cases);
    let nan = Light::Omni { position_world: DVec3::NAN, range_metres: 1.0 };
    let usual = sun();
    for (description, word) in [
        (LightDescription { light: nan, case: CaseHandle(1), ..usual }, "position"),
        (LightDescription { case: CaseHandle(9), ..usual }, "case 9"),
        (LightDescription { case: CaseHandle(1), ..usual }, "kind"),
        (LightDescription { priority: f64::NAN, ..usual }, "priority"),
        (LightDescription { enough_pixels: 0.0, ..usual }, "enough_pixels"),
        (LightDescription { max_side_texels: 1, ..usual }, "sides"),
    ] {
        let error = service.add_light(&description).unwrap_err().to_string();
        assert!(error.contains(word), "{error} does not name {word}");
    }
    assert!(matches!(
        LightService::new(&gpu.device, &gpu.queue, &[], &LightOptions::default()),
        Err(ServiceError::NoCases)
    ));
    let (other, other_table) = {
        let case = with_map_size(cases[1].0.clone(), (256, 256)).unwrap();
        let table = generate(&case).unwrap().table;
        (case, table)
    };
    let mixed = [(&cases[0].0, &cases[0].1), (&other, &other_table)];
    let refused = LightService::new(&gpu.device, &gpu.queue, &mixed, &LightOptions::default());
    assert!(matches!(refused, Err(ServiceError::MixedMaps { .. })));
    let foreign = [(&cases[0].0, &cases[1].1)];
    let refused = LightService::new(&gpu.device, &gpu.queue, &foreign, &LightOptions::default());
    assert!(matches!(refused, Err(ServiceError::ForeignTable { .. })));
}

#[test]
fn two_views_share_a_submission_without_touching_each_other() {
    let gpu = exclusive();
    let cases = cases();
    let mut service = service(&gpu, &cases);
    service.add_light(&LightDescription { max_side_texels: 256, ..sun() }).unwrap();
    let mesh = box_mesh(&gpu, &mut service);
    let casters = [CasterInstance { mesh, world_from_object: DAffine3::IDENTITY }];
    let views = [view(), View { eye_world: DVec3::new(3.0, 4.0, 6.0), ..view() }];
    let two = |service: &mut LightService| {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let mut prepared = [PreparedLights::new(), PreparedLights::new()];
        for ((number, view), prepared) in views.iter().enumerate().zip(&mut prepared) {
            let view_id = ViewId(number as u32);
            service.prepare(&LightFrame { view_id, ..frame(view, &casters) }, prepared).unwrap();
        }
        for prepared in &prepared {
            service.capture(&mut encoder, prepared, None).unwrap();
        }
        gpu.queue.submit([encoder.finish()]);
        let map = read_back::texture_bytes(&gpu.device, &gpu.queue, service.map()).unwrap();
        let regions = prepared.map(|prepared| prepared.report().lights[0].region.unwrap());
        (map, regions)
    };
    let (map, regions) = two(&mut service);
    assert_ne!(regions[0], regions[1]);
    let square = |map: &[u8], region: &cssm_core::plan::MapRegion| -> Vec<u8> {
        let rows = region.y..region.y + region.height;
        let row = |y: u32| &map[((y * SIDE + region.x) * 4) as usize..][..(region.width * 4) as usize];
        rows.flat_map(row).copied().collect()
    };

    // Each view alone in a service of its own draws the same square.
    for (view, region) in views.iter().zip(&regions) {
        let mut alone = self::service(&gpu, &cases);
        alone.add_light(&LightDescription { max_side_texels: 256, ..sun() }).unwrap();
        let mesh = box_mesh(&gpu, &mut alone);
        let casters = [CasterInstance { mesh, ..casters[0] }];
        let mut prepared = PreparedLights::new();
        alone.prepare(&frame(view, &casters), &mut prepared).unwrap();
        let own = draw(&gpu, &mut alone, &prepared);
        let own_region = prepared.report().lights[0].region.unwrap();
        // Elsewhere in the map, places round by the last bits of a float; in the same place nothing differs.
        let depths = |bytes: Vec<u8>| -> Vec<f32> {
            bytes.chunks_exact(4).map(|b| f32::from_le_bytes([b[0], b[1], b[2], b[3]])).collect()
        };
        let (one, other) = (depths(square(&own, &own_region)), depths(square(&map, region)));
        let tolerance = if *region == own_region { 0.0 } else { 1e-4 };
        let differing =
            one.iter().zip(&other).filter(|(one, other)| (*one - *other).abs() > tolerance).count();
        assert!(
            differing * 1000 <= if tolerance == 0.0 { 0 } else { one.len() },
            "{differing} texels differ"
        );
    }

    // A view that is forgotten gives its texels back.
    service.remove_view(ViewId(1));
    let mut prepared = PreparedLights::new();
    service.prepare(&frame(&views[0], &casters), &mut prepared).unwrap();
    assert_eq!(prepared.report().owned_texels, u64::from(regions[0].width).pow(2));
}

#[test]
fn a_light_that_reached_nothing_is_asked_again_when_bounds_change() {
    let gpu = exclusive();
    let cases = cases();
    let mut service = service(&gpu, &cases);
    service.add_light(&lamp(DVec3::Y)).unwrap();
    let view = view();
    let far_away = BoundingBox { min: DVec3::new(-1.0, -1.0, -80.0), max: DVec3::new(1.0, 1.0, -70.0) };
    let mut prepared = PreparedLights::new();
    let mut state = |bounds: SceneBounds| {
        service.prepare(&LightFrame { bounds, ..frame(&view, &[]) }, &mut prepared).unwrap();
        prepared.report().lights[0].state.clone()
    };
    assert_eq!(state(SceneBounds::of(Some(far_away))), LightState::Unseen);
    assert_eq!(state(SceneBounds::of(Some(far_away))), LightState::Unseen);
    assert_eq!(state(SceneBounds::default()), LightState::Current);
}
