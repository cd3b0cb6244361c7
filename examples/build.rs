//! Compiles the declarations of the examples that use build scripts, and the capture shaders around an engine's plants.

use cssm::build::{Build, BuildError, CasterEntry};

fn main() -> Result<(), BuildError> {
    let plants = ["shaders/plants.wgsl"];
    let stem = CasterEntry::new("stem", "stem_position");
    let leaf = CasterEntry::new("leaf", "leaf").hole("leaf_hole").world(1, 1);
    let build = Build::new().file("valley.cssm").file("meadow.cssm");
    build.caster("Meadow", plants, stem).caster("Meadow", plants, leaf).compile()?;
    Ok(())
}
