//! Eight planes: a point light in the view is enclosed by a bipyramid. Four front faces between the light and the eye are
//! camera space facets that meet in the image of the eye's own light ray; four back faces behind the light are plain
//! projections; each four fill a square (camera space shadow maps, section 6.3, omnidirectional light).
//!
//! The front apex T lies on the line from the eye to the light at depth dt, the equator is the view's rectangle at depth
//! Dj, and the back apex lies behind the light on the same line, as far as the equator's edges are on average, so that
//! every back face is seen alike. The polytope is convex around the light: every ray meets one face. All faces meet the
//! line, so four half-planes around it part the sectors, and the plane through light and equator edge parts front from
//! back.
//!
//! The paper puts the equator where front and back faces are equally good there. That ends the camera space faces too
//! early (measured: up to three times worse footprints); dt = sqrt(near * light depth) and Dj = 2.7 sqrt(dt * light
//! depth) equate the radial loss Dj / dt of the front with the loss light depth / Dj of the back. Both laws scaled by
//! 0.7 are better by a fifth at lights farther than a few metres; nearer ones want the equator out.
//!
//! A light beside the view is taken in by enlarging the rectangle on its side. For any other light the configuration takes
//! the form of a tetrahedron, which the same shader serves.

use glam::{DVec2, DVec3, DVec4};
use smallvec::smallvec;

use super::anchors::{Anchors, barycentric};
use super::tetrahedron;
use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::light::{BORDER_MARGIN, LightPosition};
use crate::plan::PlanError;
use crate::receivers::DEPTH_ROW;
use crate::schema::{Choice, Word};
use crate::technique::side_faces::{self, Course};
use crate::technique::{ConfigurationSpec, Drafts, Situation};

/// A rectangle has four edges.
const SECTORS: u32 = 4;
/// Two edges of a triangle are inner ones.
const CLIPS: u32 = 2;
/// Equator depth in geometric means of the front apex' depth and the light's.
const EQUATOR: f64 = 2.7;
/// Scales of both laws that are tried: the first suits lights farther than a few metres, the second nearer ones.
const FORMS: [Form; 2] =
    [Form { front: 0.7, equator: 0.7, name: "drawn in" }, Form { front: 0.85, equator: 1.0, name: "wide" }];
/// Front and back take equal squares: their shares of the receivers trade off where the equator lies.
const SHARE: f64 = 0.5;
/// Smallest depth of the light, in near distances: the front apex must clear it.
const NEAREST: f64 = 2.0;
/// Largest enlarged area, in areas of the view's own, that is worth a try.
const LARGEST_AREA: f64 = 6.0;

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("eight_plane", "a bipyramid around a light in or just beside the view"),
    lights: &[LightKind::Spot, LightKind::Omni],
    takes_distribution: false,
    serves: |position| matches!(position, LightPosition::InView | LightPosition::BesideView),
    shape: |_, _| FacetShape { sectors: SECTORS, bands: 2, clips: CLIPS, ..FacetShape::ONE },
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let bipyramid = Bipyramid::around(situation);
    let before = drafts.len();
    for form in &FORMS {
        let known = drafts.len();
        if bipyramid.as_ref().and_then(|bipyramid| bipyramid.draft(situation, form, drafts)).is_none() {
            drafts.truncate(known);
        }
    }
    if drafts.len() == before {
        // No bipyramid holds a light that is not before the eye: plain projections do.
        if tetrahedron::around(situation, (SPEC.choice.name, "as tetrahedron"), drafts).is_none() {
            drafts.truncate(before);
        }
    }
    Ok(())
}

/// Scales of the depths of front apex and equator.
struct Form {
    front: f64,
    equator: f64,
    name: &'static str,
}

/// The line from the eye through the light, and the rectangle of the view around it.
struct Bipyramid {
    /// The light, camera space.
    light: DVec3,
    /// Tangents of the rectangle at depth 1.
    low: DVec2,
    high: DVec2,
    /// Tangents of the light.
    t: DVec2,
}

