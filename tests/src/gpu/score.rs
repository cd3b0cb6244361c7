//! How drawn visibility fares against the twin's, wherever the twin itself is sure: where moving the point by 5e-3 of a
//! texel, the accuracy promised for resolve coordinates, does not change its answer.

use cssm_core::ShadowPlan;
use cssm_core::case::{LightCase, MaskNormal, Resolve};
use cssm_core::glam::DVec3;
use cssm_core::homography::Gradients;
use cssm_core::twin::{DepthMap, resolve};

use super::resolve::Visible;
use super::stage::Drawn;

/// Accuracy of resolve coordinates, texels.
const TEXEL_TOLERANCE: f64 = 5e-3;
/// Accuracy of the compared depth.
const DEPTH_TOLERANCE: f64 = 2e-6;
/// Accuracy of positions from f32 depth and rays, relative to the distance.
const POSITION_TOLERANCE: f64 = 5e-7;
/// Rounding of an 8-bit mask and of the 8-bit weights that filtering hardware blends with.
const MASK_TOLERANCE: f64 = 0.5 / 255.0 + 1.0 / 256.0;
/// Pixels around one that must lie on its plane for its normal to be reconstructed.
const NORMAL_REACH_PIXELS: i32 = 2;

/// Counts of pixels.
#[derive(Debug, Default)]
pub struct Score {
    /// Pixels that see a surface.
    pub judged: usize,
    /// Those whose mask is judged: all of them unless the mask reconstructs the normals that the bias reads; then only
    /// pixels inside a plane.
    pub mask_judged: usize,
    /// Pixels in shadow.
    pub shadowed: usize,
    /// Pixels at which the mask is wrong.
    pub mask_wrong: usize,
    /// Pixels at which the engine's material is wrong.
    pub material_wrong: usize,
    /// Largest error.
    pub worst: f64,
}

impl Score {
    /// Adds a frame.
    pub fn add(&mut self, case: &LightCase, drawn: &Drawn, visible: &Visible) {
        let reconstructs = |interface: &Resolve| {
            matches!(interface, Resolve::Mask { normal: MaskNormal::Reconstructed, .. })
        };
        let true_normals = !(case.bias.reads_normal() && case.resolve.iter().any(reconstructs));
        for (pixel, (ray, hit)) in visible.rays.iter().zip(&visible.hits).enumerate() {
            let Some(hit) = hit else { continue };
            let point = *ray * hit.along;
            let (low, high) = visibility_bracket(case, &drawn.plan, &drawn.map, point, hit.normal);
            self.judged += 1;
            self.shadowed += usize::from(high < 0.5);
            let outside = |image: &Vec<u8>| {
                let value = f64::from(image[pixel]) / 255.0;
                (low - value).max(value - high).max(0.0)
            };
            if let Some(mask) = &drawn.mask
                && (true_normals || visible.on_one_plane(pixel, NORMAL_REACH_PIXELS))
            {
                let error = outside(mask);
                self.mask_judged += 1;
                self.mask_wrong += usize::from(error > MASK_TOLERANCE);
                self.worst = self.worst.max(error);
            }
            if let Some(material) = &drawn.material {
                let error = outside(material);
                self.material_wrong += usize::from(error > MASK_TOLERANCE);
                self.worst = self.worst.max(error);
            }
        }
    }
}

/// Smallest and largest visibility that the twin finds within the promised accuracy of a point.
fn visibility_bracket(
    case: &LightCase,
    plan: &ShadowPlan,
    map: &DepthMap,
    point: DVec3,
    normal: DVec3,
) -> (f64, f64) {
    let centre = resolve(case, plan, map, point, normal);
    let (mut low, mut high) = (centre.visibility, centre.visibility);
    let Some(facet) = plan.facet(centre.cell) else { return (low, high) };

    // Step along the receiver's plane by the tolerance in both texel axes, and along the light in depth.
    let (light, light_metres) = if plan.light.w == 0.0 {
        (plan.light.truncate(), 1.0)
    } else {
        let toward = plan.light.truncate() - point;
        (toward.normalize_or(DVec3::Y), toward.length())
    };
    let across = normal.any_orthonormal_vector();
    let texel_metres = facet.texel_metres_per_w * Gradients::at(&facet.rows, point).w;
    let tilt = 1.0 / normal.dot(light).abs().max(0.01);
    let metres_per_depth = Gradients::at(&facet.rows, point).w / facet.depth_per_metre * light_metres;
    let depth_metres = DEPTH_TOLERANCE * metres_per_depth;
    let along = light * (depth_metres + POSITION_TOLERANCE * point.length() * tilt);
    for (one, two) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.0, 0.0)] {
        for depth in [-1.0, 1.0] {
            let step = (across * one + normal.cross(across) * two) * (TEXEL_TOLERANCE * texel_metres * tilt);
            let near = resolve(case, plan, map, point + step + along * depth, normal);
            low = low.min(near.visibility);
            high = high.max(near.visibility);
        }
    }
    (low, high)
}
