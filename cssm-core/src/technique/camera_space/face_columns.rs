//! Face columns: every light ray that meets the view frustum belongs to the side face where it has its smallest depth;
//! each face is a column of the map whose rows run with depth.
//!
//! On the face through the corners c_k, c_(k+1) a point moved along the light is u eye + s c_k + t c_(k+1); its depth there
//! is D = (s + t) / u and (t - s) / (s + t) runs across the face from -1 to 1. Both are constant along the light. From
//! one face (light from above a level camera) to all four (light in or behind the view) the entered faces tile the
//! silhouette, so no situation needs another configuration (generalises one-plane and four-plane camera space maps;
//! per-face warping after Lloyd et al.).
//!
//! A face that the light runs along has no area, and its column must need no texels there, or it would come up at full
//! size with the first ray that enters it. Cuts of equal distance are turned where they would cross a sliver lengthwise,
//! and columns whose edges lean far ask for coarser texels, see `Unrolled`.
//!
//! A point light before the eye plane sends rays both ways: those to receivers deeper than itself run away and enter by
//! the faces turned towards it; those to nearer receivers come back, and their smallest depth lies on the faces turned
//! away. The plane of its depth, which contains it, parts the two. In the view itself the first kind enters by no side
//! face: receivers behind such a light have no facet here.

use glam::{DVec3, DVec4};

use crate::case::{LightCase, LightKind};
use crate::distribution;
use crate::facet::FacetShape;
use crate::light::LightPosition;
use crate::plan::PlanError;
use crate::receivers::DEPTH_ROW;
use crate::schema::{Choice, Word};
use crate::technique::columns::{self, Column};
use crate::technique::side_faces::{self, Course, SideFace};
use crate::technique::{ConfigurationSpec, Drafts, Sides, Situation};

/// A frustum has four side faces.
const SECTORS: u32 = 4;
/// Least share of the depth that the distance is along the edge that the light sees shorter.
const LEAST_TURNED: f64 = 0.1;
/// Sines of the angle between a face's edges: below the first a cut may turn all the way, from the second on as far as
/// [`LEAST_TURNED`].
const SLIVER: (f64, f64) = (0.25, 0.65);

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("face_columns", "a column on each frustum side face that rays enter first"),
    lights: &[LightKind::Directional, LightKind::Spot, LightKind::Omni],
    takes_distribution: true,
    serves: |position| {
        matches!(position, LightPosition::Dueling | LightPosition::Border | LightPosition::General)
    },
    shape,
    draft,
};

fn shape(case: &LightCase, _: &Word) -> FacetShape {
    FacetShape {
        halves: if case.light.is_local() { 2 } else { 1 },
        sectors: SECTORS,
        bands: distribution::pieces(case),
        ..FacetShape::ONE
    }
}

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let light = situation.light;
    let before_eye = light.w > 0.0 && light.z < 0.0;
    let split = before_eye.then(|| DEPTH_ROW + DVec4::W * light.z);
    let halves: &[(Course, f64)] = match (light.w > 0.0, split.is_some()) {
        (false, _) if Course::of_directional(light.truncate()) == Course::Back => &[(Course::Back, 1.0)],
        (_, false) => &[(Course::Away, 1.0)],
        (_, true) => &[(Course::Away, 1.0), (Course::Back, -1.0)],
    };

    let corners = situation.view.corner_tangents().map(|(x, y)| DVec3::new(x, y, -1.0));
    let bands = distribution::pieces(situation.case);
    let draft = drafts.open(SPEC.choice.name, (SECTORS, bands));
    draft.selection.split = split;
    let faces = |course: &Course| side_faces::entered_first(DVec3::ZERO, corners, light, *course);
    draft.reserve(halves.iter().map(|(course, _)| faces(course).len()).sum::<usize>() * bands as usize);
    for (half, (course, side)) in halves.iter().enumerate() {
        let faces = faces(course);
        let half_space = split.map(|split| split * *side);
        draft.complete &= !faces.is_empty()
            || half_space.is_some_and(|half| situation.receivers.cut_by(&[half]).is_empty());
        for sector in 0..SECTORS {
            let Some(face) = faces.get(sector as usize) else {
                // What a half lacks is never reached.
                let selection = &mut draft.selection;
                selection.borders.push(if sector == 0 { DVec4::W } else { -DVec4::W });
                if bands > 1 {
                    selection.distances.push(DVec4::W);
                    selection.thresholds.extend((1..bands).map(|_| f64::MAX));
                    selection.units.push(DVec4::W);
                }
                continue;
            };
            let sides: Sides = face.sides().into_iter().chain(half_space).collect();
            let unrolled = if light.w == 0.0 { Unrolled::of(face) } else { Unrolled::plain(face) };
            let column = Column {
                half: half as u32,
                sector,
                across: unrolled.across,
                distance: unrolled.distance,
                slant: unrolled.slant,
                unit: face.unit,
                receivers: situation.receivers.cut_by(&sides),
                sides,
            };
            columns::add(&column, situation, draft);

            // The outer borders of a run that does not close are the frustum's own silhouette: nothing is past them.
            let closed = faces.len() == SECTORS as usize;
            let selection = &mut draft.selection;
            selection.borders.push(if sector > 0 || closed { face.start } else { DVec4::W });
            if bands > 1 {
                selection.distances.push(column.distance);
                selection.units.push(column.unit);
            }
        }
    }
    if light.w == 0.0 {
        draft.selection.units.clear();
    }
    Ok(())
}

/// Rows of a face's column.
struct Unrolled {
    /// Place along the cut at a distance, measured from the apex' foot on it.
    across: DVec4,
    /// a s + b t, a and b at most 1: the depth on the face, or on one of its edges and less than that elsewhere.
    distance: DVec4,
    /// The farther end of the cut from the apex' foot on it, over the apex' height.
    slant: f64,
}

impl Unrolled {
    /// Cuts at equal depths.
    fn plain(face: &SideFace) -> Self {
        Self { across: face.t - face.s, distance: face.s + face.t, slant: 0.0 }
    }

    /// Cuts that need no more texels than the face has area, for a directional light.
    fn of(face: &SideFace) -> Self {
        // The cut at distance 1 goes from a point p on the first edge to a point q on the second. Their products
        // across the light, up to a common factor: the row s is normal to q, t to p.
        let (s, t) = (face.s.truncate(), face.t.truncate());
        let (pp, qq, pq) = (t.length_squared(), s.length_squared(), -s.dot(t));

        // Turn the cut until it meets the shorter edge at no more than a right angle, or as far as it may.
        let sine_squared = (1.0 - pq * pq / (pp * qq)).max(0.0);
        let least = LEAST_TURNED * ((sine_squared.sqrt() - SLIVER.0) / (SLIVER.1 - SLIVER.0)).clamp(0.0, 1.0);
        let turned = |square: f64| (square / pq.max(square)).max(least);
        let (a, b) = (turned(pp), turned(qq));
        let (s, t) = (face.s * a, face.t * b);
        let (pp, qq, pq) = (pp / (a * a), qq / (b * b), pq / (a * b));

        // Measure along it, in its lengths; twice the triangle's area over its length is the apex' height.
        let length_squared = pp + qq - 2.0 * pq;
        let (p, q) = ((pq - pp) / length_squared, (qq - pq) / length_squared);
        let area = (pp * qq - pq * pq).max(0.0).sqrt();
        let farther = p.abs().max(q.abs()) * length_squared;
        let slant = if area > 0.0 { farther / area } else { f64::MAX };
        Self { across: s * p + t * q, distance: s + t, slant }
    }
}
