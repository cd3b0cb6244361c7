//! What a warped map does to the view: outline, focus region and lines of the view in map coordinates, for the two
//! problems of trapezoidal maps that the parallel-split slides show and for their remedy.

use cssm_core::glam::{DVec2, DVec3, DVec4};
use cssm_core::homography::Gradients;
use cssm_core::polygon;
use cssm_core::receivers::Polytope;
use cssm_core::{LightCase, SceneBounds, ShadowPlan, View, plan};
use embedded_graphics::Drawable as _;
use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::{Line, Primitive as _, PrimitiveStyle};
use plotters::prelude::*;

use super::canvas::{Canvas, LINES, PAPER, PEN, paint};
use super::cases::{case, variant, with_argument};
use super::{Figure, FigureOptions, drawn, focus_area, legend};
use crate::error::LabError;
use crate::picture::{Colour, Picture};

const FAR: f64 = 200.0;
const SIDE_TEXELS: u32 = 1024;
/// Share of the map's rows that the focus region is to have.
const SHARE: f64 = 0.8;
/// Side of a map picture, and size of a chart.
const SIDE: usize = 340;
const CHART: (usize, usize) = (330, 340);
const MARGIN: usize = 12;
/// Depths of the view's lines, metres, and lines of sight between the left and the right edge.
const DEPTHS: [f64; 9] = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0];
const SIGHTS: usize = 9;
/// Steps of a line.
const STEPS: usize = 64;

const FOCUS_FILL: Colour = [255, 224, 178];
const OUTLINE: Colour = [0, 92, 170];
const GRID: Colour = [120, 124, 132];
const FOCUS_LINE: Colour = [196, 30, 40];

/// The problems: the light under which each shows, as a point of the plane of angles in degrees, and the focus in metres.
const PROBLEMS: [(&str, (f64, f64), f64); 2] = [
    ("Problem 1: the focus region reaches beyond the focus line", (38.0, -42.0), 20.0),
    ("Problem 2: the foreground is stretched more than the view itself does", (0.0, -90.0), 1.5),
];

/// Draws the figure; without trapezoidal maps there is none.
///
/// # Errors
/// When a declaration is not sound.
pub fn figure(_: &FigureOptions) -> Result<Figure, LabError> {
    let view = focus_area::view()?;
    let mut problems = Vec::new();
    for (problem, (x, y), focus) in PROBLEMS {
        let light = focus_area::light(x, y)?;
        let declared = declared(focus)?;
        let mut pictures = Vec::new();
        let mut plans = Vec::new();
        for (name, case) in &declared {
            let plan = plan(case, &view, &light, &SceneBounds::default())?;
            pictures.push(map(name, &plan, &view, focus));
            plans.push((*name, plan));
        }
        for axis in 0..2 {
            pictures.push(chart(&plans, &view, axis)?);
        }
        let title = format!("{problem} (light {x}, {y} degrees off the line of sight, focus {focus} m)");
        problems.push(Picture::beside(&pictures).titled(&title));
    }
    let title = format!(
        "Maps as the light fills them: blue: the view; orange: focus region; grey: lines of equal depth and \
         of sight at the eye's height; red: the focus line with {:.0} % of the rows before it",
        100.0 * SHARE
    );
    Ok(Figure {
        file: "trapezoidal-problems.png",
        picture: Picture::stacked(&problems).titled(&title),
        shows: "Parallel-split slides: trapezoidal problems 1 (focus region not preserved in the general case) and 2 \
                (unexpected stretching on the foreground) as map pictures, the focused remedy in x and z, one plane beside",
        data: None,
    })
}

/// The trapezoids with their line at its share, and one plane with the same share before the same focus.
fn declared(focus: f64) -> Result<Vec<(&'static str, LightCase)>, LabError> {
    let mut declared = Vec::new();
    for (word, name) in [("", "original"), ("focused", "focused")] {
        if let Some(variant) = variant("trapezoidal", word) {
            let technique = with_argument(variant, &format!("focus: {focus} m, line: fixed"));
            declared.push((name, case(&technique, "", SIDE_TEXELS, FAR)?));
        }
    }
    let rows = format!("distribution: perspective {{ focus: {focus} m, share: {SHARE} }}, stretch: none,");
    let fields = format!("configurations: [one_plane], {rows}");
    declared.push(("one plane", case("camera_space", &fields, SIDE_TEXELS, FAR)?));
    Ok(declared)
}

