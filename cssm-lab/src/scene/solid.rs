//! Closed solids with outward faces: boxes, beams, prisms, cones, bent tubes, lumps.

use cssm_core::glam::DVec3;

use super::Mesh;

/// Collects solids into one mesh.
pub(crate) struct MeshBuilder {
    positions: Vec<[f32; 3]>,
    indices: Vec<u32>,
}

impl MeshBuilder {
    pub(crate) const fn new() -> Self {
        Self { positions: Vec::new(), indices: Vec::new() }
    }

    pub(crate) fn build(self, name: impl Into<String>) -> Mesh {
        Mesh { name: name.into(), positions: self.positions, indices: self.indices, mask: None }
    }

    /// A single triangle, counter-clockwise from outside.
    pub(crate) fn triangle(&mut self, corners: [DVec3; 3]) {
        let first = self.vertices(&corners);
        self.indices.extend([first, first + 1, first + 2]);
    }

    /// A flat quadrilateral, counter-clockwise from outside: 2 triangles.
    pub(crate) fn quad(&mut self, corners: [DVec3; 4]) {
        let first = self.vertices(&corners);
        self.indices.extend([0, 1, 2, 0, 2, 3].map(|index| first + index));
    }

    /// An axis-aligned box: 12 triangles.
    pub(crate) fn cuboid(&mut self, min: DVec3, max: DVec3) {
        let corner = |x: bool, y: bool, z: bool| {
            let pick = |high: bool, low: f64, top: f64| if high { top } else { low };
            DVec3::new(pick(x, min.x, max.x), pick(y, min.y, max.y), pick(z, min.z, max.z))
        };
        let [o, i] = [false, true];
        self.hexahedron([
            corner(o, o, o),
            corner(i, o, o),
            corner(o, i, o),
            corner(i, i, o),
            corner(o, o, i),
            corner(i, o, i),
            corner(o, i, i),
            corner(i, i, i),
        ]);
    }

    /// A bent box: 12 triangles. The corners run along x first, then y, then z, of any right-handed axes.
    pub(crate) fn hexahedron(&mut self, corners: [DVec3; 8]) {
        for side in [[4, 5, 7, 6], [1, 0, 2, 3], [5, 1, 3, 7], [0, 4, 6, 2], [6, 7, 3, 2], [0, 1, 5, 4]] {
            self.quad(side.map(|corner: usize| corners[corner]));
        }
    }

    /// A straight beam with a rectangular section, upright as far as its direction allows: 12 triangles.
    pub(crate) fn beam(&mut self, from: DVec3, to: DVec3, width: f64, height: f64) {
        let along = (to - from).normalize_or(DVec3::Y);
        let across = along.cross(DVec3::Y).normalize_or(DVec3::X);
        let (across, up) = (across * (0.5 * width), across.cross(along) * (0.5 * height));
        let ends = [(from, -across, -up), (from, across, -up), (from, -across, up), (from, across, up)];
        let near = ends.map(|(end, across, up)| end + across + up);
        let far = near.map(|corner| corner + (to - from));
        // Across, up and back along the beam are right-handed: the far end comes first.
        self.hexahedron([far[0], far[1], far[2], far[3], near[0], near[1], near[2], near[3]]);
    }

    /// A lump: the surface of the cube [-1, 1], each side in `cells` times `cells` squares, moved by a map that
    /// keeps its sides outward: `12 * cells * cells` triangles.
    pub(crate) fn lump(&mut self, cells: u32, moved: impl Fn(DVec3) -> DVec3) {
        let at = |step: u32| 2.0 * f64::from(step) / f64::from(cells) - 1.0;
        let sides = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().flat_map(|axis| [axis, -axis]);
        for outward in sides {
            let along = DVec3::new(outward.y, outward.z, outward.x);
            let across = outward.cross(along);
            for cell in 0..cells * cells {
                let (column, row) = (cell % cells, cell / cells);
                let corner = |u: u32, v: u32| moved(outward + along * at(column + u) + across * at(row + v));
                self.quad([corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)]);
            }
        }
    }

    /// An upright frustum of a cone with flat ends; a radius of zero closes in a point. `sides` quads (or
    /// triangles) around, `sides - 2` triangles for each end that is open.
    pub(crate) fn frustum(
        &mut self,
        foot: DVec3,
        height: f64,
        radius_foot: f64,
        radius_head: f64,
        sides: u32,
    ) {
        let head = foot + DVec3::Y * height;
        let (low, high) = (ring(foot, radius_foot, sides), ring(head, radius_head, sides));
        let count = sides as usize;
        for side in 0..count {
            let next = (side + 1) % count;
            if radius_head == 0.0 {
                self.triangle([low[side], low[next], head]);
            } else if radius_foot == 0.0 {
                self.triangle([foot, high[next], high[side]]);
            } else {
                self.quad([low[side], low[next], high[next], high[side]]);
            }
        }
        for side in 1..count - 1 {
            if radius_foot > 0.0 {
                self.triangle([low[0], low[side + 1], low[side]]);
            }
            if radius_head > 0.0 {
                self.triangle([high[0], high[side], high[side + 1]]);
            }
        }
    }

    /// A bent tube through centres, each with its own radius, without ends: `2 * sides` triangles a segment.
    pub(crate) fn tube(&mut self, centres: &[(DVec3, f64)], sides: u32) {
        // Carry one direction across the axis along, so that the tube does not twist.
        let mut across = DVec3::ZERO;
        let mut rings = Vec::with_capacity(centres.len());
        for index in 0..centres.len() {
            let before = centres[index.saturating_sub(1)].0;
            let after = centres[(index + 1).min(centres.len() - 1)].0;
            let axis = (after - before).normalize_or(DVec3::Y);
            across = (across - axis * axis.dot(across)).normalize_or(axis.any_orthonormal_vector());
            rings.push(ring_across(centres[index].0, across, axis.cross(across), centres[index].1, sides));
        }
        for pair in rings.windows(2) {
            for side in 0..sides as usize {
                let next = (side + 1) % sides as usize;
                self.quad([pair[0][side], pair[0][next], pair[1][next], pair[1][side]]);
            }
        }
    }

    fn vertices(&mut self, corners: &[DVec3]) -> u32 {
        let first = self.positions.len() as u32;
        self.positions.extend(corners.iter().map(|corner| corner.as_vec3().to_array()));
        first
    }
}

