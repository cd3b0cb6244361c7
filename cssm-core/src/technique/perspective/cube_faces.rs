//! Cube faces: the faces of the unit cube that look away from the light each have a tile (perspective shadow maps: care and
//! feeding, section 14.2.2, "using cube maps"). In world space these are the frustum's planes by which rays leave it.
//!
//! A receiver is moved along its ray onto the face; its place there in post-projective space is its place in the tile.
//! Rays leave by the near or the far plane or by sides. Sectors around the axis through eye and light tell the sides
//! apart; in each, one plane through the light and an edge of the near or far rectangle tells the side from that
//! rectangle. With a local light at the eye there is no such axis, and nothing is promised. The paper's faces have equal sizes; here a face has as many texels as make its footprint the others', so that
//! one that comes into the light's view begins with none and nothing pops. For a local light in the view both rectangles are there, parted by the light's own depth.

use glam::{DVec3, DVec4};
use smallvec::{SmallVec, smallvec};

use super::post_space::slide_back;
use crate::case::{LightCase, LightKind};
use crate::facet::{Cell, FacetShape, Selection};
use crate::light::LightPosition;
use crate::plan::PlanError;
use crate::receivers::{BodyPlace, DEPTH_ROW};
use crate::remap::Curve;
use crate::schema::{Choice, Word};
use crate::technique::side_faces::{self, Course, SideFace};
use crate::technique::{ConfigurationSpec, Drafts, FacetDraft, Region, Sides, Situation, TileRequest};

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("cube_faces", "the view's planes by which rays leave it, each with a tile"),
    lights: &[LightKind::Directional, LightKind::Spot, LightKind::Omni],
    takes_distribution: false,
    serves: |position| position != LightPosition::AtEye,
    shape,
    draft,
};

/// A frustum has four sides.
const SECTORS: u32 = 4;
/// The end rectangle, or the side.
const BANDS: u32 = 2;

fn shape(case: &LightCase, _: &Word) -> FacetShape {
    let halves = if case.light.is_local() { 2 } else { 1 };
    FacetShape { halves, sectors: SECTORS, bands: BANDS, ..FacetShape::ONE }
}

/// The near or the far rectangle of the view, in one half of space.
struct End {
    half: u32,
    /// Its plane, positive inside the view.
    plane: DVec4,
    /// The half-space of its receivers, for a light between near and far.
    part: Option<DVec4>,
    /// For each back side a row that is positive on the side's receivers, negative on the rectangle's.
    edges: Sides,
}

fn draft(situation: &Situation<'_>, word: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    if situation.receivers.is_unbounded() {
        return Err(PlanError::Unbounded { technique: super::SPEC.choice.name });
    }
    let light = situation.light;
    let (near, far) = depths(situation);
    let corners = situation.view.corner_tangents().map(|(x, y)| DVec3::new(x, y, -1.0));
    let sides = side_faces::entered_first(DVec3::ZERO, corners, light, Course::Back);

    // Rays to deeper receivers leave by the far rectangle, to others by the near one.
    let depth = DEPTH_ROW - DVec4::W * DEPTH_ROW.dot(light);
    let end = |half: u32, own: f64, other: f64, part: Option<DVec4>| {
        let edge = |side: &SideFace| edge(corners, side.corner, (own, other), light);
        let plane = (DEPTH_ROW - DVec4::W * own) * (other - own).signum();
        End { half, plane, part, edges: sides.iter().map(edge).collect() }
    };
    let between = light.w > 0.0 && -light.z > near && -light.z < far;
    let recedes = if light.w > 0.0 { -light.z < far } else { light.z >= 0.0 };
    let ends: SmallVec<[End; 2]> = if between {
        smallvec![end(0, far, near, Some(depth)), end(1, near, far, Some(-depth))]
    } else {
        let (own, other) = if recedes { (far, near) } else { (near, far) };
        smallvec![end(0, own, other, None)]
    };

    let (slide, fallback) = slide_back(situation, near, far);
    let faces = Faces { situation, slide, corners };
    let draft = drafts.open(word.name, (SECTORS, BANDS));
    draft.complete = LightPosition::of(situation.view, light) != LightPosition::AtEye;
    draft.fallback = fallback;
    for facet in ends.iter().map(|end| faces.end(end)) {
        draft.push_cut(facet, &situation.receivers);
    }
    for (index, side) in sides.iter().enumerate() {
        draft.push_cut(faces.side(index, side, &ends), &situation.receivers);
    }
    draft.selection.split = between.then_some(depth);
    select(&sides, &ends, &mut draft.selection);
    Ok(())
}

