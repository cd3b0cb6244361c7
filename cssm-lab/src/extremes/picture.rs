//! The table of techniques as a picture.

use super::situations::AXES;
use super::{Extremes, Row, table};
use crate::picture::{Colour, INK, LABEL_BACKGROUND, Picture};

const CELL_WIDTH: usize = 132;
const CELL_HEIGHT: usize = 42;
const NAME_WIDTH: usize = 480;
const MARGIN: usize = 8;
const GAP: usize = 2;

/// What holds, by the growth of its footprint, and what breaks.
const STEADY: Colour = [30, 92, 62];
const COARSER: Colour = [122, 104, 34];
const MUCH_COARSER: Colour = [140, 66, 28];
const BROKEN: Colour = [176, 24, 44];
const NOTHING: Colour = [48, 52, 60];

/// Growth of a footprint from which a cell counts as coarser, and as much coarser.
const COARSER_FROM: f64 = 10.0;
const MUCH_COARSER_FROM: f64 = 300.0;

/// One row for each technique, one column for each axis: the largest error in texels above the growth of the footprint.
pub fn picture(extremes: &Extremes) -> Picture {
    let rows: Vec<&Row> = extremes.rows.iter().filter(|row| row.is_variant).collect();
    let width = NAME_WIDTH + AXES.len() * (CELL_WIDTH + GAP) + MARGIN;
    let mut picture = Picture::filled(width, (rows.len() + 1) * (CELL_HEIGHT + GAP), LABEL_BACKGROUND);
    for (column, axis) in AXES.iter().enumerate() {
        picture.text(left(column) + MARGIN, 14, axis.name(), INK);
    }
    for (line, row) in rows.iter().enumerate() {
        let top = (line + 1) * (CELL_HEIGHT + GAP);
        let lines = Picture::lines(&row.name, NAME_WIDTH);
        let first = top + if lines.len() == 1 { 13 } else { 5 };
        for (line, text) in lines.iter().enumerate() {
            picture.text(MARGIN, first + 17 * line, text, INK);
        }
        for (column, found) in row.axes.iter().enumerate() {
            let broken = !found.breaks().is_empty();
            let colour = match found.blow_up() {
                _ if broken => BROKEN,
                _ if found.receivers == 0 => NOTHING,
                growth if growth >= MUCH_COARSER_FROM => MUCH_COARSER,
                growth if growth >= COARSER_FROM => COARSER,
                _ => STEADY,
            };
            picture.fill(left(column), top, CELL_WIDTH, CELL_HEIGHT, colour);
            let refused = found.refused();
            let refusals = if refused > 0 { format!(" {refused}r") } else { String::new() };
            if found.receivers > 0 {
                let texels = format!("{:.0e} tx", found.texels.value);
                picture.text(left(column) + MARGIN, top + 5, &texels, INK);
                let growth = format!("x {}{refusals}", table::short(found.blow_up()));
                picture.text(left(column) + MARGIN, top + 22, &growth, INK);
            } else {
                picture.text(left(column) + MARGIN, top + 13, refusals.trim(), INK);
            }
        }
    }
    let legend = "green: holds; amber, orange: holds, footprint 10, 300 times its best; red: breaks; r: typed refusals; \
                  tx: largest error of f32 across the map, texels";
    picture.titled(legend)
}

const fn left(column: usize) -> usize {
    NAME_WIDTH + column * (CELL_WIDTH + GAP)
}
