//! Standard shadow map: one uniform facet, fitted to the receivers along fixed axes of the light plane.

use super::TechniqueSpec;
use crate::facet::FacetShape;
use crate::schema::Choice;

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice::plain("standard", "one uniform map fitted to the receivers, up = the camera's y"),
    configurations: &[Choice::plain("single", "one facet over the whole map")],
    distribution: None,
    shape: |_| FacetShape { sectors: 1, bands: 1 },
    check: |_| Vec::new(),
};
