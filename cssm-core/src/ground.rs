//! Planes whose receivers shadow nothing on themselves: where one lies in a facet's tile, and which receivers lie on it.
//!
//! Where a facet's image knows no rows but straight ones, a plane's depth and one over w are affine over it, and the
//! squared density of texels along each axis of the map is w^-2 times a polynomial of that axis alone.

use glam::{DMat4, DVec3, DVec4};

use crate::facet::Facet;

/// How far a receiver may lie from a plane, relative to the terms of its distance: positions of f32 that took a few roundings
/// to make, among them that of a float depth buffer.
pub const ROUNDING: f64 = 4e-6;
/// Light, as a share of the plane's normal, below which it lies in the plane.
const ALONG: f64 = 1e-9;

/// A plane as a facet's tile shows it, of clip x/w and y/w before rows are bent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneInTile {
    /// Depth that shadows the plane where the map holds less, growing away from the light: (x, y, 1) times it.
    pub depth: DVec3,
    /// One over w on the plane, likewise; not positive where no ray of the tile meets it.
    pub inverse_w: DVec3,
    /// Squared texels per metre on the plane along x, times w squared: (1, x, x squared) times it.
    pub across: DVec3,
    /// The same along y, before rows are bent: (1, y, y squared) times it.
    pub up: DVec3,
}

impl PlaneInTile {
    /// A plane (unit normal and offset) in a facet's tile; both, and the light as a homogeneous point, in one space. `sign` turns
    /// stored depth so that it grows away from the light; `chord_texels` is how far casters' edges may lie off along bent
    /// rows. `None` where the light lies in the plane, which it then neither lights nor shadows.
    pub fn of(plane: DVec4, facet: &Facet, light: DVec4, sign: f64, chord_texels: f64) -> Option<Self> {
        // Turn the plane towards the light, and lift it by half a texel: what it holds itself must not shadow it.
        let above = plane.dot(light);
        if above.abs() <= ALONG * light.truncate().length().max(light.w) {
            return None;
        }
        let rows = &facet.rows;
        let lift =
            facet.receiver_plane_depth / facet.depth_per_metre + chord_texels * facet.texel_metres_per_w;
        let lifted = plane * above.signum() - rows.w * lift;

        // Functionals of space become functionals of clip space by the inverse of the rows, transposed.
        let to_clip = DMat4::from_cols(rows.x, rows.y, rows.z * sign, rows.w).inverse();
        let in_clip = to_clip * lifted;
        let affine = |value: DVec4| DVec3::new(value.x, value.y, value.w);
        let depth = affine(in_clip) / -in_clip.z;
        let unit = to_clip * DVec4::W;
        let inverse_w = affine(unit) + depth * unit.z;
        if !depth.is_finite() || !inverse_w.is_finite() {
            return None;
        }

        // Texels along an axis lie as close on the plane as the part of the gradient within it tells.
        let normal = plane.truncate();
        let within = |row: DVec4| row.truncate() - normal * normal.dot(row.truncate());
        let density = |row: DVec4, texels: u32| {
            let (own, w) = (within(row), within(rows.w));
            let half = 0.5 * f64::from(texels);
            DVec3::new(own.length_squared(), -2.0 * own.dot(w), w.length_squared()) * (half * half)
        };
        Some(Self {
            depth: depth - DVec3::Z * facet.rounding_depth,
            inverse_w,
            across: density(rows.x, facet.tile.width),
            up: density(rows.y, facet.tile.height),
        })
    }
}

/// The rows a_x x + a_y y + a at which a facet that shares its tile is cut off, of clip x/w and y/w, positive inside; as many as
/// it has clip half-spaces.
pub fn edges_in_tile(facet: &Facet) -> impl Iterator<Item = DVec3> + '_ {
    let rows = &facet.rows;
    let to_clip = DMat4::from_cols(rows.x, rows.y, rows.z, rows.w).inverse();
    facet.clip.iter().map(move |clip| {
        let edge = to_clip * *clip;
        DVec3::new(edge.x, edge.y, edge.w)
    })
}

/// Which of some planes a receiver lies on; both in one space.
pub fn plane_of(planes: impl IntoIterator<Item = DVec4>, receiver: DVec3) -> Option<usize> {
    let point = receiver.extend(1.0);
    planes.into_iter().position(|plane| plane.dot(point).abs() <= ROUNDING * plane.abs().dot(point.abs()))
}
