//! Texels where pixels are: how much coarser or finer each facet's texels are than the others'.
//!
//! What is wrong along a shadow's edge grows with the footprint f there. With p_i pixels and a_i texels wanted at a
//! footprint of one pixel, the mean of p_i f_i under the budget of a_i / f_i^2 is least where f_i goes with the cube root
//! of a_i / p_i.

/// Share of what is seen that every facet has as if pixels were spread as texels are: what comes into view needs texels at
/// once.
const FLOOR: f64 = 0.2;

/// Footprints, beside each other's, of facets with some texels wanted and some points that are trusted by a share; 1 where
/// they are not trusted at all.
pub(super) fn coarser(wanted: &[f64], points: &[usize], trust: f64) -> Vec<f64> {
    let total: usize = points.iter().sum();
    let all: f64 = wanted.iter().sum();
    let one = |(wanted, points): (&f64, &usize)| {
        let wanted = wanted / all;
        let seen = (1.0 - FLOOR) * *points as f64 / total as f64 + FLOOR * wanted;
        let change = libm::pow(wanted / seen, trust / 3.0);
        if change.is_finite() && change > 0.0 { change } else { 1.0 }
    };
    wanted.iter().zip(points).map(one).collect()
}
