//! The front of error against cost, as a vector picture.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontFamily, TextStyle};

use super::error::MeasureError;
use super::pareto::front;
use super::results::{Overall, Results};

const WIDTH: u32 = 1180;
const PANEL_HEIGHT: u32 = 520;
const LEGEND_WIDTH: u32 = 400;
const FONT_PIXELS: i32 = 13;
const TITLE_PIXELS: i32 = 16;
const LINE_PIXELS: i32 = 18;
/// Room on either side of the points, as a factor.
const MARGIN: f64 = 1.4;
/// Points of the smallest map; every next size is drawn this much larger.
const DOT_PIXELS: (i32, i32) = (3, 1);
/// From a point to its number.
const LABEL_SHIFT_PIXELS: (i32, i32) = (10, -20);
/// Cases of one cost stand side by side over this factor, technique by technique.
const SPREAD: f64 = 1.5;
/// Colours of techniques, dark enough for small dots; the house's is black.
const COLOURS: [RGBColor; 12] = [
    RGBColor(230, 25, 75),
    RGBColor(60, 160, 60),
    RGBColor(0, 110, 220),
    RGBColor(245, 130, 48),
    RGBColor(145, 30, 180),
    RGBColor(0, 170, 170),
    RGBColor(200, 40, 190),
    RGBColor(130, 150, 0),
    RGBColor(150, 90, 40),
    RGBColor(70, 70, 170),
    RGBColor(128, 0, 0),
    RGBColor(110, 130, 140),
];
/// Lines of a legend beside its entries.
const LEGEND_HEADINGS: usize = 6;
/// Most labels of an axis.
const TICKS: usize = 10;
/// Error of a case without any wrong pixel, so that it has a place on a logarithmic axis.
const LEAST_ERROR: f64 = 1e-6;

type Panel<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A cost that cases are plotted over.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Cost {
    /// Bytes of the map.
    Memory,
    /// Triangles that can matter to some facet.
    Triangles,
    /// Time of both passes, in multiples of the reference's.
    Time,
}

impl Cost {
    /// Heading.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Memory => "bytes of the map (equal maps side by side)",
            Self::Triangles => "triangles a frame, after culling, all facets",
            Self::Time => "time of capture and resolve, reference = 1",
        }
    }

    /// The cost of a case, if it was measured.
    pub fn of(self, row: &Overall<'_>) -> Option<f64> {
        match self {
            Self::Memory => Some(row.map_bytes as f64),
            Self::Triangles => Some(row.triangles),
            Self::Time => row.time,
        }
    }
}

