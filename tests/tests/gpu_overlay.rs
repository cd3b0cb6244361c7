//! What overlays show is so: every pixel has the colour of the facet that it reads, squares of the checker are texels, and
//! tiles are the map's, texel for texel.

use std::collections::BTreeSet;
use std::path::Path;

use cssm_codegen::generate;
use cssm_core::case::MaskDepth;
use cssm_core::glam::DVec3;
use cssm_core::plan::WorldPlane;
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use cssm_lab::case_file::{pick_case, with_map_size};
use cssm_runtime::{
    Options, Overlay, OverlayLook, OverlayTile, ServiceError, ShadowService, facet_colour, read_back, wgpu,
};
use cssm_tests::gpu::yard::{ORIGIN, suns, views};
use cssm_tests::gpu::{TestDevice, Yard, exclusive, images};
use shaders_gen::shipped;

const SIZE: (u32, u32) = (160, 90);
const SIDE: u32 = 512;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Levels of a channel that rounding may take.
const LEVELS: u8 = 1;

fn case(name: &str, text: &str) -> LightCase {
    with_map_size(pick_case(Path::new("case.cssm"), text, Some(name)).unwrap(), (SIDE, SIDE)).unwrap()
}

/// A slope with steps under a sky, in metres.
fn depths() -> Vec<f32> {
    let pixel = |index: u32| {
        let (x, y) = (index % SIZE.0, index / SIZE.0);
        if y < 8 {
            0.0
        } else {
            0.8 + 0.002 * ((97 - y.min(96)) * (97 - y.min(96))) as f32 + 0.3 * (x / 40) as f32
        }
    };
    (0..SIZE.0 * SIZE.1).map(pixel).collect()
}

/// Plans of many shapes, with what they were made for.
fn plans() -> Vec<(String, View, ShadowPlan)> {
    let views = views(SIZE);
    let mut found = Vec::new();
    let directional = [
        ("Sun", shipped::SUN),
        ("FourPlane", shipped::FOUR_PLANE),
        ("SunLog", shipped::SUN_LOG),
        ("Pssm4Log", shipped::PSSM4_LOG),
    ];
    for (name, text) in directional {
        for (view, sun) in views.iter().zip(suns()) {
            if let Ok(plan) = plan(&case(name, text), view, &sun, &SceneBounds::default()) {
                found.push((name.to_owned(), *view, plan));
            }
        }
    }
    // A dominant plane that the slope crosses.
    let text = "case Ground { dominant_plane: share { share: 0.25, thickness: 0.3 m } }";
    let ground = WorldPlane { point_world: views[0].eye_world - 0.6 * DVec3::Y, normal_world: DVec3::Y };
    let bounds = SceneBounds { dominant_plane: Some(ground), ..SceneBounds::default() };
    found.push((
        "Ground".into(),
        views[0],
        plan(&case("Ground", text), &views[0], &suns()[0], &bounds).unwrap(),
    ));
    for place in [DVec3::new(2.0, 6.0, -9.0), DVec3::new(-3.0, 4.0, 6.0), DVec3::new(0.0, 1.0, -4.0)] {
        let lamp = Light::omni(ORIGIN + place, 40.0).unwrap();
        if let Ok(plan) = plan(&case("Lamp", shipped::LAMP), &views[0], &lamp, &SceneBounds::default()) {
            found.push((format!("Lamp, {}", plan.configuration), views[0], plan));
        }
    }
    found
}

/// The picture of an overlay over black.
fn shown(
    gpu: &TestDevice,
    overlay: &Overlay,
    depth: &wgpu::Texture,
    (plan, view): (&ShadowPlan, &View),
    look: &OverlayLook,
) -> Result<Vec<[u8; 4]>, ServiceError> {
    let target = images::target(gpu, SIZE, FORMAT);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    let [depth, drawn] = [depth, &target].map(|texture| texture.create_view(&Default::default()));
    overlay.draw_facets(&mut encoder, plan, view, &depth, &drawn, look)?;
    gpu.queue.submit([encoder.finish()]);
    let bytes = read_back::texture_bytes(&gpu.device, &gpu.queue, &target)?;
    Ok(bytes.chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2], pixel[3]]).collect())
}

