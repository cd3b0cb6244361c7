//! Trapezoidal: the view frustum as the light sees it is enclosed by a trapezoid, which becomes the map (Martin and Tan,
//! Anti-aliasing and continuity with trapezoidal shadow maps).
//!
//! Base and top line are orthogonal to the centre line and touch the outline; the side lines run from a point q on the
//! centre line, which is placed so that the end of a focus region falls on a line of the map: the 80 % line, or, by
//! search over map rows, the line with which the focus region covers most of the map (section 6.2). In the terms of
//! `warp` the line's share s and the focus region's share r of the extent give the strength
//! (s - r) / (r (1 - s)).
//!
//! The `focused` rule mends two problems that the parallel-split slides show. The original measures the focus on the
//! centre line, so corners of the focus region may fall beyond the focus line; here the line holds the whole region
//! (along). And it may magnify the foreground more than the view itself does; here the centre of projection stays
//! behind the eye (across).
//!
//! Where the centres of near and far plane fall together the centre line has no direction. The paper takes the smallest
//! box around the far plane there; here the map turns and relaxes towards that box before it comes to it. For a
//! light that does not reach the whole view (section 6.4) the centre line runs through the middle of what is
//! reached, and the focus shrinks with its depth. That middle is taken from its extents in the image, which are
//! continuous; the paper's mean of vertices jumps when a vertex is cut off.

mod search;

use glam::{DVec2, DVec3, DVec4};

pub use self::search::FocusTable;
use super::warp::{self, LightPlane, Warp, WarpSpec, Warped, smooth};
use super::{ConfigurationSpec, Fallback, TechniqueSpec};
use crate::case::LightKind;
use crate::facet::FacetShape;
use crate::receivers::{DEPTH_ROW, Polytope};
use crate::schema::{Choice, Default, Field, Kind, Unit};

const RULES: &[Choice] = &[
    Choice::plain("original", "the paper's: focus measured on the centre line"),
    Choice::plain(
        "focused",
        "the focus line holds the whole focus region and the foreground is not overstretched",
    ),
];

const LINES: &[Choice] = &[
    Choice::plain("search", "the focus line with which the focus region covers most of the map"),
    Choice::plain("fixed", "the focus line at its share, whatever it wastes"),
];

const ARGUMENTS: &[Field] = &[
    Field {
        name: "rule",
        summary: "how the focus region is measured",
        kind: Kind::Choice(RULES),
        default: Default::Value("original"),
    },
    Field {
        name: "focus",
        summary: "depth that the focus region ends at",
        kind: Kind::Number { min: 0.0, max: f64::INFINITY, open: true, unit: Unit::Length },
        default: Default::Value("10 m"),
    },
    Field {
        name: "share",
        summary: "share of the map's rows before the focus line, or the largest to search from",
        kind: Kind::Number { min: 0.0, max: 1.0, open: true, unit: Unit::None },
        default: Default::Value("0.8"),
    },
    Field {
        name: "line",
        summary: "where the focus line lies",
        kind: Kind::Choice(LINES),
        default: Default::Value("search"),
    },
];

const CHOICE: Choice = Choice {
    name: "trapezoidal",
    summary: "one map from a trapezoid around the view, with a focus region",
    arguments: ARGUMENTS,
};

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: CHOICE,
    configurations: &[ConfigurationSpec {
        choice: Choice::plain("trapezoid", "one warped facet over the whole map"),
        lights: &[LightKind::Directional, LightKind::Spot],
        takes_distribution: false,
        serves: |_| true,
        shape: |_, _| FacetShape::ONE,
        draft: |situation, word, drafts| warp::draft(&WARP, word.name, situation, drafts),
    }],
    default_configurations: |light| match light {
        LightKind::Directional | LightKind::Spot => &["trapezoid"],
        LightKind::Omni => &[],
    },
    distribution: None,
    fits_infinity: false,
    follows_camera: true,
    variants: &["trapezoidal", "trapezoidal { rule: focused }", "trapezoidal { line: fixed }"],
    check: |_| Vec::new(),
};

/// Its warp.
pub(super) const WARP: WarpSpec = WarpSpec { choice: CHOICE, warp };

/// Distance between the images of the near and the far centre, in half sides of the far plane's image, below which the
/// map turns to the box around the far plane.
const COINCIDENT: f64 = 0.1;

/// What decides the focus line.
#[derive(Debug, Clone, Copy)]
pub(super) struct FocusRule {
    /// Share of the extent along the centre line that lies before the focus line's point.
    pub(super) region: f64,
    /// Largest share of the map's rows before the focus line.
    pub(super) share: f64,
    /// Largest strength.
    pub(super) strongest: f64,
}

impl FocusRule {
    /// Strength of the warp that takes the focus line to a share of the map.
    pub(super) fn strength(&self, share: f64) -> f64 {
        let strength = (share - self.region) / (self.region * (1.0 - share));
        if strength.is_nan() { 0.0 } else { strength.clamp(0.0, self.strongest) }
    }
}

/// Largest strength: a focus region of no extent would ask for more.
const STRONGEST: f64 = 1e6;

