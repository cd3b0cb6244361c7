//! Monotone remaps of a facet's rows: how a continuous distribution spends them over distance.
//!
//! The y and w rows of a remapped facet give k = y/w = 1 / distance, which a homography can; the remap takes k to the
//! tile (camera space shadow maps, section 4: stretching, reduced to one coordinate). In (x, k) straight lines stay
//! straight, so coverage and depth are decided there; only the place of a texel row is bent.

/// The shape of a remap, a monotone function of k = 1 / distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Curve {
    /// k itself: rows of a homography.
    Straight,
    /// 1 / (distance + push-back): the rows of an eye that is pushed back.
    Perspective {
        /// The push-back.
        push_back_metres: f64,
    },
    /// The logarithm of distance; beyond a horizon it goes on with equal slope as 1 - horizon / distance, so that
    /// infinity has a row.
    Logarithmic {
        /// The distance where the value is zero.
        reference_metres: f64,
        /// The horizon; may be infinite where receivers are not.
        horizon_metres: f64,
    },
}

/// Smallest divisor of an inverse perspective.
const SMALLEST_DIVISOR: f64 = 1e-9;

impl Curve {
    /// Value at k, in 1/metres.
    pub fn value(&self, k: f64) -> f64 {
        match *self {
            Self::Straight => k,
            Self::Perspective { push_back_metres } => k / (1.0 + push_back_metres * k),
            Self::Logarithmic { reference_metres, horizon_metres } => {
                if k * horizon_metres <= 1.0 {
                    libm::log(horizon_metres / reference_metres) + 1.0 - horizon_metres * k
                } else {
                    -libm::log(k * reference_metres)
                }
            }
        }
    }

    /// Change of the value per unit of k.
    pub fn slope(&self, k: f64) -> f64 {
        match *self {
            Self::Straight => 1.0,
            Self::Perspective { push_back_metres } => {
                let divisor = 1.0 + push_back_metres * k;
                1.0 / (divisor * divisor)
            }
            Self::Logarithmic { horizon_metres, .. } => {
                if k * horizon_metres <= 1.0 {
                    -horizon_metres
                } else {
                    -1.0 / k
                }
            }
        }
    }

    /// The k of a value; the inverse of [`Self::value`].
    pub fn inverse(&self, value: f64) -> f64 {
        match *self {
            Self::Straight => value,
            // Gutters may reach nearer than the pushed back eye sees; what lies there is as near as can be told apart.
            Self::Perspective { push_back_metres } => {
                value / (1.0 - push_back_metres * value).max(SMALLEST_DIVISOR)
            }
            Self::Logarithmic { reference_metres, horizon_metres } => {
                let at_horizon = libm::log(horizon_metres / reference_metres);
                if value >= at_horizon {
                    (at_horizon + 1.0 - value) / horizon_metres
                } else {
                    libm::exp(-value) / reference_metres
                }
            }
        }
    }
}

/// A curve, scaled and shifted to a tile: y = scale * curve(k) + shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Remap {
    /// Its shape.
    pub curve: Curve,
    /// NDC per value.
    pub scale: f64,
    /// NDC of the value zero.
    pub shift: f64,
}

impl Remap {
    /// No remap: y = k.
    pub const NONE: Self = Self { curve: Curve::Straight, scale: 1.0, shift: 0.0 };

    /// Whether y = k.
    pub fn is_none(&self) -> bool {
        *self == Self::NONE
    }

    /// The remap that takes the values between two k to NDC -1 and 1. `None` where it has no extent.
    pub fn fitted(curve: Curve, k_low: f64, k_high: f64) -> Option<Self> {
        let (one, two) = (curve.value(k_low), curve.value(k_high));
        let (low, high) = (one.min(two), one.max(two));
        let extent = high - low;
        let usable = extent.is_finite() && extent > 0.0;
        usable.then(|| Self { curve, scale: 2.0 / extent, shift: -(high + low) / extent })
    }

    /// NDC of k.
    pub fn y(&self, k: f64) -> f64 {
        self.scale * self.curve.value(k) + self.shift
    }

    /// Change of NDC per unit of k.
    pub fn slope(&self, k: f64) -> f64 {
        self.scale * self.curve.slope(k)
    }

    /// k of an NDC; the inverse of [`Self::y`].
    pub fn k(&self, y: f64) -> f64 {
        self.curve.inverse((y - self.shift) / self.scale)
    }

    /// The remap whose NDC is this one's times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        Self { curve: self.curve, scale: self.scale * factor, shift: self.shift * factor }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const CURVES: [Curve; 5] = [
        Curve::Straight,
        Curve::Perspective { push_back_metres: 10.0 },
        Curve::Logarithmic { reference_metres: 1.0, horizon_metres: 1e5 },
        Curve::Logarithmic { reference_metres: 0.1, horizon_metres: 1e4 },
        Curve::Logarithmic { reference_metres: 10.0, horizon_metres: f64::INFINITY },
    ];

    #[test]
    fn inverses_and_slopes_agree_with_values() {
        for curve in CURVES {
            let remap = Remap::fitted(curve, 1.0 / 1e6, 5.0).unwrap();
            for index in 0..200 {
                let k = 5.0 * libm::pow(10.0, -0.035 * f64::from(index));
                let y = remap.y(k);
                assert!((remap.k(y) - k).abs() <= 1e-7 * k, "{curve:?} {k}");
                let step = 1e-6 * k;
                let slope = (remap.y(k + step) - remap.y(k - step)) / (2.0 * step);
                let kink = matches!(curve, Curve::Logarithmic { horizon_metres, .. }
                    if (k * horizon_metres - 1.0).abs() < 1e-3);
                assert!(kink || (slope / remap.slope(k) - 1.0).abs() < 1e-3, "{curve:?} {k}");
            }
        }
    }

    #[test]
    fn the_ends_of_the_fitted_range_fall_on_the_tiles_edges_and_infinity_has_a_row() {
        for curve in CURVES {
            let remap = Remap::fitted(curve, 0.01, 5.0).unwrap();
            let (one, two) = (remap.y(0.01), remap.y(5.0));
            assert!((one.min(two) + 1.0).abs() < 1e-12 && (one.max(two) - 1.0).abs() < 1e-12);
        }
        assert!(CURVES[2].value(0.0).is_finite());
    }
}
