//! Tables of footprints, each line of ours over one of the reference and one of the ratios.

use super::cases::BuiltIn;
use super::figures::Figures;
use super::grid::Class;
use super::omni::{IN_VIEW, LEAST_GAIN};
use super::{OmniRow, Row, medians};

const CASE_LETTERS: usize = 28;
const LIGHT_LETTERS: usize = 13;

/// The rows of one case: one line for each light, or medians over each class of lights.
pub(super) fn directional(built: &BuiltIn, rows: &[Row], each: bool, head: bool) -> String {
    let mut text = if head { heading() } else { String::new() };
    if each {
        for row in rows {
            let light = format!("{},{}", row.elevation_deg, row.azimuth_deg);
            text += &line(&built.name, &light, row.figures.array());
        }
        return text;
    }
    for class in Class::ALL {
        let Some(figures) = medians(rows, class) else { continue };
        text += &line(&built.name, class.name(), figures.array());
        let reference = built.reference.figures(class).array();
        if reference.iter().any(|number| !number.is_nan()) {
            let ours = figures.array();
            text += &line("", "reference", reference);
            text += &line("", "ratio", std::array::from_fn(|column| ours[column] / reference[column]));
        }
    }
    let unassigned: usize = rows.iter().map(|row| row.unassigned).sum();
    let multiple: usize = rows.iter().map(|row| row.multiply_assigned).sum();
    let least = rows.iter().map(|row| row.figures.beam_utilisation).fold(f64::INFINITY, f64::min);
    let bound = rows.iter().map(|row| row.p95_per_bound).fold(0.0, f64::max);
    text += &format!(
        "{:<CASE_LETTERS$}receivers in no facet: {unassigned}, in several: {multiple}; least use {least:.2}; p95 / bound at most {bound:.2}\n",
        ""
    );
    text
}

fn heading() -> String {
    let names = Figures::NAMES.map(|name| format!("{name:>10}"));
    format!("{:<CASE_LETTERS$}{:<LIGHT_LETTERS$}{}\n", "case", "light", names.concat())
}

fn line(case: &str, light: &str, numbers: [f64; 8]) -> String {
    let numbers = numbers
        .map(|number| if number.is_nan() { format!("{:>10}", "-") } else { format!("{number:>10.2}") });
    format!("{case:<CASE_LETTERS$}{light:<LIGHT_LETTERS$}{}\n", numbers.concat())
}

/// Logarithmic splits against face columns, light by light.
pub(super) fn against_splits(rows: &[Row]) -> String {
    let p95 = |name: &str| -> Vec<f64> {
        rows.iter().filter(|row| row.case == name).map(|row| row.figures.p95).collect()
    };
    let (splits, faces) = (p95("pssm4_log"), p95("face_columns_8"));
    if splits.len() != faces.len() || faces.is_empty() {
        return String::new();
    }
    let worst = splits.iter().zip(&faces).map(|(split, face)| split / face).fold(f64::INFINITY, f64::min);
    format!("pssm4_log p95 / face_columns_8 p95, worst light: {worst:.2}\n")
}

/// Omni lights: p95 beside the reference, and the bipyramid against the cube.
pub(super) fn omni(rows: &[OmniRow]) -> String {
    let mut text = format!("\n{:<16}{:<18}{:>10}{:>11}{:>8}\n", "omni", "lamp", "p95", "reference", "ratio");
    for OmniRow { place, measured } in rows {
        let [x, y, z] = place.position;
        let p95 = measured.figures.p95;
        text += &format!(
            "{:<16}{:<18}{p95:>10.2}{:>11.2}{:>8.2}{}\n",
            place.configuration,
            format!("{x}, {y}, {z}"),
            place.reference_p95,
            p95 / place.reference_p95,
            if measured.unassigned > 0 {
                format!("  {} in no facet", measured.unassigned)
            } else {
                String::new()
            }
        );
    }
    let p95 = |configuration: &str, position: [f64; 3]| {
        let row = rows
            .iter()
            .find(|row| row.place.configuration == configuration && row.place.position == position);
        row.map_or(f64::NAN, |row| row.measured.figures.p95)
    };
    for (position, least) in IN_VIEW.into_iter().zip(LEAST_GAIN) {
        let gain = p95("cube", position) / p95("eight_plane", position);
        text += &format!("cube / eight_plane at {} m: {gain:.1} (at least {least})\n", -position[2]);
    }
    text
}
