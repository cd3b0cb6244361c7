//! The continuous family from standard to perspective: one parameter eta from -1 (uniform) over 0 (light space
//! perspective's optimum) to 1 (the centre of projection in the eye, as strong as perspective shadow maps), after Lloyd
//! et al., Logarithmic perspective shadow maps, which also gives eta as a function of the angle gamma between light and
//! view axis: uniform until the light leaves a third of the view cone, then rising to a first value at the cone's
//! border and on to a last one. With the eye inside the silhouette even little of it is worse than a uniform map, so it
//! ends where the other warps do.

use super::light_space_perspective::optimal_strength;
use super::warp::{self, Warp, WarpSpec, Warped, smooth};
use super::{ConfigurationSpec, TechniqueSpec, only_directional};
use crate::case::LightKind;
use crate::facet::FacetShape;
use crate::schema::{Choice, Default, Field, Kind, Unit};

/// `eta`, the parameter.
pub(super) const ETA: Field = Field {
    name: "eta",
    summary: "-1: uniform; 0: light space perspective; 1: centre of projection in the eye; `by_angle`: rises with the angle between light and view axis",
    kind: Kind::NumberOr {
        min: -1.0,
        max: 1.0,
        open: false,
        unit: Unit::None,
        choices: &[Choice::plain("by_angle", "rises with the angle between light and view axis")],
    },
    default: Default::Value("by_angle"),
};

/// Entry of the name table.
pub const SPEC: TechniqueSpec = TechniqueSpec {
    choice: Choice {
        name: "warp_family",
        summary: "one map between standard and perspective",
        arguments: &[ETA],
    },
    configurations: &[ConfigurationSpec {
        choice: Choice::plain("between", "one warped facet over the whole map"),
        lights: &[LightKind::Directional],
        takes_distribution: false,
        serves: |_| true,
        shape: |_, _| FacetShape::ONE,
        draft: |situation, word, drafts| warp::draft(&WARP, word.name, situation, drafts),
    }],
    default_configurations: |light| only_directional(light, &["between"]),
    distribution: None,
    fits_infinity: false,
    follows_camera: true,
    variants: &["warp_family", "warp_family { eta: -0.2 }", "warp_family { eta: 0.5 }"],
    check: |_| Vec::new(),
};

/// Its warp.
pub(super) const WARP: WarpSpec = WarpSpec {
    choice: Choice { name: "warp_family", summary: "between uniform and perspective", arguments: &[ETA] },
    warp,
};

/// Eta at the border of the view cone.
const AT_BORDER: f64 = -0.2;
/// Eta with the light across the view.
const AT_RIGHT_ANGLES: f64 = 0.0;
/// Share of the way from the border to a right angle after which eta has its last value.
const LAST: f64 = 0.3;
/// Share of the view cone in which maps stay uniform.
const UNIFORM: f64 = 1.0 / 3.0;
/// Least ratio of the strengths at 1 and at 0.
const LEAST_RISE: f64 = 1.1;
/// Largest strength: a centre of projection in the near edge itself has none.
const STRONGEST: f64 = 1e6;

fn warp(warped: &Warped<'_>) -> Warp {
    rising_to(AT_RIGHT_ANGLES, warped)
}

/// The warp of the declared eta, or of one that rises with the angle between light and view axis to a last value.
pub(super) fn rising_to(last: f64, warped: &Warped<'_>) -> Warp {
    let eta = warped.arguments.number(ETA.name).unwrap_or_else(|| {
        let tangents = warped.situation.view.corner_tangents().map(|(x, y)| x.abs().max(y.abs()));
        let half = libm::atan(tangents.into_iter().fold(0.0, f64::max));
        eta_by_angle(libm::asin(warped.plane.sine.clamp(0.0, 1.0)), half, last)
    });
    warped.outside_silhouette(strength(warped, eta))
}

/// Strength for an eta.
pub(super) fn strength(warped: &Warped<'_>, eta: f64) -> f64 {
    let (near, _) = warped.depths_metres;
    let (low, extent) = warped.plane.extent(warped.receivers);
    let sine = warped.plane.sine;
    let optimal = optimal_strength(near, extent, sine);

    // The eye's place in the image plane is 0; inside the silhouette it is no centre of projection.
    let to_eye = low.max(near * sine);
    let perspective = if to_eye > 0.0 { (extent / to_eye).min(STRONGEST) } else { STRONGEST * sine };
    between(eta, optimal, perspective.max(optimal))
}

/// The strength at eta of the hyperbola that is 0 at -1, and has two other values at 0 and 1.
fn between(eta: f64, at_zero: f64, at_one: f64) -> f64 {
    // (1 + eta) p / (q - eta), with p = q s0 and 2 p / (q - 1) = s1; equal ends would leave no way to uniform.
    let at_one = at_one.max(LEAST_RISE * at_zero);
    let excess = at_one - 2.0 * at_zero;
    if excess.abs() <= 1e-9 * at_one {
        return (1.0 + eta) * at_zero;
    }
    let pole = at_one / excess;
    (1.0 + eta) * pole * at_zero / (pole - eta)
}

/// Eta for an angle between light and view axis, half the angle of the view cone and the value at right angles.
pub fn eta_by_angle(angle_radians: f64, half_cone_radians: f64, at_right_angles: f64) -> f64 {
    let begin = UNIFORM * half_cone_radians;
    let last_radians = half_cone_radians + LAST * (std::f64::consts::FRAC_PI_2 - half_cone_radians);
    if angle_radians <= half_cone_radians {
        let share = smooth((angle_radians - begin) / (half_cone_radians - begin));
        -1.0 + (AT_BORDER + 1.0) * share
    } else {
        let share =
            ((angle_radians - half_cone_radians) / (last_radians - half_cone_radians)).clamp(0.0, 1.0);
        AT_BORDER + (at_right_angles - AT_BORDER) * libm::sin(std::f64::consts::FRAC_PI_2 * share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_family_runs_from_uniform_over_the_optimum_to_the_eye() {
        for (zero, one) in [(60.0, 5000.0), (3.0, 6.0), (3.0, 4.0), (5.0, 5.6)] {
            assert!(between(-1.0, zero, one).abs() < 1e-9);
            assert!((between(0.0, zero, one) / zero - 1.0).abs() < 1e-9);
            assert!((between(1.0, zero, one) / one - 1.0).abs() < 1e-9);
            let values: Vec<f64> = (0..=40).map(|k| between(-1.0 + 0.05 * f64::from(k), zero, one)).collect();
            assert!(values.windows(2).all(|pair| pair[1] > pair[0]), "{zero} {one}: {values:?}");
        }
    }

    #[test]
    fn eta_is_continuous_over_the_angle() {
        let etas: Vec<f64> =
            (0..=9000).map(|k| eta_by_angle(f64::from(k) * 1.745e-4, 0.6, AT_RIGHT_ANGLES)).collect();
        assert_eq!(etas[0], -1.0);
        assert!(etas.windows(2).all(|pair| pair[1] >= pair[0] && pair[1] - pair[0] < 1e-3));
        assert_eq!(etas[9000], AT_RIGHT_ANGLES);
    }
}
