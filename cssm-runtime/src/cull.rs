//! From object space to the eye, in f64: rows in camera axes for the device, boxes in world axes for culling.

use cssm_core::BoundingBox;
use cssm_core::glam::{DAffine3, DMat3, DVec3};

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

/// The smallest box of world axes around a transformed box.
pub(crate) fn box_from_eye(eye_from_object: &DAffine3, bounds_object: &BoundingBox) -> BoundingBox {
    let centre = eye_from_object.transform_point3((bounds_object.min + bounds_object.max) * 0.5);
    let half = eye_from_object.matrix3.abs() * ((bounds_object.max - bounds_object.min) * 0.5);
    BoundingBox { min: centre - half, max: centre + half }
}
