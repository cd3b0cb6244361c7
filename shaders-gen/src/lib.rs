//! Command line of the shader generator.
//!
//! `emit` writes the files of every case, `check` only looks, `explain` says what a case will do and cost,
//! `reference` prints every declared field. The command reads and writes files and does nothing else: what it writes
//! comes from `cssm-codegen`, byte for byte as the macro, the build script and the Rust builder have it. Nothing is
//! written before every case of every file has been generated.

mod arguments;
mod commands;
mod input;
pub mod shipped;

use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::Parser;

use arguments::{Arguments, Command};

/// Why a command fails; its display form is what the user reads.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Error {
    /// Files cannot be read or are at fault; the reports of all of them.
    #[error("{}", .0.text)]
    Input(input::Faults),
    /// The cases do not generate.
    #[error("error: {0}\n")]
    Generate(#[from] cssm_codegen::GenerateError),
    /// An output cannot be written.
    #[error("error: {0}\n")]
    Write(#[from] cssm_codegen::WriteError),
    /// The reader of the output is gone.
    #[error("error: cannot print: {0}\n")]
    Print(#[from] io::Error),
}

impl Error {
    /// `{"reports": [{"file", "errors": [..]}]}`; faults outside a file have no `file`.
    fn to_json(&self) -> serde_json::Value {
        match self {
            Self::Input(faults) => serde_json::json!({ "reports": faults.reports }),
            error => {
                let message = error.to_string();
                let message = message.trim_start_matches("error: ").trim_end();
                serde_json::json!({ "reports": [{ "errors": [{ "message": message }] }] })
            }
        }
    }
}

/// Runs the command line: exit code 0 when all is well, 1 with reports otherwise, 2 for arguments that make no sense.
///
/// Results go to `out`, reports to `complaints`; with `--format json` reports go to `out`, as JSON.
pub fn main(
    arguments: impl IntoIterator<Item = impl Into<OsString> + Clone>,
    out: &mut dyn Write,
    complaints: &mut dyn Write,
) -> ExitCode {
    let arguments = match Arguments::try_parse_from(arguments) {
        Ok(arguments) => arguments,
        Err(error) => {
            // A reader that is gone cannot be told so.
            let _ = if error.use_stderr() { write!(complaints, "{error}") } else { write!(out, "{error}") };
            return ExitCode::from(u8::try_from(error.exit_code()).unwrap_or(2));
        }
    };
    let result = match &arguments.command {
        Command::Emit(emit) => commands::emit(emit, out),
        Command::Check(check) => commands::check(check, out),
        Command::Explain(explain) => commands::explain(explain, out),
        Command::Reference => commands::reference(out),
    };
    let Err(error) = result else { return ExitCode::SUCCESS };
    if let Error::Print(gone) = &error
        && gone.kind() == io::ErrorKind::BrokenPipe
    {
        return ExitCode::SUCCESS;
    }
    // A reader that is gone cannot be told so.
    let _ = if arguments.wants_json() {
        writeln!(out, "{:#}", error.to_json())
    } else {
        write!(complaints, "{error}")
    };
    ExitCode::FAILURE
}