fn warp(warped: &Warped<'_>) -> Warp {
    let fixed = warped.arguments.word("line").is_some_and(|line| line.name == "fixed");
    let focused = Focused::of(warped);
    let share = if fixed { focused.rule.share } else { focused.best_share(warped) };
    let Focused { plane, beside, rule, .. } = focused;

    // Relax towards the box around the far plane where the centre line loses its direction.
    let boxed = 1.0 - smooth(beside / COINCIDENT);
    let strength = rule.strength(share) * (1.0 - boxed);
    let plane = plane.turned(boxed * to_box(&plane, warped.receivers));
    let why = "the centres of the near and the far plane coincide in the light's view";
    Warp { plane, strength, fallback: Fallback::of("the box around the far plane", why, boxed) }
}

/// The focus region of some receivers.
struct Focused {
    /// The light's image plane along the centre line.
    plane: LightPlane,
    /// Distance between the images of the centres, see [`centre_line`].
    beside: f64,
    /// What lies before the focus.
    region: Polytope,
    rule: FocusRule,
}

impl Focused {
    fn of(warped: &Warped<'_>) -> Self {
        let focused = warped.arguments.word("rule").is_some_and(|rule| rule.name == "focused");
        let (plane, beside) = centre_line(warped);
        let (low, extent) = plane.extent(warped.receivers);
        let focus = focus_depth(warped);

        // Find the point or the line that goes to the focus line.
        let region = warped.receivers.cut_by(&[DVec4::W * focus - DEPTH_ROW]);
        let on_line = plane.image(middle(warped.receivers, focus)).map_or(low + extent, |image| image.y);
        let end = if focused { plane.extent(&region).0 + plane.extent(&region).1 } else { on_line };
        let to_eye = match plane.image(DVec4::W) {
            Some(eye) if focused && low > eye.y => extent / (low - eye.y),
            _ => STRONGEST,
        };
        let rule = FocusRule {
            region: ((end - low) / extent).clamp(0.0, 1.0),
            share: warped.arguments.number("share").unwrap_or(0.8),
            strongest: to_eye.min(STRONGEST),
        };
        Self { plane, beside, region, rule }
    }

    /// The share of the map's rows before the focus line with which the region covers most of the map.
    fn best_share(&self, warped: &Warped<'_>) -> f64 {
        let (_, rows) = warped.situation.map_size_texels;
        search::largest_region(&self.plane, warped.receivers, &self.region, &self.rule, rows)
    }
}

/// The light's image plane along the centre line, and the distance between the images of the centres in half sides of the
/// far plane's image.
fn centre_line(warped: &Warped<'_>) -> (LightPlane, f64) {
    let (near, far) = warped.depths_metres;
    let (one, two) = (middle(warped.receivers, near), middle(warped.receivers, far));
    let plain = warped.plane;
    let Some((near_image, far_image)) = plain.image(one).zip(plain.image(two)) else { return (plain, 1.0) };
    let line = far_image - near_image;

    // The plane's own axes stand at right angles, so a turn takes along to the line.
    let plane = match line.try_normalize() {
        Some(line) => plain.turned(libm::atan2(-line.x, line.y)),
        None => plain,
    };
    let (low, extent) = plain.extent(warped.receivers);
    let (left, right) = warped.receivers.ratio_range(plain.across, plain.unit);
    let half = 0.5 * extent.min(right - left).max(f64::MIN_POSITIVE);
    let beside = if low.is_finite() { line.length() / half } else { 0.0 };
    (plane, beside)
}

/// The middle of some receivers at a depth, by their extents in the image.
fn middle(receivers: &Polytope, depth_metres: f64) -> DVec4 {
    let (left, right) = receivers.ratio_range(DVec4::X, DEPTH_ROW);
    let (bottom, top) = receivers.ratio_range(DVec4::Y, DEPTH_ROW);
    let tangents = DVec2::new(left + right, bottom + top) * 0.5;
    DVec3::new(tangents.x * depth_metres, tangents.y * depth_metres, -depth_metres).extend(1.0)
}

/// Depth that the focus region of some receivers ends at, metres.
fn focus_depth(warped: &Warped<'_>) -> f64 {
    let situation = warped.situation;
    let (near, far) = warped.depths_metres;
    let declared = warped.arguments.number("focus").unwrap_or(10.0);
    let whole = situation.view.far_metres - situation.view.near_metres;
    let focus = if situation.light.w > 0.0 && whole.is_finite() {
        near + (declared - situation.view.near_metres).max(0.0) * (far - near) / whole
    } else {
        declared
    };
    // Receivers that begin beyond the focus are focused on their nearer half.
    if focus > near { focus.min(far) } else { 0.5 * (near + far) }
}

/// Angle from the plane's axes to those of the smallest box around the far plane, at most 45 degrees either way.
fn to_box(plane: &LightPlane, receivers: &Polytope) -> f64 {
    let (_, far) = receivers.range(DEPTH_ROW);
    let side = [middle(receivers, far), middle(receivers, far) + DVec4::X * far];
    let Some((one, two)) = plane.image(side[0]).zip(plane.image(side[1])) else { return 0.0 };
    let angle = libm::atan2((two - one).y, (two - one).x);
    let quarter = std::f64::consts::FRAC_PI_2;
    angle - quarter * libm::round(angle / quarter)
}
