//! A facet's rows fitted to its receivers, and their outline in the light's view.

use glam::{DVec2, DVec4};
use smallvec::SmallVec;

use crate::facet::FacetRows;
use crate::polygon::{self, Outline};
use crate::receivers::{Body, is_negligible};
use crate::remap::{Curve, Remap};
use crate::technique::{FacetDraft, Region};

/// Extent in x/w or y/w, relative to its size, below which a facet holds no receivers of any area.
const EMPTY_EXTENT: f64 = 1e-12;
/// Area in clip space, of 4, below which a facet's receivers lie on a line in the light's view.
const EMPTY_AREA: f64 = 1e-9;

/// The rows of a facet fitted to its receivers, if there are any, and their outline.
pub(super) fn fitted(facet: &FacetDraft, receivers: Body<'_>) -> Option<(FacetRows, Outline)> {
    if receivers.is_empty() {
        return None;
    }

    // Where receivers lie; those whose w vanishes share their image with the other end of their edge.
    let mut places: SmallVec<[DVec2; 48]> = SmallVec::new();
    let mut points = Outline::new();
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for vertex in receivers.vertices {
        let w = facet.w.dot(*vertex);
        if is_negligible(w, facet.w, *vertex) {
            continue;
        }
        let place = DVec2::new(facet.x.dot(*vertex), facet.y.dot(*vertex)) / w;
        (low, high) = (low.min(place), high.max(place));
        if w > 0.0 {
            places.push(place);
        }
    }

    // Bent rows keep 1 / distance and fit what it goes through.
    let plain = FacetRows { x: facet.x, y: facet.y, z: facet.w, w: facet.w, remap: Remap::NONE };
    let across = Fit::of(low.x, high.x)?;
    let x = across.row(facet.x, facet.w);
    let (whole, up) = if facet.curve == Curve::Straight {
        let up = Fit::of(low.y, high.y)?;
        (FacetRows { x, y: up.row(facet.y, facet.w), ..plain }, up)
    } else {
        let remap = Remap::fitted(facet.curve, low.y.max(0.0), high.y)?;
        (FacetRows { x, remap, ..plain }, Fit { scale: 1.0, shift: 0.0 })
    };

    let (scale, shift) = (DVec2::new(across.scale, up.scale), DVec2::new(across.shift, up.shift));
    points.extend(places.iter().map(|place| *place * scale - shift));
    let outline = polygon::hull(points);
    let area = if whole.remap.is_none() {
        polygon::area(&outline)
    } else {
        let bent = outline.iter().map(|corner| DVec2::new(corner.x, whole.remap.y(corner.y)));
        polygon::area(&bent.collect::<Outline>())
    };
    if area.abs() <= EMPTY_AREA {
        return None;
    }
    Some(match facet.region {
        Region::Tile(_) => (whole, outline),
        Region::Whole(_) | Region::Triangle { .. } => (plain, polygon::hull(Outline::from_slice(&places))),
    })
}

/// What takes a range of ratios to -1 and 1.
struct Fit {
    scale: f64,
    shift: f64,
}

impl Fit {
    /// `None` where the range has no extent.
    fn of(low: f64, high: f64) -> Option<Self> {
        let extent = high - low;
        let usable = extent.is_finite() && extent > EMPTY_EXTENT * low.abs().max(high.abs());
        usable.then(|| Self { scale: 2.0 / extent, shift: (high + low) / extent })
    }

    /// The row whose ratio to w runs from -1 to 1.
    fn row(&self, row: DVec4, w: DVec4) -> DVec4 {
        row * self.scale - w * self.shift
    }
}
