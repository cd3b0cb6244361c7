//! Planes with masks in the yard, and what receivers on them show.

use cssm_core::SceneBounds;
use cssm_core::case::LightCase;
use cssm_core::glam::DVec3;
use cssm_core::ground::plane_of;
use cssm_core::plan::WorldPlane;
use cssm_core::twin::resolve;

use super::resolve::Visible;
use super::stage::Drawn;
use super::yard::ORIGIN;

/// Rounding of both blurred images to 8 bits, of the mask, and of the weights that filtering hardware blends with.
const TOLERANCE: f64 = 3.0 * 0.5 / 255.0 + 1.0 / 256.0;

/// The ground, and planes through faces of boxes and through nothing.
pub fn planes() -> [WorldPlane; 4] {
    let plane = |at: [f64; 3], normal: [f64; 3]| WorldPlane {
        point_world: ORIGIN + DVec3::from_array(at),
        normal_world: DVec3::from_array(normal),
    };
    let turned = |turn: f64| [turn.sin(), 0.0, turn.cos()];
    let front = |turn: f64, half: f64| turned(turn).map(|part| part * half);
    let [x, y, z] = front(0.3, 1.5);
    [
        plane([0.0; 3], [0.0, 2.0, 0.0]),
        plane([4.0 + x, y, -12.0 + z], turned(0.3)),
        plane([0.0, 4.0, 0.0], [0.0, -1.0, 0.0]),
        plane([0.0, 50.0, 0.0], [0.3, 1.0, 0.2]),
    ]
}

/// What planning is told: the first of the planes.
pub fn bounds(count: u32) -> SceneBounds {
    let mut bounds = SceneBounds::default();
    let given = planes().into_iter().map(Some).take(count as usize);
    bounds.ground_planes.iter_mut().zip(given).for_each(|(place, plane)| *place = plane);
    bounds
}

/// What receivers on planes show.
#[derive(Debug, Default)]
pub struct Masked {
    /// Pixels on a plane.
    pub pixels: usize,
    /// Those in half shadow.
    pub soft: usize,
    /// Those at which the mask is wrong.
    pub mask_wrong: usize,
    /// Those at which the engine's material is wrong.
    pub material_wrong: usize,
    /// Largest error.
    pub worst: f64,
}

impl Masked {
    /// Compares pixels on planes with the twin.
    pub fn of(case: &LightCase, drawn: &Drawn, visible: &Visible) -> Self {
        let mut found = Self::default();
        for (pixel, (ray, hit)) in visible.rays.iter().zip(&visible.hits).enumerate() {
            let Some(hit) = hit else { continue };
            let point = *ray * hit.along;
            if plane_of(drawn.plan.ground_planes(), point).is_none() {
                continue;
            }
            let truth = resolve(case, &drawn.plan, &drawn.map, point, hit.normal).visibility;
            let error = |image: &Option<Vec<u8>>| {
                image.as_ref().map_or(0.0, |image| (f64::from(image[pixel]) / 255.0 - truth).abs())
            };
            let (mask, material) = (error(&drawn.mask), error(&drawn.material));
            found.pixels += 1;
            found.soft += usize::from(truth > 0.02 && truth < 0.98);
            found.mask_wrong += usize::from(mask > TOLERANCE);
            found.material_wrong += usize::from(material > TOLERANCE);
            found.worst = found.worst.max(mask).max(material);
        }
        found
    }
}
