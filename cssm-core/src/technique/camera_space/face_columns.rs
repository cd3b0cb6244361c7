//! Face columns: every light ray that meets the view frustum belongs to the side face where it has its smallest depth;
//! each face is a column of the map whose rows run with depth.
//!
//! Through the eye and two neighbouring frustum corners c_k, c_(k+1) runs a side face. A point X, moved along the light
//! L onto that plane, is s c_k + t c_(k+1); its depth there is D = s + t and (t - s) / D runs across the face from -1
//! to 1. Both are constant along the light. The faces on which rays have their smallest depth are those with positive
//! signed area in the light's view; they tile the frustum's silhouette without gap or overlap, from one face (light from
//! above a level camera) to all four (light in or behind the view), so no situation needs another configuration
//! (generalises one-plane and four-plane camera space maps; per-face warping after Lloyd et al.).
//!
//! Depth is split into bands of equal ratio, each affine in 1/D: straight lines stay straight and ordinary rasterisation
//! is exact. With an infinite far plane the last band truly reaches infinity.

use glam::{DVec3, DVec4};

use crate::case::LightCase;
use crate::facet::Selection;
use crate::plan::PlanError;
use crate::receivers::{DEPTH_ROW, Polytope};
use crate::technique::{Draft, FacetDraft, Situation, TileRequest};

/// A frustum has four side faces.
pub(super) const SECTORS: u32 = 4;

/// Signed area, relative to the largest, below which a face holds no rays.
const AREA_TOLERANCE: f64 = 1e-9;

/// Number of bands and horizon in metres of a case.
pub(super) fn bands(case: &LightCase) -> (u32, f64) {
    let arguments = case.distribution.as_ref().map(|word| &word.arguments);
    let count = arguments.and_then(|arguments| arguments.count("count")).unwrap_or(8);
    let horizon = arguments.and_then(|arguments| arguments.number("horizon")).unwrap_or(1e5);
    (count, horizon)
}

pub(super) fn draft(situation: &Situation<'_>) -> Result<Draft, PlanError> {
    let (band_count, horizon) = bands(situation.case);
    let faces = faces_entered_first(situation);
    let mut selection =
        Selection { borders: Vec::new(), distances: Vec::new(), thresholds: Vec::new(), bands: band_count };
    let mut facets = Vec::new();
    for sector in 0..SECTORS as usize {
        let face = faces.get(sector);
        selection.borders.push(border(&faces, sector));
        let face = match face {
            Some(face) => face,
            None => {
                // A sector that no walk reaches: its rows only fill the record.
                selection.distances.push(DVec4::W);
                selection.thresholds.push(vec![f64::MAX; band_count as usize - 1]);
                continue;
            }
        };
        let sides = sides(&faces, sector);
        let receivers = situation.receivers.cut_by(&sides);
        let limits = BandLimits::new(face, &receivers, situation, band_count, horizon);
        selection.distances.push(face.distance);
        selection.thresholds.push(limits.inner());
        for band in 0..band_count {
            facets.push(band_facet(
                face,
                &sides,
                &receivers,
                &limits,
                sector as u32 * band_count + band,
                band,
            ));
        }
    }
    if band_count == 1 {
        selection.distances.clear();
        selection.thresholds.clear();
    }
    Ok(Draft { configuration: super::SPEC.configurations[0].name, selection, facets })
}

/// A side face that rays enter first.
struct Face {
    /// Row that is zero on the border through the face's first corner and positive towards the face.
    start: DVec4,
    /// Row that is zero on the border through the face's second corner and positive past it.
    end: DVec4,
    /// t - s.
    across: DVec4,
    /// D = t + s, metres of depth on the face.
    distance: DVec4,
}

