//! Convex outlines in a facet's clip space.

use glam::{DVec2, DVec4};
use smallvec::{Array, SmallVec};

use crate::facet::FacetRows;
use crate::receivers::is_negligible;

/// Corners of an outline, with room for what its hull is found in.
pub(crate) type Outline = SmallVec<[DVec2; 96]>;
/// Points in x/w and y/w.
pub(crate) type Places = SmallVec<[DVec2; 48]>;

/// Convex outline (counter-clockwise) of a receiver vertex list in a facet's x/w and y/w: its clip space, unless its rows
/// are bent.
pub fn outline(rows: &FacetRows, receivers: &[DVec4]) -> Vec<DVec2> {
    small_outline(rows, receivers).into_vec()
}

/// [`outline`] without an allocation.
pub(crate) fn small_outline(rows: &FacetRows, receivers: &[DVec4]) -> Outline {
    let points = receivers.iter().filter_map(|vertex| {
        let w = rows.w.dot(*vertex);
        let usable = w > 0.0 && !is_negligible(w, rows.w, *vertex);
        usable.then(|| DVec2::new(rows.x.dot(*vertex), rows.y.dot(*vertex)) / w)
    });
    hull(points.collect())
}

/// Points on the edges of an outline after bending.
const BENT_STEPS: u32 = 24;

/// The outline after the rows' remap, in NDC: bent edges become many short ones.
pub fn image(rows: &FacetRows, outline: &[DVec2]) -> Vec<DVec2> {
    if rows.remap.is_none() {
        return outline.to_vec();
    }
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    let steps = edges.flat_map(|(one, two)| {
        // Even steps in the bent coordinate follow it best.
        let (from, to) = (rows.remap.y(one.y), rows.remap.y(two.y));
        (0..BENT_STEPS).map(move |step| {
            let share = f64::from(step) / f64::from(BENT_STEPS);
            let y = from + (to - from) * share;
            let along = if one.y == two.y { share } else { (rows.remap.k(y) - one.y) / (two.y - one.y) };
            // On an edge that is level but for rounding the quotient is noise.
            let along = along.clamp(0.0, 1.0);
            DVec2::new(one.x + (two.x - one.x) * along, y)
        })
    });
    let mut points: Vec<DVec2> = steps.collect();
    if area(&points) < 0.0 {
        // A remap that falls turns the outline over.
        points.reverse();
    }
    points
}

/// Area enclosed by a counter-clockwise outline.
pub fn area(outline: &[DVec2]) -> f64 {
    let edges = outline.iter().zip(outline.iter().cycle().skip(1));
    0.5 * edges.map(|(one, two)| one.perp_dot(*two)).sum::<f64>()
}

/// Convex hull by monotone chains, counter-clockwise.
fn hull(mut points: Places) -> Outline {
    let mut outline = Outline::new();
    add_hull(&mut points, &mut outline);
    outline
}

/// Adds the convex hull of some points to a list of corners.
pub(crate) fn add_hull<A: Array<Item = DVec2>>(points: &mut Places, corners: &mut SmallVec<A>) {
    points.retain(|point| point.is_finite());
    sort(points);
    points.dedup();
    let (start, count) = (corners.len(), points.len());
    if count < 3 {
        corners.extend_from_slice(points);
        return;
    }

    // Each chain turns left only; its last point begins the next.
    corners.resize(start + 2 * count, DVec2::ZERO);
    let below = chain(&mut corners[start..], points.iter());
    let above = chain(&mut corners[start + below..], points.iter().rev());
    corners.truncate(start + below + above);
}

/// Sorts points, few and mostly half in order, by x and then by y.
fn sort(points: &mut [DVec2]) {
    for end in 1..points.len() {
        let point = points[end];
        let mut place = end;
        while place > 0 {
            let before = points[place - 1];
            if before.x < point.x || (before.x == point.x && before.y <= point.y) {
                break;
            }
            points[place] = before;
            place -= 1;
        }
        points[place] = point;
    }
}

/// Writes a chain of sorted points that turns left only and says how many it has but for its last.
fn chain<'a>(corners: &mut [DVec2], points: impl Iterator<Item = &'a DVec2>) -> usize {
    let mut count = 0;
    for point in points {
        while let [.., one, two] = corners[..count] {
            if (two - one).perp_dot(*point - two) > 0.0 {
                break;
            }
            count -= 1;
        }
        corners[count] = *point;
        count += 1;
    }
    count.saturating_sub(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hull_of_a_square_with_inner_points_has_its_area() {
        let mut points = Places::from_slice(&[DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE]);
        points.extend([DVec2::splat(0.5), DVec2::new(0.2, 0.9), DVec2::new(0.5, 0.0)]);
        let outline = hull(points);
        assert_eq!(outline.len(), 4);
        assert_eq!(area(&outline), 1.0);
    }
}
