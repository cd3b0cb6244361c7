//! Bounding box: one uniform map, turned to the box of least area around the receivers as the light sees them. The box of a
//! convex outline with the least area has a side on an edge of the outline (rotating edges); which edge may change
//! from one frame to the next, and with it the whole map: this technique is not continuous (trapezoidal shadow maps,
//! section 5, figure 2).
//!
//! Over `visible` the outline is that of the receivers' bounding volumes, or of visible pixels, which the frame gives
//! (Brabec et al., Practical shadow mapping); without any it is the view's own.

use glam::{DVec2, DVec3, DVec4};

use super::warp::{self, LightPlane};
use super::{ConfigurationSpec, Drafts, Situation, TechniqueSpec};
use crate::case::LightKind;
use crate::facet::{FacetRows, FacetShape};
use crate::plan::PlanError;
use crate::polygon;
use crate::receivers::extremes;
use crate::remap::Remap;
use crate::schema::{Choice, Default, Field, Kind, Word};

const OVER: &[Choice] = &[
    Choice::plain("frustum", "the view, as far as receivers may be"),
    Choice::plain("visible", "the volumes that the frame says are visible"),
];

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "bounding_box",
        summary: "one uniform map in the box of least area",
        arguments: &[Field {
            name: "over",
            summary: "what the box holds",
            kind: Kind::Choice(OVER),
            default: Default::Value("frustum"),
        }],
    },
    configurations: &[ConfigurationSpec {
        choice: Choice::plain("least_area", "one uniform facet over the whole map"),
        lights: &[LightKind::Directional, LightKind::Spot],
        takes_distribution: false,
        serves: |_| true,
        shape: |_, _| FacetShape::ONE,
        draft,
    }],
    default_configurations: |light| match light {
        LightKind::Directional | LightKind::Spot => &["least_area"],
        LightKind::Omni => &[],
    },
    distribution: None,
    fits_infinity: false,
    follows_camera: false,
    variants: &["bounding_box", "bounding_box { over: visible }"],
    check: |_| Vec::new(),
};

fn draft(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: SPEC.choice.name });
    }
    let over = situation.case.technique.arguments.word("over").map(|over| over.name);
    let held = if over == Some("visible") { situation.seen() } else { &situation.receivers.vertices };
    let plane = least_area(&LightPlane::along(situation, DVec3::Y), held);
    let rows = [plane.across, plane.along, plane.unit];

    // What lies outside the box is not seen.
    let sides = super::enclosing(&rows, held);
    warp::single(drafts, word.name, rows, situation.receivers.cut_by(&sides).body());
    Ok(())
}

/// The plane turned to the box of least area around some points.
pub(super) fn least_area(plane: &LightPlane, points: &[DVec4]) -> LightPlane {
    let rows =
        FacetRows { x: plane.across, y: plane.along, z: plane.unit, w: plane.unit, remap: Remap::NONE };
    let outline = polygon::small_outline(&rows, points);
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    let angle_and_area = |(one, two): (&DVec2, &DVec2)| {
        let axis = (*two - *one).try_normalize()?;
        let extent = |axis: DVec2| {
            let (low, high) = extremes(outline.iter().map(|corner| axis.dot(*corner)));
            high - low
        };
        Some((axis, extent(axis) * extent(axis.perp())))
    };
    let best = edges.filter_map(angle_and_area).min_by(|one, two| one.1.total_cmp(&two.1));
    best.map_or(*plane, |(axis, _)| {
        // Turn by less than a quarter: which side is up does not matter.
        let angle = libm::atan2(axis.y, axis.x);
        let quarter = std::f64::consts::FRAC_PI_2;
        plane.turned(angle - quarter * libm::round(angle / quarter))
    })
}
