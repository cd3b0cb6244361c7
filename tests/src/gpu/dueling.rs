//! Suns in, behind and just outside a view: where facets share tiles and depth is stored reversed.

use cssm_core::glam::DVec3;
use cssm_core::{Light, View};

/// Suns for a view: ahead inside the image, behind the camera, and ahead above the image's upper edge.
///
/// # Panics
/// Never; the directions are fixed.
pub fn suns(view: &View) -> [Light; 3] {
    let above = view.top + 0.1 * (view.top - view.bottom);
    [DVec3::new(0.2, 0.3, -1.0), DVec3::new(0.15, 0.25, 1.0), DVec3::new(0.1, above, -1.0)].map(|toward| {
        let toward_world = view.camera_from_world.transpose() * toward;
        Light::directional_travelling(-toward_world).expect("a fixed direction")
    })
}
