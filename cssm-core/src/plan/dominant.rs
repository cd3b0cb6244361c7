//! The dominant plane: receivers near a given plane get a facet whose texels are the camera's own pixels on it (camera space
//! shadow maps, conclusion: the paper's flight scenario).
//!
//! A point is moved along its light ray onto the plane and projected as the camera projects it: on the plane itself the
//! facet's texel grid is the screen's, wherever the view looks.

use glam::{DVec3, DVec4};
use smallvec::{SmallVec, smallvec};

use crate::receivers::{BodyPlace, DEPTH_ROW, Polytope};
use crate::remap::Curve;
use crate::technique::{FacetDraft, Region, Sides, Situation, TileRequest};

/// A plane in camera space with its facet.
#[derive(Debug)]
pub(crate) struct DominantFacet {
    /// Rows of receivers on the plane: the first lies between -1 and 1, the second is not negative.
    pub(crate) rows: [DVec4; 2],
    /// The facet; its cell is named when the walk is known.
    pub(crate) facet: FacetDraft,
    /// Its receivers.
    pub(crate) receivers: Polytope,
}

/// Smallest sine of the angle between light and plane, and between eye and plane, in thicknesses.
const SMALLEST_SINE: f64 = 1e-3;

/// The facet of a plane (unit normal and offset, camera space), where the case declares one and both light and eye stand
/// on the same side of it and something visible lies on it.
pub(super) fn facet(situation: &Situation<'_>, plane: DVec4) -> Option<DominantFacet> {
    let declared = situation.case.dominant_plane?;
    let thickness = declared.thickness_metres;
    let light = situation.light;

    // Turn the plane so that the eye stands above it; light from below shadows it whole.
    let plane = if plane.w < 0.0 { -plane } else { plane };
    let above = plane.dot(light) / light.truncate().length().max(light.w);
    if above < SMALLEST_SINE || plane.w <= thickness || (light.w > 0.0 && plane.dot(light) <= 2.0 * thickness)
    {
        return None;
    }

    // Move rows along the light onto the plane.
    let onto = |row: DVec4| row - plane * (row.dot(light) / plane.dot(light));
    let (x, y, w) = (onto(DVec4::X), onto(DVec4::Y), onto(DEPTH_ROW));
    let mut select: Sides = smallvec![plane + DVec4::W * thickness, DVec4::W * thickness - plane];
    let front = w - DVec4::W * (0.5 * situation.view.near_metres);
    select.push(front);
    let receivers = situation.receivers.cut_by(&select);
    let facet = FacetDraft {
        cells: SmallVec::new(),
        x,
        y,
        curve: Curve::Straight,
        w,
        select,
        receivers: BodyPlace::default(),
        region: Region::Tile(TileRequest::Share(declared.share)),
    };
    (!receivers.is_empty()).then_some(DominantFacet { rows: [plane / thickness, front], facet, receivers })
}

/// A plane found from visible points and their normals (world axes, points relative to the eye): the one that most points
/// lie within a thickness of, with the normal of its points; as unit normal and offset. `None` where no plane holds a
/// tenth of them.
pub fn dominant_plane(points: &[(DVec3, DVec3)], thickness_metres: f64) -> Option<DVec4> {
    /// Points that are tried as a plane's own.
    const TRIALS: usize = 64;
    /// Smallest share of all points that a plane must hold.
    const SMALLEST_SHARE: f64 = 0.1;
    /// Smallest cosine between the normals of a plane and of a point on it.
    const SAME_NORMAL: f64 = 0.9;

    // Count supporters of planes through evenly picked points.
    let stride = points.len().div_ceil(TRIALS).max(1);
    let supports = |plane: DVec4, (point, normal): &(DVec3, DVec3)| {
        plane.dot(point.extend(1.0)).abs() <= thickness_metres && normal.dot(plane.truncate()) >= SAME_NORMAL
    };
    let trial = |(point, normal): &(DVec3, DVec3)| {
        let normal = normal.try_normalize()?;
        let plane = normal.extend(-normal.dot(*point));
        Some((points.iter().filter(|other| supports(plane, other)).count(), plane))
    };
    let trials = points.iter().step_by(stride).filter_map(trial);
    let (count, best) = trials.max_by_key(|(count, _)| *count)?;
    if (count as f64) < SMALLEST_SHARE * points.len() as f64 {
        return None;
    }

    // Average what the supporters say.
    let own: Vec<_> = points.iter().filter(|other| supports(best, other)).collect();
    let normal = own.iter().map(|(_, normal)| *normal).sum::<DVec3>().try_normalize()?;
    let offset = own.iter().map(|(point, _)| normal.dot(*point)).sum::<f64>() / own.len() as f64;
    Some(normal.extend(-offset))
}
