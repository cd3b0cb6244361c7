//! Results of a measurement, as they stand in its JSON file.
//!
//! The file is written after every cell, under another name first, so that a run that is cut short loses nothing. A cell
//! carries a key: a hash of everything that decides its numbers. A later run takes over the cells whose keys agree.

use std::collections::BTreeMap;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::error::MeasureError;
use super::evaluate::{Evaluation, Figures};
use crate::error::LabError;

/// Everything that was measured on a scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Results {
    /// The scene.
    pub scene: String,
    /// Triangles of the scene, instances counted.
    pub triangles: u64,
    /// Width and height of the images.
    pub pixels: (u32, u32),
    /// The adapter, or what stood in for it.
    pub adapter: String,
    /// The view paths.
    pub paths: Vec<PathEntry>,
    /// The cases, without sizes and filters.
    pub cases: Vec<CaseEntry>,
    /// Map sides in texels, ascending.
    pub sides: Vec<u32>,
    /// What was found, case by case and path by path.
    pub cells: Vec<Cell>,
}

/// A path of the results.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct PathEntry {
    /// Its name.
    pub name: String,
    /// What is special about it.
    pub summary: String,
    /// Stations that were judged.
    pub stations: usize,
}

/// A case of the results.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct CaseEntry {
    /// What it is called in tables and plots.
    pub label: String,
    /// Its technique.
    pub technique: String,
    /// Whether it is the customary form of its technique.
    pub customary: bool,
    /// Whether its technique is the one that a declaration without any stands for.
    pub house: bool,
    /// The declaration with its first size and filter; empty for cases of the user's own file.
    pub declaration: String,
}

/// One case at one size with one filter on one path.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// Hash of what decides its numbers.
    pub key: String,
    /// Label of the case.
    pub case: String,
    /// Map side in texels.
    pub side: u32,
    /// Name of the filter.
    pub filter: String,
    /// Name of the path.
    pub path: String,
    /// What was found.
    pub found: Evaluation,
}

/// A case at one size with one filter over all paths.
#[derive(Debug, Clone, PartialEq)]
pub struct Overall<'a> {
    /// The case.
    pub case: &'a CaseEntry,
    /// Map side in texels.
    pub side: u32,
    /// Name of the filter.
    pub filter: &'a str,
    /// Its cells, in the order of the paths.
    pub cells: Vec<&'a Cell>,
    /// Whether every station of every path could be planned.
    pub complete: bool,
    /// Share of light-facing pixels that is wrong, all paths together.
    pub mismatch: f64,
    /// Share that is wrong away from every edge and crease.
    pub interior: f64,
    /// Texel footprint p95, mean over the paths, screen pixels.
    pub footprint_p95: f64,
    /// Flicker, the worst of the paths.
    pub flicker: Option<f64>,
    /// Triangles that can matter to some facet, all facets together; mean over the paths.
    pub triangles: f64,
    /// Bytes of the map.
    pub map_bytes: u64,
    /// Time of capture and resolve as multiples of the reference's, mean over the paths that were timed.
    pub time: Option<f64>,
}

impl Results {
    /// Reads the results of an earlier run; nothing if there is no file.
    ///
    /// # Errors
    /// When the file is something else.
    pub fn read(path: &Path) -> Result<Option<Self>, MeasureError> {
        let text = match std::fs::read_to_string(path) {
            Ok(text) => text,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(MeasureError::Read { path: path.to_owned(), source }),
        };
        let read = serde_json::from_str(&text);
        read.map(Some).map_err(|source| MeasureError::Earlier { path: path.to_owned(), source })
    }

    /// Writes the file whole or not at all.
    ///
    /// # Errors
    /// When it cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), LabError> {
        let fail = |source| LabError::Write { path: path.to_owned(), source };
        let text = serde_json::to_string(self).map_err(|error| fail(error.into()))?;
        write_whole(path, &(text + "\n"))
    }

    /// The cells by key.
    pub fn by_key(self) -> BTreeMap<String, Cell> {
        self.cells.into_iter().map(|cell| (cell.key.clone(), cell)).collect()
    }

    /// The case of a label.
    pub fn case(&self, label: &str) -> Option<&CaseEntry> {
        self.cases.iter().find(|case| case.label == label)
    }

    /// Every case at every size with every filter, over all paths, in the order of the cells.
    pub fn overall(&self) -> Vec<Overall<'_>> {
        let mut groups: Vec<(&CaseEntry, u32, &str, Vec<&Cell>)> = Vec::new();
        for cell in &self.cells {
            let Some(case) = self.case(&cell.case) else { continue };
            let same = |group: &&mut (&CaseEntry, u32, &str, Vec<&Cell>)| {
                group.0.label == case.label && group.1 == cell.side && group.2 == cell.filter
            };
            match groups.iter_mut().find(same) {
                Some(group) => group.3.push(cell),
                None => groups.push((case, cell.side, &cell.filter, vec![cell])),
            }
        }
        groups.into_iter().map(|(case, side, filter, cells)| overall(case, side, filter, cells)).collect()
    }
}

fn overall<'a>(case: &'a CaseEntry, side: u32, filter: &'a str, cells: Vec<&'a Cell>) -> Overall<'a> {
    let figures: Vec<&Figures> = cells.iter().filter_map(|cell| cell.found.figures.as_ref()).collect();
    let facing: u64 = figures.iter().map(|found| found.facing_pixels).sum();
    let pooled = |share: fn(&Figures) -> f64| {
        let wrong: f64 = figures.iter().map(|found| share(found) * found.facing_pixels as f64).sum();
        if facing == 0 { 0.0 } else { wrong / facing as f64 }
    };
    let mean =
        |values: &[f64]| (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64);
    let all = |pick: fn(&Figures) -> f64| {
        mean(&figures.iter().map(|found| pick(found)).collect::<Vec<_>>()).unwrap_or_default()
    };
    let timed = figures.iter().filter_map(|found| found.times.as_ref());
    let times: Vec<f64> = timed.map(|times| times.whole.median).collect();
    Overall {
        case,
        side,
        filter,
        complete: !figures.is_empty() && cells.iter().all(|cell| cell.found.refusals.is_empty()),
        mismatch: pooled(|found| found.mismatch),
        interior: pooled(|found| found.interior),
        footprint_p95: all(|found| found.footprint.p95),
        flicker: figures.iter().filter_map(|found| found.flicker).reduce(f64::max),
        triangles: all(|found| found.counts.triangles_after_culling),
        map_bytes: figures.first().map_or(0, |found| found.counts.map_bytes),
        time: mean(&times),
        cells,
    }
}

/// Writes a text file whole or not at all.
///
/// # Errors
/// When it cannot be written.
pub(super) fn write_whole(path: &Path, text: &str) -> Result<(), LabError> {
    let fail = |source| LabError::Write { path: path.to_owned(), source };
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".part");
    let part = path.with_file_name(name);
    std::fs::write(&part, text).map_err(fail)?;
    std::fs::rename(&part, path).map_err(fail)
}
