//! Where instances stand.

use cssm_core::glam::{DAffine3, DMat3, DVec3};

use super::{Instance, Viewpoint};

/// An upright instance: turned about y, scaled, and put in its place.
pub(crate) fn upright(mesh: usize, place: DVec3, turn_radians: f64, size: f64, colour: [f32; 3]) -> Instance {
    let matrix3 = turn_about_y(turn_radians) * size;
    Instance { mesh, world_from_object: DAffine3 { matrix3, translation: place }, colour }
}

/// A turn about y, counter-clockwise seen from above.
pub(crate) fn turn_about_y(radians: f64) -> DMat3 {
    let (sin, cos) = libm::sincos(radians);
    DMat3::from_cols(DVec3::new(cos, 0.0, -sin), DVec3::Y, DVec3::new(sin, 0.0, cos))
}

/// A viewpoint from plain numbers: the eye, the point looked at, the direction in which the light travels.
pub(crate) fn viewpoint(eye: [f64; 3], target: [f64; 3], light: [f64; 3]) -> Viewpoint {
    Viewpoint { eye_world: eye.into(), target_world: target.into(), light_travels: light.into() }
}

/// A colour, lighter or darker.
pub(crate) fn shaded(colour: [f32; 3], shade: f64) -> [f32; 3] {
    colour.map(|channel| channel * shade as f32)
}