impl Bipyramid {
    /// `None` for a light at or behind the eye, or too far beside the view.
    fn around(situation: &Situation<'_>) -> Option<Self> {
        let light = situation.light.truncate();
        if situation.light.w == 0.0 || -light.z <= NEAREST * situation.view.near_metres {
            return None;
        }
        let tangents = |row: DVec4| situation.receivers.ratio_range(row, DEPTH_ROW);
        let ((left, right), (bottom, top)) = (tangents(DVec4::X), tangents(DVec4::Y));
        let (low, high) = (DVec2::new(left, bottom), DVec2::new(right, top));
        let size = high - low;
        if !(size.min_element() > 0.0 && size.is_finite()) {
            return None;
        }
        let t = LightPosition::ray(situation.light)?;
        let (low, high) = LightPosition::take_in(low, high, t, size * BORDER_MARGIN);
        let enlarged = high - low;
        (enlarged.x * enlarged.y <= LARGEST_AREA * size.x * size.y).then_some(Self { light, low, high, t })
    }

    /// `None`, with an unfinished draft, where it does not hold the light.
    fn draft(&self, situation: &Situation<'_>, form: &Form, drafts: &mut Drafts) -> Option<()> {
        // Place the apexes and the equator.
        let (light, homogeneous) = (self.light, situation.light);
        let depth = -light.z;
        let near = situation.view.near_metres;
        let front_scale = (near * depth).sqrt();
        let front_depth = form.front * front_scale;
        let equator_depth = form.equator * EQUATOR * (front_scale * depth).sqrt();
        let (low, high) = (self.low, self.high);
        let tangents = [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
        let corners = tangents.map(|corner| corner.extend(-1.0));
        let equator = corners.map(|corner| corner * equator_depth);
        let middle = |k: usize| (equator[k] + equator[(k + 1) % 4]) * 0.5;
        let reach = (0..4).map(|k| middle(k).distance(light)).sum::<f64>() / 4.0;
        let front = light * (front_depth / depth);
        let back = light * (1.0 + reach / light.length());

        // Walk around the line, then decide by the plane through light and equator edge.
        let faces = side_faces::entered_first(DVec3::ZERO, corners, homogeneous, Course::Back);
        if faces.len() < SECTORS as usize {
            return None;
        }
        let draft = drafts.open(SPEC.choice.name, (SECTORS, 2));
        draft.form = form.name;
        draft.reserve(2 * SECTORS as usize);
        let ndc = |tangents: DVec2| (tangents * 2.0 - low - high) / (high - low);
        for (sector, face) in faces.iter().enumerate() {
            let (one, two) = (face.corner, (face.corner + 1) % 4);
            let edge = [equator[one].extend(1.0), equator[two].extend(1.0)];
            let images = [ndc(tangents[one]), ndc(tangents[two])];
            let cell = |band: u32| smallvec![Cell::of(sector as u32, band)];
            let front = Anchors {
                points: [front.extend(1.0), edge[0], edge[1]],
                weights: [front_depth, equator_depth, equator_depth],
                targets: [ndc(self.t), images[0], images[1]],
                share: SHARE,
            };
            let back = Anchors {
                points: [back.extend(1.0), edge[0], edge[1]],
                weights: [1.0; 3],
                targets: [DVec2::ZERO, SQUARE[one], SQUARE[two]],
                share: SHARE,
            };
            // Neighbours share their borders to the last bit.
            let [toward_back, ..] = barycentric(back.points, light)?;
            let toward_back = toward_back / toward_back.truncate().length();
            let sides = |end: DVec4| face.sides().into_iter().chain([end]).collect();
            draft.push_cut(front.facet(cell(0), 0, light, sides(-toward_back))?, &situation.receivers);
            draft.push_cut(back.facet(cell(1), 1, light, sides(toward_back))?, &situation.receivers);
            draft.selection.borders.push(face.start);
            draft.selection.distances.push(toward_back);
            draft.selection.thresholds.push(0.0);
        }
        Some(())
    }
}

/// Corners of a square's clip space in the order of a view's corners.
const SQUARE: [DVec2; 4] =
    [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(1.0, 1.0), DVec2::new(-1.0, 1.0)];
