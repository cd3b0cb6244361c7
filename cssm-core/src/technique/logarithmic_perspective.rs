//! Logarithmic perspective: a warp as in [`super::warp_family`] across, rows that run with the logarithm of the distance
//! from its centre along (Lloyd et al., Logarithmic perspective shadow maps). The logarithm gives every texel the same
//! share of its distance, which no homography does: rows are bent, or cut into straight bands.
//!
//! Towards the view axis the centre moves away by eta(gamma), and both relax into a uniform map.

use super::columns::{self, Column};
use super::warp::{self, Warp, WarpSpec};
use super::{ConfigurationSpec, Drafts, Situation, TechniqueSpec, only_directional, warp_family};
use crate::case::LightKind;
use crate::distribution;
use crate::facet::FacetShape;
use crate::plan::PlanError;
use crate::schema::{Choice, Word};

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "logarithmic_perspective",
        summary: "one warped map whose rows run with the logarithm of distance",
        arguments: &[warp_family::ETA],
    },
    configurations: &[ConfigurationSpec {
        choice: Choice::plain("logarithmic_rows", "one column over the whole map"),
        lights: &[LightKind::Directional],
        takes_distribution: true,
        serves: |_| true,
        shape: |case, _| FacetShape { bands: distribution::pieces(case), ..FacetShape::ONE },
        draft,
    }],
    default_configurations: |light| only_directional(light, &["logarithmic_rows"]),
    distribution: Some("bands(8)"),
    fits_infinity: false,
    follows_camera: true,
    variants: &["logarithmic_perspective"],
    check: |_| Vec::new(),
};

/// Eta with the light across the view: the centre lies in the eye, so that texels widen as the view does, and the logarithm
/// does the rest.
const AT_RIGHT_ANGLES: f64 = 1.0;

/// The family's warp with a last value of its own.
const WARP: WarpSpec =
    WarpSpec { choice: SPEC.choice, warp: |warped| warp_family::rising_to(AT_RIGHT_ANGLES, warped) };

/// Least strength: weaker ones are uniform to any eye, and a logarithm of what hardly changes would lose f32 its digits.
const WEAKEST: f64 = 0.05;

fn draft(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let receivers = &situation.receivers;
    if receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }
    if receivers.is_empty() {
        return warp::draft(&WARP, word.name, situation, drafts);
    }
    let Warp { plane, strength, fallback } = warp::of_view(&WARP, situation);
    let (low, extent) = plane.extent(receivers);
    let centre = low - extent / strength.max(WEAKEST);
    let column = Column {
        half: 0,
        sector: 0,
        across: plane.across,
        distance: plane.along - plane.unit * centre,
        slant: 0.0,
        unit: plane.unit,
        sides: super::Sides::new(),
        receivers: receivers.clone(),
    };
    let bands = distribution::pieces(situation.case);
    let draft = drafts.open(word.name, (1, bands));
    draft.fallback = fallback;
    columns::add(&column, situation, draft);
    if bands > 1 {
        draft.selection.distances.push(column.distance);
    }
    Ok(())
}