/// The faces with positive signed area in the light's view, in walking order.
fn faces_entered_first(situation: &Situation<'_>) -> Vec<Face> {
    let toward = situation.light.truncate();
    let corners = situation.view.corner_tangents().map(|(x, y)| DVec3::new(x, y, -1.0));
    // Orient areas as the image rectangle is oriented in the light's view.
    let sign = if toward.z >= 0.0 { 1.0 } else { -1.0 };
    let areas: [f64; 4] = std::array::from_fn(|k| sign * corners[k].cross(corners[(k + 1) % 4]).dot(toward));
    let largest = areas.iter().fold(0.0_f64, |largest, area| largest.max(area.abs()));
    let entered = |k: usize| areas[k % 4] > AREA_TOLERANCE * largest;

    // Entered faces follow each other around the frustum: begin behind one that is not entered.
    let first = (0..4).find(|k| entered(*k) && !entered(k + 3)).unwrap_or(0);
    (first..first + 4)
        .take_while(|k| entered(*k))
        .map(|k| {
            let (one, two) = (corners[k % 4], corners[(k + 1) % 4]);
            let area = areas[k % 4];
            let start = sign * toward.cross(one);
            let end = sign * toward.cross(two);
            // Cramer's rule for X = s one + t two + m L.
            let (s, t) = (-end / area, start / area);
            Face {
                start: start.normalize().extend(0.0),
                end: end.normalize().extend(0.0),
                across: (t - s).extend(0.0),
                distance: (t + s).extend(0.0),
            }
        })
        .collect()
}

/// Border row of a sector; see [`Selection::borders`].
fn border(faces: &[Face], sector: usize) -> DVec4 {
    match faces.get(sector) {
        Some(face) if sector > 0 || faces.len() == SECTORS as usize => face.start,
        Some(_) => DVec4::W,
        None => -DVec4::W,
    }
}

/// The two border half-spaces of a sector. The outer ones of a run that does not close are the frustum's own silhouette.
fn sides(faces: &[Face], sector: usize) -> Vec<DVec4> {
    vec![faces[sector].start, -faces[sector].end]
}

/// Limits of the bands of one face, in depth D on the face.
struct BandLimits {
    /// D_0 to D_K; the last may be infinite.
    limits: Vec<f64>,
    /// Added to D in the nearest band, where D falls to zero although receivers are no nearer than the near plane.
    core: f64,
}

impl BandLimits {
    fn new(face: &Face, receivers: &Polytope, situation: &Situation<'_>, count: u32, horizon: f64) -> Self {
        let (nearest, farthest) = receivers.range(face.distance);
        let (nearest, farthest) = if nearest <= farthest { (nearest.max(0.0), farthest) } else { (1.0, 2.0) };
        let (depth_near, _) = situation.receivers.range(DEPTH_ROW);
        let core = (depth_near - nearest).max(0.0);

        // Equal ratios of D + core; with an infinite far plane the ratio is that up to the horizon.
        let start = nearest + core;
        let end = if farthest.is_finite() { farthest + core } else { horizon.max(2.0 * start) };
        let ratio = libm::pow(end / start, 1.0 / f64::from(count));
        let mut limits: Vec<f64> =
            (0..=count).map(|index| start * libm::pow(ratio, f64::from(index)) - core).collect();
        limits[0] = nearest;
        limits[count as usize] = farthest;
        Self { limits, core }
    }

    fn inner(&self) -> Vec<f64> {
        self.limits[1..self.limits.len() - 1].to_vec()
    }
}

fn band_facet(
    face: &Face,
    sides: &[DVec4],
    receivers: &Polytope,
    limits: &BandLimits,
    index: u32,
    band: u32,
) -> FacetDraft {
    let band = band as usize;
    let last = limits.limits.len() - 2;
    let mut clip = Vec::new();
    if band > 0 {
        clip.push(face.distance - DVec4::W * limits.limits[band]);
    }
    if band < last {
        clip.push(DVec4::W * limits.limits[band + 1] - face.distance);
    }
    let receivers = receivers.cut_by(&clip);
    let core = if band == 0 { limits.core } else { 0.0 };
    let select: Vec<DVec4> = sides.iter().chain(&clip).copied().collect();
    FacetDraft {
        index,
        x: face.across,
        y: -DVec4::W,
        w: face.distance + DVec4::W * core,
        clip: select.clone(),
        select,
        receivers,
        tile: TileRequest::Footprint,
    }
}
