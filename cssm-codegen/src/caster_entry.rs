//! Capture shaders around an engine's own vertex function: the caster entry.
//!
//! The engine keeps what it knows: its vertex formats, skinning, instancing, displacement, alpha masks. It names a
//! function that returns a caster's position, and one that tells holes if there are any; the rest of the capture stage
//! comes from the case, in every variant that the case has. Nothing of the engine's is renamed or reprinted: what its
//! functions reach is copied as it was written, everything generated carries the case's prefix.
//!
//! ```
//! use cssm_codegen::CasterEntry;
//! use cssm_core::LightCase;
//!
//! let source = "
//! struct Vertex { @location(0) position: vec3<f32>, @location(1) sway: f32 }
//! @group(1) @binding(0) var<uniform> wind: vec4<f32>;
//! fn leaf_position(vertex: Vertex) -> vec3<f32> { return vertex.position + wind.xyz * vertex.sway; }
//! ";
//! let case = LightCase::builder("Sun").build().unwrap();
//! let casters = CasterEntry::new("leaf", "leaf_position").source("leaf.wgsl", source).compose(&case).unwrap();
//! assert!(casters.shaders[0].wgsl.contains("leaf_position"));
//! ```
//!
//! # What the functions look like
//!
//! * The position function takes structs whose members have `@location`, `@builtin(vertex_index)` or
//!   `@builtin(instance_index)`, or parameters with such attributes. It returns `vec3<f32>`, or a struct with
//!   `position: vec3<f32>` and whatever the hole function takes beside it. In which space: [`CasterSpace`].
//! * The hole function returns `bool`, true where the caster has a hole ([`CasterEntry::hole`]), or `f32`, an alpha that
//!   is compared with a cutoff ([`CasterEntry::alpha`]). Its parameters are found by name: among the members that the
//!   position function returns, then among what that takes.
//! * Bindings are the engine's own, in any group but the facet's (group 0).
//! * `override` is refused: SPIR-V could not hold it.
//!
//! # Rows that are stretched exactly
//!
//! `stretch: exact` decides triangles by all three corners, which a function of one vertex cannot tell:
//! [`CasterError::Exact`]. Declare `distribution: bands` or `stretch: vertex` for such casters.

mod check;
mod error;
mod glue;
mod pieces;
mod report;
mod signature;
mod stages;
mod text;
mod validate;
mod variant;

use cssm_core::LightCase;
use cssm_core::case::Stretch;
use cssm_core::distribution::RemapKind;
use cssm_core::table::{CaseTable, CasterAttribute, CasterSpace, CasterTable, GroupContent, ShaderKind};

pub use self::error::CasterError;
pub use self::report::{CasterFinding, CasterPlace, CasterReport};

use self::pieces::{EngineFile, Piece};
use self::signature::{HoleResult, Reader, Signature};
use self::variant::EnginePart;
use crate::Options;
use crate::compose::Prefix;
use crate::emit::rust::casters;
use crate::generate::GenerateError;
use crate::judge::JudgeError;
use crate::{dsl, library, prelude, wgsl};

/// An engine's vertex function, and what belongs to it.
#[derive(Debug, Clone, PartialEq)]
pub struct CasterEntry {
    name: String,
    position: String,
    hole: Option<(String, HoleResult, f32)>,
    space: Space,
    files: Vec<EngineFile>,
}

/// A [`CasterSpace`] whose location may still be open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Space {
    Object { first_location: Option<u32> },
    World { group: u32, binding: u32 },
    Capture,
}

impl CasterEntry {
    /// An entry by name, whose positions come from a function of the engine's, in object space.
    pub fn new(name: &str, position: &str) -> Self {
        Self {
            name: name.to_owned(),
            position: position.to_owned(),
            hole: None,
            space: Space::Object { first_location: None },
            files: Vec::new(),
        }
    }

    /// Adds a file of the engine's: its name, for reports, and its text. Files are one module together.
    pub fn source(mut self, file: &str, text: &str) -> Self {
        self.files.push(EngineFile { name: file.to_owned(), text: text.to_owned() });
        self
    }

    /// Leaves out the fragments for which a function of the engine's returns true.
    pub fn hole(mut self, function: &str) -> Self {
        self.hole = Some((function.to_owned(), HoleResult::Bool, 0.0));
        self
    }

    /// Leaves out the fragments for which a function of the engine's returns less than `cutoff`.
    pub fn alpha(mut self, function: &str, cutoff: f32) -> Self {
        self.hole = Some((function.to_owned(), HoleResult::Alpha, cutoff));
        self
    }

    /// Puts the instance rows at this and the next two locations, instead of behind the engine's own.
    pub fn rows_at(mut self, first_location: u32) -> Self {
        self.space = Space::Object { first_location: Some(first_location) };
        self
    }

