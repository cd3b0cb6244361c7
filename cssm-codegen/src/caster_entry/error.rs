//! Why a caster entry does not compose.

use super::report::CasterReport;
use crate::generate::GenerateError;

/// Why a caster entry does not compose.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CasterError {
    /// The engine's source is at fault, or does not fit the generated part.
    #[error("{0}")]
    Source(Box<CasterReport>),
    /// The entry's name cannot name files and modules.
    #[error(
        "`{name}` cannot name a caster entry; use lower snake case that starts and ends in a letter, such as `skinned`"
    )]
    Name {
        /// The name.
        name: String,
    },
    /// The entry has no source.
    #[error("caster entry `{name}` has no source; add the engine's WGSL with `source`")]
    NoSource {
        /// The entry.
        name: String,
    },
    /// The cutoff of an alpha mask is no number.
    #[error("the alpha cutoff of caster entry `{name}` is {cutoff}; use a number from 0 to 1")]
    Cutoff {
        /// The entry.
        name: String,
        /// The cutoff.
        cutoff: f32,
    },
    /// The uniform rows are bound where the facet is.
    #[error(
        "the rows of caster entry `{name}` are bound in group {group}, which holds the facet; bind them in group {} or higher", group + 1
    )]
    RowsInFacetGroup {
        /// The entry.
        name: String,
        /// The facet's group.
        group: u32,
    },
    /// The case stretches exactly, which takes all corners of a triangle at once.
    #[error(
        "case `{case}` stretches exactly, which takes all three corners of a triangle at once, and the function of caster entry `{name}` knows one; declare `distribution: bands` or `stretch: vertex`"
    )]
    Exact {
        /// The case.
        case: String,
        /// The entry.
        name: String,
    },
    /// The generator is at fault.
    #[error(transparent)]
    Generate(#[from] GenerateError),
}
