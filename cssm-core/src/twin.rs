//! The f64 twin: capture and resolve on the CPU, exact enough to judge every shader.
//!
//! [`capture()`] is a point-sampled rasteriser without clipping error; [`resolve()`] follows the shader's steps one by
//! one. Both take the plan alone, whatever technique made it, and the case's filter and bias.

mod capture;
mod ground;
mod kernel;
mod moments;
mod resolve;

pub use capture::{Triangle, capture, capture_tested};
pub use resolve::{Resolved, resolve};

use crate::case::DepthFormat;
use crate::plan::DepthOrder;

/// A depth map in f64.
#[derive(Debug, Clone, PartialEq)]
pub struct DepthMap {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Depths row by row from the upper left corner; [`DepthOrder::cleared`] where nothing was drawn.
    pub depths: Vec<f64>,
}

impl DepthMap {
    /// An empty map.
    pub fn cleared(width: u32, height: u32, order: DepthOrder) -> Self {
        Self { width, height, depths: vec![order.cleared(); width as usize * height as usize] }
    }

    /// Depth of a texel; coordinates outside the map read its edge.
    pub fn depth(&self, x: i64, y: i64) -> f64 {
        let x = x.clamp(0, i64::from(self.width) - 1) as usize;
        let y = y.clamp(0, i64::from(self.height) - 1) as usize;
        self.depths[y * self.width as usize + x]
    }

    /// The map as a texture of this format stores it.
    pub fn stored(mut self, format: DepthFormat) -> Self {
        for depth in &mut self.depths {
            *depth = match format {
                DepthFormat::Depth32Float => f64::from(*depth as f32),
                DepthFormat::Depth16Unorm => (*depth * 65535.0).round() / 65535.0,
            };
        }
        self
    }
}
