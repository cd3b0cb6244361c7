//! Linear warps: one perspective in the light's image plane, stronger or weaker. Every warped map with one matrix is one of
//! them; they differ only in where the centre of projection lies (generalized framework of the parallel-split slides,
//! "freedoms of warping frustum"; facet algebra, section 2).
//!
//! With t from 0 at the near edge of the receivers to 1 at the far edge along the image of the view axis, a warp of
//! strength s has w = s t + 1: the centre lies 1/s of the extent before the near edge. Strength 0 is uniform. Rows are
//! written so that they stay regular there.

use glam::{DVec2, DVec3, DVec4};

use super::{
    Draft, Drafts, FacetDraft, Fallback, Region, Sides, Situation, TileRequest, generalized_linear,
    light_space_perspective, trapezoidal, warp_family,
};
use crate::facet::Cell;
use crate::light::LightPosition;
use crate::plan::PlanError;
use crate::receivers::{Body, DEPTH_ROW, Polytope};
use crate::schema::{Arguments, Choice};
use crate::view::View;

/// What is known of a warp.
#[derive(Debug, Clone, Copy)]
pub(super) struct WarpSpec {
    /// Name, summary and parameters as declared.
    pub(super) choice: Choice,
    /// The warp of some receivers.
    pub(super) warp: fn(&Warped<'_>) -> Warp,
}

/// Every warp that a depth slab can have of its own.
pub(super) const WARPS: [WarpSpec; 4] =
    [trapezoidal::WARP, light_space_perspective::WARP, generalized_linear::WARP, warp_family::WARP];

/// What is to be warped.
#[derive(Debug)]
pub(super) struct Warped<'a> {
    /// The frame.
    pub(super) situation: &'a Situation<'a>,
    /// Parameters of the warp.
    pub(super) arguments: &'a Arguments,
    /// The receivers.
    pub(super) receivers: &'a Polytope,
    /// Depth of the nearest and of the farthest, metres.
    pub(super) depths_metres: (f64, f64),
    /// The light's image plane.
    pub(super) plane: LightPlane,
}

/// A warp.
#[derive(Debug, Clone, Copy)]
pub(super) struct Warp {
    /// The light's image plane, turned as the warp wants it.
    pub(super) plane: LightPlane,
    /// Extent over distance of the centre of projection from the near edge; 0: uniform.
    pub(super) strength: f64,
    /// How far it is weaker than its rule says.
    pub(super) fallback: Option<Fallback>,
}

/// The light's image plane. A receiver's place in it is across / unit and along / unit; all three annihilate the light.
#[derive(Debug, Clone, Copy)]
pub(super) struct LightPlane {
    /// Row to the right.
    pub(super) across: DVec4,
    /// Row along the image of the view axis, away from the eye.
    pub(super) along: DVec4,
    /// (0, 0, 0, 1), or the distance from a spot light along its axis.
    pub(super) unit: DVec4,
    /// Sine of the angle between light and view axis.
    pub(super) sine: f64,
}

/// Sine of the angle between light and view axis below which the axis has no direction in the image plane.
const SMALLEST_SINE: f64 = 1e-12;
/// Distance of the light ray through the eye from the middle of the image, in half its sides, from which on warps are as
/// strong as their rule says: they cannot have the eye inside the silhouette, which begins at 1.
const FULL_STRENGTH: f64 = 1.2;

impl LightPlane {
    /// The plane turned along a direction of camera space.
    pub(super) fn along(situation: &Situation<'_>, direction: DVec3) -> Self {
        let toward = match situation.cone {
            Some(cone) => -cone.direction,
            None => situation.light.truncate(),
        };
        let sine = toward.cross(DVec3::NEG_Z).length();
        let candidates = [direction, DVec3::Y, DVec3::NEG_Z, DVec3::X];
        let flattened = candidates.map(|axis| axis - toward * axis.dot(toward));
        let along =
            flattened.into_iter().find(|axis| axis.length() > SMALLEST_SINE).unwrap_or(DVec3::Y).normalize();
        let row = |axis: DVec3| axis.extend(-axis.dot(situation.light.truncate()) * situation.light.w);
        let unit = if situation.light.w > 0.0 { row(-toward) } else { DVec4::W };
        Self { across: row(along.cross(toward)), along: row(along), unit, sine }
    }