    /// Takes positions in world axes, relative to an origin whose rows are bound at these numbers:
    /// [`CasterSpace::World`].
    pub fn world(mut self, group: u32, binding: u32) -> Self {
        self.space = Space::World { group, binding };
        self
    }

    /// Takes positions in the capture's axes: [`CasterSpace::Capture`].
    pub fn capture_axes(mut self) -> Self {
        self.space = Space::Capture;
        self
    }

    /// Name of the entry.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Composes the capture shaders of a case around the engine's functions: a pure function, same bytes everywhere.
    ///
    /// # Errors
    /// A [`CasterError`]; faults of the source are a [`CasterReport`] with places in the engine's files.
    pub fn compose(&self, case: &LightCase) -> Result<CasterTable, CasterError> {
        self.check(case)?;
        let table = CaseTable::describe(case);
        let (pieces, findings) = pieces::split(&self.files);
        self.refuse(findings, Vec::new())?;
        self.refuse(self.missing_functions(&pieces), Vec::new())?;

        // Look at the engine's part alone.
        let hole = self.hole.as_ref().map(|(name, result, cutoff)| (name.as_str(), *result, *cutoff));
        let roots: Vec<_> = std::iter::once(self.position.as_str()).chain(hole.map(|hole| hole.0)).collect();
        let reached = pieces::reach(&pieces, &roots);
        let (module, stages) = match validate::alone(&self.files, &pieces, &reached, &roots) {
            Ok(alone) => alone,
            Err(findings) => return Err(self.report(findings, Vec::new())),
        };
        let reserved = reserved_names(&table, case);
        let mut reader =
            Reader { module: &module, pieces: &pieces, reserved: &reserved, findings: Vec::new() };
        let signature = reader.signature(&self.position, hole.map(|(name, result, _)| (name, result)));
        let mut findings = reader.findings;
        let space = self.resolved_space(&signature, &mut findings);
        let facet = facet_group(&table)?;
        let rows = match space {
            CasterSpace::World { group, binding } => Some((group, binding)),
            CasterSpace::Object { .. } | CasterSpace::Capture => None,
        };
        findings.extend(check::bindings(&module, &pieces, facet, rows));
        findings.extend(check::overrides(&module, &pieces));
        findings.extend(stages);
        self.refuse(findings, Vec::new())?;

        // Compose and judge every variant.
        let part =
            EnginePart { pieces: &pieces, reached: &reached, signature: &signature, reserved: &reserved };
        let mut shaders = Vec::new();
        let mut bindings = Vec::new();
        for clamped in [false, true] {
            let (shader, judged) = self.shader(case, &table, &part, space, clamped)?;
            shaders.push(shader);
            bindings = check::used_bindings(&judged.module, facet);
        }
        let mut attributes: Vec<_> = signature::locations(&signature.inputs)
            .map(|(location, input)| CasterAttribute {
                location,
                name: input.source_name.clone().into(),
                ty: input.ty.clone().into(),
            })
            .collect();
        attributes.sort_by_key(|attribute| attribute.location);
        Ok(CasterTable {
            name: self.name.clone().into(),
            case: case.name.clone().into(),
            fingerprint: table.fingerprint,
            space,
            attributes: attributes.into(),
            bindings: bindings.into(),
            shaders: shaders.into(),
        })
    }

    /// What [`Self::compose`] returns as a Rust module `PREFIX_NAME` with a static `CASTERS` and the shaders.
    ///
    /// # Errors
    /// As [`Self::compose`], and [`GenerateError::CratePath`].
    pub fn rust(&self, case: &LightCase, options: &Options) -> Result<CasterModule, CasterError> {
        let table = self.compose(case)?;
        let text = casters::text(case, &table, &options.crate_path)?;
        Ok(CasterModule { name: casters::name(case, &table), text })
    }

    /// Finds what is wrong before the source is looked at.
    fn check(&self, case: &LightCase) -> Result<(), CasterError> {
        let name = || self.name.clone();
        let letter = |letter: Option<char>| letter.is_some_and(|letter| letter.is_ascii_lowercase());
        let rest = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_';
        if !letter(self.name.chars().next())
            || !letter(self.name.chars().last())
            || !self.name.chars().all(rest)
        {
            return Err(CasterError::Name { name: name() });
        }
        if self.files.is_empty() {
            return Err(CasterError::NoSource { name: name() });
        }
        if let Some((_, HoleResult::Alpha, cutoff)) = self.hole
            && !(0.0..=1.0).contains(&cutoff)
        {
            return Err(CasterError::Cutoff { name: name(), cutoff });
        }
        if matches!(case.stretch, Stretch::Exact { .. }) && case.remap() != RemapKind::None {
            return Err(CasterError::Exact { case: case.name.clone(), name: name() });
        }
        let table = CaseTable::describe(case);
        if let (Space::World { group, .. }, facet) = (self.space, facet_group(&table)?)
            && group == facet
        {
            return Err(CasterError::RowsInFacetGroup { name: name(), group });
        }
        Ok(())
    }