/// The facet that a pixel reads, and the map texel where.
fn read(plan: &ShadowPlan, view: &View, depth: f32, x: u32, y: u32) -> Option<(usize, f64, f64)> {
    if depth <= 0.0 {
        return None;
    }
    let ray = view.ray_world(f64::from(x) + 0.5, f64::from(y) + 0.5);
    let point = (ray * f64::from(depth)).extend(1.0);
    let cell = plan.selection.cell(point);
    let position = plan.facets.iter().position(|facet| facet.cells.contains(&cell))?;
    let facet = &plan.facets[position];
    let w = facet.rows.w.dot(point);
    let (u, k) = (facet.rows.x.dot(point) / w, facet.rows.y.dot(point) / w);
    let (column, row) = facet.tile.texel_from_ndc(u, facet.rows.remap.y(k));
    Some((position, column, row))
}

/// Pixels that differ from what the processor says: of all, of those on borders.
fn differing(
    pixels: &[[u8; 4]],
    depths: &[f32],
    (plan, view): (&ShadowPlan, &View),
    look: &OverlayLook,
) -> usize {
    let at = |x: u32, y: u32| read(plan, view, depths[(y * SIZE.0 + x) as usize], x, y);
    let expected = |x: u32, y: u32| -> [u8; 3] {
        let Some((facet, column, row)) = at(x, y) else { return [0; 3] };
        let is_other = |x: u32, y: u32| {
            let (x, y) = (x.min(SIZE.0 - 1), y.min(SIZE.1 - 1));
            let is_sky = depths[(y * SIZE.0 + x) as usize] <= 0.0;
            !is_sky && at(x, y).map(|(other, ..)| other) != Some(facet)
        };
        if is_other(x + 1, y) || is_other(x, y + 1) {
            return [0; 3];
        }
        let side = f64::from(look.checker_texels);
        let is_odd = side > 0.0 && ((column / side).floor() + (row / side).floor()).rem_euclid(2.0) == 1.0;
        let light = look.opacity * if is_odd { 0.6 } else { 1.0 };
        facet_colour(plan.facets[facet].first_cell()).map(|channel| (255.0 * light * channel).round() as u8)
    };
    let places = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (x, y)));
    let is_off = |(index, (x, y)): (usize, (u32, u32))| {
        let (found, expected) = (pixels[index], expected(x, y));
        (0..3).any(|channel| found[channel].abs_diff(expected[channel]) > LEVELS)
    };
    places.enumerate().filter(|place| is_off(*place)).count()
}

#[test]
fn pixels_have_the_colours_of_their_facets() {
    let gpu = exclusive();
    let (depths, plans) = (depths(), plans());
    let linear = images::float_texture(&gpu, SIZE, &depths);
    let overlay = Overlay::new(&gpu.device, &gpu.queue, MaskDepth::Linear, FORMAT).unwrap();
    let looks =
        [OverlayLook { opacity: 1.0, checker_texels: 0 }, OverlayLook { opacity: 0.7, checker_texels: 16 }];
    let mut facets_seen = 0;
    for (name, view, plan) in &plans {
        for (look, share) in looks.iter().zip([0.003, 0.01]) {
            let pixels = shown(&gpu, &overlay, &linear, (plan, view), look).unwrap();
            let differing = differing(&pixels, &depths, (plan, view), look);
            println!("{name}: {differing} pixels differ with {look:?}");
            assert!((differing as f64) < share * depths.len() as f64, "{name}: {differing} with {look:?}");
        }
        let owners = (0..depths.len() as u32).filter_map(|index| {
            let (x, y) = (index % SIZE.0, index / SIZE.0);
            read(plan, view, depths[index as usize], x, y).map(|(facet, ..)| facet)
        });
        let owners: BTreeSet<usize> = owners.collect();
        let own = |facet: &usize| plan.facets[*facet].cells.contains(&plan.selection.dominant_cell());
        assert_eq!(owners.iter().any(own), name == "Ground", "{name}");
        facets_seen += owners.len();
    }
    assert!(facets_seen > 3 * plans.len() && plans.len() > 8, "{facets_seen} facets of {}", plans.len());

    // Another plan's colours are others.
    let ((_, view, one), (_, _, other)) =
        (&plans[0], plans.iter().find(|(name, ..)| name == "Pssm4Log").unwrap());
    let pixels = shown(&gpu, &overlay, &linear, (other, view), &looks[0]).unwrap();
    assert!(differing(&pixels, &depths, (one, view), &looks[0]) > depths.len() / 10);
}

