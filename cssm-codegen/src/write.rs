//! Writing files so that nobody ever sees half of one, and nothing is touched that has not changed.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Why a file cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("cannot write {}: {source}; check the folder and its permissions", path.display())]
pub struct WriteError {
    /// The file.
    pub path: PathBuf,
    /// What the system says.
    pub source: io::Error,
}

/// Writes a file at once, creating its folder; a file that already holds these bytes is left alone, time stamp
/// included. Returns whether it was written.
///
/// # Errors
/// A [`WriteError`] that names the file.
pub fn write_file(path: &Path, bytes: &[u8]) -> Result<bool, WriteError> {
    let fail = |source: io::Error| WriteError { path: path.to_owned(), source };
    if fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(false);
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(fail)?;
    }

    // Write beside the file, then rename: readers see the old bytes or the new ones.
    let mut beside = path.as_os_str().to_owned();
    beside.push(format!(".{}.tmp", std::process::id()));
    let beside = PathBuf::from(beside);
    let written = fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path));
    if written.is_err() {
        // The first failure is the one to report.
        let _ = fs::remove_file(&beside);
    }
    written.map_err(fail)?;
    Ok(true)
}