/// Depths of the near and the far rectangle, around the receivers.
fn depths(situation: &Situation<'_>) -> (f64, f64) {
    let (near, far) = situation.receivers.range(DEPTH_ROW);
    if near < far { (near, far) } else { (situation.view.near_metres, 2.0 * situation.view.near_metres) }
}

/// The walk: sectors of back sides, in each the end rectangle before the side.
fn select(sides: &[SideFace], ends: &[End], selection: &mut Selection) {
    let closed = sides.len() == SECTORS as usize;
    for end in ends {
        for sector in 0..SECTORS as usize {
            let border = match sides.get(sector) {
                Some(side) if sector > 0 || closed => side.start,
                Some(_) => DVec4::W,
                None if sector == 0 => DVec4::W,
                None => -DVec4::W,
            };
            selection.borders.push(border);
            selection.distances.push(end.edges.get(sector).copied().unwrap_or(DVec4::W));
            // A sector without a side has its end rectangle only.
            selection.thresholds.push(if end.edges.get(sector).is_some() { 0.0 } else { f64::MAX });
        }
    }
}

/// The plane through the light and the edge of an end rectangle: positive towards the side that shares the edge.
fn edge(corners: [DVec3; 4], corner: usize, (own, other): (f64, f64), light: DVec4) -> DVec4 {
    let (one, two) = (corners[corner] * own, corners[(corner + 1) % 4] * own);
    let normal = (two - one).cross(light.truncate() - one * light.w).normalize_or_zero();
    let row = normal.extend(-normal.dot(one));
    // The side runs on to the other end; the rectangle's middle lies across the edge.
    let beyond = (one + two) * (0.5 * other / own);
    let middle = corners.iter().sum::<DVec3>() * (0.25 * own);
    if row.dot(beyond.extend(1.0)) >= row.dot(middle.extend(1.0)) { row } else { -row }
}

struct Faces<'a> {
    situation: &'a Situation<'a>,
    slide: f64,
    corners: [DVec3; 4],
}

impl Faces<'_> {
    /// The facet of an end rectangle.
    fn end(&self, end: &End) -> FacetDraft {
        let cells = (0..SECTORS).map(|sector| Cell { half: end.half, sector, band: 0 }).collect();
        let select: Sides = end.edges.iter().map(|edge| -*edge).chain(end.part).collect();
        self.facet(cells, end.plane, [DVec4::X, DVec4::Y], select)
    }

    /// The facet of a side.
    fn side(&self, index: usize, side: &SideFace, ends: &[End]) -> FacetDraft {
        let (one, two) = (self.corners[side.corner], self.corners[(side.corner + 1) % 4]);
        let plane = (-one.cross(two).normalize()).extend(0.0);
        let along = (two - one).extend(0.0);
        let cells = ends.iter().map(|end| Cell { half: end.half, sector: index as u32, band: 1 }).collect();
        let select: Sides = ends.iter().map(|end| end.edges[index]).chain(side.sides()).collect();
        self.facet(cells, plane, [along, DVec4::W], select)
    }

    /// The facet of receivers moved along the light onto a plane; `rows` are two axes of the plane, over depth.
    fn facet(&self, cells: SmallVec<[Cell; 4]>, plane: DVec4, rows: [DVec4; 2], select: Sides) -> FacetDraft {
        let light = self.situation.light;
        let toward = plane.dot(light);
        // The light stands on the plane's inner side, wherever that is.
        let sign = if toward < 0.0 { -1.0 } else { 1.0 };
        let onto = |row: DVec4| (row * toward - plane * row.dot(light)) * sign;
        FacetDraft {
            cells,
            x: onto(rows[0]),
            y: onto(rows[1]),
            curve: Curve::Straight,
            w: onto(DEPTH_ROW + DVec4::W * self.slide),
            select,
            receivers: BodyPlace::default(),
            region: Region::Tile(TileRequest::Footprint),
        }
    }
}
