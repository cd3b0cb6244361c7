//! Generalized linear parameterisation: the warp whose sampling density falls linearly with depth, for every angle between
//! light and view axis where such a warp exists (parallel-split slides, "generalized linear parameterization").
//!
//! The centre lies lambda extents before the near edge. With half heights a and b of the near and the far plane,
//! lambda1 = (n - a / tan) / (f - n + (a + b) / tan). For angles inside the view cone neither this nor the other root,
//! lambda2 = (f tan - b) / (2 b), is positive: no linear warp exists. Below an angle gamma, where lambda1 becomes smaller
//! than 0.7 n / (f - n), the slides go over to lambda1(gamma) / sin(pi angle / (2 gamma)), which ends as a uniform map.
//! With the eye inside the silhouette that is still far too strong; there this map gives way to a uniform one.

use super::warp::{self, Warp, WarpSpec, Warped};
use super::{ConfigurationSpec, TechniqueSpec, only_directional};
use crate::case::LightKind;
use crate::facet::FacetShape;
use crate::schema::Choice;

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice::plain("generalized_linear", "one map warped for linear density at every angle"),
    configurations: &[ConfigurationSpec {
        choice: Choice::plain("linear_density", "one warped facet over the whole map"),
        lights: &[LightKind::Directional],
        takes_distribution: false,
        serves: |_| true,
        shape: |_, _| FacetShape::ONE,
        draft: |situation, word, drafts| warp::draft(&WARP, word.name, situation, drafts),
    }],
    default_configurations: |light| only_directional(light, &["linear_density"]),
    distribution: None,
    fits_infinity: false,
    follows_camera: true,
    variants: &["generalized_linear"],
    check: |_| Vec::new(),
};

/// Its warp.
pub(super) const WARP: WarpSpec =
    WarpSpec { choice: Choice::plain("generalized_linear", "density that falls linearly with depth"), warp };

/// Least lambda1, in n / (f - n), that is used as it is.
const LEAST: f64 = 0.7;

fn warp(warped: &Warped<'_>) -> Warp {
    let (near, far) = warped.depths_metres;
    let view = warped.situation.view;
    let half = 0.5 * (view.top - view.bottom);
    warped.outside_silhouette(1.0 / lambda(near, far, half, warped.plane.sine))
}

/// Distance of the centre from the near edge, in extents, for the sine of the angle between light and view axis and the
/// tangent of half the field of view.
pub fn lambda(near_metres: f64, far_metres: f64, half_tangent: f64, sine: f64) -> f64 {
    // lambda1(gamma) = 0.7 n / (f - n) is linear in half_tangent / tan(gamma).
    let growth = (far_metres + near_metres) / (far_metres - near_metres);
    let gamma = libm::atan(half_tangent * (1.0 + LEAST * growth) / (1.0 - LEAST));
    let angle = libm::asin(sine.clamp(0.0, 1.0));
    if angle >= gamma {
        return lambda1(near_metres, far_metres, half_tangent, angle);
    }
    let least = LEAST * near_metres / (far_metres - near_metres);
    least / libm::sin(std::f64::consts::FRAC_PI_2 * angle / gamma)
}

/// First root of the condition of linear density; not positive inside the view cone.
pub fn lambda1(near_metres: f64, far_metres: f64, half_tangent: f64, angle_radians: f64) -> f64 {
    let (near_half, far_half) = (near_metres * half_tangent, far_metres * half_tangent);
    let tangent = libm::tan(angle_radians);
    (near_metres - near_half / tangent) / (far_metres - near_metres + (near_half + far_half) / tangent)
}

/// Second root of the condition; not positive inside the view cone.
pub fn lambda2(far_metres: f64, half_tangent: f64, angle_radians: f64) -> f64 {
    let far_half = far_metres * half_tangent;
    (far_metres * libm::tan(angle_radians) - far_half) / (2.0 * far_half)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_linear_density_exists_inside_the_view_cone() {
        let half: f64 = 0.5;
        let edge = libm::atan(half);
        for step in 1..20 {
            let inside = edge * f64::from(step) / 20.0;
            assert!(lambda1(0.2, 1000.0, half, inside) <= 0.0 && lambda2(1000.0, half, inside) <= 0.0);
            assert!(lambda(0.2, 1000.0, half, libm::sin(inside)) > 0.0);
            let outside = edge + (std::f64::consts::FRAC_PI_2 - edge) * f64::from(step) / 20.0;
            assert!(lambda1(0.2, 1000.0, half, outside) > 0.0);
        }
    }

    #[test]
    fn both_branches_meet_at_gamma() {
        let (near, far, half) = (0.2, 1000.0, 0.577);
        let growth = (far + near) / (far - near);
        let gamma = libm::atan(half * (1.0 + LEAST * growth) / (1.0 - LEAST));
        let (below, above) = (
            lambda(near, far, half, libm::sin(gamma - 1e-9)),
            lambda(near, far, half, libm::sin(gamma + 1e-9)),
        );
        assert!((below / above - 1.0).abs() < 1e-6, "{below} {above}");
        assert!(lambda(near, far, half, 0.0).is_infinite());
    }
}
