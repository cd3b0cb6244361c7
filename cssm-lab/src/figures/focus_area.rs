//! How much of the map the focus region covers, over the angle between the eye's and the light's line of sight (Martin and
//! Tan, Anti-aliasing and continuity with trapezoidal shadow maps, figure 6).

use cssm_core::facet::Facet;
use cssm_core::glam::{DMat3, DVec3};
use cssm_core::polygon;
use cssm_core::receivers::Polytope;
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use rayon::prelude::*;

use super::canvas::{PAPER, PEN, heat};
use super::cases::{case, variant, with_argument};
use super::{Figure, FigureOptions};
use crate::error::LabError;
use crate::picture::Picture;

/// Depths of the view and of the end of the focus region, metres.
const NEAR: f64 = 0.5;
const FAR: f64 = 200.0;
const FOCUS: f64 = 20.0;
const FOV_DEGREES: f64 = 60.0;
const SIDE_TEXELS: u32 = 1024;
/// Pixels from the middle of a plot to 180 degrees.
const RADIUS: usize = 180;
/// Contours are drawn at these shares of the map.
const CONTOURS: [f64; 4] = [0.02, 0.1, 0.2, 0.3];
/// Share of the map with the lightest colour.
const LIGHTEST: f64 = 0.6;
/// Room around plots.
const MARGIN: usize = 14;
const LINE: usize = 17;

/// The view that every figure about angles has.
///
/// # Errors
/// Never, for these numbers.
pub fn view() -> Result<View, LabError> {
    let fov = FOV_DEGREES.to_radians();
    Ok(View::perspective(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, fov, NEAR, FAR, (640, 640))?)
}

/// The light whose line of sight makes an angle with the eye's, both given as a point of the plane: its distance from the
/// origin is the angle in degrees, its direction that in which the light's line of sight leans.
///
/// # Errors
/// Never, for finite numbers.
pub fn light(x_degrees: f64, y_degrees: f64) -> Result<Light, LabError> {
    let angle = libm::hypot(x_degrees, y_degrees).to_radians();
    let turn = libm::atan2(y_degrees, x_degrees);
    let (sine, cosine) = (libm::sin(angle), libm::cos(angle));
    Ok(Light::directional_travelling(DVec3::new(sine * libm::cos(turn), sine * libm::sin(turn), -cosine))?)
}

/// Share of the map's texels whose beams meet the focus region.
pub fn focus_share(plan: &ShadowPlan, view: &View, focus_metres: f64) -> f64 {
    let region = Polytope::frustum(view, focus_metres);
    let world_from_camera = view.camera_from_world.transpose();
    let covered = |facet: &Facet| {
        let turn = |matrix: DMat3, row: &cssm_core::glam::DVec4| (matrix * row.truncate()).extend(row.w);
        let select: Vec<_> = facet.select.iter().map(|row| turn(view.camera_from_world, row)).collect();
        let own = region.cut_by(&select);
        let vertices: Vec<_> = own.vertices.iter().map(|vertex| turn(world_from_camera, vertex)).collect();
        let outline = polygon::outline(&facet.rows, &vertices);
        // The tile's clip space has area 4.
        0.25 * polygon::area(&polygon::image(&facet.rows, &outline)) * facet.tile.texels() as f64
    };
    let (width, height) = plan.map_size_texels;
    plan.facets.iter().map(covered).sum::<f64>() / (f64::from(width) * f64::from(height))
}

/// The share of a case under a light; `None` where there is no plan.
pub fn share(case: &LightCase, view: &View, x_degrees: f64, y_degrees: f64) -> Option<f64> {
    let light = light(x_degrees, y_degrees).ok()?;
    let plan = plan(case, view, &light, &SceneBounds::default()).ok()?;
    Some(focus_share(&plan, view, FOCUS))
}

/// The techniques side by side: the trapezoids of the paper, one plane, face columns.
///
/// # Errors
/// When a declaration is not sound.
pub fn cases() -> Result<Vec<(String, LightCase)>, LabError> {
    let mut declared = Vec::new();
    for (word, name) in [("", "trapezoidal, original"), ("focused", "trapezoidal, focused")] {
        if let Some(variant) = variant("trapezoidal", word) {
            declared.push((name, with_argument(variant, &format!("focus: {FOCUS} m")), String::new()));
        }
    }
    let rows = format!("distribution: perspective {{ focus: {FOCUS} m, share: 0.8 }}, stretch: none,");
    declared.push((
        "one plane, same focus",
        "camera_space".into(),
        format!("configurations: [one_plane], {rows}"),
    ));
    declared.push(("face columns, 8 bands", "camera_space".into(), String::new()));
    let build = |(name, technique, fields): (&str, String, String)| {
        Ok((name.to_owned(), case(&technique, &fields, SIDE_TEXELS, FAR)?))
    };
    declared.into_iter().map(build).collect()
}

