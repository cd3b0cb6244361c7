//! The name table of techniques: one file each, and nothing outside its file knows how one works.

pub mod camera_space;
pub mod parallel_split;
pub mod standard;

use crate::case::{CaseError, LightCase};
use crate::facet::FacetShape;
use crate::schema::Choice;

/// What the house knows about a technique.
#[derive(Debug, Clone, Copy)]
pub struct TechniqueSpec {
    /// Name, summary and parameters as declared.
    pub choice: Choice,
    /// Configurations it can take, default first.
    pub configurations: &'static [Choice],
    /// Default distribution in the declaration grammar; `None`: the technique takes none.
    pub distribution: Option<&'static str>,
    /// Facet shape of a case that uses it.
    pub shape: fn(&LightCase) -> FacetShape,
    /// Contradictions between its parameters and the rest of the case.
    pub check: fn(&LightCase) -> Vec<CaseError>,
}

/// Every technique.
pub const TECHNIQUES: &[TechniqueSpec] = &[standard::SPEC, parallel_split::SPEC, camera_space::SPEC];

/// Their declared names and parameters.
pub const CHOICES: &[Choice] = &[standard::SPEC.choice, parallel_split::SPEC.choice, camera_space::SPEC.choice];

/// Every configuration that some technique takes.
pub const CONFIGURATIONS: &[Choice] =
    &[standard::SPEC.configurations[0], parallel_split::SPEC.configurations[0], camera_space::SPEC.configurations[0]];

/// The entry of a name that a checked case holds; an unknown name falls to the first entry.
pub fn spec(name: &str) -> &'static TechniqueSpec {
    TECHNIQUES.iter().find(|spec| spec.choice.name == name).unwrap_or(&TECHNIQUES[0])
}
