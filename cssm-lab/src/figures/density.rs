//! Sampling density over depth under the three split schemes (Zhang, Parallel-split shadow maps, "split schemes"), with
//! face columns beside.

use cssm_core::footprint::{quantile, volume};
use cssm_core::glam::DVec3;
use cssm_core::{Light, LightCase, SceneBounds, View, plan};
use plotters::prelude::*;

use super::canvas::{Canvas, LINES, PAPER, PEN, paint};
use super::cases::case;
use super::{Figure, FigureOptions, drawn, legend};
use crate::error::LabError;
use crate::picture::Picture;

const NEAR: f64 = 0.2;
const FAR: f64 = 1000.0;
const SIDE_TEXELS: u32 = 2048;
const LINES_PIXELS: u32 = 1080;
/// Depths at which density is taken, and receivers across the image at each.
const DEPTHS: usize = 260;
const ACROSS: usize = 9;
const PANEL: (usize, usize) = (560, 430);
/// Densities that are shown, texels per pixel.
const SHOWN: std::ops::Range<f64> = 3e-4..4.0;

/// Depth, and texels of a pixel's width there: one over the median footprint across the image.
///
/// # Errors
/// What planning says.
pub fn densities(case: &LightCase, view: &View, light: &Light) -> Result<Vec<(f64, f64)>, LabError> {
    let plan = plan(case, view, light, &SceneBounds::default())?;
    let at = |index: usize| {
        let depth = NEAR * libm::pow(0.999 * FAR / NEAR, (index as f64 + 0.5) / DEPTHS as f64);
        let mut footprints = Vec::with_capacity(ACROSS * ACROSS);
        for place in 0..ACROSS * ACROSS {
            let along = |step: usize, pixels: u32| (step as f64 + 0.5) / ACROSS as f64 * f64::from(pixels);
            let (width, height) = view.size_pixels;
            let point = view.ray_world(along(place % ACROSS, width), along(place / ACROSS, height)) * depth;
            if let Some(facet) = plan.facet(plan.selection.cell(point.extend(1.0))) {
                footprints.push(volume(facet, view, point).major_pixels);
            }
        }
        footprints.sort_by(f64::total_cmp);
        (depth, 1.0 / quantile(&footprints, 0.5))
    };
    Ok((0..DEPTHS).map(at).collect())
}

/// The view and the light of the figure.
fn situation() -> Result<(View, Light), LabError> {
    let (fov, size) = (60_f64.to_radians(), (LINES_PIXELS, LINES_PIXELS));
    let view = View::perspective(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, fov, NEAR, FAR, size)?;
    Ok((view, Light::directional_travelling(DVec3::new(-0.25, -0.866, -0.433))?))
}

/// Densities of a declared technique.
///
/// # Errors
/// When the declaration is not sound.
pub fn of(technique: &str) -> Result<Vec<(f64, f64)>, LabError> {
    let (view, light) = situation()?;
    densities(&case(technique, "", SIDE_TEXELS, FAR)?, &view, &light)
}

/// Densities of face columns in 8 bands.
///
/// # Errors
/// When the declaration is not sound.
pub fn columns() -> Result<Vec<(f64, f64)>, LabError> {
    of("camera_space")
}

/// Draws the figure.
///
/// # Errors
/// When a declaration is not sound.
pub fn figure(_: &FigureOptions) -> Result<Figure, LabError> {
    let columns = columns()?;
    let schemes =
        [("uniform", "uniform"), ("logarithmic", "logarithmic"), ("practical", "practical { lambda: 0.5 }")];
    let mut panels = Vec::new();
    for (name, scheme) in schemes {
        let mut lines = Vec::new();
        for splits in [2, 3, 4] {
            let technique = format!("parallel_split {{ splits: {splits}, scheme: {scheme} }}");
            lines.push((format!("{splits} splits"), of(&technique)?));
        }
        lines.push(("face columns".to_owned(), columns.clone()));
        panels.push(panel(name, &lines)?);
    }
    let title = "Sampling density over depth: texels per pixel (one over the median volume footprint across the image), near \
                 0.2 m, far 1000 m, 60 degrees, 1080 lines, 2048 x 2048 texels in all, light 60 degrees high from behind; 1 = \
                 a texel for every pixel";
    Ok(Figure {
        file: "split-density.png",
        picture: Picture::beside(&panels).titled(title),
        shows: "Parallel-split slides: sampling density over depth of the uniform, logarithmic and practical schemes for 2 to \
                4 splits, with face columns in 8 bands",
        data: None,
    })
}

fn panel(name: &str, lines: &[(String, Vec<(f64, f64)>)]) -> Result<Picture, LabError> {
    let mut picture = Picture::filled(PANEL.0, PANEL.1, PAPER);
    let area = Canvas(&mut picture).into_drawing_area();
    let caption = format!("{name} scheme");
    let mut chart = drawn(
        ChartBuilder::on(&area)
            .caption(caption, ("monospace", 15).into_font().color(&paint(PEN)))
            .margin(12)
            .margin_right(30)
            .x_label_area_size(44)
            .y_label_area_size(64)
            .build_cartesian_2d((NEAR..FAR).log_scale(), SHOWN.log_scale()),
    )?;
    drawn(
        chart
            .configure_mesh()
            .x_desc("depth, m")
            .y_desc("texels per pixel")
            .x_label_formatter(&|value| format!("{value}"))
            .y_label_formatter(&|value| format!("{value:e}"))
            .light_line_style(paint([238, 238, 236]))
            .bold_line_style(paint([214, 214, 212]))
            .draw(),
    )?;
    for (index, (label, points)) in lines.iter().enumerate() {
        let last = index + 1 == lines.len();
        let colour = if last { paint(PEN) } else { paint(LINES[index]) };
        let style = colour.stroke_width(if last { 3 } else { 2 });
        let shown = points.iter().copied().filter(|(_, density)| SHOWN.contains(density));
        drawn(chart.draw_series(LineSeries::new(shown, style)))?
            .label(label.as_str())
            .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 18, y)], style));
    }
    legend(&mut chart, SeriesLabelPosition::LowerRight)?;
    drop(chart);
    drop(area);
    Ok(picture)
}
