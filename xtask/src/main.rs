//! Project commands: `cargo xtask demo | test | extremes | gen | validate`.
//!
//! Each command is a list of steps that run cargo, the shader generator or the lab, show what they do and how long
//! it took, and stop at the first failure with what to do about it. The commands that draw set the machine up first,
//! so that a fresh clone needs nothing but Rust. This crate links no graphics interface: it must build in seconds
//! and run where no driver is installed yet.

mod demo;
mod extremes;
mod failure;
mod generated;
mod setup;
mod steps;
mod tests;
mod validate;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

use failure::Failure;
use steps::Steps;

/// Commands of this project.
#[derive(Parser)]
#[command(name = "cargo xtask", about)]
struct Arguments {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Subcommand)]
enum Verb {
    /// Declare a sun, generate its shaders, render large scenes, check every pixel, leave pictures and a table.
    Demo {
        /// Folder for pictures and tables.
        #[arg(long, default_value = "out/demo")]
        out: String,
    },
    /// Prove everything: all tests, no snapshot left to review, generated files up to date.
    Test {
        /// Also run the long sweeps.
        #[arg(long)]
        full: bool,
        /// Arguments for `cargo test`, such as the name of one test.
        #[arg(last = true)]
        cargo: Vec<String>,
    },
    /// Take every technique to the extremes of view, light, scale and map; writes docs/extremes.md and its picture.
    Extremes,
    /// Write the generated files that are kept in the repository.
    Gen {
        /// Write nothing; fail if a file is not up to date.
        #[arg(long)]
        check: bool,
    },
    /// For developers: formatting, lints, documentation, and outside validators on every shipped case.
    Validate,
}

fn main() -> ExitCode {
    let arguments = Arguments::parse();
    match run(arguments.verb) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            eprintln!("\nerror: {failure}");
            ExitCode::FAILURE
        }
    }
}

fn run(verb: Verb) -> Result<(), Failure> {
    let mut steps = Steps::new()?;
    match verb {
        Verb::Demo { out } => demo::run(&mut steps, &out)?,
        Verb::Test { full, cargo } => tests::run(&mut steps, full, &cargo)?,
        Verb::Extremes => extremes::run(&mut steps)?,
        Verb::Gen { check: false } => generated::write(&mut steps)?,
        Verb::Gen { check: true } => generated::check(&mut steps)?,
        Verb::Validate => validate::run(&mut steps)?,
    }
    steps.summary();
    Ok(())
}
