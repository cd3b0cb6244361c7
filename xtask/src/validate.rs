//! `cargo xtask validate`: what developers look at before they hand in.

use std::fs;
use std::path::PathBuf;
use std::process::Command;

use crate::failure::{Failure, at};
use crate::generated::{cases, scratch};
use crate::setup;
use crate::steps::Steps;

/// Environment that the emitted SPIR-V is for.
const SPIRV_ENVIRONMENT: &str = "vulkan1.1";

/// Checks formatting, lints, documentation and dependencies, then every shipped case with outside validators.
pub(crate) fn run(steps: &mut Steps) -> Result<(), Failure> {
    setup::run(steps)?;
    let mut format = steps.cargo();
    steps.run("formatting", format.args(["fmt", "--all", "--check"]))?;
    let mut lints = steps.cargo();
    lints.args(["clippy", "--quiet", "--workspace", "--all-targets", "--", "-D", "warnings"]);
    steps.run("lints", &mut lints)?;
    let mut docs = steps.cargo();
    docs.args(["doc", "--quiet", "--workspace", "--no-deps"]).env("RUSTDOCFLAGS", "-D warnings");
    steps.run("documentation", &mut docs)?;
    dependencies(steps)?;
    shaders(steps)
}

/// Licences and advisories, where cargo-deny is installed.
fn dependencies(steps: &mut Steps) -> Result<(), Failure> {
    let mut deny = steps.cargo();
    if !deny.args(["deny", "--version"]).output().is_ok_and(|output| output.status.success()) {
        println!("> dependencies: SKIPPED, cargo-deny is not installed (`cargo install cargo-deny`)");
        return Ok(());
    }
    let mut deny = steps.cargo();
    steps.run("dependencies", deny.args(["deny", "--workspace", "check"]))
}

/// Emits every shipped case, which naga validates, and hands the SPIR-V to spirv-val, and the WGSL to Tint where it is
/// installed. Modules without a stage are left to the tests, which give them one.
fn shaders(steps: &mut Steps) -> Result<(), Failure> {
    let cases = cases(steps.root())?;
    let out = scratch("validate")?;
    let mut emit = steps.tool("shaders-gen")?;
    emit.arg("emit").args(&cases).args(["--target", "wgsl,spirv", "--out"]).arg(&out);
    steps.quiet("emitting", &mut emit)?;
    let mut modules = 0;
    let mut entries: Vec<_> =
        fs::read_dir(&out).map_err(at(&out))?.flatten().map(|entry| entry.path()).collect();
    entries.sort();
    for path in entries.iter().filter(|path| path.extension().is_some_and(|extension| extension == "spv")) {
        let mut validator = Command::new("spirv-val");
        steps.quiet("spirv-val", validator.args(["--target-env", SPIRV_ENVIRONMENT]).arg(path))?;
        modules += 1;
    }
    if modules == 0 {
        return Err(Failure::Step { title: "spirv-val (no module was emitted)".into() });
    }
    println!("> {} cases, {modules} SPIR-V modules valid", cases.len());

    if Command::new("tint").arg("--help").output().is_err() {
        println!("> Tint: SKIPPED, tint is not installed (build it from Dawn's sources)");
        return Ok(());
    }
    let mut texts = 0;
    let is_whole = |path: &&PathBuf| {
        path.to_str().is_some_and(|path| path.ends_with(".wgsl") && !path.ends_with(".function.wgsl"))
    };
    for path in entries.iter().filter(is_whole) {
        let mut reader = Command::new("tint");
        steps.quiet(
            "Tint",
            reader.args(["--format", "wgsl", "--output-name"]).arg(path.with_extension("tint")).arg(path),
        )?;
        texts += 1;
    }
    println!("> {texts} WGSL modules accepted by Tint");
    Ok(())
}