/// Points around a vertical axis, counter-clockwise seen from above.
fn ring(centre: DVec3, radius: f64, sides: u32) -> Vec<DVec3> {
    (0..sides)
        .map(|side| {
            let (sin, cos) = libm::sincos(f64::from(side) * std::f64::consts::TAU / f64::from(sides));
            centre + DVec3::new(cos, 0.0, -sin) * radius
        })
        .collect()
}

/// Points around the axis that is the cross product of two unit vectors, counter-clockwise seen from its head.
fn ring_across(centre: DVec3, across: DVec3, other: DVec3, radius: f64, sides: u32) -> Vec<DVec3> {
    (0..sides)
        .map(|side| {
            let (sin, cos) = libm::sincos(f64::from(side) * std::f64::consts::TAU / f64::from(sides));
            centre + (across * cos + other * sin) * radius
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Six times the signed volume, which is positive for a closed mesh with outward faces.
    fn volume(mesh: &Mesh) -> f64 {
        let corner = |index: &u32| DVec3::from_array(mesh.positions[*index as usize].map(f64::from));
        mesh.indices
            .chunks_exact(3)
            .map(|triangle| corner(&triangle[0]).cross(corner(&triangle[1])).dot(corner(&triangle[2])) / 6.0)
            .sum()
    }

    #[test]
    fn boxes_face_outward() {
        let mut builder = MeshBuilder::new();
        builder.cuboid(DVec3::new(1.0, 2.0, 3.0), DVec3::new(2.0, 4.0, 6.0));
        let mesh = builder.build("box");
        assert_eq!(mesh.triangles(), 12);
        assert!((volume(&mesh) - 6.0).abs() < 1e-5);
    }

    #[test]
    fn beams_and_lumps_face_outward() {
        let mut builder = MeshBuilder::new();
        builder.beam(DVec3::new(1.0, 2.0, 3.0), DVec3::new(3.0, 3.0, 5.0), 0.5, 2.0);
        assert!((volume(&builder.build("beam")) - 3.0).abs() < 1e-5);
        let mut builder = MeshBuilder::new();
        builder.beam(DVec3::ZERO, DVec3::Y * 3.0, 0.5, 2.0);
        assert!((volume(&builder.build("post")) - 3.0).abs() < 1e-5);
        let mut builder = MeshBuilder::new();
        builder.lump(16, |point| point.normalize() * 2.0 + DVec3::X);
        let mesh = builder.build("ball");
        assert_eq!(mesh.triangles(), 12 * 256);
        let exact = 4.0 / 3.0 * std::f64::consts::PI * 8.0;
        assert!((volume(&mesh) / exact - 1.0).abs() < 0.01, "{}", volume(&mesh));
    }

    #[test]
    fn cones_face_outward() {
        for (foot, head, triangles) in [(1.0, 0.0, 64 + 62), (0.0, 1.0, 64 + 62), (1.0, 1.0, 128 + 124)] {
            let mut builder = MeshBuilder::new();
            builder.frustum(DVec3::new(5.0, 0.0, 0.0), 3.0, foot, head, 64);
            let mesh = builder.build("cone");
            assert_eq!(mesh.triangles(), triangles);
            let exact = std::f64::consts::PI * 3.0 * (foot * foot + foot * head + head * head) / 3.0;
            assert!((volume(&mesh) / exact - 1.0).abs() < 3e-3, "{foot} {head}: {}", volume(&mesh));
        }
    }

    #[test]
    fn tubes_face_outward() {
        let mut builder = MeshBuilder::new();
        builder.tube(&[(DVec3::ZERO, 1.0), (DVec3::X * 4.0, 1.0)], 64);
        // Without its ends a tube through the origin along x still bounds two thirds of its volume.
        let exact = std::f64::consts::PI * 4.0 * 2.0 / 3.0;
        assert!((volume(&builder.build("tube")) / exact - 1.0).abs() < 3e-3);
    }
}
