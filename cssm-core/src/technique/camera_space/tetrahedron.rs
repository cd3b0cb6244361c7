//! Tetrahedron: a point light is enclosed by four plain projections that fill one square, for small lights and lights at
//! the eye (camera space shadow maps, section 6.3).
//!
//! One vertex points to the middle of the near plane: towards vertices a projection is finest, and what is visible there
//! is near. Three faces meet in it and are parted by half-planes around that axis, the fourth lies behind all three.

use glam::{DVec2, DVec3};
use smallvec::smallvec;

use super::anchors::{Anchors, barycentric};
use crate::case::LightKind;
use crate::facet::{Cell, FacetShape};
use crate::light::LightPosition;
use crate::plan::PlanError;
use crate::schema::{Choice, Word};
use crate::technique::{ConfigurationSpec, Drafts, Sides, Situation};

/// Faces around the axis.
const SECTORS: u32 = 3;
/// Two edges of a triangle are inner ones.
const CLIPS: u32 = 2;
/// Height of the base below the centre, of a circumradius of 1.
const BASE: f64 = 1.0 / 3.0;

pub(super) const SPEC: ConfigurationSpec = ConfigurationSpec {
    choice: Choice::plain("tetrahedron", "four plain projections around a small light or one at the eye"),
    lights: &[LightKind::Spot, LightKind::Omni],
    takes_distribution: false,
    serves: |position| position == LightPosition::AtEye,
    shape: |_, _| FacetShape { sectors: SECTORS, bands: 2, clips: CLIPS, ..FacetShape::ONE },
    draft,
};

fn draft(situation: &Situation<'_>, _: &Word, drafts: &mut Drafts) -> Result<(), PlanError> {
    let before = drafts.len();
    if around(situation, (SPEC.choice.name, ""), drafts).is_none() {
        drafts.truncate(before);
    }
    Ok(())
}

/// Adds the tetrahedron around a point light, as a form of a configuration. `None`, perhaps with an unfinished draft, where
/// there is none.
pub(super) fn around(
    situation: &Situation<'_>,
    (configuration, form): (&'static str, &'static str),
    drafts: &mut Drafts,
) -> Option<()> {
    if situation.light.w == 0.0 {
        return None;
    }
    let light = situation.light.truncate();
    let tip = (DVec3::NEG_Z * situation.view.near_metres - light).try_normalize().unwrap_or(DVec3::NEG_Z);
    let (across, up) = (-tip).any_orthonormal_pair();
    let base = BASE_ANGLES.map(|(cosine, sine)| {
        let radius = (1.0 - BASE * BASE).sqrt();
        (across * cosine + up * sine) * radius - tip * BASE
    });
    let at = |vertex: DVec3| (light + vertex).extend(1.0);
    let past = |vertex: DVec3| {
        let normal = vertex.cross(tip).normalize();
        normal.extend(-normal.dot(light))
    };
    let draft = drafts.open(configuration, (SECTORS, 2));
    draft.form = form;
    draft.reserve(SECTORS as usize + 1);
    let square = |k: usize| [DVec2::ZERO, SQUARE[k], SQUARE[(k + 1) % 4]];

    // Three faces around the vertex.
    for sector in 0..SECTORS as usize {
        let (one, two) = (base[sector], base[(sector + 1) % 3]);
        let face = Anchors {
            points: [at(tip), at(one), at(two)],
            weights: [1.0; 3],
            targets: square(sector),
            share: 1.0,
        };
        let [toward_tip, ..] = barycentric(face.points, light)?;
        let toward_tip = toward_tip / toward_tip.truncate().length();
        let sides = smallvec![past(one), -past(two), toward_tip];
        let cells = smallvec![Cell::of(sector as u32, 0)];
        draft.push_cut(face.facet(cells, 0, light, sides)?, &situation.receivers);
        draft.selection.borders.push(past(one));
        draft.selection.distances.push(-toward_tip);
        draft.selection.thresholds.push(0.0);
    }

    // The base behind them.
    let behind = Sides::from_slice(&draft.selection.distances);
    let face = Anchors { points: base.map(at), weights: [1.0; 3], targets: square(3), share: 1.0 };
    let cells = (0..SECTORS).map(|sector| Cell::of(sector, 1)).collect();
    draft.push_cut(face.facet(cells, 0, light, behind)?, &situation.receivers);
    Some(())
}

/// Cosine and sine of a third of a turn.
const BASE_ANGLES: [(f64, f64); 3] =
    [(1.0, 0.0), (-0.5, 0.866_025_403_784_438_6), (-0.5, -0.866_025_403_784_438_6)];
/// Corners of a square's clip space, counter-clockwise.
const SQUARE: [DVec2; 4] =
    [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(1.0, 1.0), DVec2::new(-1.0, 1.0)];
