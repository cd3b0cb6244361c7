//! The command line.

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use crate::bias::{self, BiasArguments};
use crate::catalogue_sheet::{self, CatalogueArguments};
use crate::contact_sheet::{self, ContactSheetArguments};
use crate::demo::{self, DemoArguments};
use crate::error::LabError;
use crate::extremes::{self, ExtremesArguments};
use crate::figures::{self, FiguresArguments};
use crate::footprint_command::{self, FootprintArguments};
use crate::lights::{self, LightsArguments};
use crate::measure::command::{self as measure, MeasureArguments};
use crate::progress::Progress;
use crate::render::{self, RenderArguments};
use crate::stability::{self, StabilityArguments};
use crate::tune::{self, TuneArguments};

/// Sees and proves shadow maps: scenes, ray-cast truth, scores, pictures.
#[derive(Debug, Parser)]
#[command(name = "cssm-lab", version)]
pub struct CommandLine {
    /// Draw no progress bars
    #[arg(long, global = true)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    Render(RenderArguments),
    Footprint(FootprintArguments),
    Demo(DemoArguments),
    ContactSheet(ContactSheetArguments),
    Catalogue(CatalogueArguments),
    Tune(TuneArguments),
    Extremes(ExtremesArguments),
    Figures(FiguresArguments),
    Lights(LightsArguments),
    Bias(BiasArguments),
    Stability(StabilityArguments),
    Measure(Box<MeasureArguments>),
}

/// Runs what the process's arguments say; results go to standard output, faults to standard error.
pub fn run() -> ExitCode {
    match run_command(&CommandLine::parse()) {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run_command(line: &CommandLine) -> Result<String, LabError> {
    let progress = if line.quiet { Progress::Hidden } else { Progress::Shown };
    match &line.command {
        Command::Render(arguments) => {
            let report = render::run(arguments, progress)?;
            Ok(render::summary(&report) + "\n")
        }
        Command::Demo(arguments) => {
            let (_, table) = demo::run(arguments, progress)?;
            Ok(table)
        }
        Command::ContactSheet(arguments) => contact_sheet::run(arguments, progress),
        Command::Catalogue(arguments) => catalogue_sheet::run(arguments, progress),
        Command::Figures(arguments) => figures::run(arguments, progress),
        Command::Bias(arguments) => bias::run(arguments, progress),
        Command::Stability(arguments) => stability::run(arguments, progress),
        Command::Lights(arguments) => lights::run(arguments, progress),
        Command::Extremes(arguments) => extremes::run(arguments, progress),
        Command::Measure(arguments) => measure::run(arguments, progress),
        Command::Tune(arguments) => tune::run(arguments, progress),
        Command::Footprint(arguments) => Ok(footprint_command::run(arguments)?),
    }
}
