//! What touches the half-spaces of a facet, by clipping.

use cssm_core::BoundingBox;
use cssm_core::glam::{DAffine3, DVec3, DVec4};

/// Whether any point of a convex polygon lies in all half-spaces: what they leave of it has corners.
pub fn touches(polygon: &[DVec3], planes: &[DVec4]) -> bool {
    let mut corners = polygon.to_vec();
    for plane in planes {
        let distance = |corner: DVec3| plane.dot(corner.extend(1.0));
        let mut left = Vec::with_capacity(corners.len() + 1);
        for (at, corner) in corners.iter().enumerate() {
            let next = corners[(at + 1) % corners.len()];
            let (here, there) = (distance(*corner), distance(next));
            if here >= 0.0 {
                left.push(*corner);
            }
            if (here < 0.0) != (there < 0.0) {
                left.push(corner.lerp(next, here / (here - there)));
            }
        }
        if left.is_empty() {
            return false;
        }
        corners = left;
    }
    true
}

/// Corners of an instance's box relative to the eye; bit k of a corner's number is its side along axis k.
pub fn box_corners(bounds: &BoundingBox, eye_from_object: &DAffine3) -> [DVec3; 8] {
    std::array::from_fn(|corner| {
        let side = |axis: usize| if corner >> axis & 1 == 0 { bounds.min[axis] } else { bounds.max[axis] };
        eye_from_object.transform_point3(DVec3::new(side(0), side(1), side(2)))
    })
}