    /// The plane with both axes turned counter-clockwise.
    pub(super) fn turned(&self, angle_radians: f64) -> Self {
        let (sine, cosine) = (libm::sin(angle_radians), libm::cos(angle_radians));
        Self {
            across: self.across * cosine + self.along * sine,
            along: self.along * cosine - self.across * sine,
            ..*self
        }
    }

    /// Image of a point.
    pub(super) fn image(&self, point: DVec4) -> Option<DVec2> {
        let unit = self.unit.dot(point);
        (unit > 0.0).then(|| DVec2::new(self.across.dot(point), self.along.dot(point)) / unit)
    }

    /// Place of the near edge of some receivers along the plane, and their extent.
    pub(super) fn extent(&self, receivers: &Polytope) -> (f64, f64) {
        let (low, high) = receivers.ratio_range(self.along, self.unit);
        (low, high - low)
    }

    /// Rows x, y and w of a warp of some receivers.
    pub(super) fn rows(&self, receivers: &Polytope, strength: f64) -> [DVec4; 3] {
        let (low, extent) = self.extent(receivers);
        let t = (self.along - self.unit * low) / extent;
        // Of the rows that the fit may combine with w this one never runs along it.
        [self.across, t - self.unit * strength, t * strength + self.unit]
    }
}

impl<'a> Warped<'a> {
    /// Everything visible, with the parameters of the case's technique.
    pub(super) fn of_view(situation: &'a Situation<'a>) -> Self {
        Self {
            situation,
            arguments: &situation.case.technique.arguments,
            receivers: &situation.receivers,
            depths_metres: situation.receivers.range(DEPTH_ROW),
            plane: LightPlane::along(situation, DVec3::NEG_Z),
        }
    }

    /// The warp along the view axis with a strength.
    pub(super) fn of_strength(&self, strength: f64, fallback: Option<Fallback>) -> Warp {
        Warp { plane: self.plane, strength, fallback }
    }

    /// A strength that fades to uniform until the eye is in the silhouette: from there every warp along the view axis
    /// would have to point both ways.
    pub(super) fn outside_silhouette(&self, strength: f64) -> Warp {
        let given = 1.0 - eye_outside(self.situation.view, self.situation.light);
        let why = "the eye lies in the silhouette of the view as the light sees it, or close to it";
        self.of_strength(strength * (1.0 - given), Fallback::of("uniform", why, given))
    }
}

/// 0 with the eye inside the view's silhouette as a directional light sees it, 1 well outside, continuous between.
pub(super) fn eye_outside(view: &View, light: DVec4) -> f64 {
    let Some(ray) = LightPosition::ray(light) else { return 1.0 };
    let (low, high) = (DVec2::new(view.left, view.bottom), DVec2::new(view.right, view.top));
    let halves = ((ray - (low + high) * 0.5) / ((high - low) * 0.5)).abs().max_element();
    smooth((halves - 1.0) / (FULL_STRENGTH - 1.0))
}

/// From 0 to 1 with continuous slope.
pub(super) fn smooth(value: f64) -> f64 {
    let value = value.clamp(0.0, 1.0);
    value * value * (3.0 - 2.0 * value)
}

/// The warp of everything visible.
pub(super) fn of_view(spec: &WarpSpec, situation: &Situation<'_>) -> Warp {
    (spec.warp)(&Warped::of_view(situation))
}

/// One facet over the whole map.
pub(super) fn draft(
    spec: &WarpSpec,
    configuration: &'static str,
    situation: &Situation<'_>,
    drafts: &mut Drafts,
) -> Result<(), PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: spec.choice.name });
    }
    if situation.receivers.is_empty() {
        single(drafts, configuration, [DVec4::X, DVec4::Y, DVec4::W], situation.receivers.body());
        return Ok(());
    }
    let Warp { plane, strength, fallback } = of_view(spec, situation);
    let rows = plane.rows(&situation.receivers, strength);
    single(drafts, configuration, rows, situation.receivers.body()).fallback = fallback;
    Ok(())
}

/// Adds a draft of one facet over the whole map.
pub(super) fn single<'d>(
    drafts: &'d mut Drafts,
    configuration: &'static str,
    rows: [DVec4; 3],
    receivers: Body<'_>,
) -> &'d mut Draft {
    let region = Region::Tile(TileRequest::Share(1.0));
    let draft = drafts.open(configuration, (1, 1));
    draft.push(FacetDraft::straight(Cell::FIRST, rows, Sides::new(), region), receivers);
    draft
}
