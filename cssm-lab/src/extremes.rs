//! `cssm-lab extremes`: where each technique breaks.
//!
//! Every technique, variant, configuration and distribution is planned in situations that no engine has twice: depth
//! ranges, fields of view, aspects, offsets, light angles, scales and maps at their ends. A plan must be made or refused
//! with a reason and a remedy; every number must be finite; every receiver must have one facet; and what f32 makes of a
//! receiver must lie where f64 puts it, measured in texels.

pub mod casters;
pub mod controls;
pub mod found;
pub mod judge;
pub mod lights;
pub mod picture;
pub mod rounded;
pub mod situations;
pub mod subjects;
pub mod table;

use std::path::PathBuf;

use cssm_core::case::LightKind;
use rayon::prelude::*;
use serde::Serialize;

use casters::CasterFound;
use controls::Control;
use found::Found;
use judge::{Planner, house, judge};
use situations::{AXES, Axis, Situation, situations};
use subjects::{Subject, house_technique, subjects};

use crate::catalogue::KINDS;
use crate::error::LabError;
use crate::progress::Progress;
use crate::report_files::write_json;

/// Takes every technique to the extremes of view, light, scale and map, and says where each breaks.
#[derive(Debug, clap::Args)]
pub struct ExtremesArguments {
    /// Techniques by name; without any, all of them
    #[arg(long = "technique", value_name = "NAME")]
    techniques: Vec<String>,
    /// Every situation with many receivers; without it, one in seventeen with few
    #[arg(long)]
    full: bool,
    /// Write everything found as JSON
    #[arg(long, value_name = "OUT")]
    json: Option<PathBuf>,
    /// Write the tables as Markdown
    #[arg(long, value_name = "OUT")]
    markdown: Option<PathBuf>,
    /// Write the table as a picture
    #[arg(long, value_name = "OUT.png")]
    picture: Option<PathBuf>,
}

/// How much is swept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Extent {
    /// One situation in this many is taken.
    pub every: usize,
    /// Receivers of each plan.
    pub receivers: usize,
}

impl Extent {
    /// A sample that takes seconds.
    pub const SAMPLED: Self = Self { every: 17, receivers: 80 };
    /// Everything.
    pub const FULL: Self = Self { every: 1, receivers: 600 };
}

/// What a subject did.
#[derive(Debug, Clone, Serialize)]
pub struct Row {
    /// Name of its technique.
    pub technique: &'static str,
    /// Its name.
    pub name: String,
    /// Whether it stands for the technique.
    pub is_variant: bool,
    /// Whether it is the house's own technique, of which nothing may break.
    pub is_house: bool,
    /// What was found on each axis of [`AXES`].
    pub axes: Vec<Found>,
    /// What became of casters that are no proper triangles.
    pub casters: CasterFound,
}

/// Everything that was found.
#[derive(Debug, Clone, Serialize)]
pub struct Extremes {
    /// Names of the axes.
    pub axes: Vec<&'static str>,
    /// One row for each subject.
    pub rows: Vec<Row>,
    /// Known faults, and whether they were seen.
    pub controls: Vec<Control>,
}

/// Runs the command; returns the table for the terminal.
///
/// # Errors
/// A [`LabError`] that says what to change.
pub fn run(arguments: &ExtremesArguments, progress: Progress) -> Result<String, LabError> {
    let extent = if arguments.full { Extent::FULL } else { Extent::SAMPLED };
    let found = sweep(&arguments.techniques, extent, &house, progress)?;
    if let Some(path) = &arguments.json {
        write_json(path, &found)?;
    }
    let markdown = table::markdown(&found, extent);
    if let Some(path) = &arguments.markdown {
        std::fs::write(path, &markdown).map_err(|source| LabError::Write { path: path.clone(), source })?;
    }
    if let Some(path) = &arguments.picture {
        picture::picture(&found).write_png(path)?;
    }
    Ok(markdown)
}

/// Takes techniques (all, where none is named) through every axis.
///
/// # Errors
/// When a declaration, a view or a light of the lists makes no sense.
pub fn sweep(
    techniques: &[String],
    extent: Extent,
    planner: &Planner,
    progress: Progress,
) -> Result<Extremes, LabError> {
    let (subjects, house) = (subjects(techniques)?, house_technique()?);
    let mut by_kind: Vec<(LightKind, Vec<Situation>)> = Vec::new();
    for kind in KINDS {
        let all = situations(kind)?;
        let taken = all.into_iter().enumerate().filter(|(index, _)| index.is_multiple_of(extent.every));
        by_kind.push((kind, taken.map(|(_, situation)| situation).collect()));
    }
    let steps = |subject: &Subject| {
        let own = by_kind.iter().find(|(kind, _)| *kind == subject.case.light);
        own.map_or(&[][..], |(_, situations)| situations.as_slice())
    };
    let total: usize = subjects.iter().map(|subject| steps(subject).len()).sum();
    let bar = progress.bar(total as u64, "planning at the extremes");
    let rows = subjects
        .par_iter()
        .map(|subject| {
            let mut axes = vec![Found::default(); AXES.len()];
            for situation in steps(subject) {
                let place = AXES.iter().position(|axis: &Axis| *axis == situation.axis).unwrap_or(0);
                axes[place].merge(judge(subject, situation, extent.receivers, planner));
                bar.inc(1);
            }
            Row {
                technique: subject.technique.choice.name,
                name: subject.name.clone(),
                is_variant: subject.is_variant,
                is_house: subject.technique.choice.name == house,
                axes,
                casters: casters::judge(subject, steps(subject)),
            }
        })
        .collect();
    bar.finish_and_clear();
    Ok(Extremes {
        axes: AXES.iter().map(|axis| axis.name()).collect(),
        rows,
        controls: controls::controls()?,
    })
}
