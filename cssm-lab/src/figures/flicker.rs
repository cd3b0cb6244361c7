//! Flicker in a forest in the wind: how many shadows flip between frames of a slow camera although nothing they depend on
//! did.

use cssm_core::technique::TECHNIQUES;
use cssm_core::{Light, LightCase, View};
use plotters::prelude::*;
use rayon::prelude::*;
use serde::Serialize;

use super::canvas::{Canvas, LINES, PAPER, PEN, paint};
use super::cases::case;
use super::wind::{blown, sways};
use super::{Figure, FigureOptions, drawn, legend};
use crate::creep::Creep;
use crate::error::LabError;
use crate::picture::Picture;
use crate::scene::Scene;
use crate::score::statistics::share;
use crate::sight::Sight;
use crate::truth::{Frame, Tracer, Visible};
use crate::twin::{TwinCasters, visibility};

const SIZE: (u32, u32) = (320, 180);
const QUICK_SIZE: (u32, u32) = (96, 54);
const SIDE_TEXELS: u32 = 2048;
const DISTANCE: f64 = 1000.0;
/// Steps of each motion.
const STEPS: u32 = 3;

/// Distance between lines of a name.
const LINE_PIXELS: usize = 16;

/// Shares of pixels that flip.
#[derive(Debug, Clone, Serialize)]
pub struct Flicker {
    /// The variant.
    pub technique: String,
    /// Of pixels on what stands still, for each motion.
    pub still: [f64; 2],
    /// Of pixels on what sways, for each motion.
    pub swaying: [f64; 2],
    /// Pixels of a kind whose truth did not flip, all frames and both motions together.
    pub pixels: [u64; 2],
}

/// A pair of frames: the pixels of the first, in both.
struct Pair<'a> {
    now: Sight<'a>,
    /// The same points of the same surfaces in the next frame, relative to the next eye.
    next: Sight<'a>,
    now_casters: TwinCasters<'a>,
    next_casters: TwinCasters<'a>,
    motion: usize,
    sways: Vec<bool>,
}

/// Draws the figure.
///
/// # Errors
/// When a declaration is not sound.
pub fn figure(options: &FigureOptions) -> Result<Figure, LabError> {
    let scene = Scene::forest();
    let (view, light) = scene.views.first().ok_or(LabError::NoView)?.pictured(if options.quick {
        QUICK_SIZE
    } else {
        SIZE
    })?;
    let steps = if options.quick { 1 } else { STEPS };
    let frames: Vec<Scene> = (0..=steps).map(|frame| blown(&scene, frame)).collect();
    let tracers: Vec<Tracer> = frames.par_iter().map(Tracer::new).collect();
    let mut pairs = Vec::new();
    for (motion, creep) in Creep::ALL.into_iter().enumerate() {
        for step in 0..steps as usize {
            let eyes = [creep.moved(&view, step as u32), creep.moved(&view, step as u32 + 1)];
            pairs.push(pair(
                [&frames[step], &frames[step + 1]],
                [&tracers[step], &tracers[step + 1]],
                eyes,
                light,
                motion,
            ));
        }
    }
    let mut found = Vec::new();
    let bar = options.progress.bar(variants()?.len() as u64, "flicker in the wind");
    for (name, case) in variants()? {
        // What cannot plan such a view has no bar.
        found.extend(judge(name, &case, &pairs));
        bar.inc(1);
    }
    bar.finish_and_clear();
    let title = format!(
        "Flicker in a forest in the wind: share of light-facing pixels whose shadow flips between frames although the truth \
         does not; {SIDE_TEXELS} x {SIDE_TEXELS} texels, {} x {} pixels, {steps} steps of each motion",
        view.size_pixels.0, view.size_pixels.1
    );
    Ok(Figure {
        file: "flicker.png",
        picture: bars(&found)?.titled(&title),
        shows: "Flicker on an animated forest: shadows that flip between frames of a slow camera although the truth does not, \
                on still and on swaying surfaces",
        data: serde_json::to_value(&found).ok(),
    })
}

/// Every variant of every technique.
fn variants() -> Result<Vec<(String, LightCase)>, LabError> {
    let all = TECHNIQUES.iter().flat_map(|spec| spec.variants);
    all.map(|variant| Ok(((*variant).to_owned(), case(variant, "", SIDE_TEXELS, DISTANCE)?))).collect()
}

fn pair<'a>(
    scenes: [&'a Scene; 2],
    tracers: [&Tracer; 2],
    views: [View; 2],
    light: Light,
    motion: usize,
) -> Pair<'a> {
    let frame = Frame::trace(tracers[0], &views[0], &light, &|_| {});
    let sways: Vec<bool> = frame
        .pixels
        .iter()
        .map(|pixel| pixel.is_some_and(|pixel| sways(scenes[0], pixel.instance as usize)))
        .collect();
    let carried = frame
        .pixels
        .par_iter()
        .map(|pixel| pixel.map(|pixel| carried(pixel, scenes, tracers[1], views, &light)));
    let next = Frame { width: frame.width, height: frame.height, pixels: carried.collect() };
    Pair {
        now: Sight::of_frame(scenes[0], views[0], light, frame),
        next: Sight::of_frame(scenes[1], views[1], light, next),
        now_casters: TwinCasters::new(scenes[0], views[0].eye_world),
        next_casters: TwinCasters::new(scenes[1], views[1].eye_world),
        motion,
        sways,
    }
}