/// Costs that a set of cases has.
pub fn costs(rows: &[Overall<'_>]) -> Vec<Cost> {
    let all = [Cost::Memory, Cost::Triangles, Cost::Time];
    all.into_iter()
        .filter(|cost| rows.iter().any(|row| cost.of(row).is_some_and(|cost| cost > 0.0)))
        .collect()
}

/// Cases on the front of a cost, by ascending cost; only those that served every station take part.
pub fn on_front(rows: &[Overall<'_>], cost: Cost) -> Vec<usize> {
    let point = |row: &Overall<'_>| match cost.of(row) {
        Some(cost) if row.complete => (cost, row.mismatch),
        _ => (f64::INFINITY, f64::INFINITY),
    };
    front(&rows.iter().map(point).collect::<Vec<_>>())
}

/// Draws one panel for each cost.
///
/// # Errors
/// [`MeasureError::Plot`] with the library's words.
pub fn svg(results: &Results) -> Result<String, MeasureError> {
    let rows = results.overall();
    let costs = costs(&rows);
    let mut text = String::new();
    {
        // Panels are as high as the longest legend.
        let longest = costs.iter().map(|cost| on_front(&rows, *cost).len()).max().unwrap_or(0);
        let lines = techniques(results).len() + 2 * longest + LEGEND_HEADINGS;
        let panel = PANEL_HEIGHT.max(LINE_PIXELS as u32 * lines as u32);
        let height = panel * costs.len().max(1) as u32;
        let root = SVGBackend::with_string(&mut text, (WIDTH, height)).into_drawing_area();
        let drawn = root.fill(&WHITE).map_err(fault).and_then(|()| {
            let panels = root.split_evenly((costs.len().max(1), 1));
            costs.iter().zip(&panels).try_for_each(|(cost, panel)| draw(panel, results, &rows, *cost))
        });
        drawn?;
        root.present().map_err(fault)?;
    }
    Ok(text)
}

fn fault(error: impl std::fmt::Display) -> MeasureError {
    MeasureError::Plot { reason: error.to_string() }
}

fn draw(panel: &Panel<'_>, results: &Results, rows: &[Overall<'_>], cost: Cost) -> Result<(), MeasureError> {
    let (chart_area, legend) = panel.split_horizontally(WIDTH - LEGEND_WIDTH);
    let techniques = techniques(results);
    let index =
        |row: &Overall<'_>| techniques.iter().position(|(name, _)| *name == row.case.technique).unwrap_or(0);
    let colour = |row: &Overall<'_>| techniques[index(row)].1;
    let at = |row: &Overall<'_>| {
        let share = index(row) as f64 / (techniques.len().max(2) - 1) as f64 - 0.5;
        let spread = if cost == Cost::Memory { libm::pow(SPREAD, share) } else { 1.0 };
        cost.of(row).unwrap_or(1.0) * spread
    };
    let error = |row: &Overall<'_>| row.mismatch.max(LEAST_ERROR);
    let shown: Vec<&Overall<'_>> = rows
        .iter()
        .filter(|row| {
            cost.of(row).is_some_and(|cost| cost > 0.0) && row.cells.iter().any(|c| c.found.figures.is_some())
        })
        .collect();
    let range = |values: &dyn Fn(&Overall<'_>) -> f64| {
        let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
        shown.iter().for_each(|row| {
            low = low.min(values(row));
            high = high.max(values(row));
        });
        if low > high { (1.0, 10.0) } else { (low / MARGIN, high * MARGIN) }
    };
    let costs = range(&|row| at(row));
    let errors = range(&|row| error(row));

    // Axes.
    let title = format!("{}: share of wrong pixels over {}", results.scene, cost.name());
    let mut chart = ChartBuilder::on(&chart_area)
        .caption(title, font(TITLE_PIXELS))
        .margin(14)
        .x_label_area_size(44)
        .y_label_area_size(76)
        .build_cartesian_2d(
            (costs.0..costs.1).log_scale().with_key_points(ticks(costs)),
            (errors.0..errors.1).log_scale().with_key_points(ticks(errors)),
        )
        .map_err(fault)?;
    chart
        .configure_mesh()
        .x_desc(cost.name())
        .y_desc("wrong pixels, all paths")
        .x_label_formatter(&|value| quantity(*value))
        .y_label_formatter(&|value| format!("{} %", (1e5 * value).round() / 1e3))
        .label_style(font(FONT_PIXELS))
        .axis_desc_style(font(FONT_PIXELS))
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.13))
        .draw()
        .map_err(fault)?;

    // The front as a staircase below everything.
    let on_front: Vec<&Overall<'_>> = on_front(rows, cost).into_iter().map(|index| &rows[index]).collect();
    let mut stairs = Vec::new();
    for row in &on_front {
        let place = (at(row), error(row));
        if let Some((_, above)) = stairs.last().copied() {
            stairs.push((place.0, above));
        }
        stairs.push(place);
    }
    if let Some((_, least)) = stairs.last().copied() {
        stairs.push((costs.1, least));
    }
    chart.draw_series(LineSeries::new(stairs, BLACK.mix(0.55).stroke_width(2))).map_err(fault)?;

    // Every case; hollow where some station has no map.
    for row in &shown {
        let place = (at(row), error(row));
        let step = results.sides.iter().position(|side| *side == row.side).unwrap_or(0) as i32;
        let radius = DOT_PIXELS.0 + DOT_PIXELS.1 * step;
        let style = if row.complete { colour(row).mix(0.75).filled() } else { colour(row).stroke_width(1) };
        chart.draw_series([Circle::new(place, radius, style)]).map_err(fault)?;
    }

    // The front's members, ringed and numbered.
    for (number, row) in on_front.iter().enumerate() {
        let place = (at(row), error(row));
        chart.draw_series([Circle::new(place, 9, BLACK.stroke_width(2))]).map_err(fault)?;
        let label = Text::new((number + 1).to_string(), LABEL_SHIFT_PIXELS, font(TITLE_PIXELS));
        chart.draw_series([EmptyElement::at(place) + label]).map_err(fault)?;
    }
    draw_legend(&legend, &techniques, &on_front, cost)
}