    /// Functions that are named and not declared.
    fn missing_functions(&self, pieces: &[Piece]) -> Vec<CasterFinding> {
        let names = std::iter::once(&self.position).chain(self.hole.as_ref().map(|(name, ..)| name));
        let is_missing = |name: &&String| pieces::function(pieces, name).is_none();
        names.filter(is_missing).map(|name| self.missing_function(name, pieces)).collect()
    }

    fn missing_function(&self, name: &str, pieces: &[Piece]) -> CasterFinding {
        let functions = pieces.iter().filter(|piece| pieces::function(pieces, piece.name()).is_some());
        let names: Vec<_> = functions.clone().map(|piece| piece.name()).collect();
        let files: Vec<_> = self.files.iter().map(|file| file.name.as_str()).collect();
        let message = format!("there is no function `{name}` in {}", files.join(", "));
        match dsl::nearest(name, &names) {
            Some(near) => {
                let place = pieces::function(pieces, near).map(Piece::name_place);
                let finding = CasterFinding::nowhere(
                    message,
                    format!("name `{near}`, or add the file that declares `{name}`"),
                );
                match place {
                    Some(place) => finding.and(place, "a function of a similar name"),
                    None => finding,
                }
            }
            None => CasterFinding::nowhere(message, format!("add the file that declares `{name}`")),
        }
    }

    /// The space with its numbers filled in.
    fn resolved_space(&self, signature: &Signature, findings: &mut Vec<CasterFinding>) -> CasterSpace {
        let first_location = match self.space {
            Space::World { group, binding } => return CasterSpace::World { group, binding },
            Space::Capture => return CasterSpace::Capture,
            Space::Object { first_location } => first_location,
        };
        let taken = || signature::locations(&signature.inputs);
        let behind = taken().map(|(location, _)| location.saturating_add(1)).max().unwrap_or(0);
        let first_location = first_location.unwrap_or(behind);
        let rows = first_location..first_location.saturating_add(3);
        if let Some((location, input)) = taken().find(|(location, _)| rows.contains(location)) {
            findings.push(CasterFinding::at(
                input.place().clone(),
                format!(
                    "location {location} holds one of the instance rows, {first_location} to {}",
                    rows.end - 1
                ),
                format!("move the rows with `rows_at({behind})`, or take positions in other axes"),
            ));
        }
        CasterSpace::Object { first_location }
    }

    /// An error of findings, if there are any.
    fn refuse(
        &self,
        findings: Vec<CasterFinding>,
        generated: Vec<(String, String)>,
    ) -> Result<(), CasterError> {
        if findings.is_empty() { Ok(()) } else { Err(self.report(findings, generated)) }
    }

    fn report(&self, findings: Vec<CasterFinding>, generated: Vec<(String, String)>) -> CasterError {
        let files = self.files.iter().map(|file| (file.name.clone(), file.text.clone()));
        CasterError::Source(Box::new(CasterReport::new(files.chain(generated).collect(), findings)))
    }
}

/// A caster entry as Rust.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CasterModule {
    /// Name of the module.
    pub name: String,
    /// Text of a file that holds it.
    pub text: String,
}

/// Number of the group that holds the facet.
fn facet_group(table: &CaseTable) -> Result<u32, GenerateError> {
    let group = table.group(ShaderKind::Capture, GroupContent::CaptureFacet).map(|group| group.group);
    group.ok_or_else(|| GenerateError::Judge {
        case: table.case.to_string(),
        shader: ShaderKind::Capture.name(),
        source: JudgeError::Table("the table has no facet group".into()),
    })
}

/// Every name that the generated part may declare, before it is prefixed.
fn reserved_names(table: &CaseTable, case: &LightCase) -> Vec<String> {
    const GLUE: [&str; 7] = [
        "CasterVertex",
        "TestedCaster",
        "engine_caster",
        "capture_position",
        "is_hole",
        "caster_rows",
        "ALPHA_CUTOFF",
    ];
    let prelude = prelude::prelude(table, ShaderKind::Capture, &Prefix::new(&case.prefix));
    let declared = |source: &str| -> Vec<String> {
        wgsl::declarations(source).iter().map(|declaration| declaration.name.to_owned()).collect()
    };
    let library = library::LIBRARY.iter().flat_map(|file| declared(&file.source));
    let mut names: Vec<_> =
        GLUE.iter().map(|name| (*name).to_owned()).chain(declared(&prelude)).chain(library).collect();
    names.sort();
    names.dedup();
    names
}