/// The first facet's map with the view's lines.
fn map(name: &str, plan: &ShadowPlan, view: &View, focus_metres: f64) -> Picture {
    let mut picture = Picture::filled(SIDE + 2 * MARGIN, SIDE + 2 * MARGIN + 20, PAPER);
    picture.text(MARGIN, 4, name, PEN);
    let Some(facet) = plan.facets.first() else { return picture };
    let rows = &facet.rows;
    let plain = |point: DVec4| {
        let w = rows.w.dot(point);
        (w > 0.0).then(|| DVec2::new(rows.x.dot(point) / w, rows.remap.y(rows.y.dot(point) / w)))
    };
    let world = |camera: DVec3| (view.camera_from_world.transpose() * camera).extend(1.0);

    // Show tiles that lie on their side upright.
    let along = [view.near_metres, FAR].map(|depth| plain(world(DVec3::NEG_Z * depth)).unwrap_or_default());
    let turned = (along[1].x - along[0].x).abs() > (along[1].y - along[0].y).abs();
    let upright = |point: DVec2| if turned { DVec2::new(point.y, point.x) } else { point };
    let image = |point: DVec4| plain(point).map(upright);
    let pixel = |ndc: DVec2| {
        let along = |value: f64| (value * 0.5 + 0.5) * SIDE as f64;
        DVec2::new(MARGIN as f64 + along(ndc.x), (MARGIN + 20) as f64 + along(-ndc.y))
    };

    // Fill the focus region.
    let region = Polytope::frustum(view, focus_metres);
    let vertices: Vec<DVec4> = region.vertices.iter().map(|vertex| world(vertex.truncate())).collect();
    let focus = polygon::outline(rows, &vertices);
    let inside = |point: DVec2| {
        let point = upright(point);
        let edges = focus.iter().zip(focus.iter().cycle().skip(1));
        edges.into_iter().all(|(one, two)| (*two - *one).perp_dot(point - *one) >= 0.0)
    };
    for y in 0..SIDE {
        for x in 0..SIDE {
            let along = |pixel: usize| 2.0 * (pixel as f64 + 0.5) / SIDE as f64 - 1.0;
            if inside(DVec2::new(along(x), -along(y))) {
                picture.set(MARGIN + x, MARGIN + 20 + y, FOCUS_FILL);
            }
        }
    }

    // Draw lines of equal depth and of sight; where lines crowd, only some have room for their depth.
    let mut named: Option<DVec2> = None;
    for depth in DEPTHS.into_iter().filter(|depth| *depth >= view.near_metres) {
        let point = |step: usize| {
            let x = view.left + (view.right - view.left) * step as f64 / STEPS as f64;
            image(world(DVec3::new(x, 0.0, -1.0) * depth)).map(pixel)
        };
        polyline(&mut picture, (0..=STEPS).map(point), GRID, 1);
        if let Some(end) = point(STEPS).filter(|end| named.is_none_or(|last| last.distance(*end) > 15.0)) {
            named = Some(end);
            let (x, y) = (end.x.clamp(0.0, (SIDE - 40) as f64), end.y.max(0.0));
            picture.text(x as usize + 3, y as usize, &format!("{depth}"), GRID);
        }
    }
    for sight in 0..SIGHTS {
        let x = view.left + (view.right - view.left) * sight as f64 / (SIGHTS - 1) as f64;
        let point = |step: usize| {
            let depth = view.near_metres * libm::pow(FAR / view.near_metres, step as f64 / STEPS as f64);
            image(world(DVec3::new(x, 0.0, -1.0) * depth)).map(pixel)
        };
        polyline(&mut picture, (0..=STEPS).map(point), GRID, 1);
    }

    // Outline the view, and mark the line that the focus is to reach from the eye's side.
    let outline = polygon::outline(rows, &facet.receivers);
    let closed = outline.iter().chain(outline.first()).map(|point| Some(pixel(upright(*point))));
    polyline(&mut picture, closed, OUTLINE, 2);
    let side = |depth: f64| image(world(DVec3::NEG_Z * depth)).map_or(0.0, |image| image.y);
    let sign = if side(FAR) >= side(view.near_metres) { 1.0 } else { -1.0 };
    let line = sign * (2.0 * SHARE - 1.0);
    let ends = [DVec2::new(-1.0, line), DVec2::new(1.0, line)].map(|point| Some(pixel(point)));
    polyline(&mut picture, ends.into_iter(), FOCUS_LINE, 2);
    picture.outline(MARGIN, MARGIN + 20, SIDE, SIDE, PEN);
    picture
}