fn draw_legend(
    legend: &Panel<'_>,
    techniques: &[(&str, RGBColor)],
    on_front: &[&Overall<'_>],
    cost: Cost,
) -> Result<(), MeasureError> {
    let mut y = 24;
    let mut write = |x: i32, text: String, size: i32| {
        let drawn = legend.draw(&Text::new(text, (x, y), font(size))).map_err(fault);
        y += LINE_PIXELS;
        drawn.map(|()| y - LINE_PIXELS)
    };
    write(0, "technique (larger dot: larger map)".to_owned(), TITLE_PIXELS)?;
    for (technique, colour) in techniques {
        let top = write(20, (*technique).to_owned(), FONT_PIXELS)?;
        let dot = Circle::new((8, top + 6), 6, colour.filled());
        legend.draw(&dot).map_err(fault)?;
    }
    write(0, String::new(), FONT_PIXELS)?;
    write(0, "on the front".to_owned(), TITLE_PIXELS)?;
    for (number, row) in on_front.iter().enumerate() {
        let cost = cost.of(row).map_or_else(String::new, quantity);
        let text = format!("{}  {}, {}, {}", number + 1, row.case.label, row.side, row.filter);
        write(0, text, FONT_PIXELS)?;
        write(20, format!("{:.3} % wrong at {cost}", 100.0 * row.mismatch), FONT_PIXELS)?;
    }
    Ok(())
}

/// Techniques in the order of the cases, with their colours.
fn techniques(results: &Results) -> Vec<(&str, RGBColor)> {
    let mut techniques: Vec<(&str, RGBColor)> = Vec::new();
    for case in &results.cases {
        if !techniques.iter().any(|(known, _)| *known == case.technique) {
            let colour = if case.house { BLACK } else { COLOURS[techniques.len() % COLOURS.len()] };
            techniques.push((&case.technique, colour));
        }
    }
    techniques
}

fn font(pixels: i32) -> TextStyle<'static> {
    (FontFamily::SansSerif, pixels).into()
}

/// Round numbers within a range, few enough to be read.
fn ticks((low, high): (f64, f64)) -> Vec<f64> {
    let decades = libm::floor(libm::log10(low)) as i32..=libm::ceil(libm::log10(high)) as i32;
    let within = |steps: &[f64]| -> Vec<f64> {
        let all = decades
            .clone()
            .flat_map(|decade| steps.iter().map(move |step| step * libm::pow(10.0, f64::from(decade))));
        all.filter(|tick| (low..=high).contains(tick)).collect()
    };
    let finest = within(&[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0]);
    let coarser = [&[1.0, 2.0, 5.0][..], &[1.0]].map(within);
    [finest, coarser[0].clone()].into_iter().find(|ticks| ticks.len() <= TICKS).unwrap_or(coarser[1].clone())
}

/// A number as people write it.
fn quantity(value: f64) -> String {
    match value {
        value if value >= 1e6 => format!("{:.3} M", value / 1e6),
        value if value >= 1e4 => format!("{:.1} k", value / 1e3),
        value if value >= 10.0 => format!("{value:.0}"),
        value => format!("{value:.2}"),
    }
}
