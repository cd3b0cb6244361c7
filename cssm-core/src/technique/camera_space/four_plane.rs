//! Four planes: the view's four side faces fill one square of the map, in four triangles that meet in the image t of the
//! eye's own light ray (camera space shadow maps, section 3, dueling frusta).
//!
//! Face k is spanned by T, a point of that ray, and two neighbouring corners of the far plane; T goes to t in the
//! square, the corners to the square's corners. T is pushed along the light ray to the focus depth, which leaves its
//! image where it is: the farther, the less of the map the surroundings of the eye take. Pushed straight along the
//! camera's axis instead (the paper warns of it), T leaves the ray and the triangles share the square almost alike.
//!
//! Where t leaves the view, or comes close to its edge, the rectangle of the view is enlarged until t lies inside
//! again, on one side only; the border to light from outside needs no rotation of the camera. Far outside one plane is
//! better and the same shader serves it; both are offered and the smaller predicted footprint wins.

use glam::{DVec2, DVec4};

use super::one_plane;
use crate::case::LightKind;
use crate::distribution;
use crate::facet::{Cell, FacetShape};
use crate::focus::{self, Focus};
use crate::light::{BORDER_MARGIN, LightPosition};
use crate::plan::PlanError;
use crate::receivers::DEPTH_ROW;
use crate::schema::{Choice, Default, Field, Kind, Word};
use crate::technique::columns;
use crate::technique::side_faces::{self, Course, SideFace};
use crate::technique::{ConfigurationSpec, Drafts, FacetDraft, Region, Sides, Situation, TileRequest};

/// A square has four triangles.
const SECTORS: u32 = 4;
/// Two edges of a triangle are inner ones.
const CLIPS: u32 = 2;
/// Least distance of t from the rectangle's edge in gutters of the map; in sides of the view it is [`BORDER_MARGIN`].
const MARGIN_GUTTERS: f64 = 8.0;
/// Share of the rows before the focus in the form on one plane.
const EVEN_SHARE: f64 = 0.5;
/// Largest enlarged area, in areas of the view's own, that is worth a try.
const LARGEST_AREA: f64 = 16.0;

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice {
        name: "four_plane",
        summary: "the four side faces in one square; for light in, behind or just outside the view",
        arguments: &[
            Field {
                name: "push",
                summary: "which way the point where the triangles meet is pushed to the focus",
                kind: Kind::Choice(&[
                    Choice::plain("t", "along the light ray through the eye"),
                    Choice::plain("camera", "straight along the camera's axis; for comparison, it is worse"),
                ]),
                default: Default::Value("t"),
            },
            Field { summary: "depth that it is pushed to", ..focus::FIELD },
        ],
    },
    lights: &[LightKind::Directional, LightKind::Spot, LightKind::Omni],
    takes_distribution: false,
    serves: |position| matches!(position, LightPosition::Dueling | LightPosition::Border),
    shape: |_, _| FacetShape { sectors: SECTORS, clips: CLIPS, ..FacetShape::ONE },
    draft,
};

fn draft(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let focus = Focus::of(&word.arguments).metres(situation.eye_height_metres);
    let straight = word.arguments.word("push").is_some_and(|push| push.name == "camera");
    let light = situation.light;

    // Rays of a point before the eye plane run both ways: they meet no single square.
    let before_eye = light.w > 0.0 && light.z < 0.0;
    let square = (!before_eye).then(|| Square::around(situation)).flatten();
    if let Some(square) = &square {
        square.draft(situation, "in a square", (focus, straight), drafts);
        if light.w > 0.0 {
            // A point behind the eye gains from a tip nearer than the focus (facet algebra, section 4).
            let near = situation.view.near_metres;
            let depth = (near * (near + libm::fabs(light.z))).sqrt();
            square.draft(situation, "in a square, tip at the light's scale", (depth, straight), drafts);
        }
    }
    let outside = LightPosition::of(situation.view, light) != LightPosition::Dueling;
    if outside || square.is_none() {
        on_one_plane(situation, focus, drafts);
    }
    Ok(())
}

/// The rectangle of the view at depth 1, enlarged where t needs it.
struct Square {
    low: DVec2,
    high: DVec2,
    /// Tangents of the light ray through the eye.
    t: DVec2,
}

