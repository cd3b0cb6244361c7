//! `cargo xtask test`: everything that proves the work.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::failure::{Failure, at};
use crate::steps::Steps;
use crate::{generated, setup};

/// What names of test programs begin with that do nothing but draw.
const DEVICE_PREFIX: &str = "gpu_";
/// Folders that hold no sources.
const OTHER_FOLDERS: [&str; 3] = ["target", "out", ".git"];

/// Runs all tests, then looks for snapshots left to review and stale generated files. What follows the tests is
/// silent unless it fails, so that the last lines shown are the tests' own results.
pub(crate) fn run(steps: &mut Steps, full: bool, arguments: &[String]) -> Result<(), Failure> {
    setup::run(steps)?;
    if arguments.is_empty() {
        run_lanes(steps, full)?;
    } else {
        steps.run("tests", cargo_test(steps, full).args(arguments))?;
    }

    let mut left = Vec::new();
    left_snapshots(steps.root(), &mut left)?;
    if !left.is_empty() {
        let relative = left.iter().map(|path| path.strip_prefix(steps.root()).unwrap_or(path).to_owned());
        return Err(Failure::Snapshots(relative.collect()));
    }
    generated::check(steps)?;
    if full { generated::check_release(steps) } else { Ok(()) }
}

/// Runs the tests of the device beside all others: they take turns on the device and leave a core idle that the others use.
/// Those are the longer lane, because the last of them trace rays on every core that is free.
fn run_lanes(steps: &mut Steps, full: bool) -> Result<(), Failure> {
    steps.run("building tests", cargo_test(steps, full).arg("--no-run"))?;

    // The same workspace in every lane, so that cargo builds nothing twice.
    let (mut device, mut others) = (cargo_test(steps, full), cargo_test(steps, full));
    others.args(["--lib", "--bins", "--bench", "*"]);
    for (of_device, name) in test_names(steps.root())? {
        let lane = if of_device { &mut device } else { &mut others };
        lane.args(["--test", &name]);
    }
    steps.run_beside("tests", [("on the device", &mut device), ("elsewhere", &mut others)])?;
    steps.run("documentation tests", cargo_test(steps, full).arg("--doc"))
}

/// Cargo's tests of the whole workspace.
fn cargo_test(steps: &Steps, full: bool) -> Command {
    let mut tests = steps.cargo();
    tests.args(["test", "--workspace", "--no-fail-fast"]).env("INSTA_UPDATE", "no");
    if full {
        tests.env("CSSM_FULL", "1");
    }
    tests
}

/// Names of the workspace's test programs, and whether they draw.
fn test_names(root: &Path) -> Result<BTreeSet<(bool, String)>, Failure> {
    let mut names = BTreeSet::new();
    for package in fs::read_dir(root).map_err(at(root))? {
        let package = package.map_err(at(root))?.path();
        let tests = package.join("tests");
        if !package.join("Cargo.toml").is_file() || !tests.is_dir() {
            continue;
        }
        for file in fs::read_dir(&tests).map_err(at(&tests))? {
            let file = file.map_err(at(&tests))?.path();
            let name = file.file_stem().and_then(|stem| stem.to_str());
            if let Some(name) = name.filter(|_| file.extension().is_some_and(|extension| extension == "rs")) {
                names.insert((name.starts_with(DEVICE_PREFIX), name.to_owned()));
            }
        }
    }
    Ok(names)
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
