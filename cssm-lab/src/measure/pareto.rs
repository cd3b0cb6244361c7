//! The front of error against cost: what nothing else beats in both.

/// Indices of the points that no other point dominates, by ascending cost. A point dominates another that costs no less
/// and errs no less, unless both are equal in both; of equal points the first stands for all. Points that are not finite
/// are never on the front.
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len())
        .filter(|index| points[*index].0.is_finite() && points[*index].1.is_finite())
        .collect();
    order.sort_by(|one, two| {
        let ((cost, error), (other_cost, other_error)) = (points[*one], points[*two]);
        cost.total_cmp(&other_cost).then(error.total_cmp(&other_error)).then(one.cmp(two))
    });

    // Walk to higher costs and keep what lowers the error.
    let mut least = f64::INFINITY;
    order.retain(|index| {
        let better = points[*index].1 < least;
        least = least.min(points[*index].1);
        better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_holds_what_nothing_dominates() {
        let points = [(4.0, 1.0), (1.0, 4.0), (2.0, 2.0), (2.0, 3.0), (3.0, 2.0), (5.0, 1.0), (1.0, 4.0)];
        assert_eq!(front(&points), [1, 2, 0]);
    }

    #[test]
    fn points_that_are_not_finite_stay_away() {
        assert_eq!(front(&[(1.0, f64::NAN), (f64::INFINITY, 0.0), (2.0, 1.0)]), [2]);
        assert!(front(&[]).is_empty());
    }

    #[test]
    fn every_point_is_on_the_front_or_dominated_by_it() {
        // A lattice walked in an order without pattern.
        let points: Vec<(f64, f64)> = (0..400_u32)
            .map(|index| (f64::from(index * 7919 % 101), f64::from(index * 104_729 % 97)))
            .collect();
        let front = front(&points);
        for (index, (cost, error)) in points.iter().enumerate() {
            let beaten = front.iter().any(|on| points[*on].0 <= *cost && points[*on].1 <= *error);
            assert!(beaten, "point {index}");
            let strictly = |other: &(f64, f64)| {
                other.0 <= *cost && other.1 <= *error && (other.0 < *cost || other.1 < *error)
            };
            assert!(!front.contains(&index) || !points.iter().any(strictly), "point {index} is dominated");
        }
    }
}
