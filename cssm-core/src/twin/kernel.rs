//! Boxes around a receiver: how wide a filter's kernel is, and what the texels in it are worth.

use glam::DVec2;

use crate::case::Kernel;
use crate::facet::Tile;
use crate::homography::Gradients;

/// Half the width of the narrowest kernel, texels: bilinear blending.
pub(super) const NARROWEST: DVec2 = DVec2::splat(0.5);

/// Texels per metre across the light along x and y of the map: an edge of the box of so many texels per metre lies a
/// metre from its opposite, however x and y are sheared against each other.
pub(super) fn texels_per_metre(tile: &Tile, gradients: &Gradients) -> DVec2 {
    let size = DVec2::new(f64::from(tile.width), f64::from(tile.height));
    DVec2::new(gradients.x.length(), gradients.y.length()) * 0.5 * size
}

/// Half the widest kernel that stays inside a tile, texels.
pub(super) fn room(tile: &Tile, texel: DVec2) -> DVec2 {
    let (low, high) = tile.texel_limits();
    (texel - low).min(high - texel) + NARROWEST
}

/// Half the widths of a kernel in texels, at most `widest`; a pixel spans `pixel_metres` at the receiver's depth.
pub(super) fn half_widths(kernel: Kernel, widest: f64, per_metre: DVec2, pixel_metres: f64) -> DVec2 {
    let metres = match kernel {
        Kernel::Texels => return DVec2::splat(widest),
        Kernel::Metres(metres) => metres,
        Kernel::Pixels(pixels) => pixels * pixel_metres,
    };
    (per_metre * (0.5 * metres)).clamp(NARROWEST, DVec2::splat(widest))
}

/// The texels that a box around a point touches: upper left corner and overlap of each.
pub(super) fn overlaps(texel: DVec2, half_widths: DVec2) -> impl Iterator<Item = (DVec2, f64)> {
    let (low, high) = (texel - half_widths, texel + half_widths);
    let (first, last) = (low.floor(), high.floor());
    let columns = (last.x - first.x) as u32 + 1;
    let rows = (last.y - first.y) as u32 + 1;
    (0..rows).flat_map(move |row| {
        (0..columns).map(move |column| {
            let corner = first + DVec2::new(f64::from(column), f64::from(row));
            let overlap = (high.min(corner + 1.0) - low.max(corner)).max(DVec2::ZERO);
            (corner, overlap.element_product())
        })
    })
}

/// Share of light in a box around a point.
pub(super) fn lit_in_box(texel: DVec2, half_widths: DVec2, lit_at: impl Fn(DVec2) -> f64) -> f64 {
    let lit: f64 = overlaps(texel, half_widths).map(|(corner, overlap)| overlap * lit_at(corner)).sum();
    lit / (4.0 * half_widths.element_product())
}

/// The edge of a shadow that a light with an extent throws.
pub(super) struct SoftEdge {
    /// Half the widths of the edge in texels for a caster one unit of depth before the receiver. Depth times w over depth per
    /// metre is a distance along a directional light's rays; for a local light it is that distance as a multiple of the
    /// caster's own from the light. Times the light's radius both are half the edge in metres at the receiver.
    pub(super) per_depth: DVec2,
    /// Half the widest box, texels.
    pub(super) widest: DVec2,
}

impl SoftEdge {
    /// Visibility of a point, `highest` in depth behind the near end; `before` tells how far before the receiver's reference
    /// a texel holds a caster, 0 or less if it shadows nothing.
    pub(super) fn visibility(&self, texel: DVec2, highest: f64, before: impl Fn(DVec2) -> f64) -> f64 {
        let half_widths = |depth: f64| (self.per_depth * depth).clamp(NARROWEST, self.widest);

        // Average the casters that could reach the receiver.
        let (mut weight, mut depth) = (0.0, 0.0);
        for (corner, overlap) in overlaps(texel, half_widths(highest)) {
            let before = before(corner);
            if before > 0.0 {
                weight += overlap;
                depth += overlap * before;
            }
        }
        if weight <= 0.0 {
            return 1.0;
        }

        // Blend as wide as the light's image through their edge.
        lit_in_box(texel, half_widths(depth / weight), |corner| f64::from(u8::from(before(corner) <= 0.0)))
    }
}
