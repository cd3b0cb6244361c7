//! `cargo xtask extremes`: where each technique breaks, every situation.

use crate::failure::Failure;
use crate::steps::Steps;

/// Where the tables and their picture are kept.
const MARKDOWN: &str = "docs/extremes.md";
const PICTURE: &str = "docs/extremes.png";

/// Writes the tables and the picture.
pub(crate) fn run(steps: &mut Steps) -> Result<(), Failure> {
    steps.build("cssm-lab")?;
    let mut lab = steps.tool("cssm-lab")?;
    lab.args(["extremes", "--full", "--markdown", MARKDOWN, "--picture", PICTURE]);
    steps.quiet("extremes", &mut lab)?;
    println!("> wrote {MARKDOWN} and {PICTURE}");
    Ok(())
}
