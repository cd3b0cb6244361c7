//! The volume that a box of casters can shadow.

use glam::{DVec3, DVec4};

use crate::plan::BoundingBox;

/// Sine of the angle between the light and a plane below which the plane counts as containing it.
const CONTAINS_LIGHT: f64 = 1e-9;

/// Half-spaces (world axes, relative to the eye) around everything that a box can throw shadow on: the faces towards the
/// light, and planes through the light along the silhouette. The light is a homogeneous point. None where the light
/// stands in the box or beside it so that everything may be shadowed.
pub(super) fn half_spaces(box_from_eye: &BoundingBox, light: DVec4) -> Vec<DVec4> {
    let size = (box_from_eye.max - box_from_eye.min).max(DVec3::ZERO);
    // Outward faces, told by whether they face the light.
    let face = |axis: usize, side: usize| {
        let normal = DVec3::AXES[axis] * if side == 0 { -1.0 } else { 1.0 };
        let corner = if side == 0 { box_from_eye.min } else { box_from_eye.max };
        normal.extend(-normal.dot(corner))
    };
    let lengths = light.truncate().length() + light.w;
    let faces_light = |plane: DVec4| plane.dot(light) > CONTAINS_LIGHT * lengths;
    let mut planes = Vec::new();
    for axis in 0..3 {
        for side in 0..2 {
            let plane = face(axis, side);
            if faces_light(plane) {
                planes.push(-plane);
            }
        }
    }
    if planes.is_empty() {
        return planes;
    }

    // An edge between a face towards the light and one away from it is on the silhouette.
    let centre = ((box_from_eye.min + box_from_eye.max) * 0.5).extend(1.0);
    for along in 0..3 {
        let (one, two) = ((along + 1) % 3, (along + 2) % 3);
        for sides in 0..4_usize {
            let (first, second) = (face(one, sides & 1), face(two, sides >> 1));
            if faces_light(first) == faces_light(second) {
                continue;
            }
            let mut start = box_from_eye.min;
            start[one] += size[one] * (sides & 1) as f64;
            start[two] += size[two] * (sides >> 1) as f64;
            let normal = DVec3::AXES[along].cross(light.truncate() - start * light.w);
            let plane = normal.extend(-normal.dot(start));
            planes.push(if plane.dot(centre) < 0.0 { -plane } else { plane });
        }
    }
    planes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exactly_what_rays_through_the_box_reach_is_kept() {
        let casters = BoundingBox { min: DVec3::new(-1.0, 0.0, -2.0), max: DVec3::new(1.0, 3.0, 0.5) };
        let lights = [
            DVec3::new(0.3, 0.9, 0.2).normalize().extend(0.0),
            DVec3::new(-0.9, 0.1, 0.0).normalize().extend(0.0),
            DVec4::Y,
            DVec4::new(2.0, 9.0, 1.0, 1.0),
            DVec4::new(-6.0, 1.0, -1.0, 1.0),
        ];
        for light in lights {
            let planes = half_spaces(&casters, light);
            let (mut shadowed, mut kept) = (0, 0);
            for index in 0..60_000_u32 {
                let unit = |step: f64| (f64::from(index) * step).fract() * 16.0 - 8.0;
                let point = DVec3::new(unit(0.819_172_5), unit(0.671_043_6), unit(0.549_700_5));
                let inside = planes.iter().all(|plane| plane.dot(point.extend(1.0)) >= 0.0);
                kept += u32::from(inside);
                if is_reached(&casters, point, light) {
                    shadowed += 1;
                    assert!(inside, "{light} {point}");
                }
            }
            assert!(shadowed > 50 && kept <= shadowed + 1, "{light}: {shadowed} {kept}");
        }
        assert!(half_spaces(&casters, DVec4::new(0.0, 1.0, 0.0, 1.0)).is_empty());
    }

    /// Whether the way from a point to the light meets a box: slabs.
    fn is_reached(casters: &BoundingBox, point: DVec3, light: DVec4) -> bool {
        let (way, end) =
            if light.w > 0.0 { (light.truncate() - point, 1.0) } else { (light.truncate(), f64::INFINITY) };
        let (mut low, mut high) = (0.0_f64, end);
        for axis in 0..3 {
            if way[axis] == 0.0 {
                if point[axis] < casters.min[axis] || point[axis] > casters.max[axis] {
                    return false;
                }
                continue;
            }
            let (one, two) = (
                (casters.min[axis] - point[axis]) / way[axis],
                (casters.max[axis] - point[axis]) / way[axis],
            );
            low = low.max(one.min(two));
            high = high.min(one.max(two));
        }
        low <= high
    }
}
