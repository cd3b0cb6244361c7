//! Reads declaration files and gathers the faults of all of them.

use std::fs;
use std::path::{Path, PathBuf};

use cssm_codegen::dsl::{self, Report};
use cssm_core::LightCase;

use crate::Error;

/// The cases of one file.
#[derive(Debug)]
pub(crate) struct Input {
    /// The file.
    pub(crate) path: PathBuf,
    /// Its cases.
    pub(crate) cases: Vec<LightCase>,
}

/// Faults of files, rendered for people and for tools.
#[derive(Debug)]
pub(crate) struct Faults {
    /// Plain text, one paragraph for each fault.
    pub(crate) text: String,
    /// One entry for each file at fault.
    pub(crate) reports: Vec<serde_json::Value>,
}

/// Reads every file, or reports the faults of all of them.
pub(crate) fn read(paths: &[PathBuf]) -> Result<Vec<Input>, Error> {
    let mut inputs = Vec::new();
    let mut texts = Vec::new();
    let mut reports = Vec::new();
    for path in paths {
        match read_one(path) {
            Ok(input) => inputs.push(input),
            Err(fault) => {
                texts.push(fault.text());
                reports.push(fault.json(path));
            }
        }
    }
    if texts.is_empty() {
        return Ok(inputs);
    }
    Err(Error::Input(Faults { text: texts.concat(), reports }))
}

/// Why one file gives no cases.
enum Fault {
    Unreadable(String),
    Declaration(Report),
}

impl Fault {
    fn text(&self) -> String {
        match self {
            Self::Unreadable(message) => format!("error: {message}\n"),
            Self::Declaration(report) => report.render(),
        }
    }

    fn json(&self, path: &Path) -> serde_json::Value {
        match self {
            Self::Unreadable(message) => {
                serde_json::json!({ "file": path.display().to_string(), "errors": [{ "message": message }] })
            }
            // A report is valid JSON by construction.
            Self::Declaration(report) => serde_json::from_str(&report.to_json()).unwrap_or_default(),
        }
    }
}

fn read_one(path: &Path) -> Result<Input, Fault> {
    let text = fs::read_to_string(path).map_err(|error| {
        Fault::Unreadable(format!(
            "cannot read {}: {error}; give the path of a declaration file",
            path.display()
        ))
    })?;
    let cases = dsl::parse_file(&path.display().to_string(), &text).map_err(Fault::Declaration)?;
    Ok(Input { path: path.to_owned(), cases })
}
