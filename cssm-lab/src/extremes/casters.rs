//! Casters that are no proper triangles: without area, thinner than rounding, longer than the world, through the eye and
//! the light.

use cssm_core::glam::DVec3;
use cssm_core::twin::{Triangle, capture, resolve};
use cssm_core::{LightCase, ShadowPlan};
use serde::Serialize;

use super::found::Count;
use super::judge::{case_in, house};
use super::situations::Situation;
use super::subjects::Subject;

/// One situation in this many is drawn.
const EVERY: usize = 17;
/// Side of the map that is drawn.
const SIDE: u32 = 256;
/// Depths of the receivers that casters stand before, as exponents of a share between near distance and reach.
const DEPTHS: [f64; 4] = [0.05, 0.35, 0.6, 0.9];

/// What became of such casters.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct CasterFound {
    /// Maps that were drawn.
    pub maps: u64,
    /// Maps in which a caster without area covers a texel.
    pub drawn_without_area: Count,
    /// Maps with depths that are no numbers from 0 to 1.
    pub wrong_depths: Count,
    /// Receivers whose visibility is no number from 0 to 1.
    pub wrong_visibilities: Count,
}

impl CasterFound {
    /// What is broken, each with the situation.
    pub fn breaks(&self) -> Vec<(String, &str)> {
        let counts = [
            ("maps with texels of casters without area", &self.drawn_without_area),
            ("maps with wrong depths", &self.wrong_depths),
            ("wrong visibilities", &self.wrong_visibilities),
        ];
        let broken = counts.into_iter().filter(|(_, count)| count.times > 0);
        broken.map(|(what, count)| (format!("{} {what}", count.times), count.place.as_str())).collect()
    }
}

/// Draws such casters in some of the situations.
pub fn judge(subject: &Subject, situations: &[Situation]) -> CasterFound {
    let mut found = CasterFound::default();
    for situation in situations.iter().step_by(EVERY) {
        let mut case = case_in(subject, situation);
        (case.map.width, case.map.height) = (SIDE, SIDE);
        let Ok(plan) = house(&case, situation) else { continue };
        judge_plan(&mut found, &case, &plan, situation);
    }
    found
}

/// Draws them into the map of one plan.
pub fn judge_plan(found: &mut CasterFound, case: &LightCase, plan: &ShadowPlan, situation: &Situation) {
    found.maps += 1;
    let place = || situation.to_string();
    let points: Vec<DVec3> = DEPTHS.iter().map(|share| point(situation, *share)).collect();

    // What has no area covers no texel.
    let nothing: Vec<Triangle> = points.iter().flat_map(|point| without_area(*point)).collect();
    let map = capture(plan, &nothing);
    if map.depths.iter().any(|depth| *depth != plan.depth_order.cleared()) {
        found.drawn_without_area.add(&place);
    }

    // What has hardly any covers what it may, with depths that are depths.
    let light = plan.light;
    let thin: Vec<Triangle> = points.iter().flat_map(|point| slivers(*point, light.truncate())).collect();
    let map = capture(plan, &thin);
    if map.depths.iter().any(|depth| !(0.0..=1.0).contains(depth)) {
        found.wrong_depths.add(&place);
    }
    for point in points {
        for normal in [DVec3::Y, DVec3::new(0.6, 0.0, 0.8), light.truncate().normalize_or(DVec3::X)] {
            let visibility = resolve(case, plan, &map, point, normal).visibility;
            if !(0.0..=1.0).contains(&visibility) {
                found.wrong_visibilities.add(&place);
            }
        }
    }
}

/// A visible point relative to the eye, world axes.
fn point(situation: &Situation, share: f64) -> DVec3 {
    let view = &situation.view;
    let depth = view.near_metres * libm::pow(situation.reach_metres / view.near_metres, share);
    let (width, height) = view.size_pixels;
    view.ray_world(f64::from(width) * (0.2 + 0.5 * share), f64::from(height) * 0.6) * depth
}

/// Points and lines; coordinates are doubled, so that sums are exact.
fn without_area(point: DVec3) -> [Triangle; 4] {
    let along = DVec3::new(0.25, -0.5, 0.125) * point.length();
    [
        [point, point, point],
        [point, point, point + along],
        [point, point + along, point],
        [point * 2.0, point * 4.0, point * 8.0],
    ]
}

/// Triangles thinner than rounding, longer than the world, edge-on to the light, around the eye.
fn slivers(point: DVec3, light: DVec3) -> [Triangle; 7] {
    let size = point.length();
    let (across, along) = (DVec3::new(0.3, 0.8, -0.1) * size, DVec3::new(-0.7, 0.1, 0.6) * size);
    let toward = light.normalize_or(DVec3::Y) * size;
    [
        [point, point + across, point + across * 0.5 + along * 1e-9],
        [point, point + across, point + across * 0.5 + along * 1e-18],
        [point - along * 1e6, point + along * 1e6, point + across * 1e-6],
        [point, point + toward, point + toward * 0.5 + across * 1e-12],
        [point, point + toward * 0.5, point + across * 0.1],
        [-point, point * 2.0, across],
        [point - across * 1e12, point + across * 1e12 - along * 1e12, point + along * 1e12 + toward * 0.1],
    ]
}
