//! The narrowest cone around some directions, from the light (perspective shadow maps: care and feeding, section 14.2.2,
//! "find a light camera"): the smallest cap on the unit sphere, found point by point as the smallest circle is (Welzl).

use glam::DVec3;

/// Cosine by which a direction may lie outside a cap for rounding.
const TOLERANCE: f64 = 1e-12;

/// A cone.
#[derive(Debug, Clone, Copy)]
struct Cap {
    axis: DVec3,
    cosine: f64,
}

impl Cap {
    fn holds(&self, direction: DVec3) -> bool {
        self.axis.dot(direction) >= self.cosine - TOLERANCE
    }

    fn of_two(one: DVec3, two: DVec3) -> Self {
        let axis = (one + two).try_normalize().unwrap_or_else(|| one.any_orthonormal_vector());
        Self { axis, cosine: axis.dot(one).min(axis.dot(two)) }
    }

    /// The cap through three directions, or the widest through two of them where they lie on one great circle.
    fn of_three(one: DVec3, two: DVec3, three: DVec3) -> Self {
        match (two - one).cross(three - one).try_normalize() {
            Some(normal) => {
                let axis = normal * normal.dot(one).signum();
                Self { axis, cosine: axis.dot(one).min(axis.dot(two)).min(axis.dot(three)) }
            }
            None => {
                let caps = [Self::of_two(one, two), Self::of_two(one, three), Self::of_two(two, three)];
                caps.into_iter().min_by(|one, two| one.cosine.total_cmp(&two.cosine)).unwrap_or(caps[0])
            }
        }
    }
}

/// Axis of the narrowest cone around unit directions that lie within half a space.
pub(super) fn narrowest(directions: &[DVec3]) -> DVec3 {
    let Some(first) = directions.first() else { return DVec3::Z };
    let mut cap = Cap { axis: *first, cosine: 1.0 };

    // Whatever lies outside the cap of those before it lies on the cap's border with them.
    for (i, one) in directions.iter().enumerate() {
        if cap.holds(*one) {
            continue;
        }
        cap = Cap { axis: *one, cosine: 1.0 };
        for (j, two) in directions[..i].iter().enumerate() {
            if cap.holds(*two) {
                continue;
            }
            cap = Cap::of_two(*one, *two);
            for three in &directions[..j] {
                if !cap.holds(*three) {
                    cap = Cap::of_three(*one, *two, *three);
                }
            }
        }
    }
    cap.axis
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_other_axis_has_a_narrower_cone() {
        let mut seed = 1_u64;
        let mut unit = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
        };
        for count in 1..40 {
            let towards = DVec3::new(unit(), unit(), unit()).normalize_or(DVec3::X);
            let directions: Vec<DVec3> = (0..count)
                .map(|_| {
                    (towards * 1.3 + DVec3::new(unit(), unit(), unit()).normalize_or(DVec3::X)).normalize()
                })
                .collect();
            let widest = |axis: DVec3| directions.iter().map(|one| axis.dot(*one)).fold(1.0, f64::min);
            let axis = narrowest(&directions);
            let best = widest(axis);
            for _ in 0..300 {
                let other = (axis + DVec3::new(unit(), unit(), unit()) * 0.1).normalize();
                assert!(widest(other) <= best + 1e-9, "{count}: {} > {best}", widest(other));
            }
        }
    }
}
