//! Where the house's own technique wins and where it loses, path by path at equal texels.

use super::evaluate::Figures;
use super::results::{CaseEntry, Cell, Results};

/// What is compared; less is better.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Share of light-facing pixels that is wrong.
    Mismatch,
    /// Texel footprint, 95th percentile.
    Footprint,
    /// Distance between true edges and the map's, 95th percentile.
    Edges,
    /// Share of points that flicker.
    Flicker,
}

/// All that is compared.
pub const MEASURES: [Measure; 4] = [Measure::Mismatch, Measure::Footprint, Measure::Edges, Measure::Flicker];

/// The house's customary case against the best of every other technique, on one path at one size with one filter.
#[derive(Debug, Clone, PartialEq)]
pub struct Contest<'a> {
    /// The path.
    pub path: &'a str,
    /// Map side in texels.
    pub side: u32,
    /// The filter.
    pub filter: &'a str,
    /// What the house's case has.
    pub subject: f64,
    /// What the best case of each other technique has, in the order of the cases.
    pub rivals: Vec<Rival<'a>>,
}

/// The best case of another technique.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rival<'a> {
    /// The technique.
    pub technique: &'a str,
    /// Its best case; absent where none of its cases could be planned at every station.
    pub best: Option<(&'a str, f64)>,
}

impl Measure {
    /// Heading in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mismatch => "mismatch",
            Self::Footprint => "footprint p95",
            Self::Edges => "edge displacement p95",
            Self::Flicker => "flicker",
        }
    }

    /// The number, if it was measured.
    pub const fn of(self, figures: &Figures) -> Option<f64> {
        match self {
            Self::Mismatch => Some(figures.mismatch),
            Self::Footprint => Some(figures.footprint.p95),
            Self::Edges => Some(figures.edge_pixels_p95),
            Self::Flicker => figures.flicker,
        }
    }

    /// The number as text, with its unit.
    pub fn text(self, value: f64) -> String {
        match self {
            Self::Mismatch | Self::Flicker => format!("{:.3} %", 100.0 * value),
            Self::Footprint | Self::Edges => format!("{value:.2} px"),
        }
    }
}

impl Contest<'_> {
    /// How many times the rival's number is the subject's; below 1 the subject loses.
    pub fn lead(&self, value: f64) -> f64 {
        if value == self.subject { 1.0 } else { value / self.subject }
    }

    /// Rivals that are better than the subject.
    pub fn losses(&self) -> impl Iterator<Item = (&Rival<'_>, f64)> {
        let better =
            |rival: &Rival<'_>| rival.best.map(|(_, value)| self.lead(value)).filter(|lead| *lead < 1.0);
        self.rivals.iter().filter_map(move |rival| Some((rival, better(rival)?)))
    }
}

/// The case that stands for the house: its customary one.
pub fn subject(results: &Results) -> Option<&CaseEntry> {
    let mut own = results.cases.iter().filter(|case| case.house);
    let first = own.clone().next();
    own.find(|case| case.customary).or(first)
}

/// Techniques other than the subject's, in the order of the cases.
pub fn rival_techniques<'a>(results: &'a Results, subject: &CaseEntry) -> Vec<&'a str> {
    let mut techniques: Vec<&str> = Vec::new();
    for case in results.cases.iter().filter(|case| case.technique != subject.technique) {
        if !techniques.contains(&case.technique.as_str()) {
            techniques.push(&case.technique);
        }
    }
    techniques
}

/// Every contest of a measure; none where the house does not take part.
pub fn contests(results: &Results, measure: Measure) -> Vec<Contest<'_>> {
    let Some(subject) = subject(results) else { return Vec::new() };
    let techniques = rival_techniques(results, subject);
    let own = results.cells.iter().filter(|cell| cell.case == subject.label);
    let contest = |cell: &'_ Cell| -> Option<Contest<'_>> {
        let cell = results.cells.iter().find(|known| known.key == cell.key)?;
        let level =
            |other: &&Cell| (&other.path, other.side, &other.filter) == (&cell.path, cell.side, &cell.filter);
        let best = |technique: &&str| -> Option<(&str, f64)> {
            let of_technique =
                |other: &&Cell| results.case(&other.case).is_some_and(|case| case.technique == **technique);
            let cells = results.cells.iter().filter(level).filter(of_technique);
            cells
                .filter_map(|other| Some((other.case.as_str(), complete(other, measure)?)))
                .min_by(|(_, one), (_, two)| one.total_cmp(two))
        };
        Some(Contest {
            path: &cell.path,
            side: cell.side,
            filter: &cell.filter,
            subject: complete(cell, measure)?,
            rivals: techniques.iter().map(|technique| Rival { technique, best: best(technique) }).collect(),
        })
    };
    own.filter_map(contest).collect()
}

/// The number of a cell whose every station was planned.
fn complete(cell: &Cell, measure: Measure) -> Option<f64> {
    let figures = cell.found.figures.as_ref().filter(|_| cell.found.refusals.is_empty())?;
    measure.of(figures)
}
