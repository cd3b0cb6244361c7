//! Seeing inside: the view under all lights, whose shadows every pixel reads, and the tiles of the map.

use std::path::Path;

use cssm_core::Light;
use cssm_core::glam::DVec3;
use cssm_runtime::lights::LightOptions;

use super::judge::Bench;
use super::motion::MOTIONS;
use super::plant::scene_at;
use super::{Host, Town};
use crate::error::LabError;
use crate::gpu::{Gpu, SceneBuffers, Surface};
use crate::picture::{Colour, Picture, srgb_byte};
use crate::truth::{Frame, Tracer};

const SUN: [f64; 3] = [0.30, 0.27, 0.26];
const LAMP: [f64; 3] = [1.5, 1.15, 0.75];
const SPOT: [f64; 3] = [0.9, 1.1, 1.5];
const DUSK: [f64; 3] = [0.05, 0.06, 0.09];
const SKY: [f64; 3] = [0.10, 0.12, 0.22];
/// Distance from a lamp at which its light has fallen to a half, metres.
const HALF_METRES: f64 = 4.0;
const EMPTY: Colour = [14, 20, 44];
const REDRAWN: Colour = [235, 70, 60];
const HELD: Colour = [60, 150, 90];
/// Side of the picture of the map in pixels.
const TILES_PIXELS: usize = 720;
/// Opacity of the tint that tells lights apart.
const TINT: f64 = 0.55;
/// Frames that the strip shows, and their size in pixels.
const STRIP_FRAMES: [u32; 4] = [0, 8, 16, 24];
const STRIP_PIXELS: (u32, u32) = (480, 270);

/// The last frame of a host: `view.png`, `owners.png` and `tiles.png`.
///
/// # Errors
/// What the device says; files that cannot be written.
pub(super) fn write(folder: &Path, host: &Host, bench: &Bench) -> Result<(), LabError> {
    let (view, owners) = lit(host, bench)?;
    view.write_png(&folder.join("view.png"))?;
    owners.titled("which light gives each pixel most").write_png(&folder.join("owners.png"))?;
    let title = "the shared map: light squares, facets; red: redrawn in this frame";
    tiles(host, TILES_PIXELS)?.titled(title).write_png(&folder.join("tiles.png"))?;
    Ok(())
}

/// Some frames of a slow camera among cars that drive, each over its map: `strip.png`.
///
/// # Errors
/// What the service or the device says; files that cannot be written.
pub(super) fn write_strip(
    folder: &Path,
    gpu: &Gpu,
    town: &Town,
    buffers: &SceneBuffers,
    tracer: &Tracer,
) -> Result<(), LabError> {
    let motion = MOTIONS.iter().find(|motion| motion.cars_drive && motion.step_metres > 0.0);
    let Some(motion) = motion else { return Ok(()) };
    let mut host = Host::new(gpu, town, buffers, &LightOptions::default())?;
    let mut columns = Vec::new();
    let last = STRIP_FRAMES.into_iter().max().unwrap_or(0);
    for number in 0..=last {
        let mut view = motion.view(&town.view, number);
        host.frame(&view, number)?;
        if !STRIP_FRAMES.contains(&number) {
            continue;
        }

        // Trace what is seen with the cars where they are.
        let scene = scene_at(town.scene, &town.cars, number);
        let moved = if number == 0 { None } else { Some(Tracer::new(&scene)) };
        let tracer = moved.as_ref().unwrap_or(tracer);
        view.size_pixels = STRIP_PIXELS;
        let frame = Frame::trace(tracer, &view, &town.lights[0].light, &|_| ());
        let surface = Surface::new(gpu, &view, &frame)?;
        let bench = Bench { gpu, scene: &scene, tracer, buffers, frame: &frame, view, surface: &surface };
        let (lit, _) = lit(&host, &bench)?;
        let report = host.runner.report();
        let share = 100.0 * report.redrawn_texels as f64 / report.owned_texels.max(1) as f64;
        let title = format!("frame {number}: {share:.1} % of texels redrawn");
        let map = tiles(&host, STRIP_PIXELS.0 as usize)?;
        columns.push(Picture::stacked(&[lit.titled(&title), map]));
    }
    Picture::beside(&columns).write_png(&folder.join("strip.png"))?;
    Ok(())
}

