//! Camera space shadow maps: facets whose texels follow the viewing camera's.

use super::TechniqueSpec;
use crate::facet::FacetShape;
use crate::schema::Choice;

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice::plain("camera_space", "facets whose texels follow the viewing camera's"),
    configurations: &[Choice::plain("face_columns", "a column of bands on each frustum side face that rays enter first")],
    distribution: Some("bands(8)"),
    shape: |case| {
        let count = case.distribution.as_ref().and_then(|word| word.arguments.count("count"));
        FacetShape { sectors: 4, bands: count.unwrap_or(8) }
    },
    check: |_| Vec::new(),
};
