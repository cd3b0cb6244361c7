//! Nearest hits and any hits among all triangles of a scene; rays pass through the holes of alpha masks.

use std::ops::Range;

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::{Bvh, BvhNode, rayon_executor};
use cssm_core::glam::DVec3;
use nalgebra::Point3;

use super::cutouts::Cutouts;
use super::triangle::Triangle;
use crate::scene::Scene;

/// All triangles of a scene in world space, under one hierarchy of boxes.
pub struct Tracer {
    triangles: Vec<Triangle>,
    instances: Vec<u32>,
    cutouts: Cutouts,
    nodes: Vec<Node>,
}

/// A nearest hit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hit {
    /// Ray parameter.
    pub distance: f64,
    /// Index of the triangle in the whole scene.
    pub triangle: u32,
}

/// A node of the hierarchy: a triangle, or two boxes.
enum Node {
    Leaf { triangle: u32 },
    Inner { children: [u32; 2], boxes: [Slab; 2] },
}

/// A box as the interval test wants it.
#[derive(Clone, Copy)]
struct Slab {
    min: DVec3,
    max: DVec3,
}

impl Slab {
    /// Ray parameter at which the box is entered, if that lies in `start..=end`.
    #[inline]
    fn entered(&self, origin: DVec3, inverse: DVec3, start: f64, end: f64) -> Option<f64> {
        let (one, two) = ((self.min - origin) * inverse, (self.max - origin) * inverse);
        // A ray in the plane of a side gives NaN, which min and max of floats skip. Such a box may count as missed:
        // boxes are wider than what they hold, so nothing lies in their sides.
        let axis = |one: f64, two: f64| (one.min(two), one.max(two));
        let ((x_in, x_out), (y_in, y_out), (z_in, z_out)) =
            (axis(one.x, two.x), axis(one.y, two.y), axis(one.z, two.z));
        let enter = start.max(x_in).max(y_in).max(z_in);
        let leave = end.min(x_out).min(y_out).min(z_out);
        (enter <= leave * BOX_SLACK).then_some(enter)
    }
}

/// Covers the rounding of the three interval ends, so that a flat box is never missed.
const BOX_SLACK: f64 = 1.0 + 1e-14;

impl Tracer {
    /// Places every triangle in the world and builds the hierarchy.
    pub fn new(scene: &Scene) -> Self {
        // Place the triangles; those without area can neither be seen nor cast.
        let mut triangles = Vec::with_capacity(scene.triangles());
        let mut instances = Vec::with_capacity(scene.triangles());
        let mut cutouts = Cutouts::new(scene);
        for (index, instance) in scene.instances.iter().enumerate() {
            let mesh = &scene.meshes[instance.mesh];
            for corners in mesh.indices.chunks_exact(3) {
                let place = |corner: u32| {
                    let object = DVec3::from_array(mesh.positions[corner as usize].map(f64::from));
                    instance.world_from_object.transform_point3(object)
                };
                let [corner, second, third] = [place(corners[0]), place(corners[1]), place(corners[2])];
                let triangle = Triangle { corner, edges: [second - corner, third - corner] };
                if triangle.edges[0].cross(triangle.edges[1]).length_squared() > 0.0 {
                    triangles.push(triangle);
                    instances.push(index as u32);
                    cutouts.push(instance.mesh, mesh, corners);
                }
            }
        }

        // Build the hierarchy and copy it into the order in which rays walk it.
        let mut shapes: Vec<_> =
            triangles.iter().map(|triangle| Shape { bounds: bounds(triangle), node: 0 }).collect();
        let bvh = Bvh::build_with_executor(&mut shapes, rayon_executor);
        let nodes = bvh.nodes.iter().map(copied).collect();
        Self { triangles, instances, cutouts, nodes }
    }

    /// Number of triangles with an area.
    pub fn triangles(&self) -> usize {
        self.triangles.len()
    }

    /// Unit normal on the counter-clockwise side.
    pub fn normal(&self, triangle: u32) -> DVec3 {
        let [along, across] = self.triangles[triangle as usize].edges;
        along.cross(across).normalize_or_zero()
    }

    /// Instance a triangle belongs to.
    pub fn instance(&self, triangle: u32) -> u32 {
        self.instances[triangle as usize]
    }

