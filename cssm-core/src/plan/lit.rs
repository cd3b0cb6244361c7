//! What a local light can reach: a polytope around its range and its cone.

use glam::{DVec3, DVec4};

use crate::light::Light;
use crate::receivers::Polytope;
use crate::technique::Cone;

/// Sides of the pyramid around a spot light's cone.
const CONE_SIDES: u32 = 8;

/// Cuts receivers to what a light can reach; everything in camera space.
pub(super) fn cut(receivers: &mut Polytope, light: &Light, light_camera: DVec4, cone: Option<Cone>) {
    let position = light_camera.truncate();
    let range = match light {
        Light::Directional { .. } => return,
        Light::Spot { range_metres, .. } | Light::Omni { range_metres, .. } => *range_metres,
    };
    let within = |direction: DVec3, reach: f64| (-direction).extend(direction.dot(position) + reach);

    // Keep the pyramid around the cone, or the polyhedron around the sphere: cube and octahedron.
    if let Some(Cone { direction, half_angle_radians }) = cone {
        let across = direction.any_orthonormal_vector();
        let up = direction.cross(across);
        let (sine, cosine) = (libm::sin(half_angle_radians), libm::cos(half_angle_radians));

        // First what is far: the sides all meet in the light, and corners far away would not tell where.
        if range.is_finite() {
            for axis in [direction, across, -across, up, -up] {
                receivers.cut(within(axis, range));
            }
        }
        for side in 0..CONE_SIDES {
            let angle = std::f64::consts::TAU * f64::from(side) / f64::from(CONE_SIDES);
            let around = across * libm::cos(angle) + up * libm::sin(angle);
            receivers.cut(within(around * cosine - direction * sine, 0.0));
        }
    } else if range.is_finite() {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z] {
            receivers.cut(within(axis, range));
            receivers.cut(within(-axis, range));
        }
        for signs in 0..8_u32 {
            let sign = |bit: u32| if signs & (1 << bit) == 0 { 1.0 } else { -1.0 };
            receivers.cut(within(DVec3::new(sign(0), sign(1), sign(2)).normalize(), range));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::View;

    #[test]
    fn everything_visible_that_a_light_reaches_is_kept() {
        let view =
            View::perspective(DVec3::ZERO, DVec3::NEG_Z, DVec3::Y, 1.0, 0.1, f64::INFINITY, (16, 9)).unwrap();
        let position = DVec3::new(1.0, 2.0, -8.0);
        let direction = DVec3::new(0.2, -0.9, -0.4).normalize();
        let spot = Light::spot(position, direction, 0.6, 9.0).unwrap();
        let cone = Cone { direction, half_angle_radians: 0.6 };
        let omni = Light::omni(position, 5.0).unwrap();
        for (light, cone) in [(spot, Some(cone)), (omni, None)] {
            let whole = Polytope::frustum(&view, f64::INFINITY);
            let mut receivers = whole.clone();
            cut(&mut receivers, &light, position.extend(1.0), cone);
            let (mut reached, mut kept) = (0, 0);
            for index in 0..40_000_u32 {
                let unit = |step: f64| (f64::from(index) * step).fract() * 24.0 - 12.0;
                let point = position + DVec3::new(unit(0.819_172_5), unit(0.671_043_6), unit(0.549_700_5));
                if !whole.contains(point.extend(1.0)) {
                    continue;
                }
                kept += usize::from(receivers.contains(point.extend(1.0)));
                if light.reaches(point) {
                    reached += 1;
                    assert!(receivers.contains(point.extend(1.0)), "{light:?} {point}");
                }
            }
            assert!(reached > 100 && kept < 2 * reached, "{reached} {kept}");
        }
    }
}
