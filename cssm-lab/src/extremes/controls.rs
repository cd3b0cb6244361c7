//! Known faults, which the measure has to see: positions in world space, the logarithm of a normalised coordinate, a
//! matrix element that is a little off.

use cssm_core::case::{LightKind, Stretch};
use cssm_core::facet::Facet;
use cssm_core::glam::{DVec3, DVec4, Vec3, Vec4};
use cssm_core::homography::Gradients;
use cssm_core::remap::Curve;
use cssm_core::schema::{Value, Word};
use cssm_core::{Light, LightCase, SceneBounds, ShadowPlan, View, plan};
use serde::Serialize;

use super::found::TEXEL_TARGET;
use super::rounded::Rounded;
use crate::error::LabError;

/// A fault and what the measure makes of it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Control {
    /// The fault.
    pub what: &'static str,
    /// Largest error with it, texels.
    pub texels: f64,
    /// Largest error of the same plan without it.
    pub sound_texels: f64,
}

impl Control {
    /// Whether the fault is seen, and nothing without it.
    pub fn is_seen(&self) -> bool {
        self.texels > 4.0 * TEXEL_TARGET && self.sound_texels <= TEXEL_TARGET
    }
}

/// Eye's distance from the origin at which world space is tried, metres.
const OFFSET_METRES: f64 = 1e7;
/// Factor of a matrix element that is a little off.
const OFF: f64 = 1.0 + 1e-4;
/// Receivers of each control.
const RECEIVERS: usize = 2000;

/// Every control.
///
/// # Errors
/// When a declaration, a view or a light of the controls makes no sense.
pub fn controls() -> Result<Vec<Control>, LabError> {
    let build = |name: &str, distribution: Option<(Word, Stretch)>| {
        let builder = LightCase::builder(name).light(LightKind::Directional);
        let builder = match distribution {
            Some((word, stretch)) => builder.distribution(word).stretch(stretch),
            None => builder,
        };
        builder.build().map_err(|errors| LabError::Catalogue { errors })
    };
    let plain = build("Plain", None)?;
    let unfolded = Word::with("logarithmic", [("folds", Value::Count(1))]);
    let logarithmic = (unfolded, Stretch::Exact { bound_texels: 0.25 });
    let bent = build("Bent", Some(logarithmic))?;
    let light = Light::directional_travelling(DVec3::new(0.4, -0.8, 0.3))?;
    let view = |offset: f64, near: f64, far: f64| {
        let eye = DVec3::new(0.6, -0.3, 0.7) * offset;
        let target = eye + DVec3::new(0.5, -0.2, -0.8) * (1.0 + offset);
        View::perspective(eye, target, DVec3::Y, 1.0, near, far, (1080, 1080))
    };
    let far_off = view(OFFSET_METRES, 0.2, 1000.0)?;
    let deep = view(0.0, 1e-4, 1000.0)?;
    let planned = |case: &LightCase, view: &View| plan(case, view, &light, &SceneBounds::default());
    let (plain_plan, bent_plan) = (planned(&plain, &far_off)?, planned(&bent, &deep)?);
    Ok(vec![
        Control {
            what: "positions in world space, 1e7 m from the origin",
            texels: largest(&plain_plan, &far_off, in_world_space),
            sound_texels: largest(&plain_plan, &far_off, as_shaders_do),
        },
        Control {
            what: "the logarithm of a normalised y, near/far 1e-7",
            texels: largest(&bent_plan, &deep, of_normalised_y),
            sound_texels: largest(&bent_plan, &deep, as_shaders_do),
        },
        Control {
            what: "one element of each matrix off by 1e-4",
            texels: largest(&plain_plan, &far_off, with_an_element_off),
            sound_texels: largest(&plain_plan, &far_off, as_shaders_do),
        },
    ])
}

/// Clip coordinates of a receiver by some way of evaluating a facet.
type Evaluate = fn(&ShadowPlan, &Facet, DVec3) -> (f64, f64);

/// Largest error of a way of evaluating a plan, texels.
fn largest(plan: &ShadowPlan, view: &View, evaluate: Evaluate) -> f64 {
    let mut largest = 0.0_f64;
    for index in 0..RECEIVERS {
        // Irrational steps spread receivers over the image and, in their logarithm, over depth.
        let unit = |step: f64| (index as f64 * step).fract();
        let depth =
            view.near_metres * libm::pow(0.999 * view.far_metres / view.near_metres, unit(0.819_172_513));
        let ray = view.ray_world(1080.0 * unit(0.671_043_607), 1080.0 * unit(0.549_700_478));
        let camera = (view.camera_from_world * ray * depth).as_vec3().as_dvec3();
        let point = view.camera_from_world.transpose() * camera;
        let Some(facet) = plan.facet(plan.selection.cell(point.extend(1.0))) else { continue };
        let exact = Gradients::at(&facet.rows, point).ndc;
        let (x, y) = evaluate(plan, facet, point);
        let (width, height) = (f64::from(facet.tile.width), f64::from(facet.tile.height));
        let error = 0.5 * ((x - exact.x).abs() * width).max((y - exact.y).abs() * height);
        // Where w vanishes the receiver is lost altogether.
        let lost = width.max(height);
        largest = largest.max(if error < lost { error } else { lost });
    }
    largest
}

fn as_shaders_do(plan: &ShadowPlan, facet: &Facet, point: DVec3) -> (f64, f64) {
    let rounded = Rounded::of(plan);
    let (ndc, _) = rounded.ndc(&facet.rows, rounded.position(plan.camera_from_world * point));
    (ndc.x, ndc.y)
}

fn with_an_element_off(plan: &ShadowPlan, facet: &Facet, point: DVec3) -> (f64, f64) {
    let mut facet = facet.clone();
    facet.rows.x.x *= OFF;
    as_shaders_do(plan, &facet, point)
}

/// Matrices that take world positions, as an engine without a moving origin has them.
fn in_world_space(plan: &ShadowPlan, facet: &Facet, point: DVec3) -> (f64, f64) {
    let world = (plan.eye_world + point).as_vec3();
    let dot = |row: DVec4| {
        let row = row.truncate().extend(row.w - row.truncate().dot(plan.eye_world));
        dot_in_f32(row.as_vec4(), world)
    };
    let w = dot(facet.rows.w);
    (f64::from(dot(facet.rows.x) / w), facet.rows.remap.y(f64::from(dot(facet.rows.y) / w)))
}

/// Rows whose y was fitted to -1 to 1 before the logarithm is taken: 1 / distance is cancelled out of a coordinate near 1.
fn of_normalised_y(_: &ShadowPlan, facet: &Facet, point: DVec3) -> (f64, f64) {
    let rows = &facet.rows;
    let Curve::Logarithmic { .. } = rows.remap.curve else { return (0.0, 0.0) };
    let (one, two) = (rows.remap.k(-1.0), rows.remap.k(1.0));
    let normalised = (rows.y * 2.0 - rows.w * (one + two)) / (two - one);
    let position = point.as_vec3();
    let w = dot_in_f32(rows.w.as_vec4(), position);
    let y = dot_in_f32(normalised.as_vec4(), position) / w;
    let k = (y * (two - one) as f32 + (one + two) as f32) * 0.5;
    let exact = Gradients::at(rows, point).ndc;
    (exact.x, rows.remap.y(f64::from(k)))
}

fn dot_in_f32(row: Vec4, point: Vec3) -> f32 {
    row.x * point.x + row.y * point.y + row.z * point.z + row.w
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_fault_is_seen() {
        for control in controls().unwrap() {
            println!("{control:?}");
            assert!(control.is_seen(), "{control:?}");
        }
    }
}