#[test]
fn stored_depth_and_held_plans_show_the_same() {
    let gpu = exclusive();
    let depths = depths();
    let (_, view, plan) = plans().remove(0);
    let far_inverse = 1.0 / view.far_metres;
    let scale = 1.0 / view.near_metres - far_inverse;
    let stored = |depth: &f32| {
        if *depth > 0.0 { ((1.0 / f64::from(*depth) - far_inverse) / scale) as f32 } else { 0.0 }
    };
    let stored: Vec<f32> = depths.iter().map(stored).collect();
    let depth = images::depth_texture(&gpu, SIZE, &stored);
    let overlay = Overlay::new(&gpu.device, &gpu.queue, MaskDepth::ReversedZ, FORMAT).unwrap();
    let look = OverlayLook { opacity: 1.0, checker_texels: 0 };
    let pixels = shown(&gpu, &overlay, &depth, (&plan, &view), &look).unwrap();
    let allowed = depths.len() * 3 / 1000;
    assert!(differing(&pixels, &depths, (&plan, &view), &look) < allowed);

    // A plan that is held while the eye moves on is brought to it.
    let later = View { eye_world: view.eye_world + DVec3::new(0.4, 0.1, -0.3), ..view };
    let pixels = shown(&gpu, &overlay, &depth, (&plan, &later), &look).unwrap();
    assert!(differing(&pixels, &depths, (&plan.rebased(&later), &later), &look) < allowed);

    // A texture of another kind is refused.
    let wrong = images::float_texture(&gpu, SIZE, &depths);
    assert!(matches!(
        shown(&gpu, &overlay, &wrong, (&plan, &view), &look),
        Err(ServiceError::Refused { .. })
    ));
}

#[test]
fn tiles_are_shown_texel_for_texel() {
    let gpu = exclusive();
    let case = case("Sun", shipped::SUN);
    let table = generate(&case).unwrap().table;
    let mut service = ShadowService::new(&gpu.device, &gpu.queue, &table, &Options::default()).unwrap();
    let (yard, view, sun) = (Yard::new(), views(SIZE)[0], suns()[0]);
    let buffers = yard.upload(&gpu);
    let casters = yard.add_to(&mut service, &buffers).unwrap();
    let plan = plan(&case, &view, &sun, &SceneBounds::of(Some(yard.bounds()))).unwrap();
    let frame = service.prepare(&plan, &view, &casters).unwrap();
    let overlay = Overlay::new(&gpu.device, &gpu.queue, MaskDepth::Linear, FORMAT).unwrap();
    let target = images::target(&gpu, (SIDE, SIDE), FORMAT);
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    service.capture(&mut encoder, &frame, None).unwrap();
    let tiles = OverlayTile::of_plan(&plan);
    let drawn = target.create_view(&Default::default());
    overlay.draw_tiles(&mut encoder, service.map(), &tiles, &drawn, [0, 0, SIDE, SIDE]).unwrap();
    gpu.queue.submit([encoder.finish()]);
    let pixels = read_back::texture_bytes(&gpu.device, &gpu.queue, &target).unwrap();
    let map = service.read_map().unwrap();

    let (mut covered, mut empty, mut off) = (0, 0, 0);
    for shown in &tiles {
        let tile = shown.tile;
        let depth = |x: u32, y: u32| map[(y * SIDE + x) as usize];
        let is_drawn = |depth: &f32| *depth > 0.0 && *depth < 1.0;
        let sample = |at: u32| {
            let place = |at: u32, size: u32| ((at as f32 + 0.5) / 16.0 * size as f32) as u32;
            depth(tile.x + place(at % 16, tile.width), tile.y + place(at / 16, tile.height))
        };
        let samples: Vec<f32> = (0..256).map(sample).filter(is_drawn).collect();
        let (low, high) =
            samples.iter().fold((1.0_f32, 0.0_f32), |(low, high), depth| (low.min(*depth), high.max(*depth)));
        for (x, y) in
            (tile.y..tile.y + tile.height).flat_map(|y| (tile.x..tile.x + tile.width).map(move |x| (x, y)))
        {
            let is_edge =
                x == tile.x || y == tile.y || x + 1 == tile.x + tile.width || y + 1 == tile.y + tile.height;
            let found = &pixels[4 * (y * SIDE + x) as usize..][..3];
            let byte = |value: f32| (255.0 * value).round() as u8;
            let expected = match depth(x, y) {
                _ if is_edge => shown.colour.map(byte),
                depth if is_drawn(&depth) => {
                    covered += 1;
                    [byte(0.2 + 0.75 * ((depth - low) / (high - low).max(1e-9)).clamp(0.0, 1.0)); 3]
                }
                _ => {
                    empty += 1;
                    shown.colour.map(|channel| byte(0.15 * channel))
                }
            };
            off += usize::from((0..3).any(|channel| found[channel].abs_diff(expected[channel]) > 2));
        }
    }
    println!("{covered} covered, {empty} empty, {off} off");
    assert!(covered > 20_000 && empty > 500, "{covered} covered, {empty} empty");
    assert_eq!(off, 0);
}
