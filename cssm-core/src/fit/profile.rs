//! How often each distance is seen in a column.

/// Steps between quantiles.
const STEPS: usize = 16;
/// Points of a column beside which the even distribution counts for nothing: with fewer it takes over.
const FEW_POINTS: f64 = 16.0;
/// Share of what is to be parted that follows the points; the rest follows the logarithm of distance.
const SEEN_SHARE: f64 = 0.3;
/// Rounds of the search for a quantile of the mixture.
const ROUNDS: u32 = 48;

/// How often each distance is seen: quantiles of its logarithm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// Logarithms that equal shares of the points lie between.
    quantiles: [f64; STEPS + 1],
    /// How much the points count: 0 where there are none, towards 1 where there are many.
    weight: f64,
}

impl Profile {
    /// The profile of some distances that are trusted by a share; nothing where none is positive.
    pub(crate) fn of(distances: impl Iterator<Item = f64>, trust: f64) -> Option<Self> {
        let usable = distances.filter(|distance| *distance > 0.0 && distance.is_finite());
        let mut logarithms: Vec<f64> = usable.map(libm::log).collect();
        if logarithms.is_empty() {
            return None;
        }
        logarithms.sort_by(f64::total_cmp);
        let quantile = |step: usize| crate::footprint::quantile(&logarithms, step as f64 / STEPS as f64);
        let count = logarithms.len() as f64;
        Some(Self { quantiles: std::array::from_fn(quantile), weight: trust * count / (count + FEW_POINTS) })
    }

    /// Share of the points before a distance.
    fn share_before(&self, logarithm: f64) -> f64 {
        let above = self.quantiles.partition_point(|quantile| *quantile <= logarithm);
        match above {
            0 => 0.0,
            above if above > STEPS => 1.0,
            above => {
                let (low, high) = (self.quantiles[above - 1], self.quantiles[above]);
                ((above - 1) as f64 + (logarithm - low) / (high - low)) / STEPS as f64
            }
        }
    }

    /// The distance that a share of the points lies before, drawn towards `declared` where there are few.
    pub fn quantile(&self, share: f64, declared: f64) -> f64 {
        let logarithm = crate::footprint::quantile(&self.quantiles, share);
        let declared = libm::log(declared);
        libm::exp(declared + (logarithm - declared) * self.weight)
    }

    /// The distance between two others before which a share of a mixture lies: of what is seen, and of the logarithm of
    /// distance, so that what is not seen keeps its part. Grows with the share, from `start` to `end`.
    pub fn mixed(&self, share: f64, start: f64, end: f64) -> f64 {
        let (first, last) = (libm::log(start), libm::log(end));
        let seen = SEEN_SHARE * self.weight;
        let (none, all) = (self.share_before(first), self.share_before(last));
        let mixture = |logarithm: f64| {
            let even = (logarithm - first) / (last - first);
            let own = if all > none { (self.share_before(logarithm) - none) / (all - none) } else { even };
            seen * own + (1.0 - seen) * even
        };
        let (mut low, mut high) = (first, last);
        for _ in 0..ROUNDS {
            let middle = 0.5 * (low + high);
            if mixture(middle) < share { low = middle } else { high = middle }
        }
        libm::exp(0.5 * (low + high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limits_gather_where_points_are_and_leave_the_rest_a_share() {
        let crowded = Profile::of((0..400).map(|index| 10.0 + f64::from(index) * 0.01), 1.0).unwrap();
        let limits: Vec<f64> = (0..=8).map(|k| crowded.mixed(f64::from(k) / 8.0, 0.1, 1000.0)).collect();
        assert!(limits.windows(2).all(|pair| pair[0] < pair[1]), "{limits:?}");
        let near = |limit: &&f64| (9.9..14.1).contains(*limit);
        assert!(limits.iter().filter(near).count() >= 2, "{limits:?}");
        assert!(limits[1] < 10.0 && limits[7] > 14.0, "{limits:?}");
        assert!((limits[0] - 0.1).abs() < 1e-9 && (limits[8] - 1000.0).abs() < 1e-6);
    }

    #[test]
    fn few_points_change_little() {
        let lone = Profile::of([10.0].into_iter(), 1.0).unwrap();
        assert!((lone.mixed(0.5, 0.1, 1000.0) / 10.0 - 1.0).abs() < 0.2);
        assert!((lone.quantile(0.5, 2.0) / 2.0 - 1.0).abs() < 0.2);
        assert!(Profile::of([0.0, f64::NAN, -1.0].into_iter(), 1.0).is_none());
    }
}