    /// Nearest hit with a ray parameter in `start..end`. `stack` is scratch space.
    pub fn nearest(
        &self,
        origin: DVec3,
        direction: DVec3,
        start: f64,
        end: f64,
        stack: &mut Vec<u32>,
    ) -> Option<Hit> {
        let inverse = direction.recip();
        let mut best: Option<Hit> = None;
        stack.clear();
        stack.extend((!self.nodes.is_empty()).then_some(0));
        while let Some(index) = stack.pop() {
            let limit = best.map_or(end, |hit| hit.distance);
            match &self.nodes[index as usize] {
                Node::Leaf { triangle } => {
                    let within = |distance: f64| distance >= start && distance < limit;
                    if let Some(distance) = self.hit(*triangle, origin, direction, within) {
                        best = Some(Hit { distance, triangle: *triangle });
                    }
                }
                Node::Inner { children, boxes } => {
                    let [one, two] = boxes;
                    let entered = |slab: &Slab| slab.entered(origin, inverse, start, limit);
                    match [entered(one), entered(two)] {
                        [Some(one), Some(two)] if one <= two => stack.extend([children[1], children[0]]),
                        [Some(_), Some(_)] => stack.extend(*children),
                        [Some(_), None] => stack.push(children[0]),
                        [None, Some(_)] => stack.push(children[1]),
                        [None, None] => {}
                    }
                }
            }
        }
        best
    }

    /// Whether anything but `except` lies inside an interval of the ray. `stack` is scratch space.
    pub fn blocked(
        &self,
        origin: DVec3,
        direction: DVec3,
        within: Range<f64>,
        except: u32,
        stack: &mut Vec<u32>,
    ) -> bool {
        let inverse = direction.recip();
        stack.clear();
        stack.extend((!self.nodes.is_empty()).then_some(0));
        while let Some(index) = stack.pop() {
            match &self.nodes[index as usize] {
                Node::Leaf { triangle } => {
                    let inside = |distance: f64| {
                        *triangle != except && distance > within.start && distance < within.end
                    };
                    if self.hit(*triangle, origin, direction, inside).is_some() {
                        return true;
                    }
                }
                Node::Inner { children, boxes } => {
                    for (child, slab) in children.iter().zip(boxes) {
                        if slab.entered(origin, inverse, within.start, within.end).is_some() {
                            stack.push(*child);
                        }
                    }
                }
            }
        }
        false
    }

    /// Ray parameter at which a triangle stops a ray, if `counts` holds for it.
    #[inline]
    fn hit(
        &self,
        triangle: u32,
        origin: DVec3,
        direction: DVec3,
        counts: impl Fn(f64) -> bool,
    ) -> Option<f64> {
        let meeting = self.triangles[triangle as usize].hit(origin, direction)?;
        let stops = counts(meeting.distance) && !self.cutouts.is_hole(triangle, meeting.weights);
        stops.then_some(meeting.distance)
    }
}

fn copied(node: &BvhNode<f64, 3>) -> Node {
    let slab = |bounds: &Aabb<f64, 3>| Slab {
        min: DVec3::new(bounds.min.x, bounds.min.y, bounds.min.z),
        max: DVec3::new(bounds.max.x, bounds.max.y, bounds.max.z),
    };
    match node {
        BvhNode::Leaf { shape_index, .. } => Node::Leaf { triangle: *shape_index as u32 },
        BvhNode::Node { child_l_index, child_l_aabb, child_r_index, child_r_aabb, .. } => Node::Inner {
            children: [*child_l_index as u32, *child_r_index as u32],
            boxes: [slab(child_l_aabb), slab(child_r_aabb)],
        },
    }
}

/// What the hierarchy is built from.
struct Shape {
    bounds: Aabb<f64, 3>,
    node: usize,
}

impl Bounded<f64, 3> for Shape {
    fn aabb(&self) -> Aabb<f64, 3> {
        self.bounds
    }
}

impl BHShape<f64, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

fn bounds(triangle: &Triangle) -> Aabb<f64, 3> {
    let corners = [triangle.corner, triangle.corner + triangle.edges[0], triangle.corner + triangle.edges[1]];
    let (min, max) =
        corners.iter().fold((corners[0], corners[0]), |(min, max), c| (min.min(*c), max.max(*c)));
    // The far corners are sums again: widen by their rounding.
    let slack = DVec3::splat(4.0 * f64::EPSILON * min.abs().max(max.abs()).max_element());
    let (min, max) = (min - slack, max + slack);
    Aabb::with_bounds(Point3::new(min.x, min.y, min.z), Point3::new(max.x, max.y, max.z))
}

#[cfg(test)]
impl Tracer {
    /// [`Self::nearest`] without the hierarchy.
    pub(super) fn nearest_tried(&self, origin: DVec3, direction: DVec3, start: f64) -> Option<Hit> {
        let hits = (0..self.triangles.len() as u32).filter_map(|triangle| {
            let distance = self.hit(triangle, origin, direction, |distance| distance >= start)?;
            Some(Hit { distance, triangle })
        });
        hits.min_by(|one, two| one.distance.total_cmp(&two.distance))
    }

    /// [`Self::blocked`] without the hierarchy.
    pub(super) fn blocked_tried(
        &self,
        origin: DVec3,
        direction: DVec3,
        within: Range<f64>,
        except: u32,
    ) -> bool {
        (0..self.triangles.len() as u32).any(|triangle| {
            let inside =
                |distance: f64| triangle != except && distance > within.start && distance < within.end;
            self.hit(triangle, origin, direction, inside).is_some()
        })
    }
}