/// The view under all lights, and the same tinted by the light that gives each pixel most.
fn lit(host: &Host, bench: &Bench) -> Result<(Picture, Picture), LabError> {
    let frame = bench.frame;
    let mut sums = vec![DVec3::from_array(DUSK); frame.pixels.len()];
    let mut strongest = vec![(0.0, 0_usize); frame.pixels.len()];
    for (index, (handle, planted)) in host.handles.iter().zip(&host.town.lights).enumerate() {
        let visibility = host.runner.visibility(*handle, bench.surface)?;
        let colour = DVec3::from_array(match planted.light {
            Light::Directional { .. } => SUN,
            Light::Spot { .. } => SPOT,
            Light::Omni { .. } => LAMP,
        });
        for (pixel, seen) in frame.visible() {
            let place = bench.view.eye_world + seen.position;
            if !planted.light.reaches(place) {
                continue;
            }
            let distance = planted.light.distance_metres(place);
            let fall = if distance.is_finite() {
                (HALF_METRES / (HALF_METRES + distance)).powi(2) * 4.0
            } else {
                1.0
            };
            let cosine = seen.normal.dot(planted.light.toward_world(place)).max(0.0);
            let strength = fall * cosine * f64::from(visibility[pixel]);
            sums[pixel] += colour * strength;
            if strength > strongest[pixel].0 {
                strongest[pixel] = (strength, index);
            }
        }
    }

    let shade = |index: usize| match &frame.pixels[index] {
        None => DVec3::from_array(SKY),
        Some(seen) => {
            let instance = bench.scene.instances.get(seen.instance as usize);
            let albedo = instance.map_or([0.5; 3], |instance| instance.colour).map(f64::from);
            DVec3::from_array(albedo) * sums[index]
        }
    };
    let byte = |colour: DVec3| colour.to_array().map(srgb_byte);
    let picture = |colour: &dyn Fn(usize) -> Colour| Picture {
        width: frame.width,
        height: frame.height,
        pixels: (0..frame.pixels.len()).map(colour).collect(),
    };
    let tinted = |index: usize| {
        let (strength, light) = strongest[index];
        let plain = byte(shade(index));
        if strength == 0.0 { plain } else { mixed(plain, hue(light)) }
    };
    Ok((picture(&|index| byte(shade(index))), picture(&tinted)))
}

/// Depths of the map as grey, stretched in each tile, under outlines of tiles and squares.
fn tiles(host: &Host, side: usize) -> Result<Picture, LabError> {
    let depths = host.runner.map()?;
    let texels = host.runner.service.map().width() as usize;
    let scale = side as f64 / texels as f64;
    let at = |texel: u32| (f64::from(texel) * scale) as usize;
    let mut picture = Picture::filled(side, side, EMPTY);
    let report = host.runner.report();
    for light in &report.lights {
        for shown in &light.tiles {
            let tile = shown.tile;
            let rows = tile.y as usize..(tile.y + tile.height) as usize;
            let row = |y: usize| &depths[y * texels + tile.x as usize..][..tile.width as usize];
            let drawn = rows.clone().flat_map(row).filter(|depth| **depth > 0.0 && **depth < 1.0);
            let (low, high) =
                drawn.fold((1.0_f32, 0.0_f32), |(low, high), depth| (low.min(*depth), high.max(*depth)));
            for y in at(tile.y)..at(tile.y + tile.height) {
                for x in at(tile.x)..at(tile.x + tile.width) {
                    let texel = |pixel: usize| (((pixel as f64 + 0.5) / scale) as usize).min(texels - 1);
                    let depth = depths[texel(y) * texels + texel(x)];
                    if depth > 0.0 && depth < 1.0 && high > low {
                        let grey = (40.0 + 200.0 * (depth - low) / (high - low)) as u8;
                        picture.set(x, y, [grey; 3]);
                    }
                }
            }
            let colour = if shown.redrawn { REDRAWN } else { HELD };
            let size = |from: u32, length: u32| at(from + length) - at(from);
            picture.outline(
                at(tile.x),
                at(tile.y),
                size(tile.x, tile.width),
                size(tile.y, tile.height),
                colour,
            );
        }
    }
    for (index, light) in report.lights.iter().enumerate() {
        let Some(region) = light.region else { continue };
        let size = at(region.x + region.width) - at(region.x);
        picture.outline(at(region.x), at(region.y), size, size, hue(index));
        if size > 30 {
            picture.text(at(region.x) + 3, at(region.y) + 2, &index.to_string(), hue(index));
        }
    }
    Ok(picture)
}

/// A colour that tells neighbouring numbers apart.
fn hue(number: usize) -> Colour {
    let turn = (number as f64 * 0.618_033_988_749_895).fract() * 6.0;
    let channel = |shift: f64| {
        let place = (turn + shift).rem_euclid(6.0);
        let level = (2.0 - (place - 3.0).abs()).clamp(0.0, 1.0);
        (70.0 + 185.0 * (1.0 - level)) as u8
    };
    [channel(0.0), channel(2.0), channel(4.0)]
}

fn mixed(one: Colour, other: Colour) -> Colour {
    let channel = |index: usize| {
        let (one, other) = (f64::from(one[index]), f64::from(other[index]));
        (one + (other - one) * TINT) as u8
    };
    [channel(0), channel(1), channel(2)]
}