/// The same point of the same surface in the next frame, with its truth.
fn carried(pixel: Visible, scenes: [&Scene; 2], tracer: &Tracer, views: [View; 2], light: &Light) -> Visible {
    let transform = |scene: &Scene| scene.instances[pixel.instance as usize].world_from_object;
    let object = transform(scenes[0]).inverse().transform_point3(views[0].eye_world + pixel.position);
    let world = transform(scenes[1]).transform_point3(object);
    let outward = tracer.normal(pixel.triangle);
    let normal = if outward.dot(pixel.normal) < 0.0 { -outward } else { outward };
    let toward = light.toward_world(world);
    let start = 1e-9 * (1.0 + world.abs().max_element());
    let free = !tracer.blocked(world, toward, start..f64::INFINITY, pixel.triangle, &mut Vec::new());
    Visible { position: world - views[1].eye_world, normal, cosine: normal.dot(toward), lit: free, ..pixel }
}

/// Counts flips of one case; `None` where a frame has no plan.
fn judge(technique: String, case: &LightCase, pairs: &[Pair<'_>]) -> Option<Flicker> {
    let mut flips = [[0_u64; 2]; 2];
    let mut counted = [[0_u64; 2]; 2];
    for pair in pairs {
        let shown = |sight: &Sight<'_>, casters: &TwinCasters<'_>| {
            let plan = sight.plan(case).ok()?;
            Some(visibility(sight, casters, case, &plan).1)
        };
        let now = shown(&pair.now, &pair.now_casters)?;
        let next = shown(&pair.next, &pair.next_casters)?;
        let pixels = pair.now.frame.pixels.iter().zip(&pair.next.frame.pixels).enumerate();
        for (index, (one, two)) in pixels {
            let (Some(one), Some(two)) = (one, two) else { continue };
            if !one.faces_light() || !two.faces_light() || one.lit != two.lit {
                continue;
            }
            let kind = usize::from(pair.sways[index]);
            counted[kind][pair.motion] += 1;
            flips[kind][pair.motion] += u64::from((now[index] >= 0.5) != (next[index] >= 0.5));
        }
    }
    let shares = |kind: usize| [0, 1].map(|motion| share(flips[kind][motion], counted[kind][motion]));
    let pixels = [0, 1].map(|kind| counted[kind].iter().sum());
    Some(Flicker { technique, still: shares(0), swaying: shares(1), pixels })
}

/// One group of four bars for each technique.
fn bars(found: &[Flicker]) -> Result<Picture, LabError> {
    const ROW: usize = 46;
    const NAMES: usize = 480;
    let height = 90 + ROW * found.len();
    let mut picture = Picture::filled(1240, height, PAPER);
    let most = found
        .iter()
        .flat_map(|flicker| flicker.still.into_iter().chain(flicker.swaying))
        .fold(1e-4, f64::max);
    let area = Canvas(&mut picture).into_drawing_area();
    let mut chart = drawn(
        ChartBuilder::on(&area)
            .margin(10)
            .x_label_area_size(42)
            .y_label_area_size(NAMES as u32)
            .build_cartesian_2d(0.0..100.0 * most * 1.5, 0.0..found.len() as f64),
    )?;
    drawn(
        chart
            .configure_mesh()
            .disable_y_mesh()
            .y_labels(0)
            .x_desc("% of pixels")
            .light_line_style(paint([240, 240, 238]))
            .bold_line_style(paint([214, 214, 212]))
            .draw(),
    )?;
    let series = [
        ("still, 1 cm a frame", LINES[0]),
        ("still, 0.05 degrees a frame", LINES[6]),
        ("swaying, 1 cm a frame", LINES[1]),
        ("swaying, 0.05 degrees a frame", LINES[5]),
    ];
    for (bar, (label, colour)) in series.into_iter().enumerate() {
        let rectangles = found.iter().enumerate().map(|(row, flicker)| {
            let value = 100.0 * if bar < 2 { flicker.still[bar] } else { flicker.swaying[bar - 2] };
            let top = (found.len() - row) as f64 - 0.08 - 0.21 * bar as f64;
            Rectangle::new([(0.0, top), (value, top - 0.19)], paint(colour).filled())
        });
        drawn(chart.draw_series(rectangles))?
            .label(label)
            .legend(move |(x, y)| Rectangle::new([(x, y - 5), (x + 16, y + 5)], paint(colour).filled()));
    }
    legend(&mut chart, SeriesLabelPosition::LowerRight)?;
    drop(chart);
    drop(area);
    let rows = height - 62;
    for (row, flicker) in found.iter().enumerate() {
        let y = 10 + rows * (2 * row + 1) / (2 * found.len().max(1)) - 8;
        let lines = Picture::lines(&flicker.technique, NAMES - 20);
        for (line, text) in lines.iter().enumerate() {
            picture.text(12, y + LINE_PIXELS * line - LINE_PIXELS * (lines.len() - 1) / 2, text, PEN);
        }
    }
    Ok(picture)
}
