//! Camera space shadow maps: facets whose texels follow the viewing camera's.

mod face_columns;

use super::TechniqueSpec;
use crate::facet::FacetShape;
use crate::schema::Choice;

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice::plain("camera_space", "facets whose texels follow the viewing camera's"),
    configurations: &[Choice::plain(
        "face_columns",
        "a column of bands on each frustum side face that rays enter first",
    )],
    distribution: Some("bands(8)"),
    fits_infinity: true,
    shape: |case| FacetShape { sectors: face_columns::SECTORS, bands: face_columns::bands(case).0 },
    check: |_| Vec::new(),
    draft: face_columns::draft,
};
