//! Quality figures of a plan: how many screen pixels a map texel spans, and how much of the map sees anything.

mod score;

pub use score::{VolumeScore, accepts, score_volume};

use glam::{DVec2, DVec3};

use crate::facet::{Facet, FacetRows, Tile};
use crate::homography::{Gradients, singular_values};
use crate::plan::ShadowPlan;
use crate::polygon;
use crate::view::View;

/// Texel footprint at a visible point, in screen pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// Major axis of a texel across the light ray, seen at the point's depth.
    pub major_pixels: f64,
    /// Geometric mean of both axes.
    pub geometric_pixels: f64,
}

/// Displacements across the light, in metres, of one texel across and one up.
fn texel_vectors(rows: &FacetRows, tile: &Tile, point_from_eye: DVec3) -> (DVec3, DVec3) {
    let (u, v) = Gradients::at(rows, point_from_eye).across_light();
    (u * (2.0 / f64::from(tile.width)), v * (2.0 / f64::from(tile.height)))
}

/// Volume footprint of a facet at a point relative to the eye: the texel's extent across the light ray, at the
/// point's depth (the literature's perspective aliasing, independent of surface orientation).
pub fn volume(facet: &Facet, view: &View, point_from_eye: DVec3) -> Footprint {
    let (u, v) = texel_vectors(&facet.rows, &facet.tile, point_from_eye);
    let (major, minor) = singular_values(u, v);
    let pixels_per_metre = view.pixels_per_tangent() / view.depth_metres(point_from_eye);
    Footprint {
        major_pixels: major * pixels_per_metre,
        geometric_pixels: (major * minor).sqrt() * pixels_per_metre,
    }
}

/// Surface footprint: the major axis in screen pixels of the image of one texel on a surface with this normal.
pub fn surface(facet: &Facet, view: &View, point_from_eye: DVec3, normal: DVec3) -> f64 {
    let (u, v) = Gradients::at(&facet.rows, point_from_eye).along_surface(normal);
    let to_screen = |displacement: DVec3| {
        // Differentiate x / depth and y / depth along the displacement.
        let camera = view.camera_from_world * point_from_eye;
        let change = view.camera_from_world * displacement;
        let depth = -camera.z;
        let scale = view.pixels_per_tangent() / depth;
        DVec2::new(change.x + camera.x / depth * change.z, change.y + camera.y / depth * change.z) * scale
    };
    let u = to_screen(u * (2.0 / f64::from(facet.tile.width)));
    let v = to_screen(v * (2.0 / f64::from(facet.tile.height)));
    singular_values(u.extend(0.0), v.extend(0.0)).0
}

/// Share of all texels of the plan's region whose beam meets the visible volume.
pub fn beam_utilisation(plan: &ShadowPlan) -> f64 {
    let used: f64 = plan
        .facets
        .iter()
        .map(|facet| {
            let outline = polygon::outline(&facet.rows, &facet.receivers);
            // The tile's clip space has area 4.
            polygon::area(&polygon::image(&facet.rows, &outline)) / 4.0 * facet.tile.texels() as f64
        })
        .sum();
    used / (f64::from(plan.region.width) * f64::from(plan.region.height))
}

/// Smallest possible largest isotropic footprint, in pixels, of any map with so many texels: each side face and the
/// image rectangle must be covered at least once in the light's view. Directional light; needs a finite far depth.
pub fn bound(view: &View, toward_light_world: DVec3, texels: f64, far_metres: f64) -> f64 {
    let toward = view.camera_from_world * toward_light_world;
    let corners = view.corner_tangents().map(|(x, y)| DVec3::new(x, y, -1.0));
    let sign = if toward.z >= 0.0 { 1.0 } else { -1.0 };
    let logarithm = libm::log(far_metres / view.near_metres);
    let faces: f64 =
        (0..4).map(|k| (0.5 * sign * corners[k].cross(corners[(k + 1) % 4]).dot(toward)).max(0.0)).sum();
    let rectangle = (view.right - view.left) * (view.top - view.bottom) * toward.z.abs();
    view.pixels_per_tangent() * ((2.0 * faces * logarithm + rectangle) / texels).sqrt()
}

/// Value at a share (0 to 1) of an ascending list; linear between neighbours.
pub fn quantile(ascending: &[f64], share: f64) -> f64 {
    let Some(last) = ascending.len().checked_sub(1) else { return f64::NAN };
    let position = share.clamp(0.0, 1.0) * last as f64;
    let below = position.floor() as usize;
    let above = (below + 1).min(last);
    ascending[below] + (ascending[above] - ascending[below]) * (position - below as f64)
}
