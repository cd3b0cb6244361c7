//! Folders and files of results.

use std::path::Path;

use serde::Serialize;

use crate::error::LabError;

/// Writes a value as JSON that people can read.
///
/// # Errors
/// When the file cannot be written.
pub fn write_json(path: &Path, value: &impl Serialize) -> Result<(), LabError> {
    let fail = |source| LabError::Write { path: path.to_owned(), source };
    let mut text = serde_json::to_string_pretty(value).map_err(|error| fail(error.into()))?;
    text.push('\n');
    std::fs::write(path, text).map_err(fail)
}

/// Creates a folder and those it lies in.
///
/// # Errors
/// When it cannot be created.
pub fn create_folder(path: &Path) -> Result<(), LabError> {
    std::fs::create_dir_all(path).map_err(|source| LabError::Write { path: path.to_owned(), source })
}
