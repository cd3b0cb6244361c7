//! From a declared light case to specialised WGSL, SPIR-V and matching tables.
//!
//! Four doors lead here: text files and `light_case!` (through [`dsl`]), build scripts ([`Build`]), the command line
//! and the Rust builder. All of them end in [`generate`], a pure function from a checked declaration to bytes: no
//! clock, no environment, no hash order, no version, no path. Equal declarations give equal bytes in any process, on
//! any machine, in any build profile.
//!
//! # How shaders come about
//!
//! The library (`src/shaders`) holds whole WGSL functions, one file for each alternative of a slot: how casters are
//! captured, how a facet is selected, which way depth is stored, how bias is found, how the map is filtered, what the
//! engine's depth holds, where normals come from.
//! `library` picks the files of a case and writes the function that joins them, a part for each property. `prelude`
//! prints constants, records and bindings from the case's table. `compose` keeps what the entry points reach, gives every
//! module-scope name the case's prefix, and prints the text as it was written: comments, names and loops survive because
//! nothing is reprinted. `judge` lets naga validate the result and holds it against the table: nothing unused, the same
//! bindings, the same sizes and offsets. `spirv` writes the words with every option pinned.
//!
//! # Casters of the engine's own
//!
//! [`CasterEntry`] puts an engine's vertex function, and the function that tells holes, in the place of the fixed vertex
//! of the capture shaders; faults are reported with places in the engine's source.
//!
//! # What it refuses to do
//!
//! No branch on a constant, no override, no preprocessor: what a case does not declare is not in its text. No
//! graphics interface: tables speak of bindings, never of a device. No output but strings and bytes: only [`Build`]
//! and the command line touch files.

pub mod dsl;

mod build;
mod caster_entry;
mod compose;
mod emit;
mod generate;
mod judge;
mod library;
mod macro_door;
mod prelude;
mod spirv;
mod wgsl;
mod write;

pub use build::{Build, BuildError};
pub use caster_entry::{CasterEntry, CasterError, CasterFinding, CasterModule, CasterPlace, CasterReport};
pub use compose::ComposeError;
pub use emit::files::{GeneratedFile, Target};
pub use generate::GenerateError;
pub use judge::JudgeError;
pub use macro_door::macro_expand;
pub use write::{WriteError, write_file};

use cssm_core::LightCase;
use cssm_core::table::CaseTable;

/// Everything that is generated from a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Generated {
    /// The table, shaders filled in.
    pub table: CaseTable,
    /// A Rust module with the declaration, records, constants, shaders and the table.
    pub rust: String,
    /// The table as JSON.
    pub json: String,
    /// The report for people: configurations, passes, bindings, layouts, costs.
    pub explain: String,
}

/// What a caller may choose about generated Rust.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// Path of the façade crate in generated Rust: `::cssm` unless it is re-exported elsewhere.
    pub crate_path: String,
}

impl Default for Options {
    fn default() -> Self {
        Self { crate_path: emit::rust::DEFAULT_CRATE_PATH.to_owned() }
    }
}

/// Generates a case.
///
/// # Errors
/// A [`GenerateError`] where the generator itself is at fault; a checked case generates.
pub fn generate(case: &LightCase) -> Result<Generated, GenerateError> {
    generate_with(case, &Options::default())
}

/// Generates a case, with choices.
///
/// # Errors
/// As [`generate`], and [`GenerateError::CratePath`].
pub fn generate_with(case: &LightCase, options: &Options) -> Result<Generated, GenerateError> {
    let crate_path = emit::rust::crate_path(&options.crate_path)?;
    let table = generate::table_with_shaders(case)?;
    let module = emit::rust::module(case, &table, &crate_path);
    let rust = emit::rust::text(case, &table, module)?;
    let json = emit::json::text(case, &table);
    let explain = emit::explain::text(case, &table);
    Ok(Generated { table, rust, json, explain })
}

/// Generates several cases that are to stand side by side.
///
/// # Errors
/// As [`generate_with`], and [`GenerateError::SharedPrefix`].
pub fn generate_all(cases: &[LightCase], options: &Options) -> Result<Vec<Generated>, GenerateError> {
    generate::check_prefixes(cases)?;
    cases.iter().map(|case| generate_with(case, options)).collect()
}
