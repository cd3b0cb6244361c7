//! What may stand on the command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use cssm_codegen::{Options, Target};

/// Turns declared light cases into shaders and tables.
#[derive(Debug, Parser)]
#[command(name = "shaders-gen", version)]
pub(crate) struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub(crate) command: Command,
}

impl Arguments {
    /// Whether reports are wanted as JSON.
    pub(crate) fn wants_json(&self) -> bool {
        let format = match &self.command {
            Command::Emit(emit) => emit.format,
            Command::Check(check) => check.format,
            Command::Explain(explain) => explain.format,
            Command::Reference => Format::Text,
        };
        format == Format::Json
    }
}

/// What to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Write the shaders and tables of every case.
    Emit(Emit),
    /// Check declarations and write nothing.
    Check(Check),
    /// Say what every case will do and what it costs.
    Explain(Explain),
    /// Print every field of a declaration with its range and default.
    Reference,
}

/// Arguments of `emit`.
#[derive(Debug, Args)]
pub(crate) struct Emit {
    /// Declaration files.
    #[arg(required = true, value_name = "FILES")]
    pub(crate) files: Vec<PathBuf>,
    /// Folder to write to; it is created where it is missing.
    #[arg(long, value_name = "DIR", default_value = ".")]
    pub(crate) out: PathBuf,
    /// What to write.
    #[arg(long, value_name = "TARGETS", value_delimiter = ',', default_values = ["wgsl", "spirv", "rust", "json"])]
    pub(crate) target: Vec<TargetName>,
    /// Path of the façade crate in generated Rust.
    #[arg(long, value_name = "PATH", default_value_t = Options::default().crate_path)]
    pub(crate) crate_path: String,
    /// How results and reports are printed.
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub(crate) format: Format,
}

/// Arguments of `check`.
#[derive(Debug, Args)]
pub(crate) struct Check {
    /// Declaration files.
    #[arg(required = true, value_name = "FILES")]
    pub(crate) files: Vec<PathBuf>,
    /// How results and reports are printed.
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub(crate) format: Format,
}

/// Arguments of `explain`.
#[derive(Debug, Args)]
pub(crate) struct Explain {
    /// Declaration files.
    #[arg(required = true, value_name = "FILES")]
    pub(crate) files: Vec<PathBuf>,
    /// How results and reports are printed.
    #[arg(long, value_name = "FORMAT", default_value = "text")]
    pub(crate) format: Format,
}

/// How results and reports are printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people.
    Text,
    /// For tools.
    Json,
}

/// Targets by their names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum TargetName {
    /// One WGSL file for each shader.
    Wgsl,
    /// One SPIR-V file for each shader with entry points.
    Spirv,
    /// One Rust module for each case.
    Rust,
    /// One JSON table for each case.
    Json,
}

impl TargetName {
    /// The generator's name of the target.
    pub(crate) fn target(self) -> Target {
        match self {
            Self::Wgsl => Target::Wgsl,
            Self::Spirv => Target::Spirv,
            Self::Rust => Target::Rust,
            Self::Json => Target::Json,
        }
    }
}
