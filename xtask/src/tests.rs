//! `cargo xtask test`: everything that proves the work.

use std::fs;
use std::path::{Path, PathBuf};

use crate::failure::{Failure, at};
use crate::steps::Steps;
use crate::{generated, setup};

/// Folders that hold no sources.
const OTHER_FOLDERS: [&str; 3] = ["target", "out", ".git"];

/// Runs all tests, then looks for snapshots left to review and stale generated files. What follows the tests is
/// silent unless it fails, so that the last lines shown are the tests' own results.
pub(crate) fn run(steps: &mut Steps, full: bool, arguments: &[String]) -> Result<(), Failure> {
    setup::run(steps)?;
    let mut tests = steps.cargo();
    tests.args(["test", "--workspace", "--no-fail-fast"]).args(arguments).env("INSTA_UPDATE", "no");
    if full {
        tests.env("CSSM_FULL", "1");
    }
    steps.run("tests", &mut tests)?;

    let mut left = Vec::new();
    left_snapshots(steps.root(), &mut left)?;
    if !left.is_empty() {
        let relative = left.iter().map(|path| path.strip_prefix(steps.root()).unwrap_or(path).to_owned());
        return Err(Failure::Snapshots(relative.collect()));
    }
    generated::check(steps)?;
    if full { generated::check_release(steps) } else { Ok(()) }
}

/// Collects snapshots that wait for review.
fn left_snapshots(folder: &Path, left: &mut Vec<PathBuf>) -> Result<(), Failure> {
    for entry in fs::read_dir(folder).map_err(at(folder))? {
        let entry = entry.map_err(at(folder))?;
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if entry.file_type().map_err(at(entry.path()))?.is_dir() {
            if !OTHER_FOLDERS.contains(&name.as_ref()) {
                left_snapshots(&entry.path(), left)?;
            }
        } else if name.ends_with(".snap.new") || name.ends_with(".pending-snap") {
            left.push(entry.path());
        }
    }
    Ok(())
}