impl Square {
    /// `None` where t lies too far away.
    fn around(situation: &Situation<'_>) -> Option<Self> {
        // Bound the receivers on the screen.
        let tangents = |row: DVec4| situation.receivers.ratio_range(row, DEPTH_ROW);
        let ((left, right), (bottom, top)) = (tangents(DVec4::X), tangents(DVec4::Y));
        let (low, high) = (DVec2::new(left, bottom), DVec2::new(right, top));
        let size = high - low;
        if !(size.min_element() > 0.0 && size.is_finite()) {
            return None;
        }

        // Take t in, with room for the gutters of the smallest triangle.
        let t = LightPosition::ray(situation.light)?;
        let (map_width, map_height) = situation.map_size_texels;
        let gutters = MARGIN_GUTTERS * f64::from(situation.case.gutter_texels() + 1);
        let margin = size * BORDER_MARGIN.max(gutters / f64::from(map_width.min(map_height)));
        let (low, high) = LightPosition::take_in(low, high, t, margin);
        let enlarged = Self { low, high, t };
        let area = |size: DVec2| size.x * size.y;
        (area(enlarged.high - enlarged.low) <= LARGEST_AREA * area(size)).then_some(enlarged)
    }

    fn corners(&self) -> [DVec2; 4] {
        [self.low, DVec2::new(self.high.x, self.low.y), self.high, DVec2::new(self.low.x, self.high.y)]
    }

    /// Where tangents fall in the square, from -1 to 1.
    fn ndc(&self, tangents: DVec2) -> DVec2 {
        (tangents * 2.0 - self.low - self.high) / (self.high - self.low)
    }

    fn draft(
        &self,
        situation: &Situation<'_>,
        form: &'static str,
        (focus, straight): (f64, bool),
        drafts: &mut Drafts,
    ) {
        let (near, far) = situation.receivers.range(DEPTH_ROW);
        let depth = focus.clamp(near, far);

        // Find T, and the point of depth 0 on the light ray through it, from which faces are spanned.
        let tip = if straight { self.t * (near / depth) } else { self.t };
        let apex = ((tip - self.t) * depth).extend(0.0);
        let corner = |tangents: DVec2| tangents.extend(-1.0) - apex / far;
        let corners = self.corners().map(corner);
        let light = situation.light;
        let course = if light.w > 0.0 { Course::Away } else { Course::of_directional(light.truncate()) };
        let faces = side_faces::entered_first(apex, corners, light, course);

        let draft = drafts.open(SPEC.choice.name, (SECTORS, 1));
        draft.form = form;
        draft.reserve(faces.len());
        for (sector, face) in faces.iter().enumerate() {
            let triangle = Triangle { face, square: self, tip: self.ndc(tip), depth, far };
            draft.push_cut(triangle.facet(sector as u32), &situation.receivers);
            draft.selection.borders.push(face.start);
        }
    }
}

/// One side face and its triangle of the square.
struct Triangle<'a> {
    face: &'a SideFace,
    square: &'a Square,
    /// Image of T in the square.
    tip: DVec2,
    /// Depth of T.
    depth: f64,
    /// Depth of the corners; may be infinite.
    far: f64,
}

impl Triangle<'_> {
    fn facet(&self, sector: u32) -> FacetDraft {
        // Weigh the anchors T, c_k, c_(k+1) by their depths: the square shows the view's own perspective there.
        let corners = self.square.corners().map(|corner| self.square.ndc(corner));
        let (one, two) = (corners[self.face.corner], corners[(self.face.corner + 1) % 4]);
        let SideFace { s, t, unit, .. } = *self.face;
        let at_tip = (unit - (s + t) / self.far) * self.depth;
        let sides = self.face.sides();
        let x = at_tip * self.tip.x + s * one.x + t * two.x;
        let y = at_tip * self.tip.y + s * one.y + t * two.y;
        let region =
            Region::Triangle { square: 0, request: TileRequest::Footprint, corners: [self.tip, one, two] };
        let select = Sides::from_slice(&sides);
        FacetDraft::straight(Cell::of(sector, 0), [x, y, at_tip + s + t], select, region)
    }
}

/// The form for light from far outside the view.
fn on_one_plane(situation: &Situation<'_>, focus: f64, drafts: &mut Drafts) {
    let column = one_plane::column(situation);
    let piece = distribution::perspective_piece(focus, EVEN_SHARE, &columns::range(&column, situation));
    let draft = drafts.open(SPEC.choice.name, (1, 1));
    draft.form = "on one plane";
    draft.complete = one_plane::is_complete(&column, situation);
    columns::split(&column, &[piece], draft);
}
