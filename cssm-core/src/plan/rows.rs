//! A facet's rows fitted to its receivers, and their outline in the light's view.

use glam::{DVec2, DVec4};

use super::window::Corners;
use crate::facet::FacetRows;
use crate::polygon::{self, Places};
use crate::receivers::{Body, is_negligible};
use crate::remap::{Curve, Remap};
use crate::technique::{FacetDraft, Region};

/// Extent in x/w or y/w, relative to its size, below which a facet holds no receivers of any area.
const EMPTY_EXTENT: f64 = 1e-12;
/// Area in clip space, of 4, below which a facet's receivers lie on a line in the light's view.
const EMPTY_AREA: f64 = 1e-9;

/// The rows of a facet fitted to its receivers, if there are any; adds the corners of their outline.
pub(super) fn fitted(facet: &FacetDraft, receivers: Body<'_>, corners: &mut Corners) -> Option<FacetRows> {
    if receivers.is_empty() {
        return None;
    }

    // Where receivers lie; those whose w vanishes share their image with the other end of their edge.
    let mut places = Places::new();
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for vertex in receivers.vertices {
        let w = facet.w.dot(*vertex);
        if is_negligible(w, facet.w, *vertex) {
            continue;
        }
        let place = DVec2::new(facet.x.dot(*vertex), facet.y.dot(*vertex)) * (1.0 / w);
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
    let is_whole = matches!(facet.region, Region::Tile(_));
    if is_whole {
        for place in &mut places {
            *place = *place * scale - shift;
        }
    }

    // Find their outline, which must have an area.
    let start = corners.len();
    polygon::add_hull(&mut places, corners);
    let area = if whole.remap.is_none() {
        let area = polygon::area(&corners[start..]);
        if is_whole { area } else { area * scale.x * scale.y }
    } else {
        let bent = |corner: &DVec2| {
            let x = if is_whole { corner.x } else { corner.x * scale.x - shift.x };
            DVec2::new(x, whole.remap.y(corner.y))
        };
        polygon::area(&corners[start..].iter().map(bent).collect::<Places>())
    };
    if area.abs() <= EMPTY_AREA {
        corners.truncate(start);
        return None;
    }
    Some(if is_whole { whole } else { plain })
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
