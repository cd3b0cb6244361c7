//! The workload: palms seen with the sun outside the image, and with the sun in it.

use cssm_core::glam::DVec3;
use cssm_core::{Light, SceneBounds, View};
use cssm_lab::error::LabError;
use cssm_lab::scene::{Scene, Viewpoint};

use crate::error::BenchError;

/// The paper's image.
pub const IMAGE_PIXELS: (u32, u32) = (640, 640);

/// Elevation tangent and sideways tangent of a sun in the image, over the horizontal direction of sight.
const SUN_IN_VIEW: [f64; 2] = [0.3, 0.25];

/// A view of a scene under a sun.
#[derive(Debug, Clone)]
pub struct Situation {
    /// In words, for the report.
    pub name: &'static str,
    /// The view.
    pub view: View,
    /// The sun.
    pub light: Light,
    /// What planning is told of the scene.
    pub bounds: SceneBounds,
    /// Cases of `speed.cssm` that are timed here; after [`IN_FRAGMENTS`](crate::contender::IN_FRAGMENTS) their depth comes
    /// from a fragment shader.
    pub cases: &'static [&'static str],
}

/// The paper's two: the general case and the dueling case.
///
/// # Errors
/// When the scene lacks views.
pub fn situations(scene: &Scene, size_pixels: (u32, u32)) -> Result<[Situation; 2], BenchError> {
    let missing = || BenchError::Missing { scene: scene.name.clone(), what: "first and third view" };
    let (general, first_person) = scene.views.first().zip(scene.views.get(2)).ok_or_else(missing)?;
    let bounds = SceneBounds::of(scene.bounds_world());

    // Turn the sun of the first-person view into its image.
    let ahead = (first_person.target_world - first_person.eye_world).with_y(0.0).normalize_or(DVec3::NEG_Z);
    let toward_sun = ahead + DVec3::Y * SUN_IN_VIEW[0] + ahead.cross(DVec3::Y) * SUN_IN_VIEW[1];
    let dueling = Viewpoint { light_travels: -toward_sun, ..*first_person };

    let general_cases: &[_] = &[
        "Standard",
        "Unstretched",
        "Stretched",
        "UnstretchedInFragments",
        "Logarithmic",
        "Bands",
        "FaceColumns",
    ];
    let dueling_cases: &[_] = &["Standard", "FourPlane", "FaceColumns"];
    let situation = |name, viewpoint: &Viewpoint, cases| -> Result<_, LabError> {
        let (view, light) = viewpoint.pictured(size_pixels)?;
        Ok(Situation { name, view, light, bounds, cases })
    };
    Ok([
        situation("sun outside the image (general case)", general, general_cases)?,
        situation("sun in the image (dueling case)", &dueling, dueling_cases)?,
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_workload_is_the_papers() {
        let scene = Scene::palm();
        assert_eq!(scene.triangles(), 10_624);
        let [general, dueling] = situations(&scene, IMAGE_PIXELS).unwrap();
        let seen = |situation: &Situation| {
            let view = &situation.view;
            let light = view.camera_from_world * situation.light.toward_world(view.eye_world);
            let (x, y) = (light.x / -light.z, light.y / -light.z);
            light.z < 0.0 && x > view.left && x < view.right && y > view.bottom && y < view.top
        };
        assert!(seen(&dueling) && !seen(&general));
        assert_eq!(general.view.size_pixels, IMAGE_PIXELS);
    }
}
