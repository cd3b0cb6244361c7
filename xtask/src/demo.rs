//! `cargo xtask demo`: from a declared sun to pictures and a table.

use crate::failure::Failure;
use crate::setup;
use crate::steps::Steps;

/// Runs the lab's demonstration. The lab is built as for the tests, where the crates that count are optimised.
pub(crate) fn run(steps: &mut Steps, out: &str) -> Result<(), Failure> {
    setup::run(steps)?;
    steps.build("cssm-lab")?;
    let mut lab = steps.tool("cssm-lab")?;
    steps.run("demo", lab.args(["demo", "--out", out]))
}
