//! Flicker over errors, a mark for each mode, joined technique by technique.

use cssm_core::glam::DVec2;
use plotters::prelude::*;

use super::{MODES, StabilityArguments, StabilityFinding, TECHNIQUES};
use crate::creep::Creep;
use crate::error::LabError;
use crate::figures::canvas::{Canvas, LINES, PAPER, PEN, paint};
use crate::figures::{drawn, legend};
use crate::picture::Picture;

const PANEL: (usize, usize) = (600, 470);
/// Room around the marks, as a factor.
const MARGIN: f64 = 1.5;
/// Flicker of what never flips, so that it has a place on a logarithmic axis, percent.
const LEAST_PERCENT: f64 = 1e-4;

/// A panel for each motion.
pub(super) fn draw(found: &[StabilityFinding], arguments: &StabilityArguments) -> Result<Picture, LabError> {
    let panels = Creep::ALL.iter().enumerate().map(|(index, creep)| panel(found, index, *creep));
    let panels = panels.collect::<Result<Vec<_>, _>>()?;
    let modes: Vec<String> =
        MODES.iter().enumerate().map(|(index, mode)| format!("{} {mode}", index + 1)).collect();
    let title = format!(
        "Flicker against errors in {}: {side} x {side} texels, {} x {} pixels, {} frames. Modes: {}",
        arguments.scene,
        arguments.size.0,
        arguments.size.1,
        arguments.frames,
        modes.join("; "),
        side = arguments.side,
    );
    Ok(Picture::beside(&panels).titled(&title))
}

fn panel(found: &[StabilityFinding], index: usize, creep: Creep) -> Result<Picture, LabError> {
    let at = |finding: &StabilityFinding| {
        DVec2::new(100.0 * finding.wrong, (100.0 * finding.flicker[index]).max(LEAST_PERCENT))
    };
    let low = found.iter().map(at).fold(DVec2::INFINITY, DVec2::min).y / MARGIN;
    let high = found.iter().map(at).fold(DVec2::ZERO, DVec2::max) * MARGIN;
    let mut picture = Picture::filled(PANEL.0, PANEL.1, PAPER);
    let area = Canvas(&mut picture).into_drawing_area();
    let mut chart = drawn(
        ChartBuilder::on(&area)
            .caption(creep.name(), ("monospace", 15).into_font().color(&paint(PEN)))
            .margin(12)
            .margin_right(30)
            .x_label_area_size(44)
            .y_label_area_size(72)
            .build_cartesian_2d(0.0..high.x, (low..high.y).log_scale()),
    )?;
    drawn(
        chart
            .configure_mesh()
            .x_desc("wrong pixels, %")
            .y_desc("pixels that flip, %")
            .light_line_style(paint([238, 238, 236]))
            .bold_line_style(paint([214, 214, 212]))
            .draw(),
    )?;
    for (number, (technique, _)) in TECHNIQUES.iter().enumerate() {
        let own: Vec<&StabilityFinding> =
            found.iter().filter(|finding| finding.technique == *technique).collect();
        let colour = paint(LINES[number]);
        let places: Vec<(f64, f64)> = own.iter().map(|finding| at(finding).into()).collect();
        let line = LineSeries::new(places.iter().copied(), colour.mix(0.4).stroke_width(1));
        drawn(chart.draw_series(line))?;
        let marks = places.iter().map(|place| Circle::new(*place, 5, colour.filled()));
        drawn(chart.draw_series(marks))?
            .label(*technique)
            .legend(move |(x, y)| Circle::new((x + 8, y), 5, colour.filled()));
        let numbers = own.iter().zip(&places).map(|(finding, place)| {
            let mode = MODES.iter().position(|mode| *mode == finding.mode).unwrap_or(0) + 1;
            let style = ("monospace", 15).into_font().color(&paint(PEN));
            EmptyElement::at(*place) + Text::new(mode.to_string(), (8, -16), style)
        });
        drawn(chart.draw_series(numbers))?;
    }
    legend(&mut chart, SeriesLabelPosition::LowerLeft)?;
    drop(chart);
    drop(area);
    Ok(picture)
}
