//! Truth: what a ray caster in f64 says about every pixel of a view.
//!
//! A primary ray through the pixel's centre finds the visible surface; a second ray from there towards the light
//! says lit or shadowed. The second ray starts on the surface itself: it skips the triangle it starts on and
//! anything nearer than the rounding of the coordinates, and nothing else; it ends at the light, so that what stands
//! beyond a lamp casts no shadow. Both rays pass through the holes of alpha masks.

mod cutouts;
mod tracer;
mod triangle;

pub use tracer::Tracer;

use cssm_core::glam::DVec3;
use cssm_core::{Light, View};
use rayon::prelude::*;

/// Shadow rays start this far off, relative to the size of the coordinates: some rounding errors of f64.
const START_RELATIVE: f64 = 1e-12;

/// Rows that one task traces.
const ROWS_PER_TASK: usize = 4;

/// Every pixel of a view, row by row from the top.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Width in pixels.
    pub width: usize,
    /// Height in pixels.
    pub height: usize,
    /// What each pixel sees; `None` is sky.
    pub pixels: Vec<Option<Visible>>,
}

/// What a pixel sees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Visible {
    /// Point relative to the eye, world axes, metres.
    pub position: DVec3,
    /// Unit geometric normal on the eye's side.
    pub normal: DVec3,
    /// Cosine between that normal and the direction towards the light.
    pub cosine: f64,
    /// Distance to the light, metres; infinite under a directional light.
    pub light_metres: f64,
    /// Depth along the view axis, metres.
    pub depth: f64,
    /// Index of the instance.
    pub instance: u32,
    /// Index of the triangle in the whole scene.
    pub triangle: u32,
    /// Whether the light's range and cone hold the point.
    pub reached: bool,
    /// Whether the light reaches the point and the ray towards it is free.
    pub lit: bool,
}

/// Surfaces face the light above this cosine of normal and light.
pub const FACING_COSINE: f64 = 0.05;

impl Visible {
    fn surface(&self) -> Surface {
        let Self { position, normal, depth, instance, triangle, .. } = *self;
        Surface { position, normal, depth, instance, triangle }
    }

    /// Whether the light reaches the surface from the front, so that a shadow on it can be judged.
    pub fn faces_light(&self) -> bool {
        self.reached && self.cosine > FACING_COSINE
    }
}

impl Frame {
    /// Traces a view. `progress` is called with the number of rows that were finished.
    pub fn trace(tracer: &Tracer, view: &View, light: &Light, progress: &(dyn Fn(u64) + Sync)) -> Self {
        let (width, height) = (view.size_pixels.0 as usize, view.size_pixels.1 as usize);
        let mut pixels = vec![None; width * height];
        pixels.par_chunks_mut(width * ROWS_PER_TASK).enumerate().for_each_init(
            Vec::new,
            |stack, (chunk, pixels)| {
                for (index, pixel) in pixels.iter_mut().enumerate() {
                    let (x, y) = (index % width, chunk * ROWS_PER_TASK + index / width);
                    let ray = view.ray_world(x as f64 + 0.5, y as f64 + 0.5);
                    *pixel = trace_pixel(tracer, view, light, ray, stack);
                }
                progress((pixels.len() / width) as u64);
            },
        );
        Self { width, height, pixels }
    }

    /// The same surfaces under another light. The tracer is the one that found them.
    pub fn under(&self, tracer: &Tracer, view: &View, light: &Light) -> Self {
        let relit = |pixel: &Option<Visible>, stack: &mut Vec<u32>| {
            let pixel = (*pixel)?;
            Some(lit_by(tracer, view, light, pixel.surface(), stack))
        };
        let pixels = self.pixels.par_iter().map_init(Vec::new, |stack, pixel| relit(pixel, stack)).collect();
        Self { width: self.width, height: self.height, pixels }
    }

    /// The pixel at a place.
    pub fn at(&self, x: usize, y: usize) -> Option<&Visible> {
        self.pixels[y * self.width + x].as_ref()
    }

    /// Pixels that see a surface, with their index.
    pub fn visible(&self) -> impl Iterator<Item = (usize, &Visible)> {
        self.pixels.iter().enumerate().filter_map(|(index, pixel)| Some((index, pixel.as_ref()?)))
    }
}

fn trace_pixel(
    tracer: &Tracer,
    view: &View,
    light: &Light,
    ray: DVec3,
    stack: &mut Vec<u32>,
) -> Option<Visible> {
    // Find the surface between the near and the far plane; the ray has depth 1, so its parameter is the depth.
    let hit = tracer.nearest(view.eye_world, ray, view.near_metres, view.far_metres, stack)?;
    let position = ray * hit.distance;
    let outward = tracer.normal(hit.triangle);
    let normal = if outward.dot(ray) > 0.0 { -outward } else { outward };

    let surface = Surface {
        position,
        normal,
        depth: hit.distance,
        instance: tracer.instance(hit.triangle),
        triangle: hit.triangle,
    };
    Some(lit_by(tracer, view, light, surface, stack))
}

/// What a pixel sees, whatever the light.
#[derive(Debug, Clone, Copy)]
struct Surface {
    position: DVec3,
    normal: DVec3,
    depth: f64,
    instance: u32,
    triangle: u32,
}

/// Asks for anything between a surface and the light.
fn lit_by(tracer: &Tracer, view: &View, light: &Light, surface: Surface, stack: &mut Vec<u32>) -> Visible {
    let Surface { position, normal, depth, instance, triangle } = surface;
    let world = view.eye_world + position;
    let start = START_RELATIVE * (world.abs().max_element() + view.eye_world.abs().max_element() + depth);
    let toward_light = light.toward_world(world);
    let light_metres = light.distance_metres(world);
    let reached = light.reaches(world);
    let lit = reached && !tracer.blocked(world, toward_light, start..light_metres - start, triangle, stack);
    let cosine = normal.dot(toward_light);
    Visible { position, normal, cosine, light_metres, depth, instance, triangle, reached, lit }
}

#[cfg(test)]
mod tests;
