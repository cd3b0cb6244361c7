//! Alpha masks: textures that cut holes into a mesh.

/// The alpha channel of a texture, and where each vertex of a mesh lies in it.
///
/// Sampled at the nearest texel; coordinates repeat.
#[derive(Debug, Clone, PartialEq)]
pub struct AlphaMask {
    /// Texture coordinates (u, v), one pair for each vertex.
    pub uvs: Vec<[f32; 2]>,
    /// Width of the texture in texels.
    pub width: u32,
    /// Height of the texture in texels.
    pub height: u32,
    /// Alpha of each texel, row by row; row 0 lies at v = 0.
    pub alpha: Vec<u8>,
    /// Texels whose alpha / 255 lies below this are holes.
    pub cutoff: f32,
}

impl AlphaMask {
    /// Whether the mask is a hole at texture coordinates.
    pub fn is_hole(&self, u: f64, v: f64) -> bool {
        let (column, row) = (texel(u, self.width), texel(v, self.height));
        self.is_hole_texel(row * self.width as usize + column)
    }

    /// Whether a texel is a hole; texels that the mask does not hold are not.
    fn is_hole_texel(&self, texel: usize) -> bool {
        self.alpha.get(texel).is_some_and(|alpha| f32::from(*alpha) / 255.0 < self.cutoff)
    }

    /// Share of the texels that are holes.
    pub fn hole_share(&self) -> f64 {
        let holes = (0..self.alpha.len()).filter(|texel| self.is_hole_texel(*texel)).count();
        holes as f64 / self.alpha.len().max(1) as f64
    }
}

/// The texel of a repeating coordinate.
fn texel(coordinate: f64, size: u32) -> usize {
    // Rounding may lift a small negative coordinate to the end of its period.
    let within = coordinate - coordinate.floor();
    ((within * f64::from(size)) as usize).min(size.saturating_sub(1) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mask(cutoff: f32) -> AlphaMask {
        AlphaMask { uvs: Vec::new(), width: 2, height: 3, alpha: vec![0, 127, 128, 255, 10, 200], cutoff }
    }

    #[test]
    fn texels_are_the_nearest_and_repeat() {
        let mask = mask(0.5);
        let holes = |u: f64| [0.1, 0.5, 0.9].map(|v| mask.is_hole(u, v));
        assert_eq!(holes(0.25), [true, false, true]);
        assert_eq!(holes(0.75), [true, false, false]);
        for turns in [-3.0, 2.0] {
            assert_eq!(holes(0.25 + turns), holes(0.25));
        }
        // The end of a period is the start of the next.
        assert_eq!((mask.is_hole(1.0, 0.5), mask.is_hole(-1e-18, 0.9)), (false, false));
    }

    #[test]
    fn alpha_at_the_cutoff_is_no_hole() {
        assert!(!mask(128.0 / 255.0).is_hole(0.25, 0.5));
        assert!(mask(129.0 / 255.0).is_hole(0.25, 0.5));
        assert!((mask(0.5).hole_share() - 0.5).abs() < 1e-12);
        assert_eq!(mask(0.0).hole_share(), 0.0);
    }
}
