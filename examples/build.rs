//! Compiles `valley.cssm` for the example `build_script_tables`.

fn main() -> Result<(), cssm::build::BuildError> {
    cssm::build::Build::new().file("valley.cssm").compile()?;
    Ok(())
}