fn polyline(picture: &mut Picture, points: impl Iterator<Item = Option<DVec2>>, colour: Colour, width: u32) {
    let style = PrimitiveStyle::with_stroke(Rgb888::new(colour[0], colour[1], colour[2]), width);
    let mut last: Option<DVec2> = None;
    for point in points {
        if let (Some(from), Some(to)) = (last, point) {
            let place = |point: DVec2| Point::new(point.x.round() as i32, point.y.round() as i32);
            // Drawing on a picture cannot fail.
            let _ = Line::new(place(from), place(to)).into_styled(style).draw(picture);
        }
        last = point;
    }
}

/// Texels per pixel over depth on the line of sight, across the map (0: x) or along it (1: z).
fn chart(plans: &[(&str, ShadowPlan)], view: &View, axis: usize) -> Result<Picture, LabError> {
    const SHOWN: std::ops::Range<f64> = 1e-3..30.0;
    let mut picture = Picture::filled(CHART.0, CHART.1 + 2 * MARGIN + 20, PAPER);
    let area = Canvas(&mut picture).into_drawing_area();
    let caption = ["texels per pixel across (x)", "texels per pixel along (z)"][axis];
    let mut chart = drawn(
        ChartBuilder::on(&area)
            .caption(caption, ("monospace", 15).into_font().color(&paint(PEN)))
            .margin(6)
            .margin_right(20)
            .x_label_area_size(42)
            .y_label_area_size(52)
            .build_cartesian_2d((view.near_metres..FAR).log_scale(), SHOWN.log_scale()),
    )?;
    drawn(
        chart
            .configure_mesh()
            .x_desc("depth, m")
            .x_labels(6)
            .y_label_formatter(&|value| format!("{value:e}"))
            .light_line_style(paint([240, 240, 238]))
            .bold_line_style(paint([220, 220, 218]))
            .draw(),
    )?;
    for (index, (name, plan)) in plans.iter().enumerate() {
        let point = |step: usize| {
            let depth = view.near_metres * libm::pow(0.999 * FAR / view.near_metres, step as f64 / 200.0);
            let point = view.camera_from_world.transpose() * DVec3::NEG_Z * depth;
            let facet = plan.facet(plan.selection.cell(point.extend(1.0)))?;
            let (across, up) = Gradients::at(&facet.rows, point).across_light();
            let texels =
                [across * 2.0 / f64::from(facet.tile.width), up * 2.0 / f64::from(facet.tile.height)];
            let sideways = |texel: DVec3| (view.camera_from_world * texel.normalize()).x.abs();
            let turned = sideways(texels[0]) < sideways(texels[1]);
            let metres = texels.map(DVec3::length);
            let axis = if turned { 1 - axis } else { axis };
            let density = depth / (metres[axis] * view.pixels_per_tangent());
            SHOWN.contains(&density).then_some((depth, density))
        };
        // One plane often covers the focused rule's line: that one is drawn broader below it.
        let style = paint(LINES[index]).stroke_width(if index == 1 { 6 } else { 2 });
        drawn(chart.draw_series(LineSeries::new((0..=200).filter_map(point), style)))?
            .label(*name)
            .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 18, y)], style));
    }
    legend(&mut chart, SeriesLabelPosition::LowerLeft)?;
    drop(chart);
    drop(area);
    Ok(picture)
}