/// Draws the figure.
///
/// # Errors
/// When a declaration is not sound.
pub fn figure(options: &FigureOptions) -> Result<Figure, LabError> {
    let view = view()?;
    let step = if options.quick { 12 } else { 4 };
    let plots: Vec<Picture> = cases()?.iter().map(|(name, case)| plot(name, case, &view, step)).collect();
    let title = format!(
        "Share of the map that the focus region ({NEAR} to {FOCUS} m of {FAR} m) covers, over the angle between the eye's and the \
         light's line of sight as a point of the plane: middle: light from behind; rings: 90 and 180 degrees (light ahead)"
    );
    let joined = Picture::beside(&plots);
    let mut scale = Picture::filled(joined.width, 3 * LINE, PAPER);
    let left = MARGIN + 60;
    for x in 0..400 {
        scale.fill(left + x, 4, 1, LINE, heat(x as f64 / 399.0));
    }
    for percent in [0, 10, 20, 30, 40, 50, 60_usize] {
        scale.text(left + 400 * percent / 60, LINE + 8, &format!("{percent}%"), PEN);
    }
    let text = "White lines: 2, 10, 20 and 30 %; grey: no plan";
    scale.text(left + 480, 6, text, PEN);
    Ok(Figure {
        file: "focus-area.png",
        picture: Picture::stacked(&[joined, scale]).titled(&title),
        shows: "Trapezoidal paper, figure 6: share of the map that the focus region covers, over the angle between the two \
                lines of sight",
        data: None,
    })
}

fn plot(name: &str, case: &LightCase, view: &View, step: usize) -> Picture {
    let size = 2 * (RADIUS + MARGIN);
    let degrees = |pixel: usize| (pixel as f64 - (RADIUS + MARGIN) as f64) * 180.0 / RADIUS as f64;

    // Plan on a lattice and interpolate between its points.
    let points = size / step + 2;
    let lattice: Vec<Option<f64>> = (0..points * points)
        .into_par_iter()
        .map(|index| {
            let (x, y) = (degrees(index % points * step), -degrees(index / points * step));
            (libm::hypot(x, y) <= 181.0 + step as f64).then(|| share(case, view, x, y)).flatten()
        })
        .collect();
    let at = |x: usize, y: usize| {
        let (column, row) = (x / step, y / step);
        let (right, down) = ((x % step) as f64 / step as f64, (y % step) as f64 / step as f64);
        let value = |column: usize, row: usize| lattice[row * points + column];
        let upper = value(column, row)? * (1.0 - right) + value(column + 1, row)? * right;
        let lower = value(column, row + 1)? * (1.0 - right) + value(column + 1, row + 1)? * right;
        Some(upper * (1.0 - down) + lower * down)
    };

    let mut picture = Picture::filled(size, size + 2 * LINE, PAPER);
    let mut extremes = (f64::INFINITY, 0.0_f64);
    for y in 0..size - 1 {
        for x in 0..size - 1 {
            let angle = libm::hypot(degrees(x), degrees(y));
            if angle > 180.0 {
                continue;
            }
            let Some(share) = at(x, y) else {
                picture.set(x, y + LINE, [150, 150, 150]);
                continue;
            };
            extremes = (extremes.0.min(share), extremes.1.max(share));
            let beside = [at(x + 1, y), at(x, y + 1)];
            let crosses =
                |level: &f64| beside.iter().flatten().any(|other| (share < *level) != (*other < *level));
            let ring = (angle - 90.0).abs() < 0.5 || (angle - 180.0).abs() < 1.0;
            let colour = if CONTOURS.iter().any(crosses) { [255; 3] } else { heat(share / LIGHTEST) };
            picture.set(x, y + LINE, if ring { PEN } else { colour });
        }
    }
    picture.text(MARGIN, 2, name, PEN);
    let range = format!("{:.1} to {:.0} %", 100.0 * extremes.0, 100.0 * extremes.1);
    picture.text(MARGIN, size + LINE, &range, PEN);
    picture
}
