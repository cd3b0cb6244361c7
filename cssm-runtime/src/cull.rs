//! From world space to the eye, in f64, and which facets a caster's shadow reaches.

use cssm_core::BoundingBox;
use cssm_core::glam::{DAffine3, DVec3};

/// Rows that take (x, y, z, 1) of object space to a position relative to the eye, world axes, metres.
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct InstanceRows(pub [[f32; 4]; 3]);

impl InstanceRows {
    /// Bytes of one instance.
    pub const BYTES: u64 = size_of::<Self>() as u64;

    /// Rounds a transform once, after the eye has been subtracted in f64; `None` where f32 cannot hold it.
    pub fn rounded(eye_from_object: &DAffine3) -> Option<Self> {
        let (matrix, shift) = (eye_from_object.matrix3, eye_from_object.translation);
        let row = |index: usize| matrix.row(index).extend(shift[index]).as_vec4();
        let rows = [row(0), row(1), row(2)];
        rows.iter().all(|row| row.is_finite()).then(|| Self(rows.map(|row| row.to_array())))
    }
}

/// The transform with the eye at the origin.
pub(crate) fn eye_from_object(world_from_object: &DAffine3, eye_world: DVec3) -> DAffine3 {
    DAffine3 { matrix3: world_from_object.matrix3, translation: world_from_object.translation - eye_world }
}

/// The smallest box of world axes around a transformed box.
pub(crate) fn box_from_eye(eye_from_object: &DAffine3, bounds_object: &BoundingBox) -> BoundingBox {
    let centre = eye_from_object.transform_point3((bounds_object.min + bounds_object.max) * 0.5);
    let half = eye_from_object.matrix3.abs() * ((bounds_object.max - bounds_object.min) * 0.5);
    BoundingBox { min: centre - half, max: centre + half }
}
