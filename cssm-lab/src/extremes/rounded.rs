//! A plan as shaders have it: every number rounded to f32 once, every operation rounded, without a fused multiplication.

use cssm_core::ShadowPlan;
use cssm_core::facet::{FacetRows, Selection};
use cssm_core::glam::{DMat3, DVec2, DVec3, DVec4, Vec3, Vec4};
use cssm_core::remap::{Curve, Remap};
use cssm_core::table::shear_parts;

/// Rows and points in sheared camera axes, as records and shaders have them.
#[derive(Debug, Clone, Copy)]
pub struct Rounded {
    camera_from_world: DMat3,
    shear: DVec2,
}

/// Leading bits of a float whose products with twelve bits are exact.
const LEADING_BITS: u32 = 0xffff_f000;
/// Sign and exponent of a float.
const EXPONENT_BITS: u32 = 0xff80_0000;

impl Rounded {
    /// The axes of a plan.
    pub fn of(plan: &ShadowPlan) -> Self {
        Self { camera_from_world: plan.camera_from_world, shear: plan.shear }
    }

    fn row(&self, row: DVec4) -> Vec4 {
        let camera = self.camera_from_world * row.truncate();
        let along = camera.z - self.shear.dot(camera.truncate());
        DVec4::new(camera.x, camera.y, along, row.w).as_vec4()
    }

    /// A point in camera axes, moved along the light step by step as the shader does.
    pub fn position(&self, point_camera: DVec3) -> Vec3 {
        let point = point_camera.as_vec3();
        let (leading, rest) = shear_parts(self.shear);
        let (leading, rest) = (leading.as_vec2(), rest.as_vec2());
        let bits = point.z.to_bits();
        let upper = f32::from_bits(bits & LEADING_BITS);
        let lower = (bits & !LEADING_BITS) as f32;
        let step = f32::from_bits(bits & EXPONENT_BITS) * f32::EPSILON;
        let moved = point.truncate() + leading * upper;
        let moved = moved + (leading * step) * lower;
        (moved + rest * point.z).extend(point.z)
    }

    fn dot(&self, row: DVec4, position: Vec3) -> f32 {
        let row = self.row(row);
        row.x * position.x + row.y * position.y + row.z * position.z + row.w
    }

    /// Clip coordinates over w, and w, of a moved position.
    pub fn ndc(&self, rows: &FacetRows, position: Vec3) -> (DVec3, f32) {
        let w = self.dot(rows.w, position);
        let [x, y, z] = [rows.x, rows.y, rows.z].map(|row| self.dot(row, position) / w);
        let y = if rows.remap.is_none() { f64::from(y) } else { bent(rows, y) };
        (DVec3::new(f64::from(x), y, f64::from(z)), w)
    }

    /// The cell of a moved position: [`Selection::cell`] with every operation rounded.
    pub fn cell(&self, selection: &Selection, position: Vec3) -> u32 {
        let dot = |row: &DVec4| self.dot(*row, position);
        if selection.dominant.is_some_and(|[row, front]| dot(&row).abs() <= 1.0 && dot(&front) >= 0.0) {
            return selection.dominant_cell();
        }
        let half = usize::from(selection.split.is_some_and(|split| dot(&split) < 0.0));
        let start = half * selection.sectors as usize;
        let ring = selection.borders.get(start..start + selection.sectors as usize);
        let walked = match ring.and_then(<[DVec4]>::split_first) {
            None => 0,
            Some((first, rest)) if dot(first) >= 0.0 => rest.iter().take_while(|row| dot(row) >= 0.0).count(),
            Some((_, rest)) => rest.len() - rest.iter().rev().take_while(|row| dot(row) < 0.0).count(),
        };
        let sector = start + walked;
        let band = selection.distances.get(sector).map_or(0, |row| {
            let unit = selection.units.get(sector).map_or(1.0, &dot);
            let limits = selection.limits(sector);
            let distance = dot(row);
            let reached = |limit: &&f64| distance >= (**limit as f32).min(f32::MAX) * unit;
            limits.iter().filter(reached).count()
        });
        sector as u32 * selection.bands + band as u32
    }
}

/// The remap with every step rounded, as records and shaders have it.
fn bent(rows: &FacetRows, k: f32) -> f64 {
    let Remap { curve, scale, shift } = rows.remap;
    let (scale, shift) = (scale as f32, shift as f32);
    let y = match curve {
        Curve::Straight => shift + scale * k,
        Curve::Perspective { push_back_metres } => shift + scale * k / (1.0 + push_back_metres as f32 * k),
        Curve::Logarithmic { reference_metres, horizon_metres } => {
            let horizon = (1.0 / horizon_metres) as f32;
            if k <= horizon {
                rows.remap.y(0.0) as f32 - (f64::from(scale) * horizon_metres) as f32 * k
            } else {
                shift - scale * libm::logf(k * reference_metres as f32)
            }
        }
    };
    f64::from(y)
}
