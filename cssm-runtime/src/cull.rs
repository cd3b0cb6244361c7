//! From object space to the eye, in f64: rows in camera axes for the device, boxes in world axes for culling.

use std::ops::Range;

use cssm_core::BoundingBox;
use cssm_core::glam::{DAffine3, DMat3, DVec3, DVec4};

/// Rows that take (x, y, z, 1) of object space to a position relative to the eye, metres, in the axes of the capture:
/// the camera's (x right, y up, looking along -z), sheared as the plan says ([`cssm_core::ShadowPlan::shear`]).
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct InstanceRows(pub [[f32; 4]; 3]);

impl InstanceRows {
    /// Bytes of one instance.
    pub const BYTES: u64 = size_of::<Self>() as u64;

    /// Rounds a transform once, after the eye has been subtracted and the axes turned in f64; `None` where f32 cannot
    /// hold it.
    pub fn rounded(capture_from_object: &DAffine3) -> Option<Self> {
        let (matrix, shift) = (capture_from_object.matrix3, capture_from_object.translation);
        let row = |index: usize| matrix.row(index).extend(shift[index]).as_vec4();
        let rows = [row(0), row(1), row(2)];
        rows.iter().all(|row| row.is_finite()).then(|| Self(rows.map(|row| row.to_array())))
    }
}

/// The transform with the eye at the origin, world axes.
pub(crate) fn eye_from_object(world_from_object: &DAffine3, eye_world: DVec3) -> DAffine3 {
    DAffine3 { matrix3: world_from_object.matrix3, translation: world_from_object.translation - eye_world }
}

/// A transform of [`eye_from_object`] turned to the sheared camera axes of capture records.
pub(crate) fn capture_from_object(eye_from_object: &DAffine3, capture_from_world: &DMat3) -> DAffine3 {
    DAffine3 {
        matrix3: *capture_from_world * eye_from_object.matrix3,
        translation: *capture_from_world * eye_from_object.translation,
    }
}

/// A box by its centre and half its sides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CentredBox {
    pub(crate) centre: DVec3,
    pub(crate) half: DVec3,
}

impl CentredBox {
    pub(crate) fn new(bounds: &BoundingBox) -> Self {
        Self { centre: (bounds.min + bounds.max) * 0.5, half: (bounds.max - bounds.min) * 0.5 }
    }

    /// The smallest box of world axes around a transformed box.
    pub(crate) fn transformed(self, space_from_object: &DAffine3) -> Self {
        Self {
            centre: space_from_object.transform_point3(self.centre),
            half: space_from_object.matrix3.abs() * self.half,
        }
    }

    /// A box of world space with the eye at the origin.
    pub(crate) fn seen_from(&self, eye_world: DVec3) -> Self {
        Self { centre: self.centre - eye_world, half: self.half }
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.centre.is_finite() && self.half.is_finite()
    }
}

/// Cosines between the normals of half-spaces whose edge is sharp: from opposite ones, whose sum is but rounding, to an
/// edge of about 75 degrees.
const SHARP_COSINES: Range<f64> = -0.9999..-0.25;
/// Weights of two half-spaces in the sums that are tested beside a sharp edge.
const SUM_WEIGHTS: [[f64; 2]; 3] = [[1.0, 1.0], [1.0, 2.0], [2.0, 1.0]];

/// A half-space of [`cssm_core::facet::Facet::casters`], ready to be tested against boxes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct HalfSpace {
    normal: DVec3,
    absolute_normal: DVec3,
    offset: f64,
}

/// How a box lies to a half-space.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Inside,
    Crossing,
    Outside,
}

impl HalfSpace {
    /// The points with `plane.X >= 0`.
    pub(crate) fn new(plane: DVec4) -> Self {
        let normal = plane.truncate();
        Self { normal, absolute_normal: normal.abs(), offset: plane.w }
    }

    /// The same half-space with distances in metres; one without a normal stays as it is.
    pub(crate) fn in_metres(self) -> Self {
        let length = self.normal.length();
        if length == 0.0 {
            return self;
        }
        let Self { normal, absolute_normal, offset } = self;
        Self { normal: normal / length, absolute_normal: absolute_normal / length, offset: offset / length }
    }

    /// Sums of two half-spaces of unit length, if their edge is sharp. What lies in both lies in every sum; a box beyond
    /// the edge may lie outside neither, but outside a sum.
    pub(crate) fn sums_beside_sharp_edge(self, other: Self) -> impl Iterator<Item = Self> {
        let is_sharp = SHARP_COSINES.contains(&self.normal.dot(other.normal));
        SUM_WEIGHTS.into_iter().filter(move |_| is_sharp).map(move |[own, others]| {
            let normal = self.normal * own + other.normal * others;
            Self { normal, absolute_normal: normal.abs(), offset: self.offset * own + other.offset * others }
        })
    }

    /// The same half-space in the space of an instance's own positions.
    pub(crate) fn in_object(&self, eye_from_object: &DAffine3) -> Self {
        let normal = eye_from_object.matrix3.transpose() * self.normal;
        let offset = self.normal.dot(eye_from_object.translation) + self.offset;
        Self { normal, absolute_normal: normal.abs(), offset }
    }

    /// Its normal and offset in other axes, to which `normals` turns normals.
    pub(crate) fn turned(&self, normals: &DMat3) -> DVec4 {
        (*normals * self.normal).extend(self.offset)
    }

    pub(crate) fn is_outside(&self, bounds: &CentredBox) -> bool {
        self.normal.dot(bounds.centre) + self.offset + self.absolute_normal.dot(bounds.half) < 0.0
    }

    pub(crate) fn side(&self, bounds: &CentredBox) -> Side {
        let distance = self.normal.dot(bounds.centre) + self.offset;
        let reach = self.absolute_normal.dot(bounds.half);
        if distance + reach < 0.0 {
            Side::Outside
        } else if distance >= reach {
            Side::Inside
        } else {
            Side::Crossing
        }
    }
}
